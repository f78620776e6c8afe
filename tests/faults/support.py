# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What the tests of faults share: runs of the programs in an empty folder, and what must hold after each."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(sys.argv[1]).resolve()  # of the built program
SOURCE = pathlib.Path(sys.argv[2]).resolve()
sys.path.append(str(SOURCE / "tests" / "support"))

from sanitized import is_sanitized  # noqa: E402

MENISCUS = FOLDER / "meniscus"
MSMS = FOLDER / "dropins" / "meniscus-msms"
NANOSHAPER = FOLDER / "dropins" / "meniscus-nanoshaper"
TO_XYZR = FOLDER / "dropins" / "pdb_to_xyzr"
UBIQUITIN = SOURCE / "examples" / "1ubq.pdb"
IS_ROOT = os.geteuid() == 0
SHADOW = 4 if is_sanitized(MENISCUS) else 1  # how many times as much memory a program takes
limits_memory = unittest.skipIf(is_sanitized(MENISCUS), "sanitizers need the whole address space")

SPHERES = "0 0 0 1.7\n1.2 0 0 1.52\n20 0 0 1.8\n"
PRM = ("Grid_scale = 2.0\nXYZR_FileName = three.xyzr\nTriangulation = true\nSurface = ses\n"
       "Probe_Radius = 1.4\nSave_Mesh_MSMS_Format = false\n")


def is_remark(line):
    """Whether a line of standard error is a note or a warning."""
    return ": warning: " in line or ": note: " in line


class FaultTest(unittest.TestCase):
    """Every test runs in an empty folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "three.xyzr").write_text(SPHERES)

    def run_program(self, *arguments, timeout=300, **keywords):
        keywords.setdefault("stdout", subprocess.PIPE)
        keywords.setdefault("stderr", subprocess.PIPE)
        keywords.setdefault("cwd", self.folder)
        result = subprocess.run([str(a) for a in arguments], timeout=timeout, check=False, **keywords)
        result.stderr = (result.stderr or b"").decode("utf-8", "replace")
        return result

    def fails(self, code, *arguments, **keywords):
        """Expects an exit code, one line of error and no temporary file; returns the line."""
        result = self.run_program(*arguments, **keywords)
        self.assertEqual(result.returncode, code, (arguments, result.stderr))
        errors = [line for line in result.stderr.splitlines() if not is_remark(line)]
        self.assertEqual(len(errors), 1, result.stderr)
        self.assertRegex(errors[0], r"\A[a-z_-]+: error: ")
        self.assertEqual(self.temporary(), [])
        return errors[0]

    def temporary(self, folder=None):
        return sorted(p.name for p in (folder or self.folder).rglob(".meniscus-*"))

    def files(self, folder=None):
        folder = folder or self.folder
        return sorted(str(p.relative_to(folder)) for p in folder.rglob("*") if not p.is_dir())


def main():
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])


def is_whole_ply(path):
    """Whether a binary PLY of ours has all the bytes that its header promises."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    sizes = {"float": 4, "double": 8, "int": 4, "uint": 4, "uchar": 1, "ushort": 2, "short": 2, "char": 1}
    expected, count = 0, 0
    for line in header.decode("ascii").splitlines():
        words = line.split()
        if words[0] == "element":
            count = int(words[2])
        elif words[0] == "property" and words[1] == "list":
            expected += count * (sizes[words[2]] + 3 * sizes[words[3]])
        elif words[0] == "property":
            expected += count * sizes[words[1]]
    return bool(re.match(rb"ply\n", header)) and len(body) == expected

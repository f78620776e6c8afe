# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What tests of the built program share. Its path and the source folder are the first two arguments of every test."""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
UBIQUITIN = SOURCE / "examples" / "1ubq.pdb"

# Two overlapping spheres and a third apart: quick, with two components.
SPHERES = "0 0 0 1.7\n1.2 0 0 1.52\n20 0 0 1.8\n"

# Ninety atoms on a sphere of 6.5 Å: an outer surface and a cavity.
SHELL = "".join(f"{6.5 * math.sqrt(1 - z * z) * math.cos(a):.4f} {6.5 * math.sqrt(1 - z * z) * math.sin(a):.4f} "
                f"{6.5 * z:.4f} 1.7\n"
                for z, a in ((1 - (2 * i + 1) / 90, 2.399963229728653 * i) for i in range(90)))

ATOM = "ATOM  {serial:5}  {name:<3} GLY A{residue:4}    {x:8.3f}{y:8.3f}{z:8.3f}  1.00 10.00           {element}\n"


def glycine(shift=0.0):
    """The heavy atoms of one glycine, as PDB lines."""
    atoms = [("N", 0.0, 0.0, 0.0, "N"), ("CA", 1.458, 0.0, 0.0, "C"), ("C", 2.009, 1.420, 0.0, "C"),
             ("O", 1.251, 2.390, 0.0, "O")]
    return "".join(ATOM.format(serial=i + 1, name=name, residue=1, x=x + shift, y=y, z=z, element=element)
                   for i, (name, x, y, z, element) in enumerate(atoms))


class ProgramTest(unittest.TestCase):
    """Every test runs in an empty folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "three.xyzr").write_text(SPHERES)

    def run_program(self, *arguments, text=None):
        """Once more where LeakSanitizer itself has crashed, as it does now and then while threads end."""
        for _ in range(3):
            result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, input=text, capture_output=True,
                                    encoding="utf-8", timeout=120, check=False)
            if "LeakSanitizer has encountered a fatal error" not in result.stderr:
                break
        return result

    def surface(self, *arguments, code=0, text=None):
        """Runs `surface`, coarse unless --spacing is given, and expects an exit code."""
        if "--spacing" not in arguments:
            arguments += ("--spacing", "0.5")
        result = self.run_program("surface", *arguments, text=text)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def refused(self, *arguments, code=2, text=None):
        """Expects one line on standard error, nothing on standard output and no new file; returns the line."""
        before = self.files()
        result = self.surface(*arguments, code=code, text=text)
        self.assertEqual(result.stdout, "")
        remarks = ("meniscus: note: ", "meniscus: warning: ")
        errors = [line for line in result.stderr.splitlines() if not line.startswith(remarks)]
        self.assertEqual(len(errors), 1, result.stderr)
        self.assertTrue(errors[0].startswith("meniscus: error: "), errors[0])
        self.assertEqual(self.files(), before)
        return errors[0]

    def files(self):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*") if p.is_file())

    def report(self, *arguments, **keywords):
        return json.loads(self.surface(*arguments, "--report", "-", **keywords).stdout)

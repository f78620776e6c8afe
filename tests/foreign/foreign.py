# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What tests with other programs share: our program, its files, and how a test is skipped that cannot run."""
import importlib.util
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
UBIQUITIN = SOURCE / "examples" / "1ubq.pdb"

SKIPPED = 77


class ForeignTest(unittest.TestCase):
    """A scratch folder in which `meniscus` has written what OPTIONS ask for, once for all tests of a class."""

    OPTIONS = ()

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="meniscus-foreign-")
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        cls.report = cls.meniscus("surface", UBIQUITIN, *cls.OPTIONS) if cls.OPTIONS else None

    @classmethod
    def meniscus(cls, *words):
        """Runs the program in the scratch folder; its report."""
        result = subprocess.run([PROGRAM, *map(str, words), "--quiet", "--report", "-"], cwd=cls.folder, check=True,
                                stdout=subprocess.PIPE, encoding="utf-8")
        return json.loads(result.stdout)


def main(programs=(), modules=()):
    """Runs the tests of the calling script, unless something that they need is absent."""
    absent = [name for name in programs if shutil.which(name) is None]
    absent += [name for name in modules if importlib.util.find_spec(name) is None]
    if absent:
        print(f"skipped: needs {', '.join(absent)}, which packages.txt lists")
        sys.exit(SKIPPED)
    unittest.main(module="__main__", argv=sys.argv[:1])

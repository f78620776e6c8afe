# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Type hints are consistent, and the stub of the extension module describes it."""
import importlib.util
import os
import pathlib
import subprocess
import sys
import unittest

from support import InScratchFolder

import meniscus

PACKAGE = pathlib.Path(meniscus.__file__).parent

USE = """
import numpy as np
import meniscus

surface: meniscus.Surface = meniscus.surface(meniscus.read("x.pdb"), probe=1.4, edge=1.0)
vertices: np.ndarray = surface.vertices
area: float = surface.cavities[0].area
points: meniscus.Points = surface.sample(density=2, seed=1)
surface.save("x.ply", color="patch")
"""
MISUSE = USE + 'surface.sample(density="much")\n'


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
class Types(InScratchFolder):
    def mypy(self, *arguments, tool="mypy"):
        environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
        return subprocess.run([sys.executable, "-m", tool, *arguments], env=environment, capture_output=True,
                              text=True, check=False)

    def test_the_package_is_consistent(self):
        result = self.mypy("--strict", "-p", "meniscus")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_users_are_told_of_mistakes(self):
        pathlib.Path("use.py").write_text(USE)
        self.assertEqual(self.mypy("use.py").returncode, 0, self.mypy("use.py").stdout)
        pathlib.Path("misuse.py").write_text(MISUSE)
        self.assertIn('incompatible type "str"; expected "float"', self.mypy("misuse.py").stdout)

    def test_the_stub_describes_the_extension(self):
        result = self.mypy("meniscus._core", tool="mypy.stubtest")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()

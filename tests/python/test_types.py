# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Type hints are consistent, and the stub of the extension module describes it."""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import unittest

from support import InScratchFolder

import meniscus

PACKAGE = pathlib.Path(meniscus.__file__).parent

USE = """
import numpy as np
import numpy.typing as npt

import meniscus

surface: meniscus.Surface = meniscus.surface(meniscus.read("x.pdb"), probe=1.4, edge=1.0)
vertices: npt.NDArray[np.float64] = surface.vertices
area: float = surface.cavities[0].area
points: meniscus.Points = surface.sample(density=2, seed=1)
surface.save("x.ply", color="patch")
meniscus.measure("x.pdb", "bondi", waters=True, chains="A")
meniscus.measure("x.pdb", watters=True)
surface.sample(density="much")
exact = meniscus.ExactSurface("x.pdb", waters=True, surface="sas")
foot: npt.NDArray[np.float64] = exact.of_same_atoms(probe=1).nearest([[0, 0, 0]]).foot
surface = exact.mesh(edge=1.0, keep_ridges=True)
exact.mesh(edgy=1.0)
"""

# Right words, and with a "W" wrong ones, each an error of its line.
WORDS = """
import io
from typing import Any

import meniscus

options = meniscus.SurfaceOptions(method="direct", spacing=1.0, time_step=None)
reading = meniscus.ReadOptions(hetero="ligands", radii="bondi", model="join")
run = meniscus.RunOptions(threads=2, memory="4G")
surface: meniscus.Surface = meniscus.surface("x.pdb", options=options, reading=reading, run=run)
surface.save("x.ply", color="curvature:-1:1", field="mask", arrays="depth", view="front", maps="apbs")
surface.write(io.BytesIO(), format="glb")
part: meniscus.Sum = surface.measures.sum("chain A")
area: float = part.errors["sas_area"]
table: Any = surface.measures.to_pandas("residue")
meniscus.read(io.BytesIO(), format="pqr", hydrogens="keep")
meniscus.surface("x.pdb", method="fast")  # W
meniscus.surface("x.pdb", surface="sass")  # W
meniscus.surface("x.pdb", components="some")  # W
meniscus.surface("x.pdb", hetero="some")  # W
meniscus.SurfaceOptions(method="fast")  # W
options.replace(corners="far")  # W
meniscus.ReadOptions(hydrogens="add")  # W
reading.replace(hetero="some")  # W
run.replace(thread=2)  # W
meniscus.read("x.pdb", hydrogens="add")  # W
meniscus.read(io.BytesIO(), format="docx")  # W
surface.save("x.ply", field="masks")  # W
surface.save("x.ply", arrays="depths")  # W
surface.write(io.BytesIO(), format="gif")  # W
surface.map_values("x.dx", interpolation="nearest")  # W
surface.measures.table("helix")  # W
surface.measures.to_pandas("helix")  # W
meniscus.ExactSurface("x.pdb", surface="mesh")  # W
meniscus.map(["x.pdb"], command="compare")  # W
"""
UNPACK = "--enable-incomplete-feature=Unpack"
# Its classes have a metaclass and an __init__ that takes anything.
OF_PYBIND11 = r"meniscus\._core\.(ComparedSurface|ExactSurface|Interfaces|Measures|Mesh|Place|Pockets|Structure|Surface)(\.__init__)?" + "\n"


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
class Types(InScratchFolder):
    def mypy(self, *arguments, tool="mypy"):
        """Versions before 1.5 heed Unpack, which names the keywords of read(), only when told to."""
        environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
        return subprocess.run([sys.executable, "-m", tool, *arguments], env=environment, capture_output=True,
                              text=True, check=False)

    def test_the_package_is_consistent(self):
        result = self.mypy("--strict", UNPACK, "-p", "meniscus")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_users_are_told_of_mistakes_and_of_nothing_else(self):
        pathlib.Path("use.py").write_text(USE)
        result = self.mypy("--strict", UNPACK, "use.py")
        self.assertIn('incompatible type "str"; expected "float"', result.stdout)
        self.assertIn("Found 3 errors in 1 file", result.stdout)
        self.assertIn('Unexpected keyword argument "watters" for "measure"', result.stdout)
        self.assertIn('Unexpected keyword argument "edgy" for "mesh" of "ExactSurface"', result.stdout)

    def test_wrong_words_are_refused(self):
        pathlib.Path("words.py").write_text(WORDS)
        result = self.mypy("--strict", UNPACK, "words.py")
        wrong = {number for number, line in enumerate(WORDS.splitlines(), 1) if line.endswith("# W")}
        found = {int(number) for number in re.findall(r"^words\.py:(\d+): error", result.stdout, re.MULTILINE)}
        self.assertEqual(found, wrong, result.stdout + result.stderr)

    def test_the_stub_describes_the_extension(self):
        pathlib.Path("allowed").write_text(OF_PYBIND11)
        result = self.mypy("meniscus._core", "--allowlist", "allowed", tool="mypy.stubtest")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Biopython's ResidueDepth and get_surface, unchanged, with our programs under the names that they call.

usage: biopython_test.py FOLDER-OF-PROGRAMS MENISCUS SOURCE [unittest arguments]
"""
import csv
import importlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
    from Bio.PDB.PDBParser import PDBParser
    residue_depth = importlib.import_module("Bio.PDB.ResidueDepth")  # Bio.PDB has a class of this name, too
except ImportError:
    residue_depth = None

PROGRAMS = pathlib.Path(sys.argv[1]).resolve()
MENISCUS = pathlib.Path(sys.argv[2]).resolve()
UBIQUITIN = pathlib.Path(sys.argv[3]).resolve() / "examples" / "1ubq.pdb"


@unittest.skipIf(residue_depth is None, "python3-biopython is not installed")
class BiopythonTest(unittest.TestCase):
    """The model is ubiquitin without its waters."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        for name, program in (("msms", "meniscus-msms"), ("pdb_to_xyzr", "pdb_to_xyzr")):
            (cls.folder / name).symlink_to(PROGRAMS / program)
        path = os.environ["PATH"]
        cls.addClassCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = f"{cls.folder}:{path}"
        cls.model = PDBParser(QUIET=True).get_structure("1ubq", UBIQUITIN)[0]
        for residue in [residue for residue in cls.model["A"] if residue.id[0] != " "]:
            cls.model["A"].detach_child(residue.id)

    def measured_depths(self):
        """The exact depth of every atom under Biopython's radii, by our own program."""
        spheres = self.folder / "radii.xyzr"
        spheres.write_text("".join("{:.3f} {:.3f} {:.3f} {:.2f}\n".format(
            *atom.coord, residue_depth._get_atom_radius(atom)) for atom in self.model.get_atoms()))
        table = self.folder / "depths.csv"
        subprocess.run([MENISCUS, "measure", spheres, "--probe", "1.5", "--per", "atom", "-o", table, "--quiet"],
                       check=True)
        with open(table, newline="") as file:
            return numpy.array([float(row["depth"]) for row in csv.DictReader(file)])

    def test_the_surface_has_a_vertex_per_square_angstrom(self):
        surface = residue_depth.get_surface(self.model)
        self.assertEqual(surface.shape[1], 3)
        self.assertGreater(len(surface), 3400)
        self.assertLess(len(surface), 4200)

    def test_depths_of_residues_are_those_that_are_measured(self):
        depths = residue_depth.ResidueDepth(self.model)
        measured = self.measured_depths()
        first = 0
        differences = []
        for residue in self.model["A"]:
            count = len(residue.get_unpacked_list())
            by_vertices, of_alpha = depths["A", residue.id]
            differences.append(by_vertices - measured[first:first + count].mean())
            self.assertGreater(of_alpha, 1.0)
            first += count
        self.assertEqual(first, len(measured))
        # Vertices are no nearer than the surface, and at most half an edge farther.
        self.assertGreater(min(differences), -0.01)
        self.assertLess(max(differences), 0.5)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])

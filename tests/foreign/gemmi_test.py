#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""gemmi reads the copies of a structure with a value in the place of the B factor.

usage: gemmi_test.py PROGRAM SOURCE_DIR
"""
import csv

import foreign


def atoms_of(path):
    import gemmi

    return [(chain.name, residue.name, residue.seqid.num, atom.name, atom.element.name, atom.pos.tolist(), atom.b_iso)
            for chain in gemmi.read_structure(str(path))[0] for residue in chain for atom in residue]


class Copies(foreign.ForeignTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.meniscus("measure", foreign.UBIQUITIN, "--value", "ses", "-o", "a.pdb", "-o", "a.cif", "--per", "atom",
                     "-o", "a.csv")
        with open(cls.folder / "a.csv", encoding="utf-8", newline="") as file:
            cls.rows = list(csv.DictReader(file))

    def test_atoms_and_values_are_those_of_the_table(self):
        for name, digits in (("a.pdb", 0.00501), ("a.cif", 0.00051)):
            atoms = atoms_of(self.folder / name)
            self.assertEqual(len(atoms), len(self.rows), name)
            for (chain, residue, number, atom, _, _, value), row in zip(atoms, self.rows, strict=True):
                self.assertEqual((chain, residue, number, atom),
                                 (row["chain"], row["resname"], int(row["resnum"]), row["name"]), name)
                self.assertAlmostEqual(value, float(row["ses_area"]), delta=digits, msg=name)

    def test_they_stay_where_they_were(self):
        own = {atom[:4]: atom[4:6] for atom in atoms_of(foreign.UBIQUITIN)}
        for name in ("a.pdb", "a.cif"):
            for atom in atoms_of(self.folder / name):
                element, place = own[atom[:4]]
                self.assertEqual(atom[4], element)
                for a, b in zip(place, atom[5], strict=True):
                    self.assertAlmostEqual(a, b, delta=1e-4)


foreign.main(modules=("gemmi",))

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Exact measures, shares of atoms, cavities, tables, signed distances."""
import json
import math
import pathlib
import unittest

import numpy as np
from support import CENTRES, RADII, UBIQUITIN, InScratchFolder, read

import meniscus

SHELL = 5 * np.vstack([np.eye(3), -np.eye(3)])


class Measuring(InScratchFolder):
    def test_two_spheres_have_their_closed_form(self):
        d, r = 2.0, 1.5
        exact = meniscus.measure([[0, 0, 0], [d, 0, 0]], [r, r], probe=0.0)
        self.assertAlmostEqual(exact.sas_area, 4 * math.pi * r * (r + d / 2), 7)
        height = r + d / 2  # of the cap that each keeps
        self.assertAlmostEqual(exact.sas_volume, 2 * math.pi / 3 * height**2 * (3 * r - height), 6)
        self.assertLess(exact.errors["sas_area"], 1e-5)

    def test_shares_of_atoms_sum_to_the_totals(self):
        exact = meniscus.measure(CENTRES, RADII)
        for kind in ("sas", "ses", "contact", "toroidal", "reentrant"):
            shares = getattr(exact, f"atom_{kind}_area")
            self.assertEqual(shares.shape, (4,))
            self.assertAlmostEqual(shares.sum(), getattr(exact, f"{kind}_area"), 8)
            self.assertAlmostEqual(exact.totals[f"{kind}_area"], getattr(exact, f"{kind}_area"), 12)

    def test_columns_are_views_that_cannot_be_written_to(self):
        column = meniscus.measure(CENTRES, RADII).atom_sas_area
        self.assertFalse(column.flags.owndata)
        with self.assertRaises(ValueError):
            column[0] = 1

    def test_depth_is_there_when_asked_for(self):
        self.assertAlmostEqual(meniscus.measure([[0, 0, 0]], [2.0], depth=True).atom_depth[0], 2.0, 8)
        with self.assertRaisesRegex(ValueError, "depth=True"):
            meniscus.measure([[0, 0, 0]], [2.0]).atom_depth

    def test_a_cavity_has_its_size_and_place(self):
        exact = meniscus.measure(SHELL, [4.0] * 6, probe=0.5)
        self.assertEqual([piece.kind for piece in exact.components], ["outer", "cavity"])
        cavity = exact.cavities[0]
        self.assertAlmostEqual(cavity.inscribed_radius, 1.0, 6)
        self.assertTrue(np.allclose(cavity.inscribed_centre, 0, atol=1e-6))
        self.assertTrue(np.allclose(cavity.centre, 0, atol=1e-6))
        self.assertEqual(cavity.atoms.tolist(), [0, 1, 2, 3, 4, 5])
        self.assertEqual(cavity.inside_of, 0)
        self.assertGreater(cavity.volume, 4 / 3 * math.pi)
        self.assertEqual(cavity.errors.keys(), exact.errors.keys())
        self.assertTrue(0 < cavity.errors["ses_volume"] < 1e-5 * cavity.volume)

    def test_tables_have_the_columns_of_the_command_line(self):
        exact = meniscus.measure(read(UBIQUITIN))
        table = exact.table("residue")
        self.assertEqual(len(table["resname"]), 76)
        self.assertAlmostEqual(sum(table["ses_area"]), exact.ses_area, 6)
        exact.save("residues.json", per="residue")
        rows = json.loads(pathlib.Path("residues.json").read_text())
        self.assertEqual([row["sas_area"] for row in rows], table["sas_area"])
        self.assertEqual(list(rows[0]), list(table))
        exact.save("atoms.csv")
        self.assertEqual(len(pathlib.Path("atoms.csv").read_text().splitlines()), 603)

    def test_what_makes_no_sense_is_refused(self):
        with self.assertRaisesRegex(ValueError, "per: unknown value 'cell'; choose one of residue, atom, chain, cavity"):
            meniscus.measure(CENTRES, RADII).table("cell")
        with self.assertRaisesRegex(ValueError, "probe"):
            meniscus.measure(CENTRES, RADII, probe=-1)
        with self.assertRaisesRegex(ValueError, "a Structure has its own"):
            meniscus.measure(meniscus.Structure.from_arrays(CENTRES, RADII), RADII)
        with self.assertRaises(OSError):
            meniscus.measure(CENTRES, RADII).save("nosuch/table.csv")

    def test_signed_distances_are_exact_inside(self):
        distances = meniscus.signed_distance(CENTRES, RADII, CENTRES)
        exact = meniscus.measure(CENTRES, RADII, depth=True)
        self.assertTrue(np.allclose(distances, -exact.atom_depth))
        with self.assertRaisesRegex(ValueError, "points: must have shape"):
            meniscus.signed_distance(CENTRES, RADII, [1, 2, 3])

    def test_signed_distances_do_not_depend_on_threads_or_company(self):
        points = np.random.default_rng(1).uniform(-8, 8, (2000, 3))
        one = meniscus.signed_distance(CENTRES, RADII, points, threads=1)
        self.assertTrue(np.array_equal(one, meniscus.signed_distance(CENTRES, RADII, points)))
        alone = [meniscus.signed_distance(CENTRES, RADII, points[i:i + 1])[0] for i in range(50)]
        self.assertTrue(np.array_equal(one[:50], alone))
        with self.assertRaisesRegex(ValueError, "threads"):
            meniscus.signed_distance(CENTRES, RADII, points, threads=-1)


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Arrays as other libraries take them: types of indices, copies that may be written to, depths."""
import importlib.util
import unittest
import warnings

import numpy as np
from support import CENTRES, RADII, UBIQUITIN, InScratchFolder, read

import meniscus


class Arrays(InScratchFolder):
    def setUp(self):
        super().setUp()
        self.surface = meniscus.surface(CENTRES, RADII)

    def test_indices_are_signed(self):
        points = self.surface.sample(1.0)
        exact = self.surface.measures
        compared = meniscus.compare(self.surface, self.surface)
        for array in (self.surface.triangles, self.surface.atom, self.surface.residue, self.surface.component,
                      points.atom, points.residue, points.component, self.surface.structure.residue,
                      exact.components[0].atoms, compared.triangles):
            self.assertEqual(array.dtype, np.int32)
            self.assertGreaterEqual(array.min(), 0)
        self.surface.save("a.npz")
        arrays = np.load("a.npz")
        for name in ("triangles", "atom", "residue", "component", "atom_residue"):
            self.assertEqual(arrays[name].dtype, np.int32, name)

    def test_copies_may_be_written_to_and_views_may_not(self):
        for owner in (self.surface, self.surface.sample(1.0), self.surface.structure):
            for name, array in owner.numpy(copy=True).items():
                self.assertTrue(array.flags.writeable and array.flags.owndata, name)
                self.assertEqual(array.tobytes(), getattr(owner, name).tobytes(), name)
                array[...] = 0
        self.assertTrue(self.surface.area.any())
        self.assertFalse(self.surface.numpy()["vertices"].flags.writeable)
        self.assertTrue(np.shares_memory(self.surface.numpy()["vertices"], self.surface.vertices))
        self.assertTrue(self.surface.triangles.copy().flags.writeable)

    @unittest.skipUnless(importlib.util.find_spec("torch"), "torch is not installed (python3-torch)")
    def test_torch_takes_every_array(self):
        import torch
        exact = self.surface.measures
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for owner in (self.surface, self.surface.sample(1.0), self.surface.structure):
                for name, array in owner.numpy(copy=True).items():
                    tensor = torch.from_numpy(array)
                    self.assertEqual(tensor.shape, array.shape, name)
                    tensor += 1
            for array in (exact.components[0].atoms, exact.atom_sas_area, self.surface.depth, self.surface.colors()):
                torch.from_numpy(array.copy())

    def test_depth_is_kept_and_saved(self):
        depth = self.surface.depth
        self.assertEqual((depth.dtype, depth.shape), (np.float32, (len(self.surface.vertices),)))
        self.assertIs(depth, self.surface.depth)
        below = -meniscus.signed_distance(CENTRES, RADII, self.surface.vertices, probe=10.0)
        self.assertTrue(np.allclose(depth, np.maximum(below, 0), atol=1e-6))
        for options in ({"color": "depth"}, {"values": {"depth": depth}}, {"color": "depth", "values": {"depth": depth}}):
            self.surface.save("a.npz", **options)
            self.assertEqual(np.load("a.npz")["depth"].tobytes(), depth.tobytes())
        self.surface.save("a.ply", color="depth")
        self.surface.save("b.ply", color="depth", values={"depth": depth})
        with open("a.ply", "rb") as one, open("b.ply", "rb") as other:
            self.assertEqual(one.read(), other.read())

    def test_one_colour_has_a_name(self):
        for color in ("tomato", "Tomato", "#ff6347"):
            self.assertEqual(np.unique(self.surface.colors(color), axis=0).tolist(), [[255, 99, 71, 255]])
        gold = np.zeros(len(self.surface.vertices))
        self.assertEqual(len(np.unique(self.surface.colors("gold", values={"gold": gold}), axis=0)), 1)
        self.assertNotEqual(self.surface.colors("gold", values={"gold": gold})[0].tolist(), [255, 215, 0, 255])
        with self.assertRaisesRegex(meniscus.UsageError, "or a colour such as tomato"):
            self.surface.colors("tomatoe")
        self.surface.save("a.png", color="navy", background="ivory", size=(64, 48))
        self.surface.save("a.html", color="navy")


class Paths(unittest.TestCase):
    def test_a_path_is_read(self):
        import pathlib
        protein = read(UBIQUITIN)
        exact = meniscus.measure(protein)
        for path in (UBIQUITIN, pathlib.Path(UBIQUITIN)):
            self.assertEqual(meniscus.measure(path).totals, exact.totals)
        self.assertEqual(meniscus.measure(UBIQUITIN, "bondi").structure.radii_set, "bondi")
        surface = meniscus.surface(UBIQUITIN, spacing=1.0)
        self.assertEqual(surface.structure.file, UBIQUITIN)
        self.assertEqual(surface.vertices.tobytes(), meniscus.surface(protein, spacing=1.0).vertices.tobytes())
        self.assertGreater(meniscus.signed_distance(UBIQUITIN, points=[[0, 0, 0]])[0], 20)

    def test_what_is_wrong_is_told_as_by_read(self):
        with self.assertRaises(FileNotFoundError):
            meniscus.surface("no-such-file.pdb")
        with self.assertRaisesRegex(meniscus.UsageError, "numbers go with an array"):
            meniscus.measure(UBIQUITIN, [1.0, 2.0])


class Interfaces(InScratchFolder):
    def setUp(self):
        super().setUp()
        self.structure = meniscus.Structure.from_arrays(
            [[0, 0, 0], [3, 0, 0], [6, 0, 0], [9, 0, 0]], 1.7, chain=["A", "B", "B", "C"],
            resname=["GLY", "GLY", "HEM", "GLY"], resnum=[1, 2, 3, 4])

    def test_two_spheres_bury_their_caps(self):
        two = meniscus.Structure.from_arrays([[0, 0, 0], [3, 0, 0]], 1.7, chain=["A", "B"])
        (found,) = meniscus.measure(two, between=("A", "B")).interfaces
        self.assertAlmostEqual(found.buried_sas, 2 * 2 * np.pi * 3.1 * (3.1 - 1.5), 5)
        self.assertAlmostEqual(found.interface_area, found.buried_sas / 2, 12)
        self.assertAlmostEqual(found.atom_buried_sas_a[0], found.buried_sas / 2, 5)
        self.assertEqual((found.a, found.b), (("A",), ("B",)))
        self.assertLess(found.errors["buried_sas"], 1e-4)

    def test_all_forms_of_a_pair(self):
        def names(between):
            return [(i.a, i.b) for i in meniscus.measure(self.structure, between=between).interfaces]
        one = [(("A",), ("B",))]
        for between in (("A", "B"), "A:B", ["A", "B"], [("A", "B")], ["A:B"], (["A"], ["B"])):
            self.assertEqual(names(between), one, between)
        self.assertEqual(names(("A,C", "B")), [(("A", "C"), ("B",))])
        self.assertEqual(names((["A", "C"], "B")), [(("A", "C"), ("B",))])
        self.assertEqual(names([("A", "B"), ("B", "C")]), one + [(("B",), ("C",))])
        self.assertEqual(names(("A:B", "B:C")), one + [(("B",), ("C",))])
        self.assertEqual(names("all"), one + [(("B",), ("C",))])
        for between in ("A", ("A", "B", "C"), ("A", ""), "A:B:C", ("A", "A"), ("A", "X")):
            with self.assertRaisesRegex(meniscus.UsageError, "^between: ", msg=between):
                meniscus.measure(self.structure, between=between)

    def test_a_ligand_may_be_a_partner(self):
        (found,) = meniscus.measure(self.structure, between=("B", "(HEM)")).interfaces
        self.assertEqual((found.atoms_a.tolist(), found.atoms_b.tolist()), ([1], [2]))
        (found,) = meniscus.measure(self.structure, between="A,C:B(HEM)").interfaces
        self.assertEqual((found.atoms_a.tolist(), found.atoms_b.tolist()), ([0, 3], [2]))
        with self.assertRaisesRegex(meniscus.UsageError, 'between: .* hetero="ligands"'):
            meniscus.measure(self.structure, between=("A", "(NAG)"))

    def test_tables_are_those_of_the_command_line(self):
        exact = meniscus.measure(self.structure, between=[("A", "B"), ("B", "C")])
        rows = exact.interface_table("residue")
        self.assertEqual(rows["interface"], ["A:B"] * 3 + ["B:C"] * 3)
        self.assertEqual(rows["resnum"], [1, 2, 3, 2, 3, 4])
        self.assertAlmostEqual(sum(rows["buried_sas"][:3]), exact.interfaces[0].buried_sas, 8)
        self.assertEqual(len(exact.interface_table("chain")["chain"]), 4)
        exact.save_interfaces("t.csv", per="atom")
        values = meniscus.surface(self.structure).table_values("t.csv")
        self.assertIn("buried_sas_A_B", values)
        with self.assertRaisesRegex(meniscus.UsageError, "between=\\('A', 'B'\\)"):
            meniscus.measure(self.structure).interface_table()


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Arrays as other libraries take them: types of indices, copies that may be written to, depths."""
import importlib.util
import inspect
import os
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

    def test_depth_is_an_array_as_others_when_asked_for(self):
        depth = self.surface.depth
        self.assertNotIn("depth", self.surface.numpy())
        for arrays in ("depth", ["depth"]):
            self.assertEqual(self.surface.numpy(copy=True, arrays=arrays)["depth"].tobytes(), depth.tobytes())
        self.surface.save("a.npz", arrays="depth", color="patch")
        self.assertEqual(np.load("a.npz")["depth"].tobytes(), depth.tobytes())
        points = self.surface.sample()
        self.assertEqual(points.numpy(arrays="depth")["depth"].tobytes(), points.depth.tobytes())
        points.save("p.npz", arrays="depth")
        self.assertEqual(np.load("p.npz")["depth"].tobytes(), points.depth.tobytes())
        for call in (self.surface.numpy, points.numpy, lambda arrays: self.surface.save("x.ply", arrays=arrays)):
            with self.assertRaisesRegex(meniscus.UsageError, "arrays: unknown value 'width'; choose one of depth"):
                call(arrays="width")
        with self.assertRaisesRegex(meniscus.UsageError, "'depth' is also the name of values"):
            self.surface.save("x.ply", arrays="depth", values={"depth": depth})

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


class Paths(InScratchFolder):
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

    def test_keywords_of_reading_go_with_a_path(self):
        wet = {"waters": True, "select": "//A/1-20", "hydrogens": "drop"}
        count = len(read(UBIQUITIN, **wet))
        self.assertEqual(len(meniscus.measure(UBIQUITIN, "bondi", **wet).structure), count)
        self.assertEqual(len(meniscus.surface(UBIQUITIN, spacing=1.0, **wet).structure), count)
        dry = meniscus.signed_distance(read(UBIQUITIN), points=[[30, 30, 30]])
        self.assertEqual(meniscus.signed_distance(UBIQUITIN, points=[[30, 30, 30]], waters=False), dry)
        part = read(UBIQUITIN, select="//A/1-20")
        found = meniscus.compare(UBIQUITIN, part, select="//A/1-20", spacing=1.0)
        self.assertLess(found.hausdorff, 0.01)

    def test_keywords_of_reading_go_with_nothing_else(self):
        protein = read(UBIQUITIN)
        for call in (lambda **reading: meniscus.surface(protein, **reading),
                     lambda **reading: meniscus.measure(CENTRES, RADII, **reading),
                     lambda **reading: meniscus.signed_distance(CENTRES, RADII, [[0, 0, 0]], **reading),
                     lambda **reading: meniscus.compare(protein, protein, **reading)):
            with self.assertRaisesRegex(TypeError, r"waters is an argument of read\(\); it applies where the path"):
                call(waters=True)
            with self.assertRaisesRegex(TypeError, "unexpected keyword argument 'watters'"):
                call(watters=True)
        with self.assertRaisesRegex(TypeError, "unexpected keyword argument 'watters'"):
            meniscus.measure(UBIQUITIN, watters=True)

    def test_they_are_described_once(self):
        from meniscus import _reading
        options = set(inspect.signature(meniscus.ReadOptions).parameters)
        self.assertEqual(options, set(_reading.ReadingOfFile.__annotations__))
        self.assertEqual(options - {"radii"} | {"frame"}, set(_reading.Reading.__annotations__))
        self.assertEqual(options | {"path", "options", "format", "name"}, set(inspect.signature(meniscus.read).parameters))

    def test_warnings_of_reading_name_the_line_of_the_caller(self):
        with open("odd.pqr", "w", encoding="ascii") as file:
            file.write("ATOM 1 N ALA 1 0 0 0 0 1.5\nATOM 2 O HOH 2 5 0 0 0 1.5\n")
        for call in (lambda: meniscus.measure("odd.pqr"), lambda: meniscus.surface("odd.pqr"),
                     lambda: meniscus.compare("odd.pqr", "odd.pqr"), lambda: meniscus.read("odd.pqr")):
            with self.assertWarns(meniscus.ReadWarning) as caught:
                call()
            self.assertEqual(os.path.basename(caught.filename), "test_arrays.py")

    def test_what_is_no_atoms_is_called_by_its_type(self):
        surface = meniscus.surface(CENTRES, RADII)
        for atoms, name in ((None, "NoneType"), (b"1ubq.pdb", "bytes"), (3.0, "float")):
            for call in (meniscus.surface, meniscus.measure):
                with self.assertRaisesRegex(TypeError, f"atoms: must be a Structure, .* not {name}$"):
                    call(atoms)
        for atoms, name in ((surface, "Surface"), (surface.measures, "Measures"), (surface.sample(), "Points")):
            with self.assertRaisesRegex(TypeError, f"not {name}; its atoms are its .structure"):
                meniscus.measure(atoms)


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
        for between in ("chain A:chain B", ("chain A", "B"), ["chain A:B"]):
            self.assertEqual(names(between), one, between)
        self.assertEqual(names("chain A+C:B"), [(("A", "C"), ("B",))])
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

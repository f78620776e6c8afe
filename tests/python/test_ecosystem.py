# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Arrays of other libraries, tables of pandas, meshes of trimesh and PyVista, sums over selections."""
import importlib.util
import pickle
import sys
import types
import unittest
import unittest.mock
import warnings

import numpy as np
from support import CENTRES, RADII, UBIQUITIN, read

import meniscus


class OnlyDLPack:
    """An array of a library that has DLPack and nothing else."""

    def __init__(self, array, device=1):
        self.array = np.array(array)
        self.device = device

    def __dlpack__(self, *, stream=None):
        return self.array.__dlpack__()

    def __dlpack_device__(self):
        return (self.device, 0)


class OnlyArray:
    def __init__(self, array):
        self.array = np.array(array)

    def __array__(self, dtype=None):
        return np.asarray(self.array, dtype)


class Arrays(unittest.TestCase):
    def test_come_in(self):
        wanted = meniscus.measure(CENTRES, RADII).ses_area
        for kind in (OnlyDLPack, OnlyArray):
            for dtype in (np.float64, np.float32):
                xyz, radii = kind(np.array(CENTRES, dtype)), kind(np.array(RADII, dtype))
                self.assertAlmostEqual(meniscus.measure(xyz, radii).ses_area, wanted, 4)
            exact = meniscus.ExactSurface(CENTRES, RADII)
            self.assertEqual(len(exact.signed_distance(kind(CENTRES))), 4)
            surface = exact.mesh(spacing=1.0)
            self.assertEqual(len(surface.colors("phi", {"phi": kind(surface.area)})), len(surface.vertices))
            self.assertEqual(len(exact.measures.sum(kind([0, 2]))), 2)
            made = meniscus.Structure.from_arrays(kind(CENTRES), kind(RADII), resnum=kind([1, 1, 2, 2]))
            self.assertEqual(made.residue.tolist(), [0, 0, 1, 1])

    def test_of_another_device_are_refused(self):
        with self.assertRaisesRegex(meniscus.UsageError, "xyz: lies in the memory of another device; copy it"):
            meniscus.measure(OnlyDLPack(CENTRES, device=2), RADII)

    def test_come_out(self):
        exact = meniscus.ExactSurface(CENTRES, RADII)
        surface = exact.mesh(spacing=1.0)
        for array in (exact.signed_distance(CENTRES), surface.level_set(CENTRES), surface.gradient(CENTRES),
                      meniscus.radii(["C", "N"]), *surface.numpy(copy=True).values(),
                      *surface.sample().numpy(copy=True).values(), *surface.structure.numpy(copy=True).values()):
            again = np.from_dlpack(OnlyDLPack(array))
            self.assertEqual(again.tobytes(), array.tobytes())
            self.assertTrue(array.flags.writeable)
            self.assertEqual(np.from_dlpack(array).shape, array.shape)

    @unittest.skipUnless(importlib.util.find_spec("torch"), "python3-torch (section full of packages.txt) is not installed")
    def test_of_torch(self):
        import torch
        exact = meniscus.ExactSurface(torch.tensor(CENTRES), torch.tensor(RADII, dtype=torch.float32))
        points = torch.rand(5, 3, dtype=torch.float64)
        distances = torch.from_dlpack(exact.signed_distance(points))
        self.assertEqual((distances.shape, distances.dtype), ((5,), torch.float64))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for name, array in exact.mesh(spacing=1.0).numpy(copy=True).items():
                self.assertEqual(torch.from_dlpack(array).numpy().tobytes(), array.tobytes(), name)
        with self.assertRaisesRegex(meniscus.UsageError, r"xyz: .*detach\(\)"):
            meniscus.measure(torch.tensor(CENTRES, requires_grad=True), RADII)


class Stored:
    """A stand-in that keeps what it was made of."""

    def __init__(self, *arguments, **keywords):
        self.arguments, self.keywords = arguments, keywords
        self.point_data = {}


class Exports(unittest.TestCase):
    def setUp(self):
        self.surface = meniscus.surface(CENTRES, RADII, spacing=1.0)

    def with_package(self, name, **members):
        module = types.ModuleType(name)
        vars(module).update(members)
        return unittest.mock.patch.dict(sys.modules, {name: module})

    def test_trimesh(self):
        """trimesh.Trimesh(vertices, faces, vertex_normals, vertex_colors, vertex_attributes, process)."""
        surface = self.surface
        with self.with_package("trimesh", Trimesh=Stored):
            made = surface.to_trimesh("patch", arrays="depth").keywords
            one = surface.to_trimesh(np.zeros((len(surface.vertices), 3), np.uint8)).keywords
        self.assertIs(made["process"], False)
        for name, wanted in (("vertices", surface.vertices), ("faces", surface.triangles),
                             ("vertex_normals", surface.normals), ("vertex_colors", surface.colors("patch"))):
            self.assertEqual(made[name].tobytes(), wanted.tobytes())
            self.assertTrue(made[name].flags.writeable)
        self.assertEqual(made["vertex_attributes"]["depth"].tobytes(), surface.depth.tobytes())
        self.assertIn("atom", made["vertex_attributes"])
        self.assertEqual(one["vertex_colors"].shape, (len(surface.vertices), 3))

    def test_pyvista(self):
        """pyvista.PolyData(points, faces), point_data by name."""
        surface = self.surface
        with self.with_package("pyvista", PolyData=Stored):
            made = surface.to_pyvista("patch")
            plain = surface.to_pyvista()
        points, faces = made.arguments
        self.assertEqual(points.tobytes(), surface.vertices.tobytes())
        rows = faces.reshape(-1, 4)
        self.assertTrue((rows[:, 0] == 3).all())
        self.assertTrue((rows[:, 1:] == surface.triangles).all())
        self.assertEqual(made.point_data["Normals"].shape, surface.vertices.shape)
        self.assertEqual(made.point_data["colors"].tobytes(), surface.colors("patch").tobytes())
        self.assertNotIn("colors", plain.point_data)

    @unittest.skipUnless(importlib.util.find_spec("vtkmodules"), "python3-vtk9 (section full) is not installed")
    def test_faces_are_as_vtk_has_them(self):
        from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonDataModel import vtkCellArray
        with self.with_package("pyvista", PolyData=Stored):
            faces = self.surface.to_pyvista().arguments[1]
        cells = vtkCellArray()
        cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(faces, deep=True))
        self.assertEqual(cells.GetNumberOfCells(), len(self.surface.triangles))

    @unittest.skipUnless(importlib.util.find_spec("pandas"), "pandas is not installed")
    def test_pandas(self):
        surface, points = self.surface, self.surface.sample()
        table = surface.to_pandas(arrays="depth")
        self.assertEqual(table[["x", "y", "z"]].to_numpy().tobytes(), np.ascontiguousarray(surface.vertices).tobytes())
        self.assertEqual(table["depth"].dtype, np.float32)
        self.assertEqual(len(points.to_pandas()), len(points))
        protein = read(UBIQUITIN)
        exact = meniscus.measure(protein)
        for per, rows in (("atom", 602), ("residue", 76), ("chain", 1), ("cavity", 0)):
            made = exact.to_pandas(per)
            self.assertEqual((len(made), list(made)), (rows, list(exact.table(per))))
        self.assertAlmostEqual(exact.to_pandas("residue")["ses_area"].sum(), exact.ses_area, 6)
        self.assertEqual(protein.to_pandas().groupby("resname").size()["MET"], 8)

    def test_what_is_not_installed_is_named(self):
        calls = {"trimesh": self.surface.to_trimesh, "pyvista": self.surface.to_pyvista, "pandas": self.surface.to_pandas}
        for package, call in calls.items():
            with unittest.mock.patch.dict(sys.modules, {package: None}):
                with self.assertRaisesRegex(ImportError, f"{call.__name__}.. needs .*; install it: pip install {package}"):
                    call()


class Sums(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.protein = read(UBIQUITIN)
        cls.exact = meniscus.measure(cls.protein)

    def test_of_every_kind_of_selection(self):
        protein, exact = self.protein, self.exact
        mask = (protein.resnum >= 10) & (protein.resnum <= 50)
        indices = np.flatnonzero(mask)
        wanted = exact.atom_sas_area[mask].sum()
        for selection in ("chain A and resi 10-50", "//A/10-50", mask, mask.tolist(), indices, indices[::-1],
                          np.repeat(indices, 2), indices - len(protein)):
            found = exact.sum(selection)
            self.assertEqual(found.atoms.tolist(), indices.tolist())
            self.assertAlmostEqual(found.sas_area, wanted, 9)
            self.assertEqual(len(found), mask.sum())

    def test_parts_add_up(self):
        exact = self.exact
        parts = [exact.sum(self.protein.residue == r) for r in range(76)]
        for name in ("sas_area", "ses_area", "contact_area", "toroidal_area", "reentrant_area"):
            self.assertAlmostEqual(sum(getattr(part, name) for part in parts), exact.totals[name], 6)
            self.assertAlmostEqual(getattr(exact.sum(np.ones(602, bool)), name), exact.totals[name], 6)
        rows = exact.table("residue")
        self.assertAlmostEqual(parts[3].ses_area, rows["ses_area"][3], 6)
        self.assertEqual(exact.sum([]).sas_area, 0.0)
        self.assertAlmostEqual(parts[3].contact_area + parts[3].toroidal_area + parts[3].reentrant_area, parts[3].ses_area, 9)

    def expect_same_within_errors(self, one, other):
        for name, error in one.errors.items():
            self.assertLessEqual(abs(getattr(one, name) - getattr(other, name)), error + other.errors[name], name)

    def test_errors_cover_another_position_of_the_molecule(self):
        """Turned, the molecule has the same areas but other rounding and perturbations."""
        turn = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
        for kind in ("ses", "sas", "vdw"):
            exact = meniscus.ExactSurface(self.protein, surface=kind).measures
            turned = meniscus.ExactSurface(self.protein.xyz @ turn.T, self.protein.radii, surface=kind).measures
            for first in range(0, 600, 100):
                one, other = exact.sum(range(first, first + 100)), turned.sum(range(first, first + 100))
                self.expect_same_within_errors(one, other)
                self.assertLess(max(one.errors.values()), 1e-3)

    def test_errors_are_large_where_the_shares_are_arbitrary(self):
        """Between the eight atoms of a cube, probe positions coincide."""
        cube = 3.2 * np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
        turn = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
        exact, turned = meniscus.measure(cube, 1.7), meniscus.measure(cube @ turn.T, 1.7)
        self.assertTrue(exact.degenerate)
        for atom in range(8):
            self.expect_same_within_errors(exact.sum([atom]), turned.sum([atom]))
        self.assertGreater(max(exact.sum([atom]).errors["reentrant_area"] for atom in range(8)), 0.5)
        self.assertLess(exact.sum(np.arange(8)).errors["reentrant_area"], 1e-6)

    def test_what_makes_no_sense(self):
        for selection, message in (("chain Z", "selects nothing|no atoms|none"), ([True, False], "a mask of 2 entries for 602"),
                                   ([602], "an index is out of range; there are 602 atoms"), ([0.5], "must be an expression"),
                                   ([[1, 2]], "must be an expression"), (3, "must be an expression")):
            with self.assertRaisesRegex(meniscus.UsageError, message):
                self.exact.sum(selection)
        with self.assertRaisesRegex(meniscus.UsageError, "not valid|understood|select"):
            self.exact.sum("resi and and")

    @unittest.skipUnless(importlib.util.find_spec("MDAnalysis"), "MDAnalysis is not installed")
    def test_of_atoms_of_mdanalysis(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            import MDAnalysis
            universe = MDAnalysis.Universe(UBIQUITIN)
        exact = meniscus.measure(universe.select_atoms("protein"))
        charged = universe.select_atoms("resname LYS ARG ASP GLU or resname HOH")
        wanted = self.exact.atom_sas_area[np.isin(self.protein.resname, ["LYS", "ARG", "ASP", "GLU"])].sum()
        self.assertAlmostEqual(exact.sum(charged).sas_area, wanted, 3)
        self.assertAlmostEqual(exact.sum(charged.residues).sas_area, wanted, 3)
        with self.assertRaisesRegex(meniscus.UsageError, "atoms of MDAnalysis go with a structure made of"):
            self.exact.sum(charged)

    @unittest.skipUnless(importlib.util.find_spec("MDAnalysis"), "MDAnalysis is not installed")
    def test_of_atoms_of_another_universe(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            import MDAnalysis
            first, same = MDAnalysis.Universe(UBIQUITIN), MDAnalysis.Universe(UBIQUITIN)
            other = MDAnalysis.Merge(first.atoms[::-1])
            larger = MDAnalysis.Merge(first.atoms, first.atoms[:1])
        exact = meniscus.measure(first.select_atoms("protein"), cavities=False)
        again = pickle.loads(pickle.dumps(exact))
        for universe in (first, same, first.copy()):
            for measures in (exact, again):
                self.assertEqual(measures.sum(universe.select_atoms("resname LYS")).sas_area, exact.sum("resn LYS").sas_area)
        self.assertEqual(len(exact.sum(first.atoms[0])), 1)
        for universe in (other, larger):
            for measures in (exact, again):
                with self.assertRaisesRegex(meniscus.UsageError, "a structure made of atoms of the same universe"):
                    measures.sum(universe.atoms[:5])
        first.atoms.names = ["X"] * len(first.atoms)
        self.assertEqual(len(exact.sum(first.atoms[:5])), 5, "the same universe, whatever its names")
        bare = MDAnalysis.Universe.empty(len(first.atoms), trajectory=True)
        with self.assertRaisesRegex(meniscus.UsageError, "the same universe"):
            exact.sum(bare.atoms[:5])

    def test_of_nothing_that_selects(self):
        for selection, kind in ((self.protein, "Structure"), (types.SimpleNamespace(atoms=3), "SimpleNamespace"), ({1}, "set")):
            with self.assertRaisesRegex(meniscus.UsageError, f"or atoms of MDAnalysis, not {kind}"):
                self.exact.sum(selection)
        for masked in (np.ma.array([1, 2], mask=[0, 1]), np.ma.array(np.ones(602, bool), mask=self.protein.residue == 0)):
            with self.assertRaisesRegex(meniscus.UsageError, "selection: some entries are masked"):
                self.exact.sum(masked)
        self.assertEqual(len(self.exact.sum(np.ma.array([1, 2]))), 2)


if __name__ == "__main__":
    unittest.main()

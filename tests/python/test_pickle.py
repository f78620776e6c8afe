# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Pickles and copies: the same numbers, to the bit; no pickle of another version."""
import copy
import pickle
import unittest

import numpy as np
from support import CENTRES, RADII, UBIQUITIN, read

import meniscus

ARRAYS = ("vertices", "triangles", "normals", "atom", "residue", "patch", "component", "area", "mean_curvature",
          "gaussian_curvature", "shape_index", "depth")


def through_a_pickle(value):
    return pickle.loads(pickle.dumps(value))


WAYS = (through_a_pickle, copy.deepcopy, copy.copy)


class Pickles(unittest.TestCase):
    def same_arrays(self, a, b, names):
        for name in names:
            self.assertEqual(getattr(a, name).tobytes(), getattr(b, name).tobytes(), name)
            self.assertEqual(getattr(a, name).dtype, getattr(b, name).dtype, name)

    def test_structures(self):
        protein = read(UBIQUITIN)
        for way in WAYS:
            again = way(protein)
            self.same_arrays(again, protein, ("xyz", "radii", "element", "name", "chain", "resname", "resnum", "icode",
                                              "residue", "altloc", "serial", "b_factor", "occupancy", "charge"))
            for name in ("file", "stem", "sha256", "radii_set", "dropped", "ligands", "notes", "warnings"):
                self.assertEqual(getattr(again, name), getattr(protein, name), name)

    def test_measures(self):
        structure = meniscus.Structure.from_arrays(CENTRES, RADII, chain=["A", "A", "B", "B"])
        exact = meniscus.measure(structure, depth=True, between=("A", "B"))
        for way in WAYS:
            again = way(exact)
            self.assertEqual((again.totals, again.errors, again.probe), (exact.totals, exact.errors, exact.probe))
            self.same_arrays(again, exact, ("atom_sas_area", "atom_ses_area", "atom_depth"))
            self.assertEqual(again.components, exact.components)
            self.assertEqual(again.components[0].atoms.tolist(), exact.components[0].atoms.tolist())
            self.assertEqual(again.interfaces, exact.interfaces)
            self.assertEqual(again.table("residue"), exact.table("residue"))
            self.assertEqual(again.interface_table("atom"), exact.interface_table("atom"))
        self.assertEqual(through_a_pickle(exact.components[0]), exact.components[0])
        self.assertEqual(through_a_pickle(exact.interfaces[0]), exact.interfaces[0])

    def test_surfaces_of_every_method(self):
        for options in ({"history": True, "verify": True}, {"method": "direct"}, {"method": "gaussian"},
                        {"edge": 1.0, "quality": True, "two_sided_distance": True}, {"fill_cavities": 10.0}):
            surface = meniscus.surface(CENTRES, RADII, **options)
            surface.measures
            for way in WAYS:
                again = way(surface)
                self.same_arrays(again, surface, ARRAYS)
                for name in ("mesh", "flow", "checks", "options", "passed"):
                    self.assertEqual(getattr(again, name), getattr(surface, name), name)
                self.assertEqual(again.measures.totals, surface.measures.totals)
                places = surface.vertices + 0.3
                self.assertEqual(again.level_set(places).tobytes(), surface.level_set(places).tobytes())
                self.assertEqual(again.gradient(places).tobytes(), surface.gradient(places).tobytes())
                self.assertEqual(again.sample(1.0, seed=3).points.tobytes(), surface.sample(1.0, seed=3).points.tobytes())

    def test_a_structure_that_several_share_stays_one(self):
        surface = meniscus.surface(CENTRES, RADII)
        surface.measures
        again, structure = through_a_pickle((surface, surface.structure))
        self.assertIs(again.structure, structure)
        self.assertIs(again.measures.structure, structure)
        self.assertIs(again.structure._core, structure._core)

    def test_every_protocol(self):
        surface = meniscus.surface(CENTRES, RADII, spacing=1.0)
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            for thing in (surface.structure, surface.exact, surface, surface.measures):
                self.assertEqual(repr(pickle.loads(pickle.dumps(thing, protocol))), repr(thing), protocol)

    def test_points(self):
        points = meniscus.surface(CENTRES, RADII).sample(2.0)
        for way in WAYS:
            self.same_arrays(way(points), points, ("points", "normals", "atom", "residue", "area", "depth"))

    def test_a_pickle_is_not_much_larger_than_its_arrays(self):
        surface = meniscus.surface(read(UBIQUITIN), method="direct")
        arrays = sum(array.nbytes for array in surface.numpy().values())
        self.assertLess(len(pickle.dumps(surface)), 1.2 * arrays)

    def test_one_of_another_version_is_refused(self):
        for value in (read(UBIQUITIN), meniscus.measure(CENTRES, RADII), meniscus.surface(CENTRES, RADII)):
            text = pickle.dumps(value)
            version = meniscus.__version__.encode()
            other = bytes([version[0] + 7]) + version[1:]
            self.assertIn(version, text)
            with self.assertRaisesRegex(meniscus.InputError, "pickled by Meniscus .* reads pickles of its own only"):
                pickle.loads(text.replace(version, other))

    def test_one_that_was_cut_off_is_refused(self):
        core = meniscus.measure(CENTRES, RADII)._core
        state = core.__getstate__()
        for size in (0, 10, len(state) // 2, len(state) - 1):
            again = type(core).__new__(type(core))
            with self.assertRaisesRegex(meniscus.InputError, "cut off"):
                again.__setstate__(state[:size])


if __name__ == "__main__":
    unittest.main()

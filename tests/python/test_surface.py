# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Surfaces: arrays, level set, closed forms, options, what is refused."""
import gc
import math
import unittest
import warnings

import numpy as np
from support import CENTRES, RADII, UBIQUITIN, read

import meniscus

ARRAYS = {"vertices": np.float64, "normals": np.float64, "triangles": np.int32, "atom": np.int32,
          "patch": np.uint8, "component": np.int32, "area": np.float32, "mean_curvature": np.float32,
          "gaussian_curvature": np.float32, "shape_index": np.float32}


class Arrays(unittest.TestCase):
    def setUp(self):
        self.surface = meniscus.surface(CENTRES, RADII)

    def test_types_and_shapes_are_as_documented(self):
        n = len(self.surface.vertices)
        for name, dtype in ARRAYS.items():
            array = getattr(self.surface, name)
            self.assertEqual(array.dtype, dtype, name)
            self.assertTrue(array.flags.c_contiguous, name)
            if name != "triangles":
                self.assertEqual(len(array), n, name)
        self.assertEqual(self.surface.vertices.shape, (n, 3))
        self.assertEqual(self.surface.triangles.shape, (2 * n - 4, 3))

    def test_they_are_views_of_one_memory_that_cannot_be_written_to(self):
        for name in ARRAYS:
            array = getattr(self.surface, name)
            self.assertTrue(np.shares_memory(array, getattr(self.surface, name)), name)
            self.assertFalse(array.flags.owndata, name)
            with self.assertRaises(ValueError):
                array[0] = 0

    def test_they_keep_the_surface_alive(self):
        vertices = self.surface.vertices
        copy = vertices.copy()
        del self.surface
        gc.collect()
        meniscus.surface(np.array(CENTRES) + 1.0, RADII)  # would overwrite memory that is free
        self.assertTrue((vertices == copy).all())

    def test_vertex_areas_sum_to_that_of_the_mesh(self):
        self.assertAlmostEqual(float(self.surface.area.sum(dtype=np.float64)) / self.surface.mesh["area"], 1.0, 5)

    def test_patches_have_their_curvatures(self):
        surface = meniscus.surface(CENTRES, RADII, method="direct", spacing=0.3)
        contact = surface.patch == 0
        radii = np.array(RADII)[surface.atom[contact]]
        self.assertTrue(np.allclose(surface.mean_curvature[contact], 1 / radii, atol=1e-6))
        self.assertTrue(np.allclose(surface.mean_curvature[surface.patch == 2], -1 / 1.4, atol=1e-6))


class ClosedForms(unittest.TestCase):
    def test_one_sphere(self):
        ball = meniscus.surface([[0.1, 0.2, 0.3]], [2.0], spacing=0.25)
        self.assertTrue(np.allclose(np.linalg.norm(ball.vertices - [0.1, 0.2, 0.3], axis=1), 2.0, atol=2e-3))
        self.assertTrue(np.allclose(ball.normals, (ball.vertices - [0.1, 0.2, 0.3]) / 2.0, atol=5e-3))
        self.assertAlmostEqual(ball.mesh["corrected_area"] / (16 * math.pi), 1.0, 3)
        self.assertAlmostEqual(ball.measures.ses_area, 16 * math.pi, 7)
        self.assertAlmostEqual(ball.measures.ses_volume, 32 / 3 * math.pi, 7)
        self.assertAlmostEqual(ball.measures.sas_area, 4 * math.pi * 3.4**2, 7)

    def test_two_spheres_without_a_probe(self):
        distance, radius = 2.0, 1.5
        surface = meniscus.surface([[0, 0, 0], [distance, 0, 0]], [radius, radius], probe=0.0)
        area = 2 * 2 * math.pi * radius * (radius + distance / 2)
        self.assertAlmostEqual(surface.measures.ses_area, area, 7)
        self.assertAlmostEqual(surface.mesh["corrected_area"] / area, 1.0, delta=0.03)

    def test_the_level_set_is_a_distance_near_the_surface(self):
        ball = meniscus.surface([[0, 0, 0]], [2.0])
        points = np.outer(np.linspace(1.6, 2.4, 9), [0.6, 0.0, 0.8])
        self.assertTrue(np.allclose(ball.level_set(points), np.linspace(-0.4, 0.4, 9), atol=0.01))
        self.assertTrue(np.allclose(ball.gradient(points), [0.6, 0.0, 0.8], atol=0.02))
        self.assertTrue(np.isnan(ball.level_set([[0, 0, 100]])).all())
        self.assertTrue(np.isnan(ball.gradient([[0, 0, 100]])).all())

    def test_without_a_level_set_it_is_the_exact_distance(self):
        ball = meniscus.surface([[0, 0, 0]], [2.0], method="direct")
        points = [[0, 0, 100], [1, 0, 0]]
        self.assertTrue(np.allclose(ball.level_set(points), [98, -1]))
        self.assertTrue(np.allclose(ball.level_set(points), meniscus.signed_distance([[0, 0, 0]], [2.0], points)))
        self.assertTrue(np.allclose(ball.gradient(points), [[0, 0, 1], [1, 0, 0]]))

    def test_vertices_are_on_the_zero_set(self):
        surface = meniscus.surface(read(UBIQUITIN))
        self.assertLess(np.abs(surface.level_set(surface.vertices)).max(), 1e-6)
        self.assertTrue(np.allclose(np.einsum("ij,ij->i", surface.normals, surface.gradient(surface.vertices)),
                                    np.linalg.norm(surface.gradient(surface.vertices), axis=1)))


class WhatComesIn(unittest.TestCase):
    def expect_same(self, xyz, radii):
        same = meniscus.surface(np.array(CENTRES), np.array(RADII)).vertices
        self.assertTrue((meniscus.surface(xyz, radii).vertices == same).all())

    def test_lists_and_any_layout_are_taken(self):
        xyz = np.array(CENTRES)
        self.expect_same(CENTRES, RADII)
        self.expect_same(np.asfortranarray(xyz), tuple(RADII))
        self.expect_same(np.hstack([xyz, xyz])[:, :3], np.repeat(RADII, 2)[::2])
        self.expect_same(meniscus.Structure.from_arrays(CENTRES, RADII), None)

    def test_single_precision_and_integers_are_converted(self):
        exact = np.array([[0, 0, 0], [2, 1, 0]])
        for dtype in (np.float32, np.int64, np.uint8, np.float16):
            surface = meniscus.surface(exact.astype(dtype), np.array([2, 1], dtype))
            self.assertTrue((surface.vertices == meniscus.surface(exact, [2.0, 1.0]).vertices).all())

    def test_the_callers_arrays_stay_theirs(self):
        xyz = np.array(CENTRES)
        surface = meniscus.surface(xyz, RADII)
        xyz[:] = 0
        self.assertEqual(surface.structure.xyz.tolist(), CENTRES)

    def test_wrong_shapes_and_values_are_value_errors_that_say_so(self):
        nan = float("nan")
        for xyz, radii, message in (
            ([0, 0, 0], [1], r"xyz: must have shape \(n, 3\), not \(3,\)"),
            ([[0, 0]], [1], r"xyz: must have shape \(n, 3\), not \(1, 2\)"),
            ([[0, 0, 0]], [1, 2], r"radii: must have shape \(1,\), one per atom, not \(2,\)"),
            ([[0, 0, nan]], [1], "xyz: entry 0 is not finite"),
            ([[0, 0, 0]], [float("inf")], "radii: entry 0 is not finite"),
            ([["a", "b", "c"]], [1], "xyz: numbers are needed"),
            ([[1j, 0, 0]], [1], "xyz: numbers are needed"),
            ([[0, 0, 0], [0, 0]], [1, 1], "xyz: rows have different lengths"),
            ([[0, 0, 0]], [0.0], "radius"),
            ([[0, 0, 0]], [-1.0], "radius"),
            ([], [], "atoms"),
        ):
            with self.assertRaisesRegex(ValueError, message):
                meniscus.surface(xyz, radii)

    def test_missing_radii_are_a_type_error_that_helps(self):
        with self.assertRaisesRegex(TypeError, "meniscus.radii"):
            meniscus.surface(CENTRES)


class Options(unittest.TestCase):
    def test_each_is_passed_on(self):
        def surface(**options):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", meniscus.CheckWarning)  # of flows that end too soon
                return meniscus.surface(CENTRES, RADII, **options)

        self.assertLess(len(surface(spacing=0.8).vertices), len(surface().vertices))
        self.assertLess(len(surface(edge=1.0).vertices), len(surface().vertices))
        self.assertAlmostEqual(len(surface(vertex_density=3.0).vertices) / surface().mesh["area"], 3.0, delta=0.6)
        self.assertNotEqual(len(surface(edge=0.8, adaptive=True).vertices), len(surface(edge=0.8).vertices))
        narrow = [[0, -1.9, 0], [0, 1.9, 0], [3.1, 0, 0]], [1.2] * 3
        self.assertNotEqual(len(meniscus.surface(*narrow, edge=1.0).vertices),
                            len(meniscus.surface(*narrow, edge=1.0, spacing=0.5).vertices))
        creased = {"probe": 0.0, "edge": 0.8, "method": "direct"}
        self.assertNotEqual(surface(keep_ridges=True, **creased).mesh["area"], surface(**creased).mesh["area"])
        self.assertGreater(surface(edge=0.8, corners="balanced").mesh["area"],
                           surface(edge=0.8, corners="on-surface").mesh["area"])
        self.assertEqual(surface(edge=0.8, simplify_topology=True).mesh["simplified"], {"handles": 0, "pieces": 0})
        self.assertEqual(len(surface(components="cavities").vertices), 0)
        self.assertIsNone(surface(method="direct").flow)
        self.assertGreater(surface(flow="parallel", max_steps=3, tolerance=1e6).flow["reinitialisations"], 0)
        self.assertEqual(surface(flow="anchored", time_step=1.0, anchor=8.0, solver="cg", slope="unit", max_steps=40,
                                 reinitialise="none", curvature="sharp", half_width=4.0, density=-0.7).flow["end"],
                         "converged")
        self.assertGreater(len(surface(flow="parallel", history=True).flow["history"]), 1)
        self.assertGreater(surface(initial_area=True).flow["initial_area"], 0)
        self.assertIsNone(surface().flow["initial_area"])
        self.assertIsNone(surface().mesh["quality"])
        self.assertEqual(len(surface(quality=True).mesh["quality"]["angle_histogram"]), 18)
        self.assertIn("to_exact", surface(two_sided_distance=True).mesh["two_sided_distance"])
        self.assertEqual(surface(verify=True).mesh["self_intersections"], 0)

    def test_small_cavities_go(self):
        shell = 5 * np.vstack([np.eye(3), -np.eye(3)])
        options = {"probe": 0.5, "spacing": 0.4}
        with_cavity = meniscus.surface(shell, [4.0] * 6, **options)
        self.assertEqual(len(with_cavity.cavities), 1)
        self.assertEqual(with_cavity.mesh["components"], 2)
        without = meniscus.surface(shell, [4.0] * 6, min_cavity=100.0, **options)
        self.assertEqual((without.mesh["components"], without.mesh["dropped"]["cavities"]), (1, 1))

        filled = meniscus.surface(shell, [4.0] * 6, fill_cavities=100.0, **options)
        self.assertEqual((filled.mesh["components"], filled.mesh["filled"]["cavities"]), (1, 1))
        self.assertGreater(filled.mesh["filled"]["volume"], 0)

    def test_results_do_not_depend_on_threads(self):
        one = meniscus.surface(CENTRES, RADII, threads=1)
        self.assertTrue((one.vertices == meniscus.surface(CENTRES, RADII).vertices).all())

    def test_what_makes_no_sense_is_a_value_error(self):
        for options, message in (({"method": "fast"}, "method: unknown value 'fast'; choose one of flow, direct, gaussian"),
                                 ({"spacing": 0}, "spacing: must be a finite number greater than 0"),
                                 ({"probe": -1}, "probe -1: must be finite and not negative"),
                                 ({"threads": -1}, "threads"),
                                 ({"edge": 0}, "edge: must be a finite number greater than 0"),
                                 ({"edge": 1, "vertex_density": 1}, "give one of them"),
                                 ({"adaptive": True}, "ask for them with edge"),
                                 ({"history": True, "method": "direct"}, "history"),
                                 ({"flow": "paper", "method": "direct"}, "flow applies to the flow"),
                                 ({"anchor": 0, "method": "gaussian"}, "anchor applies to the flow"),
                                 ({"memory": "4 sacks"}, "memory: must be an amount"),
                                 ({"components": "some"}, "components: unknown value")):
            with self.assertRaisesRegex(ValueError, message):
                meniscus.surface(CENTRES, RADII, **options)

    def test_options_are_those_that_were_given(self):
        made = meniscus.surface(CENTRES, RADII, method="direct", spacing=0.4, memory="1G")
        self.assertNotIn("finer_grid", made.options)
        again = meniscus.surface(CENTRES, RADII, **made.options)
        self.assertEqual(again.options, made.options)
        self.assertTrue((again.vertices == made.vertices).all())

    def test_arrays_without_sense_are_usage_errors(self):
        for centres, radii in (([], []), ([[0, 0, 0]], [-1.0]), ([[0, 0, 0]], [0.0])):
            with self.assertRaises(meniscus.UsageError):
                meniscus.measure(centres, radii)

    def test_what_is_no_number_is_a_type_error(self):
        for options in ({"probe": None}, {"spacing": "0.5"}, {"threads": 1.5}, {"probe": True}, {"method": 1}):
            with self.assertRaises(TypeError):
                meniscus.surface(CENTRES, RADII, **options)

    def test_what_would_not_fit_is_a_limit_error(self):
        for kind in (meniscus.LimitError, MemoryError, ValueError):
            with self.assertRaisesRegex(kind, r"needs about .* of memory .* choose a spacing of [0-9.]+ Å or more"):
                meniscus.surface(CENTRES, RADII, spacing=0.001, memory="100M")

    def test_a_surface_that_fails_its_checks_is_warned_of(self):
        with self.assertWarnsRegex(meniscus.CheckWarning, "converged") as caught:
            surface = meniscus.surface(CENTRES, RADII, flow="paper", max_steps=1)
        self.assertEqual(caught.filename, __file__)
        self.assertFalse(surface.passed)
        self.assertIn(False, [check["passed"] for check in surface.checks])

    def test_progress_is_told_and_may_end_the_computation(self):
        seen = []
        meniscus.surface(CENTRES, RADII, progress=lambda stage, part: seen.append((stage, part)))
        self.assertIn(("mesh", 1.0), seen)

        def stop(stage, part):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            meniscus.surface(CENTRES, RADII, progress=stop)


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()

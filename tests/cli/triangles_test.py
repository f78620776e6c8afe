#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What the triangles of written meshes are like: those of the grid, and even ones (--edge, --vertex-density).

usage: triangles_test.py PROGRAM SOURCE_DIR
"""
import json
import sys
import unittest

from program_case import UBIQUITIN, ProgramTest


class EveryMesh(ProgramTest):
    def test_has_no_slivers_and_no_short_edges(self):
        for method in ("flow", "direct", "gaussian"):
            for spacing in ("0.5", "1"):
                mesh = self.report(UBIQUITIN, "--method", method, "--spacing", spacing)["mesh"]
                self.assertTrue(mesh["closed"] and mesh["manifold"])
                self.assertGreaterEqual(mesh["smallest_triangle_angle_deg"], 5.0, (method, spacing))
                self.assertGreaterEqual(mesh["quality"]["edges"]["min"], 0.02, (method, spacing))

    def test_a_part_of_the_pieces_is_mended_too(self):
        mesh = self.report(UBIQUITIN, "--components", "outer", "--method", "direct")["mesh"]
        self.assertGreaterEqual(mesh["smallest_triangle_angle_deg"], 5.0)


class EvenTriangles(ProgramTest):
    def mesh(self, *arguments):
        return self.report(UBIQUITIN, *arguments)["mesh"]

    def test_edges_are_as_long_as_asked_for_and_angles_are_large(self):
        for edge in (1.0, 2.0):
            mesh = self.mesh("--edge", edge)
            self.assertTrue(mesh["closed"] and mesh["manifold"])
            self.assertGreater(mesh["smallest_triangle_angle_deg"], 20.0)
            self.assertGreater(mesh["quality"]["smallest_angles_deg"]["p5"], 40.0)
            self.assertGreater(mesh["quality"]["smallest_angles_deg"]["p50"], 45.0)
            edges = mesh["quality"]["edges"]
            self.assertTrue(0.6 * edge < edges["p5"] and edges["p95"] < 1.5 * edge, edges)
            for way in mesh["two_sided_distance"].values():
                self.assertLess(way["mean"], 0.03 * edge * edge)
            self.assertLess(abs(mesh["corrected_area_deviation"]), 0.005)

    def test_few_triangles_round_narrow_necks_are_good_ones_on_a_grid_that_is_fine_enough(self):
        spheres = self.folder / "necks.xyzr"
        spheres.write_text("0 -1.9 0 1.2\n0 1.9 0 1.2\n3.1 0 0 1.2\n")
        for method in ("flow", "direct"):
            for edge in (0.6, 1.0, 2.0):
                result = self.run_program("surface", spheres, "--edge", str(edge), "--method", method, "--report", "-")
                report = json.loads(result.stdout)
                mesh = report["mesh"]
                self.assertEqual(report["options"]["spacing"], 0.25 if method == "flow" else 0.5)
                self.assertLess(abs(mesh["corrected_area_deviation"]), 0.005, (method, edge))
                self.assertGreater(mesh["smallest_triangle_angle_deg"], 20.0)
                self.assertGreater(mesh["quality"]["smallest_angles_deg"]["p50"], 45.0)
                edges = mesh["quality"]["edges"]
                self.assertTrue(0.6 * edge < edges["p5"] and edges["p95"] < 1.5 * edge, edges)
        self.assertEqual(self.report(spheres, "--edge", "1", "--spacing", "0.5")["options"]["spacing"], 0.5)

    def test_the_topology_is_that_of_the_grid_mesh(self):
        self.assertEqual(self.mesh("--edge", "1")["euler_characteristic"], self.mesh()["euler_characteristic"])

    def test_the_topology_stays_unless_asked_otherwise(self):
        grid = self.mesh()
        for edge in ("0.6", "1", "2", "4"):
            even = self.mesh("--edge", edge)
            for key in ("euler_characteristic", "components"):
                self.assertEqual(even[key], grid[key], (edge, key))
            self.assertEqual(even["simplified"], {"handles": 0, "pieces": 0})

    def test_narrow_handles_are_cut_on_request(self):
        grid = self.mesh()
        simple = self.mesh("--edge", "2", "--simplify-topology", "--verify")
        self.assertGreater(simple["simplified"]["handles"], 0)
        self.assertEqual(simple["euler_characteristic"],
                         grid["euler_characteristic"] + 2 * simple["simplified"]["handles"])
        self.assertEqual(simple["components"], grid["components"])
        self.assertTrue(simple["closed"] and simple["manifold"])
        self.assertEqual(simple["quality"]["self_intersections"], 0)
        self.assertGreater(simple["smallest_triangle_angle_deg"], 20.0)

    def test_density_counts_vertices(self):
        mesh = self.mesh("--vertex-density", "1.5")
        self.assertAlmostEqual(mesh["vertices"] / mesh["corrected_area"], 1.5, delta=0.12)

    def test_adaptive_and_ridges_change_the_mesh(self):
        plain = self.mesh("--edge", "1", "--method", "direct")
        for option in ("--adaptive", "--keep-ridges"):
            mesh = self.mesh("--edge", "1", "--method", "direct", option)
            self.assertTrue(mesh["closed"] and mesh["manifold"])
            self.assertNotEqual(mesh["vertices"], plain["vertices"])

    def test_ridges_make_no_slivers_and_lead_through_nothing(self):
        for method, edge in (("direct", "0.6"), ("direct", "2"), ("flow", "1")):
            mesh = self.mesh("--edge", edge, "--method", method, "--keep-ridges", "--verify")
            self.assertTrue(mesh["closed"] and mesh["manifold"])
            self.assertEqual(mesh["quality"]["self_intersections"], 0, (method, edge))
            self.assertGreater(mesh["smallest_triangle_angle_deg"], 15.0, (method, edge))

    def test_corners_lie_where_they_are_asked_for(self):
        def mean(mesh):
            return mesh["two_sided_distance"]["to_exact"]["mean"]
        for method in ("flow", "direct"):
            meshes = [self.mesh("--edge", "1", "--method", method, "--verify", "--corners", where)
                      for where in ("on-surface", "near", "balanced")]
            on_surface, near, balanced = meshes
            for mesh in meshes:
                self.assertTrue(mesh["closed"] and mesh["manifold"])
                self.assertEqual(mesh["triangles"], near["triangles"])
                self.assertEqual(mesh["quality"]["self_intersections"], 0)
                self.assertGreater(mesh["smallest_triangle_angle_deg"], 20.0)
                self.assertAlmostEqual(mesh["corrected_area"], near["corrected_area"])
            self.assertLess(on_surface["mean_distance"], near["mean_distance"])
            self.assertLess(near["mean_distance"], 0.6 * balanced["mean_distance"])
            self.assertTrue(0.03 < mean(on_surface) and 0.028 < mean(near) <= 0.03, (mean(on_surface), mean(near)))
            self.assertLess(mean(balanced), 0.7 * mean(on_surface))

    def test_ridges_and_envelopes_keep_their_corners(self):
        for options in (["--keep-ridges"], ["--method", "gaussian"]):
            report = self.report(UBIQUITIN, "--edge", "1", *options)
            self.assertEqual(report["options"]["corners"], "on-surface", options)
            on_surface = self.report(UBIQUITIN, "--edge", "1", "--corners", "on-surface", *options)
            self.assertEqual(report["mesh"], on_surface["mesh"])
        self.assertEqual(self.report(UBIQUITIN, "--edge", "1")["options"]["corners"], "near")
        self.assertIsNone(self.report(UBIQUITIN)["options"]["corners"])

    def test_same_bits_for_any_number_of_threads(self):
        for options in (["--edge", "1"], ["--edge", "0.6", "--method", "direct", "--keep-ridges"],
                        ["--edge", "2", "--simplify-topology", "--min-cavity", "20"], ["--edge", "1", "--corners", "balanced"]):
            for threads in ("1", "2"):
                self.surface(UBIQUITIN, "--threads", threads, *options, "-o", f"e{threads}.ply", "--quiet")
            self.assertEqual((self.folder / "e1.ply").read_bytes(), (self.folder / "e2.ply").read_bytes(), options)

    def test_what_makes_no_sense_is_refused(self):
        self.assertIn("spacing", self.refused(UBIQUITIN, "--edge", "1", "--spacing", "0.8"))
        self.assertIn("--edge", self.refused(UBIQUITIN, "--edge", "0"))
        self.assertIn("--edge", self.refused(UBIQUITIN, "--adaptive"))
        self.assertIn("--edge", self.refused(UBIQUITIN, "--simplify-topology"))
        self.assertIn("--edge", self.refused(UBIQUITIN, "--corners", "balanced"))
        self.refused(UBIQUITIN, "--edge", "1", "--vertex-density", "2")

    def test_folds_that_leave_no_room_for_even_triangles_are_refused(self):
        folded = ("--method", "direct", "--surface", "vdw", "--edge", "4", "--keep-ridges")
        self.assertIn("narrower", self.refused(UBIQUITIN, *folded))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

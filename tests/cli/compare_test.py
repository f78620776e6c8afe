#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs `meniscus compare`: on spheres, on surfaces of ours, and on PyMOL's where that is installed.

usage: compare_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import schema

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
UBIQUITIN = SOURCE / "examples" / "1ubq.pdb"
# Debian's, which is a script of Debian's python3.
PYMOL = pathlib.Path("/usr/bin/pymol")

# With this view camera and structure have one frame, in which PyMOL writes meshes.
PYMOL_SCRIPT = """load {structure}
remove solvent
hide everything
set surface_quality, 1
set_view [1,0,0, 0,1,0, 0,0,1, 0,0,-100, 0,0,0, 50,150,0]
show surface
save {mesh}
"""


class CompareTest(unittest.TestCase):
    """Every test runs in an empty folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def run_program(self, *arguments, code=0):
        result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True,
                                encoding="utf-8", timeout=300, check=False)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def report(self, *arguments):
        report = json.loads(self.run_program("compare", *arguments, "--report", "-").stdout)
        rules = json.loads((SOURCE / "docs" / "compare.schema.json").read_text(encoding="utf-8"))
        self.assertEqual(schema.problems(report, rules), [])
        return report


class Spheres(CompareTest):
    def setUp(self):
        super().setUp()
        self.write("small.xyzr", "1 2 3 3.0\n")
        self.write("large.xyzr", "1 2 3 3.4\n")
        for name in ("a.off", "a.stl", "a.obj", "a.ply", "a.glb"):
            self.run_program("surface", "large.xyzr", "-o", name, "--method", "direct", "--quiet")

    def test_every_format_tells_the_difference_of_the_radii(self):
        for name in ("a.off", "a.stl", "a.obj", "a.ply", "a.glb"):
            report = self.report(name, "small.xyzr")
            self.assertTrue(report["a"]["closed"] and report["a"]["manifold"], name)
            for way, sign in (("a_to_b", 1), ("b_to_a", -1)):
                self.assertAlmostEqual(report[way]["mean"], 0.4, delta=0.02, msg=name)
                self.assertAlmostEqual(report[way]["signed_mean"], 0.4 * sign, delta=0.02, msg=name)
            self.assertAlmostEqual(report["hausdorff"], 0.4, delta=0.03, msg=name)

    def test_two_structures_and_two_meshes(self):
        self.assertAlmostEqual(self.report("large.xyzr", "small.xyzr")["hausdorff"], 0.4, delta=1e-6)
        report = self.report("a.ply", "a.off")
        self.assertLess(report["hausdorff"], 1e-5)
        self.assertEqual(report["a"]["triangles"], report["b"]["triangles"])

    def test_the_mesh_is_coloured_by_its_distance(self):
        self.run_program("compare", "a.off", "small.xyzr", "-o", "d.ply", "-o", "d.glb", "--range", "-1:1", "--quiet")
        header = (self.folder / "d.ply").read_bytes().partition(b"end_header")[0].decode("ascii")
        for line in ("property float distance", "property uchar red"):
            self.assertIn(line, header)
        self.assertIn(b'"_DISTANCE"', (self.folder / "d.glb").read_bytes())

    def test_errors_have_their_exit_codes(self):
        self.write("bad.off", "OFF\n1 1 0\n0 0 nan\n")
        result = self.run_program("compare", "bad.off", "small.xyzr", code=3)
        self.assertIn("bad.off:3:5: ", result.stderr)
        self.write("empty.off", "OFF\n0 0 0\n")
        self.assertIn("no triangles", self.run_program("compare", "empty.off", "small.xyzr", code=3).stderr)
        self.write("flat.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 1 0\n3 0 1 2\n")
        self.assertIn("no area", self.run_program("compare", "flat.off", "small.xyzr", code=3).stderr)
        self.run_program("compare", "none.off", "small.xyzr", code=3)
        self.run_program("compare", "a.off", code=2)
        self.run_program("compare", "a.off", "small.xyzr", "-o", "d.stl", code=2)
        self.run_program("compare", "a.off", "small.xyzr", "-o", "no/d.ply", code=4)
        self.run_program("compare", "a.ply", "small.xyzr", "-o", "a.ply", code=2)
        self.run_program("compare", "a.off", "small.xyzr", "--points", "1e15", code=5)

    def test_the_summary_tells_both_ways(self):
        text = self.run_program("compare", "a.off", "small.xyzr").stdout
        for part in ("area/Å²", "volume/Å³", "from A to B", "from B to A", "Hausdorff"):
            self.assertIn(part, text)


class Surfaces(CompareTest):
    def test_a_mesh_of_ours_is_as_far_off_as_its_report_says(self):
        self.run_program("surface", UBIQUITIN, "-o", "x.off", "--edge", "0.8", "--report", "x.json", "--quiet")
        mesh = json.loads((self.folder / "x.json").read_text(encoding="utf-8"))["mesh"]
        report = self.report("x.off", UBIQUITIN)
        told = mesh["two_sided_distance"]["to_exact"]
        self.assertAlmostEqual(report["a_to_b"]["mean"], told["mean"], delta=0.02 * told["mean"])
        self.assertAlmostEqual(report["a_to_b"]["p99"], told["p99"], delta=0.05 * told["p99"])
        self.assertGreater(report["a_to_b"]["max"], 0.999 * mesh["max_distance"])  # vertices are among the points
        self.assertAlmostEqual(report["a"]["area"], mesh["area"], delta=1e-3)
        self.assertAlmostEqual(report["a"]["volume"], mesh["volume"], delta=1e-2)
        self.assertAlmostEqual(report["b"]["area"], 3892.2387, delta=1e-3)

    @unittest.skipUnless(PYMOL.exists(), "SKIPPED: PyMOL (Debian package pymol) is not installed")
    def test_pymols_surface_beside_the_exact_one(self):
        self.write("export.pml", PYMOL_SCRIPT.format(structure=UBIQUITIN, mesh="pymol.obj"))
        subprocess.run([PYMOL, "-cq", "export.pml"], cwd=self.folder, capture_output=True, timeout=300, check=False,
                       env={"PATH": "/usr/bin:/bin", "HOME": str(self.folder)})
        self.assertTrue((self.folder / "pymol.obj").exists(), "PyMOL wrote no mesh")
        report = self.report("pymol.obj", UBIQUITIN, "--radii", "bondi")  # PyMOL's radii
        self.assertGreater(report["a"]["merged_vertices"], report["a"]["vertices"])
        self.assertLess(report["a_to_b"]["mean"], 0.1)
        self.assertLess(report["a_to_b"]["max"], 1.0)
        self.assertEqual((report["a"]["cavities"], report["b"]["cavities"]), (0, 2))
        self.assertGreater(report["b_to_a"]["max"], 5.0)  # PyMOL shows no cavities


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])

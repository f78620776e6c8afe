#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the built program for volumes: grids, fields, maps, and what is refused.

usage: volumes_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import schema

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()

BALL = "1 0 0 2.0\n"

# Ninety atoms on a sphere of 6.5 Å: an outer surface and a cavity.
SHELL = "".join(f"{6.5 * math.sqrt(1 - z * z) * math.cos(a):.4f} {6.5 * math.sqrt(1 - z * z) * math.sin(a):.4f} "
                f"{6.5 * z:.4f} 1.7\n"
                for z, a in ((1 - (2 * i + 1) / 90, 2.399963229728653 * i) for i in range(90)))


class Dx:
    """A file of values, read without our code."""

    def __init__(self, path):
        head, tail = path.read_text().split("data follows\n")
        self.head = head
        self.counts = [int(n) for n in head.split("gridpositions counts ")[1].split()[:3]]
        self.origin = [float(x) for x in head.split("origin ")[1].split()[:3]]
        self.steps = [float(line.split()[1 + i]) for i, line in
                      enumerate(line for line in head.splitlines() if line.startswith("delta"))]
        self.values = [float(x) for x in tail.split("attribute")[0].split()]

    def nodes(self):
        """Place and value of each."""
        places = ([o + i * h for o, h, i in zip(self.origin, self.steps, (i, j, k))]
                  for i in range(self.counts[0]) for j in range(self.counts[1]) for k in range(self.counts[2]))
        return list(zip(places, self.values))


class VolumesTest(unittest.TestCase):
    """Every test runs in an empty folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "ball.xyzr").write_text(BALL)
        (self.folder / "shell.xyzr").write_text(SHELL)

    def surface(self, *arguments, code=0):
        result = subprocess.run([PROGRAM, "surface", *map(str, arguments)], cwd=self.folder, capture_output=True,
                                encoding="utf-8", timeout=120, check=False)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def report(self, *arguments):
        report = json.loads(self.surface(*arguments, "--report", "-").stdout)
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text())
        self.assertEqual(schema.problems(report, rules), [])
        return report

    def refused(self, *arguments, code=2):
        before = sorted(self.folder.iterdir())
        result = self.surface("ball.xyzr", *arguments, code=code)
        self.assertEqual(sorted(self.folder.iterdir()), before)
        self.assertRegex(result.stderr, r"\Ameniscus: error: [^\n]+\n\Z")
        return result.stderr

    def dx(self, name):
        return Dx(self.folder / name)

    def test_the_usual_grid_encloses_the_atoms_and_holds_distances(self):
        self.surface("ball.xyzr", "--method", "direct", "-o", "a.dx")
        volume = self.dx("a.dx")
        self.assertIn("inside positive", volume.head)
        self.assertEqual((volume.counts, volume.origin, volume.steps), ([17, 17, 17], [-3, -4, -4], [0.5] * 3))
        for place, value in volume.nodes():
            self.assertAlmostEqual(value, 2 - math.dist(place, (1, 0, 0)), delta=1e-5)

    def test_fields(self):
        for options, radius, values in ((["mask"], 2, (1, 0)), (["dielectric"], 2, (2, 78.54)),
                                        (["dielectric", "--eps", "4,80"], 2, (4, 80)), (["ions"], 4, (0, 1)),
                                        (["ions", "--ion-radius", "0.7"], 2.7, (0, 1))):
            report = self.report("ball.xyzr", "--method", "direct", "-o", "a.dx", "--grid", "15,16,17,0.71,0,0.1,0.2",
                                 "--field", *options)
            self.assertEqual(report["options"]["field"], options[0])
            for place, value in self.dx("a.dx").nodes():
                self.assertAlmostEqual(value, values[math.dist(place, (1, 0, 0)) >= radius], delta=1e-5)

    def test_the_grid_of_another_file(self):
        self.surface("shell.xyzr", "--method", "direct", "-o", "shell.dx", "-o", "shell.mrc", "--grid",
                     "9,10,11,0.5,1,2,3", "--field", "mask")
        for name in ("shell.dx", "shell.mrc"):
            self.surface("ball.xyzr", "-o", "a.dx", "--grid", name)
            self.assertEqual(self.dx("a.dx").head.split("object 1")[1], self.dx("shell.dx").head.split("object 1")[1])
        self.assertIn("would overwrite", self.refused("-o", "shell.dx", "--grid", "shell.dx"))

    def test_grids_that_cannot_be_read_are_told_in_one_line(self):
        (self.folder / "bad.dx").write_text("object 1 class gridpositions counts 3 3\n")
        self.assertIn("bad.dx:1:40: count along z is missing", self.refused("-o", "a.dx", "--grid", "bad.dx", code=3))
        self.assertIn("none.mrc", self.refused("-o", "a.dx", "--grid", "none.mrc", code=3))
        self.assertIn("supported formats are .dx", self.refused("-o", "a.dx", "--grid", "grid.cube"))
        self.assertIn("--grid", self.refused("-o", "a.dx", "--grid", "1,2,3"))

    def test_grids_that_do_not_fit_are_refused(self):
        for arguments in (["--grid", "5000,5000,5000,0.1,0,0,0", "--memory", "1G"],
                          ["--grid", "2000000000,2000000000,2000000000,0.1,0,0,0"],
                          ["--grid", "300,300,300,0.1,0,0,0", "--memory", "100M"]):
            self.assertIn("choose a coarser or smaller grid", self.refused("-o", "a.dx", *arguments, code=5))

    def test_options_without_effect_are_refused(self):
        for arguments in (["--grid", "9,9,9,1,0,0,0"], ["--field", "mask"], ["--eps", "2,80"], ["--ion-radius", "1"],
                          ["--maps", "apbs"]):
            self.assertIn(f"{arguments[0]} applies to volumes", self.refused("-o", "a.ply", *arguments))

    def test_maps_of_apbs(self):
        report = self.report("ball.xyzr", "--method", "direct", "-o", "a.dx", "--maps", "apbs", "--grid",
                             "9,9,9,0.5,1,0,0")
        self.assertEqual((report["options"]["maps"], report["options"]["eps"]), ("apbs", [2, 78.54]))
        names = sorted(p.name for p in self.folder.glob("*.dx"))
        self.assertEqual(names, ["a_dielx.dx", "a_diely.dx", "a_dielz.dx", "a_kappa.dx"])
        origins = [self.dx(name).origin for name in names]
        self.assertEqual(origins, [[-0.75, -2, -2], [-1, -1.75, -2], [-1, -2, -1.75], [-1, -2, -2]])
        self.assertIn("needs the grid", self.refused("-o", "b.dx", "--maps", "apbs"))

    def test_filled_cavities_are_inside(self):
        middle = ["--grid", "1,1,1,1,0,0,0", "-o", "a.dx"]
        self.assertEqual(self.report("shell.xyzr", *middle)["mesh"]["components"], 2)
        self.assertLess(self.dx("a.dx").values[0], 0)
        report = self.report("shell.xyzr", *middle, "--min-cavity", "1000")
        self.assertEqual((report["mesh"]["dropped"]["cavities"], report["mesh"]["filled"]["cavities"]), (1, 0))
        self.assertLess(self.dx("a.dx").values[0], 0)
        report = self.report("shell.xyzr", *middle, "--fill-cavities", "1000")
        self.assertEqual((report["mesh"]["dropped"]["cavities"], report["mesh"]["filled"]["cavities"]), (0, 1))
        self.assertEqual(report["mesh"]["components"], 1)
        self.assertLess(abs(report["mesh"]["volume_deviation"]), 0.005)
        self.assertGreater(self.dx("a.dx").values[0], 7)

    def test_vdb_is_written_or_refused_clearly(self):
        result = subprocess.run([PROGRAM, "surface", "ball.xyzr", "-o", "a.vdb"], cwd=self.folder, capture_output=True,
                                encoding="utf-8", check=False)
        if result.returncode == 0:
            self.assertEqual((self.folder / "a.vdb").read_bytes()[:4], b" BDV")
        else:
            self.assertEqual(result.returncode, 2)
            self.assertIn("install libopenvdb-dev and build again", result.stderr)
            self.assertFalse((self.folder / "a.vdb").exists())

    def test_files_do_not_depend_on_threads(self):
        for threads in (1, 3):
            self.surface("shell.xyzr", "--threads", threads, "-o", f"{threads}.mrc", "--spacing", "1")
        self.assertEqual((self.folder / "1.mrc").read_bytes(), (self.folder / "3.mrc").read_bytes())


unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

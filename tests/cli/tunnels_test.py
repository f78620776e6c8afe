#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs `meniscus pockets` with tunnels and pores: beads with known radii, tables, pseudo-atoms, and bad input.

usage: tunnels_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import csv
import json
import math
import sys
import unittest

import schema
from program_case import ProgramTest, SOURCE


def ring(z, free):
    """Beads of radius 1 round the z axis, between which nothing passes; a ball of radius `free` fits in."""
    radius = free + 1.0
    count = math.ceil(2.0 * math.pi * radius)
    return [(radius * math.cos(2.0 * math.pi * i / count), radius * math.sin(2.0 * math.pi * i / count), z)
            for i in range(count)]


def xyzr(beads):
    return "".join(f"{x!r} {y!r} {z!r} 1.0\n" for x, y, z in beads)


WALL = [bead for i in range(14) for bead in ring(float(i), 3.5)]
BOTTOM = [(x * 1.05, y * 1.05, -1.0) for x in range(-4, 5) for y in range(-4, 5) if math.hypot(x, y) < 4.5]
NECK = ring(9.0, 2.2)
CUP = xyzr(WALL + BOTTOM + NECK)
PIPE = xyzr(WALL + NECK)


class TunnelsTest(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "cup.xyzr").write_text(CUP)
        (self.folder / "pipe.xyzr").write_text(PIPE)

    @staticmethod
    def with_radii(arguments):
        """Beads bring their radii, and so few need a finer grid for the volumes of pockets."""
        return (*arguments, "--radii", "auto", "--spacing", "0.5") if str(arguments[0]).endswith(".xyzr") else arguments

    def pockets(self, *arguments, code=0):
        result = self.run_program("pockets", *self.with_radii(arguments))
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def report_of(self, *arguments):
        self.pockets(*arguments, "--report", "r.json", "--quiet")
        report = json.loads((self.folder / "r.json").read_text())
        rules = json.loads((SOURCE / "docs" / "pockets.schema.json").read_text(encoding="utf-8"))
        self.assertEqual(schema.problems(report, rules), [])
        return report

    def test_a_tunnel_has_the_radius_of_its_neck(self):
        report = self.report_of("cup.xyzr", "--tunnels-from", "0.4,0.3,4")
        self.assertEqual(report["options"]["tunnels_from"], ["0.4,0.3,4"])
        tunnel = report["tunnels"][0]
        self.assertAlmostEqual(tunnel["bottleneck_radius"], 2.2, delta=1e-9)
        self.assertAlmostEqual(tunnel["certified_radius"], 2.2, delta=1e-9)
        for value, expected in zip(tunnel["bottleneck"], (0.0, 0.0, 9.0)):
            self.assertAlmostEqual(value, expected, delta=1e-6)
        self.assertIsNone(tunnel["pocket"])
        self.assertFalse(tunnel["bottleneck_at_end"])
        self.assertEqual(len(tunnel["bottleneck_atoms"]), 3)
        self.assertEqual(tunnel["profile"][-1]["distance"], tunnel["length"])
        self.assertGreaterEqual(min(p["radius"] for p in tunnel["profile"]), 2.2 - 1e-9)

    def test_tunnels_of_pockets_name_their_pocket(self):
        report = self.report_of("cup.xyzr", "--tunnels", "--tunnel-count", "1")
        ranks = {pocket["rank"] for pocket in report["pockets"]}
        self.assertTrue(report["tunnels"])
        for tunnel in report["tunnels"]:
            self.assertIn(tunnel["pocket"], ranks)
            self.assertEqual(tunnel["rank"], 1)
        self.assertAlmostEqual(report["tunnels"][0]["bottleneck_radius"], 2.2, delta=1e-9)

    def test_narrow_tunnels_may_be_left_out(self):
        arguments = ("cup.xyzr", "--tunnels-from", "0,0,4", "--tunnel-radius")
        self.assertEqual(self.report_of(*arguments, "2.3")["tunnels"], [])
        self.assertEqual(len(self.report_of(*arguments, "2.1")["tunnels"]), 1)

    def test_without_being_asked_for_there_are_none(self):
        report = self.report_of("cup.xyzr")
        self.assertIsNone(report["tunnels"])
        self.assertIsNone(report["pore"])

    def test_a_pore_has_the_radius_of_its_neck(self):
        for pore in ("z", "0,0,-3,0,0,16"):
            report = self.report_of("pipe.xyzr", "--pore", pore)
            self.assertEqual(report["options"]["pore"], pore)
            self.assertAlmostEqual(report["pore"]["bottleneck_radius"], 2.2, delta=1e-9)
            self.assertGreaterEqual(report["pore"]["length"], 14.9)
        self.assertIsNone(self.report_of("cup.xyzr", "--pore", "z")["pore"])

    def test_the_summary_has_a_row_per_tunnel(self):
        text = self.pockets("cup.xyzr", "--tunnels-from", "0,0,4", "--pore", "z").stdout
        self.assertRegex(text, r"\n +start 1 +1 +2\.200 +\d+\.\d +1\.\d\d  \S")
        self.assertIn("none: no ball of 0.5 Å passes", text)
        self.assertRegex(self.pockets("pipe.xyzr", "--pore", "z").stdout, r"\n +pore z +2\.200 ")

    def test_the_table_has_the_profile(self):
        self.pockets("pipe.xyzr", "--pore", "z", "--tunnels-from", "0,0,4", "--tunnel-table", "t.csv")
        with open(self.folder / "t.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["kind"] for row in rows}, {"tunnel", "pore"})
        pore = [row for row in rows if row["kind"] == "pore"]
        narrowest = min(pore, key=lambda row: float(row["radius"]))
        self.assertAlmostEqual(float(narrowest["radius"]), 2.2, delta=1e-9)
        self.assertAlmostEqual(float(narrowest["z"]), 9.0, delta=1e-6)
        for row in rows:
            place = tuple(float(row[axis]) for axis in "xyz")
            if math.hypot(*place[:2]) < 2.0 and 0.0 < place[2] < 13.0:
                clearance = min(math.dist(place, bead) for bead in WALL + NECK) - 1.0
                self.assertAlmostEqual(float(row["radius"]), clearance, delta=1e-9)

    def test_paths_are_atoms_of_the_copy(self):
        for name in ("p.pdb", "p.cif"):
            self.pockets("pipe.xyzr", "--pore", "z", "--tunnels-from", "0,0,4", "-o", name)
            text = (self.folder / name).read_text()
            self.assertRegex(text, r"\bTUN\b")
            self.assertRegex(text, r"\bPOR\b")
        radii = [float(line[60:66]) for line in (self.folder / "p.pdb").read_text().splitlines()
                 if line[17:20] == "POR"]
        self.assertEqual(min(radii), 2.2)

    def test_a_selection_is_a_start(self):
        example = SOURCE / "examples" / "1ubq.pdb"
        report = self.report_of(example, "--tunnels-from", "//A/27-29")
        self.assertIsInstance(report["tunnels"], list)
        refused = self.pockets(example, "--tunnels-from", "(HEM)", code=2).stderr
        self.assertIn("--tunnels-from (HEM): selects none", refused)

    def test_bad_input_is_one_line(self):
        for words in (["--pore", "w"], ["--pore", "0,0,0,1,1"], ["--pore", "0,0,0,1,1,b"], ["--pore", "1,1,1,1,1,1"],
                      ["--pore", ""], ["--pore", "0,0,nan,0,0,1"], ["--tunnels-from", "1,2,"],
                      ["--tunnels-from", "1-,2,3"], ["--tunnels-from", ""], ["--tunnels", "--tunnel-radius", "0"],
                      ["--tunnels", "--tunnel-count", "0"], ["--tunnel-table", "t.csv"],
                      ["--pore", "z", "--tunnel-table", "t.ply"],
                      ["--pore", "z", "--tunnel-table", "t.csv", "-o", "t.csv"]):
            result = self.pockets("cup.xyzr", *words, code=2)
            self.assertEqual(result.stdout, "")
            errors = [line for line in result.stderr.splitlines() if line.startswith("meniscus: error: ")]
            self.assertEqual(len(errors), 1, (words, result.stderr))
            self.assertFalse((self.folder / "t.csv").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])

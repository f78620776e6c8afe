#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Self-checks of the built program: every run says what it has passed, and what fails ends with 6 by name.

usage: checks_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
UBIQUITIN = SOURCE / "examples" / "1ubq.pdb"
EVERY_MESH = ["not_empty", "closed", "manifold"]
EXACT = ["mean_distance", "volume", "pieces"]


class ChecksTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_program(self, *arguments, code=0):
        result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True,
                                encoding="utf-8", timeout=300, check=False)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def line(self, *arguments, code=0):
        """What the summary says of the checks."""
        lines = re.findall(r"^  checks +(.*)$", self.run_program(*arguments, code=code).stdout, re.MULTILINE)
        self.assertEqual(len(lines), 1)
        return lines[0]

    def checks(self, *arguments, code=0):
        self.run_program(*arguments, "--report", "r.json", "--quiet", code=code)
        return {c["name"]: c for c in json.loads((self.folder / "r.json").read_text())["checks"]}


class EveryRun(ChecksTest):
    def test_says_what_it_has_passed(self):
        plain = (UBIQUITIN, "-o", "a.ply", "--spacing")
        coarse = (*plain, "0.8")
        passed = "passed: " + ", ".join([*EVERY_MESH, "converged", *EXACT])
        self.assertEqual(self.line("surface", *coarse), passed + ", exact_agreement")
        self.assertEqual(self.line("surface", *coarse, "--no-exact"), passed)
        self.assertEqual(self.line("surface", *plain, "1.2", "--no-exact"), passed)
        direct = "passed: " + ", ".join([*EVERY_MESH, *EXACT])
        for kind in ("ses", "sas", "vdw"):
            chosen = (*coarse, "--method", "direct", "--surface", kind)
            self.assertEqual(self.line("surface", *chosen), direct + ", exact_agreement")
            self.assertEqual(self.line("surface", *chosen, "--no-exact"), direct)
        envelope = (*coarse, "--method", "gaussian")
        self.assertEqual(self.line("surface", *envelope), "passed: " + ", ".join([*EVERY_MESH, "exact_agreement"]))
        self.assertEqual(self.line("surface", *envelope, "--no-exact"), "passed: " + ", ".join(EVERY_MESH))
        self.assertEqual(self.line("surface", *coarse, "--verify"),
                         passed + ", sides, no_self_intersections, exact_agreement")
        self.assertEqual(self.line("measure", UBIQUITIN), "passed: exact_agreement, sums")

    def test_passes_whatever_the_mesh_keeps(self):
        for options in (["--components", "outer"], ["--components", "cavities"], ["--min-cavity", "30"],
                        ["--fill-cavities", "30"], ["--edge", "1"], ["--edge", "2", "--simplify-topology"],
                        ["--probe", "0.4"], ["--probe", "3"], ["--show", "//A/1-20"]):
            for method in ("flow", "direct"):
                self.checks("surface", UBIQUITIN, "-o", "a.ply", "--method", method, *options)
                self.assertTrue(self.line("surface", UBIQUITIN, "-o", "a.ply", "--method", method,
                                          *options).startswith("passed"))

    def test_reports_hold_the_same_checks_as_the_line(self):
        names = list(self.checks("surface", UBIQUITIN, "-o", "a.ply"))
        self.assertEqual(names, [*EVERY_MESH, "converged", *EXACT, "exact_agreement"])
        names = list(self.checks("surface", UBIQUITIN, "-o", "a.ply", "--no-exact"))
        self.assertEqual(names, [*EVERY_MESH, "converged", *EXACT])
        self.assertEqual(list(self.checks("measure", UBIQUITIN)), ["exact_agreement", "sums"])


class Failing(ChecksTest):
    def test_a_flow_that_is_stopped_early(self):
        early = ("surface", UBIQUITIN, "-o", "a.ply", "--flow", "paper", "--max-steps", "1")
        checks = self.checks(*early, code=6)
        for name in ("converged", "mean_distance", "volume"):
            self.assertFalse(checks[name]["passed"], checks)
        line = self.line(*early, code=6)
        self.assertTrue(line.startswith("FAILED: converged, mean_distance, volume"), line)
        self.assertIn("; passed: not_empty, closed, manifold", line)
        self.assertIn("volume (", self.run_program(*early, code=6).stderr)
        self.assertFalse(json.loads((self.folder / "r.json").read_text())["flow"]["converged"])

    def test_a_cavity_that_the_start_does_not_have(self):
        # A void that the Gaussian envelope fills; without an anchor no flow opens it again.
        shell = "".join(f"{6.5 * x:.4f} {6.5 * y:.4f} {6.5 * z:.4f} 1.7\n" for x, y, z in sphere_points(150))
        (self.folder / "shell.xyzr").write_text(shell)
        checks = self.checks("surface", "shell.xyzr", "-o", "a.ply", "--flow", "paper", "--density", "-0.05",
                             "--max-steps", "2", code=6)
        self.assertFalse(checks["pieces"]["passed"], checks)
        self.assertGreater(checks["pieces"]["value"], 0)


def sphere_points(count):
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        a = 2.399963229728653 * i
        r = (1 - z * z) ** 0.5
        yield r * math.cos(a), r * math.sin(a), z


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Which surface, and which parts of it: --surface, --show, --per-chain, --cavity-files.

usage: parts_test.py PROGRAM SOURCE_DIR
"""
import json
import math
import sys
import unittest

import mesh_files
import schema
from program_case import SHELL, SOURCE, UBIQUITIN, ProgramTest

RULES = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
COMPLEX = SOURCE / "examples" / "1a0q.pdb"


class Surfaces(ProgramTest):
    def test_two_spheres_have_the_areas_and_volumes_of_their_caps(self):
        r, s, d, probe = 1.7, 1.5, 2.0, 1.4
        (self.folder / "two.xyzr").write_text(f"0 0 0 {r}\n{d} 0 0 {s}\n")
        for kind, grown in (("sas", probe), ("vdw", 0)):
            a, b = r + grown, s + grown
            x = (d * d + a * a - b * b) / (2 * d)  # of the plane between them
            area = 2 * math.pi * (a * (a + x) + b * (b + d - x))
            cap = lambda radius, height: math.pi * height**2 * (3 * radius - height) / 3
            volume = cap(a, a + x) + cap(b, b + d - x)
            report = self.report("two.xyzr", "--surface", kind, "--spacing", "0.25", "-o", "a.ply", "-o", "a.html")
            self.assertEqual(schema.problems(report, RULES), [])
            self.assertEqual(report["options"]["surface"], kind)
            self.assertEqual(report["input"]["probe"], probe if kind == "sas" else 0)
            exact, mesh = report["exact"], report["mesh"]
            for name in ("sas",) if kind == "sas" else ("sas", "ses"):
                self.assertAlmostEqual(exact[f"{name}_area"] / area, 1, delta=1e-6)
                self.assertAlmostEqual(exact[f"{name}_volume"] / volume, 1, delta=1e-6)
            self.assertAlmostEqual(mesh["area"] / (1 + mesh["area_deviation"]) / area, 1, delta=1e-6)
            self.assertAlmostEqual(mesh["corrected_area"] / area, 1, delta=0.02)
            self.assertAlmostEqual(mesh["corrected_volume"] / volume, 1, delta=3e-3)
            self.assertTrue(mesh["closed"] and mesh["manifold"])

    def test_of_a_protein_too(self):
        excluded = self.report(UBIQUITIN, "-o", "a.ply")
        for method in ("flow", "direct"):
            deviations = []
            for spacing in ("0.5", "0.25"):
                report = self.report(UBIQUITIN, "--surface", "sas", "--method", method, "--spacing", spacing, "-o", "b.ply")
                self.assertEqual((report["exact"], report["components"]), (excluded["exact"], excluded["components"]))
                self.assertLess(abs(report["mesh"]["corrected_volume_deviation"]), 0.003)
                self.assertTrue(all(check["passed"] for check in report["checks"]), report["checks"])
                deviations.append(abs(report["mesh"]["corrected_area_deviation"]))
            # Creases are cut off at the scale of the grid, wherever two atoms meet.
            self.assertLess(deviations[0], 0.05)
            self.assertLess(deviations[1], 0.6 * deviations[0])

    def test_the_summary_has_the_exact_area(self):
        exact = self.report(UBIQUITIN, "--surface", "sas", "-o", "a.ply")["exact"]
        printed = self.surface(UBIQUITIN, "--surface", "sas", "-o", "a.ply").stdout
        for label, unit, value in (("area", "Å²", exact["sas_area"]), ("volume", "Å³", exact["sas_volume"])):
            self.assertRegex(printed, rf"\n  {label} +{value:.4f} ± \S+ +{unit} exact; mesh without creases [0-9.]+ {unit},")

    def test_vdw_is_probe_0(self):
        self.surface("three.xyzr", "--surface", "vdw", "-o", "a.ply")
        self.surface("three.xyzr", "--probe", "0", "-o", "b.ply")
        self.assertEqual((self.folder / "a.ply").read_bytes(), (self.folder / "b.ply").read_bytes())

    def test_the_envelope_knows_neither(self):
        self.assertIn("--method gaussian", self.refused("three.xyzr", "--surface", "sas", "--method", "gaussian"))
        self.refused("three.xyzr", "--surface", "skin")


class Shown(ProgramTest):
    def test_a_part_and_the_rest_are_all_of_it(self):
        whole = self.report(UBIQUITIN, "-o", "whole.ply")
        names = ("ply", "obj", "off", "stl", "glb", "vtp", "npz", "png", "html")
        part = self.report(UBIQUITIN, "--show", "//A/1-30", *[w for n in names for w in ("-o", f"part.{n}")])
        rest = self.report(UBIQUITIN, "--show", "//A/31-76", "-o", "rest.ply")
        self.assertEqual(schema.problems(part, RULES), [])
        shown = part["mesh"]["shown"]
        self.assertEqual((shown["select"], shown["open"], part["mesh"]["closed"]), ("//A/1-30", True, False))
        self.assertIsNone(whole["mesh"]["shown"])
        self.assertEqual(shown["triangles"] + rest["mesh"]["shown"]["triangles"], whole["mesh"]["triangles"])
        self.assertAlmostEqual(shown["area"] + rest["mesh"]["shown"]["area"], whole["mesh"]["area"], delta=1e-6)
        self.assertEqual(part["mesh"]["area"], whole["mesh"]["area"])
        self.assertTrue(all(check["passed"] for check in part["checks"]), part["checks"])
        for name in ("ply", "obj", "off"):
            vertices, triangles = mesh_files.READERS[name](self.folder / f"part.{name}")
            self.assertEqual((len(vertices), len(triangles)), (shown["vertices"], shown["triangles"]), name)
            self.assertIn(b"open: part of a surface", (self.folder / f"part.{name}").read_bytes()[:200], name)
        self.assertIn(b'Name="open"', (self.folder / "part.vtp").read_bytes())
        self.assertIn(b'"open":true', (self.folder / "part.glb").read_bytes())
        self.assertIn(b"open.npy", (self.folder / "part.npz").read_bytes())

    def test_the_summary_says_so(self):
        printed = self.surface(UBIQUITIN, "--spacing", "1", "--show", "//A/1-30", "-o", "a.stl").stdout
        self.assertIn("open", printed)
        self.assertRegex(printed, r"\n  area +3892\.2387 ± .* exact; .*, of the whole surface\n")

    def test_all_of_it_is_closed(self):
        report = self.report(UBIQUITIN, "--show", "//A", "--spacing", "1", "-o", "a.ply")
        self.assertEqual((report["mesh"]["shown"]["open"], report["mesh"]["closed"]), (False, True))
        self.surface(UBIQUITIN, "--spacing", "1", "-o", "b.ply")
        self.assertEqual((self.folder / "a.ply").read_bytes(), (self.folder / "b.ply").read_bytes())

    def test_nothing_and_nonsense_are_refused(self):
        self.assertIn("--show //Z", self.refused(UBIQUITIN, "--show", "//Z", "-o", "a.ply"))
        self.assertIn("--show", self.refused(UBIQUITIN, "--show", "//A/((", "-o", "a.ply"))
        self.refused(UBIQUITIN, "--show", "//A", "--per-chain", "-o", "a.ply")


class Chains(ProgramTest):
    def test_every_chain_is_as_if_alone(self):
        reports = self.report(COMPLEX, "--per-chain", "--spacing", "1", "-o", "out.ply")
        self.assertEqual([report["input"]["chain"] for report in reports], ["L", "H"])
        self.assertEqual(schema.problems(reports, RULES), [])
        for report in reports:
            chain = report["input"]["chain"]
            alone = self.report(COMPLEX, "--chains", chain, "--spacing", "1", "-o", f"{chain}.ply")
            self.assertEqual(report["input"]["atoms"], alone["input"]["atoms"])
            self.assertEqual(report["mesh"]["area"], alone["mesh"]["area"])
            self.assertEqual((self.folder / f"out_chain{chain}.ply").read_bytes(),
                             (self.folder / f"{chain}.ply").read_bytes())
            self.assertTrue((self.folder / f"out_chain{chain}.atoms.csv").exists())

    def test_a_table_may_be_about_another_chain(self):
        (self.folder / "t.csv").write_text("chain,resnum,score\nL,2,1\n", encoding="ascii")
        reports = self.report(COMPLEX, "--per-chain", "--spacing", "1", "--values", "t.csv", "-o", "out.ply")
        found = {r["input"]["chain"]: r["mesh"]["vertices"] - r["values"][0]["missing"] for r in reports}
        self.assertEqual(found["H"], 0)
        self.assertGreater(found["L"], 0)

    def test_names_that_are_no_file_names_are_escaped(self):
        lines = [line for line in UBIQUITIN.read_text().splitlines() if line.startswith("ATOM")][:40]
        (self.folder / "a.pdb").write_text("\n".join(line[:21] + "/" + line[22:] for line in lines) + "\nEND\n")
        self.surface("a.pdb", "--per-chain", "-o", "a.ply")
        self.assertIn("a_chain%2F.ply", self.files())
        self.surface("three.xyzr", "--per-chain", "-o", "b.ply")
        self.assertIn("b_chain.ply", self.files())


class Cavities(ProgramTest):
    def test_each_is_a_closed_mesh_that_faces_into_it(self):
        (self.folder / "shell.xyzr").write_text(SHELL)
        report = self.report("shell.xyzr", "--cavity-files", "-o", "a.off", "-o", "a.ply")
        self.assertEqual(self.files(), ["a.atoms.csv", "a.off", "a.ply", "a_cavity1.off", "shell.xyzr", "three.xyzr"])
        vertices, triangles = mesh_files.read_off(self.folder / "a_cavity1.off")
        self.assertTrue(mesh_files.is_closed_and_oriented(triangles))
        volume = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                     + a[2] * (b[0] * c[1] - b[1] * c[0])
                     for a, b, c in ([vertices[v] for v in t] for t in triangles)) / 6
        cavity = next(c for c in report["components"] if c["kind"] == "cavity")
        self.assertAlmostEqual(-volume / cavity["ses_volume"], 1, delta=0.02)
        self.assertEqual(schema.problems(report, RULES), [])

    def test_what_cannot_be_is_refused(self):
        self.refused("three.xyzr", "--cavity-files", "-o", "a.png")
        self.refused("three.xyzr", "--cavity-files", "--components", "outer", "-o", "a.ply")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

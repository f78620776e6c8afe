#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs `meniscus pockets`: its report, tables, files, places and models, and what it refuses.

usage: pockets_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import csv
import json
import sys
import unittest

from program_case import SHELL, SOURCE, ProgramTest

ANTIBODY = SOURCE / "examples" / "1a0q.pdb"


class Pockets(ProgramTest):
    def pockets(self, *arguments, code=0, text=None):
        result = self.run_program("pockets", *arguments, text=text)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def report(self, *arguments):
        return json.loads(self.pockets(*arguments, "-q", "--report", "-").stdout)

    def table(self, name):
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def models(self, *shifts):
        """A file of models, each a closed shell; in every second one atoms are farther from the middle."""
        lines = []
        for number, shift in enumerate(shifts, 1):
            lines.append(f"MODEL     {number:4}\n")
            for i, line in enumerate(SHELL.splitlines()):
                x, y, z = (float(word) * shift for word in line.split()[:3])
                lines.append(f"HETATM{i + 1:5}  C{i + 1:<3}LIG A{1:4}    {x:8.3f}{y:8.3f}{z:8.3f}  1.00 10.00           C\n")
            lines.append("ENDMDL\n")
        (self.folder / "models.pdb").write_text("".join(lines), encoding="ascii")
        return "models.pdb"

    def test_report_table_and_summary_have_the_same_pockets(self):
        report = self.report(ANTIBODY, "--count", "2", "-o", "a.csv", "-o", "a.json")
        rows = self.table("a.csv")
        self.assertEqual([float(row["volume"]) for row in rows], [p["volume"] for p in report["pockets"]])
        self.assertEqual([row["volume"] for row in json.loads((self.folder / "a.json").read_text())],
                         [p["volume"] for p in report["pockets"]])
        total = sum(p["volume"] for p in report["pockets"]) + report["total"]["rest_volume"]
        self.assertAlmostEqual(total / report["total"]["volume"], 1.0, 9)
        self.assertTrue(all(check["passed"] for check in report["checks"]))
        self.assertIn("L:TYR 36", report["pockets"][0]["residues"])
        text = self.pockets(ANTIBODY, "--count", "2").stdout
        self.assertIn(f"{report['pockets'][0]['volume']:.1f}", text)

    def test_threads_do_not_matter(self):
        one, two = (self.report(ANTIBODY, "--count", "3", "--threads", n)["pockets"] for n in ("1", "2"))
        self.assertEqual(one, two)

    def test_a_cavity_has_its_exact_volume(self):
        (self.folder / "shell.xyzr").write_text(SHELL, encoding="ascii")
        pockets = self.report("shell.xyzr")["pockets"]
        measured = json.loads(self.run_program("measure", "shell.xyzr", "-q", "--report", "-").stdout)
        cavity = [p for p in pockets if p["cavity"]]
        self.assertEqual(len(cavity), 1)
        self.assertEqual(cavity[0]["volume"], next(c for c in measured["components"] if c["kind"] == "cavity")["ses_volume"])
        self.assertEqual(cavity[0]["mouths"], [])

    def test_files_of_atoms_and_maps(self):
        self.pockets(ANTIBODY, "--count", "2", "-q", "-o", "a.pdb", "-o", "a.cif", "-o", "a.dx", "-o", "a.mrc")
        lines = (self.folder / "a.pdb").read_text(encoding="ascii").splitlines()
        points = [line for line in lines if line[17:20] == "STP"]
        self.assertLessEqual({"1", "2"}, {line[22:26].strip() for line in points})
        self.assertIn("STP", (self.folder / "a.cif").read_text(encoding="utf-8"))
        self.assertTrue((self.folder / "a.dx").read_text(encoding="ascii").lstrip("#").strip())

    def test_a_ligand_has_its_pocket(self):
        pocket, = self.report(ANTIBODY, "--at", "(HEP)", "-o", "at.csv")["pockets"]
        self.assertEqual((pocket["at"], pocket["site"]), ("H:HEP 214", 1))
        ligand = pocket["ligand"]
        self.assertEqual((ligand["atoms"], ligand["inside"]), (23, 23))
        self.assertGreater(ligand["sas_area"], ligand["buried_area"])
        self.assertGreater(ligand["buried_area"], 0.7 * ligand["sas_area"])
        self.assertEqual(float(self.table("at.csv")[0]["ligand_buried_area"]), ligand["buried_area"])
        exact = json.loads(self.run_program("measure", ANTIBODY, "--hetero", "ligands", "--radii", "united", "--between",
                                            "H,L:(HEP)", "-q", "--report", "-").stdout)
        side = exact["interfaces"][0]
        self.assertAlmostEqual(ligand["sas_area"], side["sas_b"], 6)

    def test_places_are_points_residues_and_lists_of_these(self):
        ligand = self.report(ANTIBODY, "--at", "(HEP)")["pockets"][0]
        point = ",".join(f"{x:.3f}" for x in ligand["centre"])
        at = self.report(ANTIBODY, "--at", point, "--at", "//L/36", "--at", "//L/36 + //L/46", "--at-reach", "5")["pockets"]
        self.assertEqual([p["at"] for p in at], [point, "//L/36", "//L/36 + //L/46"])
        self.assertTrue(all(p["ligand"] is None for p in at))
        self.assertIn("L:TYR 36", at[1]["residues"])

    def test_a_larger_reach_is_a_larger_pocket(self):
        small, large = (self.report(ANTIBODY, "--at", "(HEP)", "--at-reach", r)["pockets"][0]["volume"] for r in ("3", "5"))
        self.assertLess(small, large)

    def test_a_place_without_pocket_space(self):
        result = self.pockets(ANTIBODY, "--at", "500,500,500")
        self.assertIn("there is no pocket space at 500,500,500", result.stderr)

    def test_pockets_of_models_are_followed(self):
        models = self.models(1.0, 1.01, 0.99)
        reports = self.report(models, "--model", "all", "--hetero", "ligands", "--over-models", "all.csv")
        cavities = [p for report in reports for p in report["pockets"] if p["cavity"]]
        self.assertEqual(len({p["track"] for p in cavities}), 1)
        row = next(row for row in self.table("all.csv") if int(row["track"]) == cavities[0]["track"])
        self.assertEqual((row["models"], row["of"], row["open"]), ("3", "3", "0"))
        mean = sum(p["volume"] for p in cavities) / 3
        self.assertAlmostEqual(float(row["volume"]), mean, 6)
        spread = (sum((p["volume"] - mean) ** 2 for p in cavities) / 2) ** 0.5
        self.assertAlmostEqual(float(row["volume_sd"]), spread, 6)

    def test_what_is_refused(self):
        (self.folder / "two.xyzr").write_text("0 0 0 1.7\n9 0 0 1.7\n", encoding="ascii")
        for arguments, code, text in (
                ((ANTIBODY, "--spacing", "3"), 2, "--spacing"),
                ((ANTIBODY, "--large-probe", "1"), 2, "--large-probe"),
                ((ANTIBODY, "--count", "0"), 2, "--count"),
                ((ANTIBODY, "--at", ""), 2, "--at: empty"),
                ((ANTIBODY, "--at", "(XYZ)"), 2, "--at (XYZ)"),
                ((ANTIBODY, "--at", "1,2,3", "--at-reach", "0"), 2, "--at-reach"),
                ((ANTIBODY, "--over-models", "a.csv"), 2, "--model all"),
                ((ANTIBODY, "--model", "all", "--over-models", "a.txt"), 2, "--over-models a.txt"),
                ((ANTIBODY, "-o", "a.xyz"), 2, "unknown suffix"),
                (("missing.pdb",), 3, "missing.pdb")):
            with self.subTest(arguments=arguments):
                result = self.pockets(*arguments, code=code)
                self.assertIn(text, result.stderr)
                self.assertEqual(result.stdout, "")
        self.assertFalse(list(self.folder.glob("a.*")))

    def test_a_selection_needs_a_file(self):
        result = self.pockets("-", "--at", "(HEP)", code=2, text=ANTIBODY.read_text(encoding="ascii"))
        self.assertIn("needs a file", result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Values of maps and tables on the surface: --sample, --values and their colours.

usage: values_test.py PROGRAM SOURCE_DIR
"""
import json
import sys
import unittest

import schema
from program_case import SOURCE, ProgramTest, glycine


class Values(ProgramTest):
    def write_map(self, name, values):
        """A map of one cell of 100 Å about the origin."""
        (self.folder / name).write_text(
            "object 1 class gridpositions counts 2 2 2\norigin -50 -50 -50\ndelta 100 0 0\ndelta 0 100 0\n"
            "delta 0 0 100\nobject 2 class gridconnections counts 2 2 2\n"
            f"object 3 class array type double rank 0 items 8 data follows\n{values}\n", encoding="ascii")

    def test_values_of_maps_and_tables_are_in_the_mesh_the_report_and_the_page(self):
        (self.folder / "gly.pdb").write_text(glycine())
        self.write_map("x.dx", "-50 -50 -50 -50 50 50 50 50")
        (self.folder / "t.csv").write_text("name,resnum,score\nCA,1,2.5\n", encoding="ascii")
        report = self.report("gly.pdb", "-o", "a.ply", "-o", "a.html", "--ascii", "--sample", "phi=x.dx", "--values",
                             "t.csv", "--color", "phi:-2:2", "--offset", "1")
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        self.assertEqual(schema.problems(report, rules), [])
        self.assertEqual((report["options"]["color"], report["options"]["color_range"]), ("phi", [-2, 2]))
        score, phi = report["values"]
        self.assertEqual((score["name"], score["min"], score["max"], score["file"]), ("score", 2.5, 2.5, "t.csv"))
        self.assertGreater(score["missing"], 0)
        self.assertEqual((phi["name"], phi["missing"]), ("phi", 0))
        lines = (self.folder / "a.ply").read_text(encoding="ascii").splitlines()
        names = [line.split()[2] for line in lines if line.startswith("property") and "list" not in line]
        first = dict(zip(names, map(float, lines[lines.index("end_header") + 1].split())))
        self.assertAlmostEqual(first["phi"], first["x"] + first["nx"], places=4)
        self.assertIn("score", names)
        colours = self.report("gly.pdb", "-o", "b.ply", "--color", "plddt")
        self.assertEqual([block["name"] for block in colours["values"]], ["plddt"])

    def test_values_that_make_no_sense_are_refused(self):
        (self.folder / "gly.pdb").write_text(glycine())
        self.write_map("far.dx", "1 1 1 1 1 1 1 1")
        text = (self.folder / "far.dx").read_text().replace("-50 -50 -50", "900 900 900")
        (self.folder / "far.dx").write_text(text)
        (self.folder / "t.csv").write_text("name,resnum,depth\nCA,1,2.5\n", encoding="ascii")
        for words, code, message in (
                (["--sample", "far.dx"], 2, "NAME=FILE"), (["--sample", "area=far.dx"], 2, "name of another vertex"),
                (["--sample", "depth=far.dx"], 2, "is a scheme"), (["--sample", "v=no.dx"], 3, "no.dx"),
                (["--sample", "v=far.dx"], 3, "coordinate frame"), (["--offset", "1"], 2, "--sample"),
                (["--color", "phi"], 2, "unknown value 'phi'"), (["--values", "no.csv"], 3, "no.csv"),
                (["--values", "t.csv", "--color", "phi"], 2, "choose one of depth"),
                (["--values", "t.csv", "--color", "depth"], 2, "rename"),
                (["--values", "t.csv", "--values", "t.csv"], 2, "two arrays"),
                (["--sample", "v=far.dx", "--interpolation", "best"], 2, "linear, cubic")):
            result = self.surface("gly.pdb", "-o", "a.ply", *words, code=code)
            self.assertIn(message, result.stderr, words)
        self.assertFalse((self.folder / "a.ply").exists())

    def test_tables_of_measure_are_taken(self):
        atoms = "ATOM  {:5} {:4} GLY {}{:4}    {:8.3f}   0.000   0.000  1.00  5.00           C\n"
        (self.folder / "two.pdb").write_text("".join(
            atoms.format(i + 1, " CA ", chain, i + 1, 3.0 * i) for i, chain in enumerate("ABC")))
        for between, names in (["A:B"], ["buried_sas"]), (["A:B", "B:C"], ["buried_sas_A_B", "buried_sas_B_C"]):
            words = [word for pair in between for word in ("--between", pair)]
            self.run_program("measure", "two.pdb", *words, "-o", "t.csv", "--quiet")
            report = self.report("two.pdb", "--values", "t.csv", "-o", "a.ply", "--color", f"{names[0]}:0:50")
            found = [block["name"] for block in report["values"]]
            self.assertTrue(set(names) <= set(found), found)
        self.run_program("measure", "two.pdb", "-o", "t.csv", "-o", "r.csv", "--per", "atom", "--per", "residue", "--quiet")
        for words in (["--color", "depth"], ["--arrays", "depth"]):
            result = self.surface("two.pdb", "--values", "t.csv", "-o", "a.ply", *words)
            self.assertIn("note: t.csv: column 'depth' left alone, since the depths of the surface are asked", result.stderr)
            report = self.report("two.pdb", "--values", "t.csv", "-o", "a.ply", *words)
            self.assertEqual({block["name"]: block["file"] for block in report["values"]}["depth"], "two.pdb")
        self.assertIn("have the name 'sas_area', one of t.csv and one of r.csv; rename",
                      self.refused("two.pdb", "--values", "t.csv", "--values", "r.csv", "-o", "b.ply"))
        self.run_program("measure", "two.pdb", "-o", "t.csv", "-o", "t.json", "--per", "cavity", "--quiet")
        for name, kind in ("t.csv", "a table of cavities"), ("t.json", "JSON"):
            result = self.surface("two.pdb", "--values", name, "-o", "b.ply", code=3)
            self.assertIn(f"{name}: is {kind}; values are read from", result.stderr)
        for per in ("residue", "atom", "chain"):
            self.run_program("measure", "two.pdb", "-o", "t.csv", "--per", per, "--quiet")
            self.assertIn("sas_area", {block["name"] for block in self.report(
                "two.pdb", "--values", "t.csv", "-o", "a.ply")["values"]})

    def test_columns_of_text_are_left_alone_with_a_note(self):
        (self.folder / "gly.pdb").write_text(glycine())
        (self.folder / "t.csv").write_text("resnum,kind,score\n1,core,2.5\n", encoding="ascii")
        result = self.surface("gly.pdb", "--values", "t.csv", "-o", "a.ply")
        self.assertIn("meniscus: note: t.csv: left alone, since no cell is a number: column kind", result.stderr)
        self.assertNotIn("left alone", self.surface("gly.pdb", "--values", "t.csv", "-o", "a.ply", "--quiet").stderr)

    def test_depth_is_an_array(self):
        (self.folder / "gly.pdb").write_text(glycine())
        (self.folder / "t.csv").write_text("resnum,depth\n1,2.5\n", encoding="ascii")
        for words in (["--arrays", "depth"], ["--color", "depth"], ["--arrays", "depth", "--color", "depth"]):
            report = self.report("gly.pdb", *words, "-o", "a.ply", "-o", "a.glb", "-o", "a.npz", "-o", "a.vtp", "-o", "a.html")
            (block,) = report["values"]
            self.assertEqual((block["name"], block["missing"]), ("depth", 0))
            self.assertIn(b"property float depth", (self.folder / "a.ply").read_bytes())
            self.assertIn(b"_DEPTH", (self.folder / "a.glb").read_bytes())
            self.assertIn(b"depth.npy", (self.folder / "a.npz").read_bytes())
        self.assertEqual(self.report("gly.pdb", "--arrays", "depth", "-o", "a.ply")["options"]["arrays"], ["depth"])
        self.assertIn("choose one of depth", self.refused("gly.pdb", "--arrays", "width", "-o", "b.ply"))
        self.assertIn("'depth' is also the name of values of t.csv; rename",
                      self.refused("gly.pdb", "--arrays", "depth", "--values", "t.csv", "-o", "b.ply"))

    def test_one_colour_has_a_name(self):
        (self.folder / "gly.pdb").write_text(glycine())
        for colour in ("tomato", "#ff6347"):
            report = self.report("gly.pdb", "--color", colour, "-o", "a.ply", "-o", "a.html", "--ascii")
            self.assertEqual(report["options"]["color"], "#ff6347")
            lines = (self.folder / "a.ply").read_text(encoding="ascii").splitlines()
            self.assertEqual(lines[lines.index("end_header") + 1].split()[-4:], ["255", "99", "71", "255"])
        (self.folder / "t.csv").write_text("resnum,gold\n1,2.5\n", encoding="ascii")
        self.assertIn("rename", self.refused("gly.pdb", "--values", "t.csv", "--color", "gold", "-o", "b.ply"))
        self.surface("gly.pdb", "--values", "t.csv", "--color", "gold:0:5", "-o", "b.ply")

    def test_files_that_are_read_are_not_overwritten(self):
        (self.folder / "gly.pdb").write_text(glycine())
        self.write_map("phi.dx", "1 1 1 1 1 1 1 1")
        table = "name,resnum,score\nCA,1,2.5\n"
        (self.folder / "a.atoms.csv").write_text(table, encoding="ascii")  # as the table beside a mesh is called
        self.assertIn("a.atoms.csv: would overwrite the file of --values", self.refused("gly.pdb", "--values", "a.atoms.csv", "-o", "a.ply"))
        self.assertIn("would overwrite the file of --sample", self.refused("gly.pdb", "--sample", "phi=phi.dx", "-o", "phi.dx"))
        (self.folder / "rules").write_text("* * 1.7\n", encoding="ascii")
        self.assertIn("would overwrite the file of --radii", self.refused("gly.pdb", "--radii", "rules", "--report", "./rules"))
        self.assertEqual((self.folder / "a.atoms.csv").read_text(encoding="ascii"), table)

    def test_columns_without_the_same_vertices_are_told_in_one_line(self):
        (self.folder / "gly.pdb").write_text(glycine())
        (self.folder / "t.csv").write_text("name,resnum,a,b,c\nCA,1,1,2,3\n", encoding="ascii")
        result = self.surface("gly.pdb", "--values", "t.csv", "-o", "a.ply")
        self.assertEqual(result.stderr.count("have no value"), 1, result.stderr)
        self.assertRegex(result.stderr, r"t.csv: \d+ of \d+ vertices have no value 'a', nor of 2 more\n")

    def test_missing_values_are_in_every_format(self):
        (self.folder / "gly.pdb").write_text(glycine())
        (self.folder / "t.csv").write_text("name,resnum,score\nCA,1,2.5\n", encoding="ascii")
        result = self.surface("gly.pdb", "--values", "t.csv", "--color", "score", "-o", "a.glb", "-o", "a.ply", "-o", "a.vtp",
                              "-o", "a.npz", "-o", "a.html")
        self.assertRegex(result.stderr, r"t.csv: \d+ of \d+ vertices have no value 'score'")
        self.assertIn(b'"missing":{"_SCORE":-3.4', (self.folder / "a.glb").read_bytes())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Pages of structures whose names are scripts, as a parser of HTML reads them: they have the elements and attributes of
any other page, and of scripts only those that the page's own policy names.

usage: escape_test.py PROGRAM
"""
import base64
import csv
import hashlib
import html.parser
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import hostile

PROGRAM = pathlib.Path(sys.argv[1]).resolve()


class Reader(html.parser.HTMLParser):
    """Elements with their attributes, texts, and what scripts say."""

    def __init__(self, page):
        super().__init__(convert_charrefs=True)
        self.elements, self.texts, self.scripts, self.policy, self.inside = [], [], [], "", None
        self.feed(page)
        self.close()

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if values.get("http-equiv") == "Content-Security-Policy":
            self.policy = values["content"]
        self.elements.append((tag, *sorted((key, value) for key, value in values.items() if key not in ("src", "alt"))))
        self.inside = tag
        if tag == "script" and "type" not in values:
            self.scripts.append("")

    def handle_data(self, data):
        if self.inside == "script":
            if self.scripts and self.elements[-1] == ("script",):
                self.scripts[-1] += data
        else:
            self.texts.append(data)

    def handle_endtag(self, tag):
        self.inside = None

    def handle_comment(self, data):
        raise AssertionError(f"a comment: {data}")


class EscapeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        harmless = [f"N{i}" for i in range(len(hostile.PAYLOADS))]
        cls.harmless = cls.page("harmless", "harmless.cif", harmless)
        cls.hostile = cls.page("hostile", hostile.FILE_NAME, hostile.PAYLOADS)

    @classmethod
    def page(cls, folder, name, names):
        folder = cls.folder / folder
        folder.mkdir()
        (folder / name).write_text(hostile.mmcif(names), encoding="utf-8")
        (folder / "values.csv").write_text("serial,score\n1,1\n2,2\n", encoding="ascii")
        subprocess.run([PROGRAM, "surface", name, "--values", "values.csv", "-o", "page.html", "-o", "mesh.glb",
                        "-o", "mesh.vtp", "-o", "mesh.ply", "--report", "report.json", "--quiet", "--spacing", "1"],
                       cwd=folder, check=True, capture_output=True)
        return (folder / "page.html").read_text(encoding="utf-8")

    def test_names_change_no_element_and_no_attribute(self):
        self.assertEqual(Reader(self.hostile).elements, Reader(self.harmless).elements)

    def test_names_are_there_as_text(self):
        shown = "".join(Reader(self.hostile).texts)
        self.assertIn(hostile.FILE_NAME, shown)
        self.assertNotIn("intruder", "".join(Reader(self.hostile).scripts))

    def test_only_scripts_of_the_policy_are_there(self):
        reader = Reader(self.hostile)
        self.assertEqual(len(reader.scripts), 1)
        digest = base64.b64encode(hashlib.sha256(reader.scripts[0].encode()).digest()).decode()
        self.assertIn(f"'sha256-{digest}'", reader.policy)
        for word in ("default-src 'none'", "base-uri 'none'", "form-action 'none'"):
            self.assertIn(word, reader.policy)
        self.assertNotIn("unsafe", reader.policy)

    def test_reports_and_heads_of_meshes_stay_what_they_are(self):
        report = json.loads((self.folder / "hostile" / "report.json").read_text(encoding="utf-8"))
        self.assertEqual(report["input"]["file"], hostile.FILE_NAME)
        glb = (self.folder / "hostile" / "mesh.glb").read_bytes()
        size = int.from_bytes(glb[12:16], "little")
        self.assertIn("meshes", json.loads(glb[20:20 + size].decode("utf-8")))
        head = (self.folder / "hostile" / "mesh.vtp").read_bytes().partition(b"<AppendedData")[0]
        self.assertNotIn(b"intruder", head)

    def test_names_in_tables_are_those_of_the_input(self):
        """Also what a spreadsheet takes for a formula: tables are joined by names (docs/design/supply-chain.md)."""
        names = ["=1+1", "+1", "-1", "@A", "A,B", "A\"B", "=CMD|' /C X'!A0"]
        self.page("formulas", "table.cif", names)
        with open(self.folder / "formulas" / "mesh.atoms.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        for column in ("chain", "resname", "name"):
            self.assertEqual([row[column] for row in rows], names, column)

    def test_a_value_whose_name_is_a_script_is_refused(self):
        for name in ("<script>", "a b", "\"x\""):
            quoted = name.replace('"', '""')
            (self.folder / "bad.csv").write_text(f"serial,\"{quoted}\"\n1,1\n", encoding="ascii")
            done = subprocess.run([PROGRAM, "surface", "harmless/harmless.cif", "--values", "bad.csv", "-o", "bad.html"],
                                  cwd=self.folder, capture_output=True, check=False)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertFalse((self.folder / "bad.html").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

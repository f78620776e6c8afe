#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The reference has every option with its default and a working example, every suffix and every key of the report.

usage: reference_test.py PROGRAM SOURCE_DIR
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import markdown

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
sys.path.append(str(SOURCE / "tests" / "support"))

from sanitized import is_sanitized  # noqa: E402

REFERENCE = SOURCE / "docs" / "reference"
ENTRY = re.compile(r"^  (-[\w-]+)(?:, (--[\w-]+))?(?: (\S+))?(?:  |$)")
CODE = re.compile(r"`([^`]*)`")



def options_of_help(*command):
    """Every option of a subcommand, from --help-all: name -> (value, default)."""
    text = subprocess.run([PROGRAM, *command, "--help-all"], capture_output=True, encoding="utf-8", check=True).stdout
    options, entry, value = {}, None, ""
    for line in text.partition("\n\n")[2].splitlines():
        match = ENTRY.match(line)
        if match:
            entry, value, words = match.group(2) or match.group(1), match.group(3) or "", ""
        if entry and line.startswith("  "):
            words += " " + line.strip()
            default = re.search(r"\[([^\[\]]*)\]$", words)
            options[entry] = (value, default.group(1) if default else "")
        else:
            entry = None
    return options


def options_of_page():
    """Option -> (value, default, example, heading), as docs/reference/options.md has them."""
    found = {}
    for heading, cells in markdown.tables(REFERENCE / "options.md"):
        for code in CODE.findall(cells[0]):
            name, _, value = code.partition(" ")
            entry = (value, cells[1].strip("`"), CODE.findall(cells[3])[0], heading)
            found[(heading, name) if heading == "Pockets" and name in found else name] = entry
    return found


class Options(unittest.TestCase):
    def setUp(self):
        self.page = options_of_page()
        self.help = {command: options_of_help(command) for command in ("surface", "measure", "pockets", "compare")}
        for command in ("surface", "measure"):  # a batch has these, too, and its own
            self.help[f"batch {command}"] = {name: rest for name, rest in options_of_help("batch", command).items()
                                             if name not in self.help[command]}

    def test_the_page_has_every_option_and_no_other(self):
        known = set().union(*self.help.values()) | {"-h", "--help", "--help-all", "-q", "-V", "--version"}
        self.assertEqual({name for name in self.page if isinstance(name, str)}, known)
        self.assertGreater(len(known), 40)

    def test_values_and_defaults_are_those_of_the_program(self):
        of_pockets = {"--radii": "united", "--hetero": "none"}  # as the text above their table says
        for command, options in self.help.items():
            for name, (value, default) in options.items():
                entry = self.page.get(("Pockets", name), self.page[name]) if command == "pockets" else self.page[name]
                self.assertEqual(entry[0], value, name)
                if default and not (command == "pockets" and of_pockets.get(name) == default):
                    self.assertEqual(entry[1], default, name)

    def test_every_example_works(self):
        with tempfile.TemporaryDirectory(prefix="meniscus-docs-") as folder:
            folder = pathlib.Path(folder)
            self.write_sample(folder / "in.pdb")
            self.write_values(folder)
            (folder / "list.txt").write_text("in.pdb\n")
            for name, (_, _, example, heading) in self.page.items():
                if name == "--memory-limit" and is_sanitized(PROGRAM):
                    continue  # it limits the address space
                if heading != "The program":
                    command = {"Measures": "measure", "Pockets": "pockets", "Comparing": "compare", "A batch": "batch"}.get(heading, "surface")
                    self.try_example(folder, command, name, example)

    def try_example(self, folder, command, name, example):
        words = [command, "in.pdb", *(["in.pdb"] if command == "compare" else []), *example.split()]
        if command == "batch":
            words = ["batch", "measure", *words[1:], *([] if "--out" in example else ["--out", f"out{name}"])]
        heading = self.page[name][3]
        if heading == "Colours and pictures":
            words += ["-o", "a.png"] + ([] if "--size" in example else ["--size", "20x15"])
        elif command == "surface" and "-o" not in words:
            words += ["-o", "a.ply"]
        result = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, encoding="utf-8", check=False)
        # A flow made of pieces of another need not converge.
        self.assertIn(result.returncode, (0, 6) if heading == "Flow" else (0,), f"{words} {result.stderr}")

    @staticmethod
    def write_sample(path):
        """The first residues of both chains, with the head of the file, which names an assembly."""
        lines = (SOURCE / "examples" / "1a0q.pdb").read_text().splitlines()
        kept = [line for line in lines if line.startswith("REMARK 350")
                or (line.startswith("ATOM") and int(line[22:26]) < 5)]
        path.write_text("\n".join(kept) + "\nEND\n")

    @staticmethod
    def write_values(folder):
        """A map of one cell about everything, and a table of a residue."""
        (folder / "pot.dx").write_text(
            "object 1 class gridpositions counts 2 2 2\norigin -500 -500 -500\ndelta 1000 0 0\ndelta 0 1000 0\n"
            "delta 0 0 1000\nobject 2 class gridconnections counts 2 2 2\n"
            "object 3 class array type double rank 0 items 8 data follows\n-1 0 1\n0 1 2\n1 2\n")
        (folder / "cons.csv").write_text("chain,resnum,score\nL,2,0.5\nH,3,1\n")


class Formats(unittest.TestCase):
    def test_the_page_has_every_suffix_that_the_program_knows(self):
        text = (REFERENCE / "formats.md").read_text(encoding="utf-8")
        for command in ("surface", "measure", "pockets"):
            result = subprocess.run([PROGRAM, command, "in.pdb", "-o", "a.unknown"], capture_output=True,
                                    encoding="utf-8", check=False)
            suffixes = re.findall(r"\.\w+", result.stderr.partition("choose one of")[2])
            self.assertGreater(len(suffixes), 3, result.stderr)
            for suffix in suffixes:
                self.assertIn(f"`{suffix}`", text, command)


def keys_of_schema():
    """Every key of the report as "block.key", where a block is named by its place: mesh.quality.edges.min."""
    schema = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
    found = set()

    def visit(rules, place):
        if "$ref" in rules:
            return visit(schema["$defs"][rules["$ref"].removeprefix("#/$defs/")], place)
        for branch in rules.get("anyOf", []):
            visit(branch, place)
        if "items" in rules:
            visit(rules["items"], place)
        for key, inner in rules.get("properties", {}).items():
            name = f"{place}.{key}" if place else key
            found.add(name)
            visit(inner, name)
        return None

    visit(schema["$defs"]["report"], "")
    return found


class Report(unittest.TestCase):
    def test_the_page_has_every_key_and_no_other(self):
        page = set()
        for _, cells in markdown.tables(REFERENCE / "report.md"):
            page.update(CODE.findall(cells[0]))
        keys = keys_of_schema()
        self.assertGreater(len(keys), 100)
        self.assertEqual(sorted(page - keys), [], "documented, but not in docs/report.schema.json")
        self.assertEqual(sorted(keys - page), [], "in docs/report.schema.json, but not documented")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

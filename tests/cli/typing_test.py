#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What people type: other programs' words, misspelt ones, pipes, and what helps them to type: completion and man pages.

usage: typing_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import csv
import io
import json
import os
import pathlib
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
SUBCOMMANDS = ("surface", "measure", "pockets", "compare", "batch")

ATOMS = """\
ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00           N
ATOM      2  CA  GLY A   1       1.458   0.000   0.000  1.00  0.00           C
ATOM      3  N   ALA A   2       3.002  -0.715  -1.735  1.00  0.00           N
ATOM      4  CA  ALA A   2       3.608  -1.654  -2.672  1.00  0.00           C
ATOM      5  CA  GLY B   3       7.301  -2.583  -2.699  1.00  0.00           C
HETATM    6  C1  HEP C   1      20.000   0.000   0.000  1.00  0.00           C
HETATM    7  C2  HEP C   1      21.500   0.000   0.000  1.00  0.00           C
END
"""


class Typing(unittest.TestCase):
    """Every test runs in an empty folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-typing-"))
        (self.folder / "a.pdb").write_text(ATOMS)

    def tearDown(self):
        shutil.rmtree(self.folder)

    def run_program(self, *words, **options):
        return subprocess.run([PROGRAM, *words], cwd=self.folder, capture_output=True, check=False, **options)

    def messages(self, *words, code=0):
        result = self.run_program(*words)
        text = result.stderr.decode()
        self.assertEqual(result.returncode, code, text)
        return text

    def refusal(self, *words, code=2):
        text = self.messages(*words, code=code)
        self.assertEqual(text.count("\n"), 1, text)
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.pdb"])
        return text


class Words(Typing):
    def test_an_identifier_is_no_file(self):
        hint = "get 1ubq.cif from the PDB (https://files.rcsb.org/download/1ubq.cif)"
        for words in (("surface", "1UBQ"), ("measure", "1UBQ"), ("compare", "1UBQ", "a.pdb")):
            self.assertIn("1UBQ is not a file; Meniscus does not download: " + hint, self.refusal(*words, code=3))
        self.assertIn(hint, self.refusal("1ubq"))
        self.assertIn("alphafold.ebi.ac.uk/entry/P69905", self.refusal("measure", "P69905", code=3))

    def test_options_before_the_subcommand_and_unknown_ones_are_named(self):
        early = "--quiet: options come after the subcommand; write meniscus measure --quiet ..."
        self.assertIn(early, self.refusal("--quiet", "measure", "a.pdb"))
        self.assertIn("write meniscus batch measure --out ...", self.refusal("batch", "--out", "x", "measure", "a.pdb"))
        self.assertIn("--nosuch: unknown option", self.refusal("surface", "--nosuch"))
        self.assertIn("-V is an option of meniscus itself; write meniscus -V", self.refusal("surface", "-V"))
        self.assertIn("-v: unknown option; did you mean -V?", self.refusal("-v"))
        self.assertIn("--foo: unknown option", self.refusal("--foo"))
        self.assertIn("--foo: unknown option", self.refusal("--foo", "measure", "a.pdb"))
        self.assertIn("-o=y.ply: write -o y.ply", self.refusal("surface", "a.pdb", "-o=y.ply"))

    def test_help_is_asked_for_in_any_order(self):
        wanted = self.run_program("surface", "--help").stdout
        for words in (("help", "surface"), ("--help", "surface"), ("-h", "surface"), ("surface", "help")):
            self.assertEqual(self.run_program(*words).stdout, wanted, words)
        wanted = self.run_program("batch", "measure", "--help").stdout
        for words in (("help", "batch", "measure"), ("batch", "help", "measure"), ("batch", "measure", "help")):
            self.assertEqual(self.run_program(*words).stdout, wanted, words)
        self.assertEqual(self.run_program("--help-all", "compare").stdout,
                         self.run_program("compare", "--help-all").stdout)
        self.assertIn(b"meniscus help batch measure", self.run_program("help", "batch").stdout)

    def test_a_mesh_is_not_a_structure(self):
        for name in ("a.ply", "a.stl"):
            (self.folder / name).write_bytes(b"ply\0\0")
            self.assertIn("is a mesh, not a structure", self.messages("measure", name, code=3))

    def test_selections_of_pymol_are_understood_with_a_note(self):
        text = self.messages("measure", "a.pdb", "--select", "chain A and resi 1-1")
        self.assertIn("note: a.pdb: --select chain A and resi 1-1: understood as //A/1-1.Z\n", text)
        text = self.messages("surface", "a.pdb", "--show", "chain A and name CA", "-o", "a.ply", "--spacing", "1")
        self.assertIn("note: --show chain A and name CA: understood as //A/*/CA\n", text)
        self.assertNotIn("understood", self.messages("measure", "a.pdb", "--select", "chain A", "--quiet"))
        self.assertIn("--show resi 500: understood as //*/500-500, selects none of the kept atoms",
                      self.messages("surface", "a.pdb", "--show", "resi 500", "-o", "b.ply", "--spacing", "1", code=2))
        text = self.messages("measure", "a.pdb", "--select", "//A/-1")
        self.assertIn("--select //A/-1: understood as all residues up to 1\n", text)
        self.assertIn("larger than residue numbers may be", self.messages("measure", "a.pdb", "--select", "//A/4294967297", code=2))
        text = self.messages("measure", "a.pdb", "--between", "chain A:chain B")
        self.assertIn("note: --between chain A:chain B: understood as A:B\n", text)

    def test_a_bare_residue_name_is_taken_with_a_note(self):
        text = self.messages("measure", "a.pdb", "--select", "HEP", "--hetero", "ligands")
        self.assertIn("--select HEP: understood as (HEP)", text)

    def test_what_has_no_exact_form_is_refused_with_the_right_one(self):
        self.assertIn("//A,B", self.refusal("measure", "a.pdb", "--select", "chain A or chain B"))
        self.assertIn(";polymer", self.refusal("measure", "a.pdb", "--select", "protein"))
        self.assertIn("--show", self.refusal("surface", "a.pdb", "-o", "a.ply", "--show", "not chain A", "-q"))

    def test_misspelt_and_misplaced_words(self):
        self.assertIn("did you mean meniscus measure?", self.refusal("mesure", "a.pdb"))
        self.assertIn("--between is an option of meniscus measure and batch, not of meniscus surface",
                      self.refusal("surface", "a.pdb", "--between", "A:B"))
        self.assertIn("--edge is an option of meniscus surface and batch", self.refusal("measure", "a.pdb", "--edge=1"))

    def test_what_the_parser_refuses_is_said_in_plain_words(self):
        raw = re.compile(r"excludes|required|Could not|unrecognized|Most|argument")
        cases = {
            ("surface",): "INPUT: missing; see meniscus surface --help",
            ("compare", "a.pdb"): "B: missing; see meniscus compare --help",
            (): "no subcommand; write meniscus surface|measure|pockets|compare|batch; see meniscus --help",
            ("batch", "foo"): "no subcommand; write meniscus batch surface|measure|pockets",
            ("batch", "measure", "a.pdb"): "--out: missing",
            ("surface", "a.pdb", "--edge", "1", "--vertex-density", "2"): "cannot be combined; give one of them",
            ("surface", "a.pdb", "--probe"): "--probe: a value is missing; write --probe R",
            ("measure", "a.pdb", "-o"): "-o: a value is missing; write -o FILE",
            ("surface", "a.pdb", "--probe", "1", "--probe", "2"): "--probe: given 2 times; give it once",
            ("surface", "a.pdb", "--ascii=x"): "--ascii takes no value; leave =x out",
            ("measure", "a.pdb", "--waters=5"): "--waters takes no value; leave =5 out",
        }
        for words, expected in cases.items():
            text = self.refusal(*words)
            self.assertIn(expected, text)
            self.assertIsNone(raw.search(text), text)

    def test_short_options_and_help(self):
        self.assertEqual(self.run_program("-V").stdout, self.run_program("--version").stdout)
        result = self.run_program("measure", "a.pdb", "-q")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""))
        self.assertEqual(self.run_program("help").stdout, self.run_program("--help").stdout)
        for command in SUBCOMMANDS:
            self.assertEqual(self.run_program("help", command).stdout, self.run_program(command, "--help").stdout)
        self.assertIn("did you mean meniscus surface?", self.refusal("help", "surfac"))


class Pipes(Typing):
    def test_a_mesh_on_standard_output_is_that_of_the_file(self):
        for form in ("ply", "stl", "obj", "off", "glb", "vtp", "npz", "xyzrn", "dx", "png", "html"):
            result = self.run_program("surface", "a.pdb", "-o", "-", "--format", form, "--spacing", "1", "--size", "60x40") \
                if form == "png" else self.run_program("surface", "a.pdb", "-o", "-", "--format", form, "--spacing", "1")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn(b"written     standard output\n", result.stderr)
            self.assertEqual(os.listdir(self.folder), ["a.pdb"])
            size = ("--size", "60x40") if form == "png" else ()
            self.run_program("surface", "a.pdb", "-o", f"b.{form}", "--spacing", "1", *size)
            if form not in ("html",):  # a page says how long it took
                self.assertEqual(result.stdout, (self.folder / f"b.{form}").read_bytes(), form)
            for path in self.folder.glob("b.*"):
                path.unlink()

    def test_tables_on_standard_output(self):
        for words in (("-o", "-", "--format", "csv"), ("--format", "csv"), ("-o", "/dev/stdout", "--format", "CSV")):
            result = self.run_program("measure", "a.pdb", "--per", "residue", *words)
            rows = list(csv.DictReader(io.StringIO(result.stdout.decode())))
            self.assertEqual([row["resname"] for row in rows], ["GLY", "ALA", "GLY"])
            self.assertIn(b"SES area", result.stderr)
        result = self.run_program("measure", "a.pdb", "--format", "json", "-q", "--report", "r.json")
        self.assertEqual(len(json.loads(result.stdout)), 3)
        self.assertEqual(result.stderr, b"")
        self.assertTrue((self.folder / "r.json").exists())

    def test_compare_writes_its_mesh(self):
        result = self.run_program("compare", "a.pdb", "a.pdb", "--format", "ply", "--spacing", "1")
        self.assertTrue(result.stdout.startswith(b"ply\n"), result.stderr)
        self.assertIn("--format obj: this format cannot hold distances", self.refusal("compare", "a.pdb", "a.pdb", "--format", "obj"))

    def test_what_cannot_be_is_refused(self):
        self.assertIn("add --format", self.refusal("surface", "a.pdb", "-o", "-"))
        self.assertIn("two outputs", self.refusal("surface", "a.pdb", "-o", "-", "-o", "-", "--format", "ply"))
        self.assertIn("both would go", self.refusal("surface", "a.pdb", "--format", "ply", "--report", "-"))
        self.assertIn("pair of files", self.refusal("surface", "a.pdb", "--format", "vert"))
        self.assertIn("choose one of ply obj stl", self.refusal("surface", "a.pdb", "--format", "foo"))
        self.assertIn("choose one of csv json", self.refusal("measure", "a.pdb", "--format", "ply"))
        self.assertIn("--model all", self.refusal("surface", "a.pdb", "--format", "ply", "--model", "all"))
        self.assertIn("--per-chain", self.refusal("surface", "a.pdb", "--format", "ply", "--per-chain"))
        self.assertIn("--cavity-files", self.refusal("surface", "a.pdb", "--format", "ply", "--cavity-files"))
        self.assertIn("--snapshots", self.refusal("surface", "a.pdb", "--format", "ply", "--snapshots", "1"))
        self.assertIn("--maps apbs", self.refusal("surface", "a.pdb", "--format", "dx", "--maps", "apbs", "--grid", "9,9,9,1,0,0,0"))
        self.assertIn("the suffix of a file", self.refusal("surface", "a.pdb", "-o", "b.ply", "--format", "obj"))

    def test_bytes_are_kept_from_a_terminal(self):
        main, terminal = pty.openpty()
        try:
            for words, code in ((("--format", "ply"), 2), (("--format", "png"), 2), (("--format", "xyzr"), 0)):
                result = subprocess.run([PROGRAM, "surface", "a.pdb", "--spacing", "1", *words], cwd=self.folder,
                                        stdout=terminal, stderr=subprocess.PIPE, check=False)
                self.assertEqual(result.returncode, code, result.stderr)
                self.assertEqual(b"is a terminal" in result.stderr, code == 2)
        finally:
            os.close(main)
            os.close(terminal)

    def test_suffixes_in_capitals(self):
        for command, name in (("surface", "b.PLY"), ("surface", "b.Xyzr"), ("surface", "b.DX"), ("measure", "b.CSV"),
                              ("measure", "b.PDB"), ("measure", "b.JSON")):
            words = ("--spacing", "1") if command == "surface" else ()
            self.messages(command, "a.pdb", "-o", name, *words)
            self.assertTrue((self.folder / name).exists())


def options_of_help(*command):
    text = subprocess.run([PROGRAM, *command, "--help-all"], capture_output=True, encoding="utf-8", check=True).stdout
    return set(re.findall(r"^  (?:-\w, )?(--?[\w-]+)", text.partition("\n\n")[2], re.MULTILINE))


class Made(Typing):
    def complete(self, *words):
        """What bash offers for the last of these words."""
        script = ('source <("$1" --completion bash); shift; complete -p meniscus >/dev/null || exit 1; COMP_WORDS=("$@"); '
                  'COMP_CWORD=$(($# - 1)); _meniscus; printf "%s\\n" "${COMPREPLY[@]}"')
        result = subprocess.run(["bash", "-c", script, "bash", PROGRAM, "meniscus", *words], cwd=self.folder,
                                capture_output=True, encoding="utf-8", check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout.split()

    def test_bash_completes_subcommands_options_and_words(self):
        self.assertEqual(self.complete("sur"), ["surface"])
        self.assertEqual(self.complete(""), [*SUBCOMMANDS, "help"])
        self.assertEqual(self.complete("help", "me"), ["measure"])
        self.assertEqual(self.complete("batch", ""), ["surface", "measure", "pockets"])
        self.assertEqual(self.complete("surface", "--meth"), ["--method"])
        self.assertEqual(self.complete("surface", "--method", ""), ["flow", "direct", "gaussian"])
        self.assertEqual(self.complete("surface", "a.pdb", "--method", "=", "d"), ["direct"])
        self.assertEqual(self.complete("surface", "--method", "="), ["flow", "direct", "gaussian"])
        self.assertEqual(self.complete("measure", "a.pdb", "--betw"), ["--between"])
        self.assertEqual(self.complete("surface", "a.pdb", "--betw"), [])
        self.assertIn("hydrophobicity", self.complete("surface", "--color", "h"))
        self.assertEqual(self.complete("measure", "a"), [])  # files are bash's own matter
        self.assertEqual(self.complete("batch", "measure", "--ou"), ["--out"])
        self.assertEqual(self.complete("--ver"), ["--version"])

    def test_every_option_is_completed_and_in_a_man_page(self):
        zsh = self.run_program("--completion", "zsh").stdout.decode()
        for command in ((), ("surface",), ("measure",), ("compare",), ("batch", "surface"), ("batch", "measure")):
            names = options_of_help(*command) if command else {"--help", "--help-all", "--version"}
            self.assertIn("--help-all", self.complete(*command, "--"))
            self.assertLessEqual({name for name in names if name.startswith("--")}, set(self.complete(*command, "--")))
            function = "".join("_" + word for word in ("meniscus", *command)) + "() {"
            body = zsh.partition(function)[2].partition("\n}\n")[0]
            page = self.run_program("--man", *command[:1]).stdout.decode().replace("\\-", "-")
            for name in names:
                self.assertRegex(body, rf"'\*{name}=?\[", command)
                self.assertIn(f"\\fB{name}\\fR", page, command)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_reads_its_script(self):
        script = self.run_program("--completion", "zsh").stdout
        subprocess.run(["zsh", "-n", "/dev/stdin"], input=script, check=True)

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_man_pages_are_set_without_warnings(self):
        pages = [self.run_program("--man", *name).stdout for name in ((), *((name,) for name in SUBCOMMANDS))]
        pages += [page.read_bytes() for page in (SOURCE / "cli" / "dropins" / "man1").glob("*.1")
                  if not page.read_text().startswith(".so")]
        self.assertEqual(len(pages), 9)
        for page in pages:
            self.assertTrue(page.isascii())
            result = subprocess.run(["groff", "-man", "-ww", "-Tutf8"], input=page, capture_output=True, check=False)
            self.assertEqual((result.returncode, result.stderr), (0, b""), page[:200])
            self.assertIn(b"DESCRIPTION", re.sub(b".\x08", b"", result.stdout))  # without overstrikes

    def test_unknown_pages_are_refused(self):
        self.assertIn("choose one of bash zsh", self.refusal("--completion", "fish"))
        self.assertIn("unknown subcommand 'foo'", self.refusal("--man", "foo"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])

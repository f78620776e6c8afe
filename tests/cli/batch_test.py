#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs `meniscus batch` as it is built: what it finds, what it refuses and what it writes.

usage: batch_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import unittest

from batch_case import BatchTest, contents, spheres
from program_case import PROGRAM, UBIQUITIN


class Results(BatchTest):
    def test_a_line_per_input_in_order_of_names(self):
        text = self.batch("measure", "in", "--out", "out", code=6).stdout
        results = self.results()
        names = [result["input"] for result in results]
        self.assertEqual(names, sorted(names))
        self.assertEqual(len(names), 13)
        self.assertIn("a/deep/m0.xyzr", names)
        bad = results[names.index("bad.xyzr")]
        self.assertEqual((bad["status"], bad["exit"], bad["outputs"], bad["report"]), ("failed", 3, [], None))
        self.assertRegex(bad["error"], r"^bad\.xyzr:2:")
        self.assertEqual([r["status"] for r in results].count("done"), 12)
        self.assertRegex(text, r"(?m)^  bad\.xyzr +failed +bad\.xyzr:2:")
        self.assertIn("13 inputs, 1 failed", text)

    def test_reports_are_those_of_the_subcommand(self):
        self.batch("measure", "in", "--out", "out", "--probe", "1.2", "--threads", "1", code=6)
        result = next(r for r in self.results() if r["input"] == "b/deep/m4.xyzr")
        alone = subprocess.run([PROGRAM, "measure", self.inputs / "b/deep/m4.xyzr", "--report", "-", "--probe", "1.2"],
                               capture_output=True, check=True).stdout
        expected = json.loads(alone)
        del expected["time_s"], expected["peak_memory_mb"], expected["options"]["threads"]
        self.assertEqual(result["report"], expected)
        times = [json.loads(line) for line in (self.folder / "out/times.jsonl").read_text().splitlines()]
        self.assertEqual([t["input"] for t in times], [r["input"] for r in self.results()])
        self.assertGreater(times[0]["run"]["peak_memory_mb"], 1)

    def test_the_folder_of_outputs_is_laid_out_as_the_inputs(self):
        self.batch("surface", "in", "--out", "out", "--spacing", "1", "-o", ".stl", "-o", "_x.obj", code=6)
        files = contents(self.folder / "out")
        self.assertEqual(len(files), 12 * 4 + 1)  # each mesh has its table of atoms
        self.assertIn("c/deep/m2.stl", files)
        self.assertIn("packed_x.obj", files)
        result = next(r for r in self.results() if r["input"] == "c/deep/m2.xyzr")
        self.assertEqual(result["outputs"], ["c/deep/m2.atoms.csv", "c/deep/m2.stl", "c/deep/m2_x.atoms.csv", "c/deep/m2_x.obj"])
        subprocess.run([PROGRAM, "surface", self.inputs / "c/deep/m2.xyzr", "--spacing", "1", "-o", self.folder / "x.stl"],
                       capture_output=True, check=True)
        self.assertEqual((self.folder / "x.stl").read_bytes(), files["c/deep/m2.stl"])

    def test_pockets_of_every_input(self):
        self.batch("pockets", "in", "--out", "out", "--radii", "auto", "-o", ".csv", "-o", ".ply", code=6)
        result = next(r for r in self.results() if r["input"] == "a/deep/m9.xyzr")
        self.assertEqual(result["outputs"], ["a/deep/m9.csv", "a/deep/m9.ply"])
        rows = (self.folder / "out/a/deep/m9.csv").read_text().splitlines()
        self.assertEqual(len(result["report"]["pockets"]), len(rows) - 1)
        subprocess.run([PROGRAM, "pockets", self.inputs / "a/deep/m9.xyzr", "--radii", "auto", "-o", self.folder / "x.ply"],
                       capture_output=True, check=True)
        self.assertEqual((self.folder / "x.ply").read_bytes(), (self.folder / "out/a/deep/m9.ply").read_bytes())
        refused = self.batch("pockets", "in", "--out", "out2", "-o", ".stl", code=2)
        self.assertIn("unknown suffix", refused.stderr)

    def test_a_mesh_is_the_default_of_surface(self):
        self.batch("surface", "in/top.XYZR", "--out", "out", "--spacing", "1")
        self.assertEqual(sorted(contents(self.folder / "out")), ["results.jsonl", "top.atoms.csv", "top.ply"])

    def test_records_of_the_flow_are_outputs_of_every_input(self):
        self.batch("surface", "in/a", "--out", "out", "--spacing", "1", "--history", ".csv", "-o", ".stl")
        self.assertLess({"deep/m0.csv", "deep/m9.csv"}, set(contents(self.folder / "out")))
        self.assertIn("deep/m0.csv", self.results()[0]["outputs"])
        self.assertIn("--history h.csv", self.refused("surface", "in/a", "--out", "other", "--history", "h.csv"))

    def test_failed_checks_are_marked_and_outputs_kept(self):
        self.batch("surface", self.write("two.xyzr", b"0 0 0 1.7\n2 0 0 1.7\n"), "--out", "out", "--flow", "paper", code=6)
        result, = self.results()
        self.assertEqual((result["status"], result["exit"]), ("checks failed", 6))
        self.assertIn("failed its checks", result["error"])
        self.assertEqual(result["outputs"], ["two.atoms.csv", "two.ply"])

    def test_large_ones_come_first(self):
        self.batch("measure", "in", "--out", "out", "--jobs", "1", code=6)
        log = (self.folder / "out/.batch/shard-0-of-1.log").read_text().splitlines()[1:]
        names = [json.loads(line)["result"]["input"] for line in log]
        self.assertEqual(names[:3], ["a/deep/m9.xyzr", "c/deep/m8.xyzr", "b/deep/m7.xyzr"])

    def test_small_molecules_and_units_are_inputs_as_others(self):
        atom = "{0:6}{1:5}  C{1}  {2} A   1    {3:8.3f}   0.000   0.000  1.00  0.00           C\n".format
        folder = self.folder / "mixed"
        folder.mkdir()
        (folder / "ligand.pdb").write_text(atom("HETATM", 1, "UNL", 0) + atom("HETATM", 2, "UNL", 1.5))
        (folder / "peptide.pdb").write_text(atom("ATOM", 1, "GLY", 0) + atom("HETATM", 2, "UNL", 9))
        model = atom("ATOM", 1, "GLY", 0)
        (folder / "unit.pdb1").write_text(f"MODEL 1\n{model}ENDMDL\nMODEL 2\n{model.replace('0.000  ', '4.000  ')}ENDMDL\n")
        self.batch("measure", "mixed", "--out", "out", "--radii", "bondi", "--model", "join")
        reports = {line["input"]: line["report"]["input"] for line in self.results()}
        self.assertEqual({name: r["atoms"] for name, r in reports.items()},
                         {"ligand.pdb": 2, "peptide.pdb": 1, "unit.pdb1": 2})

    def test_every_model_has_a_report(self):
        atom = "ATOM      1  CA  GLY A   1      {:6.3f}   0.000   0.000  1.00 10.00           C\n"
        self.write("x/two.pdb", "".join(f"MODEL     {i:4}\n{atom.format(i)}ENDMDL\n" for i in (1, 2)).encode())
        self.batch("measure", "in/x", "--out", "out", "--model", "all")
        self.assertEqual([r["input"]["model"] for r in self.results()[0]["report"]], [1, 2])

    def test_progress_as_lines_of_json(self):
        errors = self.batch("measure", "in", "--out", "out", "--progress", "json", "--quiet", code=6).stderr
        self.assertEqual(set(json.loads(errors.splitlines()[0])), {"done", "failed", "inputs", "time_s", "left_s"})

    def test_quiet(self):
        result = self.batch("measure", "in/top.XYZR", "--out", "out", "--quiet")
        self.assertEqual((result.stdout, result.stderr), ("", ""))


class Inputs(BatchTest):
    def names(self, *words, **keywords):
        self.batch("measure", *words, "--out", "out", **keywords)
        return [result["input"] for result in self.results()]

    def test_files_are_called_by_their_names(self):
        self.assertEqual(self.names("in/top.XYZR", "in/a/deep/m0.xyzr", "in/top.XYZR"), ["m0.xyzr", "top.XYZR"])

    def test_lists_keep_the_folders_below_the_common_one(self):
        paths = [f"in/a/deep/m{i}.xyzr" for i in (0, 3)] + ["in/b/deep/m1.xyzr", ""]
        (self.folder / "list").write_text("\r\n".join(paths))
        expected = ["a/deep/m0.xyzr", "a/deep/m3.xyzr", "b/deep/m1.xyzr"]
        self.assertEqual(self.names("--list", "list"), expected)
        shutil.rmtree(self.folder / "out")
        self.assertEqual(self.names("-", text="\n".join(paths)), expected)

    def test_a_base_names_all_files(self):
        (self.folder / "list").write_text("in/b/deep/m1.xyzr\n")
        self.archive("all.tar", self.inputs / "c")
        words = ("in/top.XYZR", "in/b/../a", "--list", "list", "all.tar")
        for base in ("in", "./in/", self.inputs, "in/a/.."):
            self.assertEqual(self.names(*words, "--base", base), [f"a/deep/m{i}.xyzr" for i in (0, 3, 6, 9)] +
                             ["b/deep/m1.xyzr"] + [f"deep/m{i}.xyzr" for i in (2, 5, 8)] + ["top.XYZR"])
            shutil.rmtree(self.folder / "out")
        self.assertEqual(self.names("in/a", "--base", "in/a"), [f"deep/m{i}.xyzr" for i in (0, 3, 6, 9)])
        self.batch("measure", "in/a", "--out", "out", "--resume")  # the base is no part of what a run computes
        (self.folder / "aa").mkdir()
        (self.folder / "a").mkdir()
        self.write("../aa/m.xyzr", b"0 0 0 1\n")
        for word, base in (("in/top.XYZR", "in/a"), ("in", "in/a"), ("aa/m.xyzr", "a"), ("aa", "a")):
            error = self.refused("measure", word, "--base", base, "--out", "out")
            self.assertIn(f"{word}: is not below {self.folder.resolve() / base}; --base", error)
        for base in ("nowhere", "in/top.XYZR"):
            error = self.refused("measure", "in/top.XYZR", "--base", base, "--out", "out")
            self.assertIn(f"--base {base}: is not a folder", error)

    def test_archives_give_the_results_of_their_files(self):
        self.batch("surface", "in", "--out", "out", "--spacing", "1", code=6)
        self.archive("all.tar")
        self.batch("surface", "all.tar", "--out", "packed", "--spacing", "1", code=6)
        self.assertEqual(contents(self.folder / "packed"), contents(self.folder / "out"))

    def test_archives_of_others(self):
        with tarfile.open(self.folder / "odd.tar", "w", format=tarfile.PAX_FORMAT) as tar:
            for name, seed in (("/abs/é" + "x" * 150 + ".xyzr", 1), ("twice.xyzr", 2), ("twice.xyzr", 3)):
                member = tarfile.TarInfo(name)
                text = spheres(9, seed)
                member.size = len(text)
                tar.addfile(member, io.BytesIO(text))
            link = tarfile.TarInfo("link.xyzr")
            link.type, link.linkname = tarfile.SYMTYPE, "twice.xyzr"
            tar.addfile(link)
        self.assertEqual(self.names("odd.tar"), ["abs/é" + "x" * 150 + ".xyzr", "twice.xyzr"])
        last = self.results()[1]
        shutil.rmtree(self.folder / "out")
        self.names(self.write("x/twice.xyzr", spheres(9, 3)))
        self.assertEqual(self.results(), [last])

    def test_names_of_archives_by_gnu_tar(self):
        with tarfile.open(self.folder / "gnu.tar", "w", format=tarfile.GNU_FORMAT) as tar:
            for name in ("ü.xyzr", "é" * 90 + ".xyzr"):
                member = tarfile.TarInfo(name)
                member.size = len(spheres(9, 1))
                tar.addfile(member, io.BytesIO(spheres(9, 1)))
        self.assertEqual(self.names("gnu.tar"), ["é" * 90 + ".xyzr", "ü.xyzr"])

    def test_pipes_in_folders_are_no_inputs(self):
        (self.folder / "x").mkdir()
        (self.folder / "x/a.xyzr").write_bytes(spheres(9, 1))
        os.mkfifo(self.folder / "x/b.xyzr")
        self.assertEqual(self.names("x"), ["a.xyzr"])

    def test_what_cannot_be_read_is_refused(self):
        (self.folder / "packed.tar.gz").write_bytes(b"")
        self.assertIn("decompress it to .tar first", self.refused("measure", "packed.tar.gz", "--out", "out", code=3))
        (self.folder / "no.tar").write_bytes(b"no archive" * 100)
        self.assertIn("no.tar: cannot be read as a tar archive", self.refused("measure", "no.tar", "--out", "out", code=3))
        self.assertIn("missing: cannot be read", self.refused("measure", "missing", "--out", "out", code=3))
        self.assertIn("list: cannot be read", self.refused("measure", "--list", "list", "--out", "out", code=3))
        (self.folder / "notes").mkdir()
        (self.folder / "notes/a.txt").write_text("")
        self.assertIn("no inputs: 1 file found, but none has the suffix", self.refused("measure", "notes", "--out", "out"))
        self.assertIn("INPUTS: missing; name files, folders or archives", self.refused("measure", "--out", "out"))

    def test_what_is_missing_fails_alone(self):
        (self.folder / "list").write_text("in/a/deep/m0.xyzr\nin/none.pdb\nin/top.XYZR\n")
        for words in (["--list", "list"], ["in/top.XYZR", "in/none.pdb", "in/a/deep/m0.xyzr"]):
            text = self.batch("measure", *words, "--out", "out", code=6).stdout
            results = self.results()
            self.assertEqual([r["status"] for r in results], ["done", "failed", "done"])
            self.assertEqual((results[1]["input"], results[1]["exit"]), ("none.pdb", 3))
            self.assertRegex(results[1]["error"], r"^none\.pdb: cannot be .*: No such file or directory")
            self.assertIn("3 inputs, 1 failed", text)
            self.write("none.pdb", UBIQUITIN.read_bytes())
            self.batch("measure", *words, "--out", "out", "--resume", "--mixed-radii")
            self.assertEqual({r["status"] for r in self.results()}, {"done"})
            (self.inputs / "none.pdb").unlink()
            shutil.rmtree(self.folder / "out")

    def test_missing_folders_are_missing_inputs(self):
        self.batch("measure", "in/top.XYZR", "nodir/", "--out", "out", code=6)
        self.assertEqual([r["input"] for r in self.results()], ["nodir", "top.XYZR"])

    def test_empty_names_are_refused(self):
        self.assertIn("INPUTS: an empty name", self.refused("measure", "in/top.XYZR", "", "--out", "out"))

    def test_where_nothing_is_there_it_is_refused(self):
        error = self.refused("measure", "no.pdb", "nor.pdb", "--out", "out", code=3)
        self.assertEqual(error, "meniscus: error: no.pdb: cannot be read: No such file or directory")
        self.assertIn("get 1ubq.cif from the PDB", self.refused("measure", "1UBQ", "--out", "out", code=3))
        self.assertFalse((self.folder / "out").exists())

    def test_outputs_are_not_compressed(self):
        for name in ("o.tar.gz", "o.TGZ", "o.zip", "o.tar.xz"):
            self.assertIn(f"--out {name}: archives of outputs are not compressed; name a folder, or a .tar",
                          self.refused("measure", "in", "--out", name))
            self.assertFalse((self.folder / name).exists())

    def test_counts_of_one_and_columns_of_failures(self):
        text = self.batch("measure", "in/top.XYZR", "--out", "one").stdout
        self.assertRegex(text, r"one  1 input, 0 failed, .*\none/results.jsonl  1 line, 0 failed\n")
        text = self.batch("measure", "in/bad.xyzr", "--out", "two", code=6).stdout
        self.assertIn("\n  bad.xyzr  failed  bad.xyzr:2:", text)

    def test_members_outside_are_refused(self):
        with tarfile.open(self.folder / "evil.tar", "w") as tar:
            tar.addfile(tarfile.TarInfo("a/../../evil.xyzr"))
        self.assertIn("leads out of", self.refused("measure", "evil.tar", "--out", "out", code=3))

    def test_lists_of_something_else_are_refused(self):
        (self.folder / "list").write_bytes(b"in/a\n" + b"x" * 5000 + b"\n")
        self.assertIn("list:2: a name of 5000 bytes", self.refused("measure", "--list", "list", "--out", "out", code=3))
        self.assertIn("more than 1 MiB", self.refused("measure", "--list", "/dev/zero", "--out", "out", code=3))

    def test_damaged_logs_are_refused(self):
        self.batch("measure", "in/a", "--out", "out")
        log = self.folder / "out/.batch/shard-0-of-1.log"
        whole = log.read_text()
        first = whole.splitlines()[1]
        for damaged in (re.sub('"input":"[^"]*"', '"input":7', first, count=1), '{"result":{"input":"a"}}', '{"result":1}',
                        re.sub('"size":[0-9]+', '"size":1e300', first)):
            self.assertNotEqual(damaged, first)
            log.write_text(whole + damaged + "\n")
            self.assertIn("is damaged", self.refused("measure", "in/a", "--out", "out", "--resume", code=3))

    def test_damaged_archives(self):
        whole = self.archive("all.tar").read_bytes()
        (self.folder / "cut.tar").write_bytes(whole[:len(whole) // 2 + 100])
        self.assertIn("cut.tar: cannot be read as a tar archive", self.refused("measure", "cut.tar", "--out", "out", code=3))

    def test_two_inputs_of_one_name_are_refused(self):
        self.assertIn("m0.xyzr of", self.refused("measure", "in/a/deep/m0.xyzr", self.write("z/m0.xyzr", b"0 0 0 1\n"),
                                                 "--out", "out"))

    def test_names_that_differ_only_in_their_suffix_keep_it(self):
        self.write("x/1.pqr", b"ATOM 1 C ALA 1 0.0 0.0 0.0 0.5 1.7\n")
        self.write("x/1.xyzr", b"0 0 0 1.7\n")
        self.batch("surface", "in/x", "--out", "out", "-o", ".glb")
        self.assertLess({"1.pqr.glb", "1.xyzr.glb"}, set(contents(self.folder / "out")))

    def test_names_that_are_no_text_are_refused(self):
        (self.inputs / os.fsdecode(b"\xff.xyzr")).write_bytes(b"0 0 0 1\n")
        self.assertIn("its name is not valid UTF-8", self.refused("measure", "in", "--out", "out", code=3))

    def test_outputs_are_no_inputs(self):
        self.batch("surface", "in", "--out", "in/out", "--spacing", "1", "-o", ".xyzr", code=6)
        self.batch("surface", "in", "--out", "in/out", "--spacing", "1", "-o", ".xyzr", "--resume", code=6)
        self.assertEqual(len(self.results("in/out")), 13)

    def test_what_is_read_is_not_overwritten(self):
        archive = self.archive("s.tar")
        link = self.folder / "link.tar"
        link.symlink_to(archive)
        pdb = self.write("x/a.pdb", UBIQUITIN.read_bytes())
        rules = self.write("a.atoms.csv", b"* * 1.7\n")
        words = self.folder / "b.jsonl"
        words.write_text(f"{self.inputs}/top.XYZR\n")
        kept = {path: path.read_bytes() for path in (archive, pdb, rules, words)}
        for command in (("surface", archive, "--out", archive), ("surface", archive, "--out", "./s.tar", "--spacing", "1"),
                        ("measure", link, "--out", archive), ("measure", archive, "--out", link),
                        ("measure", "in/x/a.pdb", "--out", "in/x", "-o", ".pdb"), ("measure", "in/x", "--out", "in/x", "-o", ".pdb"),
                        ("measure", "--list", words, "--out", "b.tar"),
                        ("measure", "in/x/a.pdb", "--radii", rules, "--out", "in", "-o", ".atoms.csv")):
            self.assertIn("would overwrite", self.refused(*command))
        self.assertIn("choose another folder", self.refused("measure", "in/x", "--out", "in/x", "-o", "_sas.pdb"))
        # A file beside the one that was asked for is known once it is there.
        self.assertIn("would overwrite", self.refused("surface", "in/x/a.pdb", "--radii", rules, "--out", "in", "--spacing", "2"))
        for path, content in kept.items():
            self.assertEqual(path.read_bytes(), content, path)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["b.jsonl", "in", "link.tar", "s.tar"])

    def test_radii_are_not_mixed_unasked(self):
        self.write("x/a.xyzr", b"0 0 0 1.7\n")
        self.write("x/b.pdb", UBIQUITIN.read_bytes())
        self.assertIn("--mixed-radii", self.refused("measure", "in/x", "--out", "out"))
        self.assertFalse((self.folder / "out/results.jsonl").exists())
        self.batch("measure", "in/x", "--out", "out", "--resume", "--mixed-radii")
        self.assertEqual([r["report"]["input"]["radii"] for r in self.results()], ["file", "united"])
        self.batch("measure", "in/x", "--out", "chosen", "--radii", "bondi", code=6)

    def test_options_are_refused_before_anything_is_computed(self):
        for words, why in ((("-o", "a.ply"), "give only the ending"), (("-o", ".xyz"), ".xyz"), (("--spacing", "0"), "--spacing"),
                           (("--shard", "4/4"), "0/4, 1/4, 2/4 or 3/4"), (("--time-limit", "soon"), "--time-limit"),
                           (("--report", "x.json"), "--report"), (("--jobs", "0"), "--jobs"), (("--memory-limt", "1G"), "--memory-limit?"),
                           (("--time-limit", "1ms"), "'1ms'"), (("--memory-limit", "10M"), "at least 32M"), (("-o", ".foo"), "NAME.foo")):
            self.assertIn(why, self.refused("surface", "in", "--out", "out", *words))
        self.assertFalse((self.folder / "out").exists())

    def test_negative_values_and_repeated_options_reach_every_input(self):
        self.batch("surface", "in/top.XYZR", "--out", "out", "--density", "-0.8", "--spacing", "1", "--color", "element")
        self.assertEqual(self.results()[0]["report"]["options"]["density"], -0.8)

    def test_exact_numbers_are_left_out_of_every_input(self):
        self.batch("surface", "in/top.XYZR", "--out", "out", "--spacing", "1", "--no-exact")
        report = self.results()[0]["report"]
        self.assertEqual((report["exact"], report["components"], report["options"]["exact"]), (None, None, False))
        self.batch("surface", "in/top.XYZR", "--out", "whole", "--spacing", "1")
        self.assertGreater(self.results("whole")[0]["report"]["exact"]["ses_area"], 0)
        self.assertIn("--no-exact", self.refused("surface", "in", "--out", "no", "--no-exact", "--verify"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

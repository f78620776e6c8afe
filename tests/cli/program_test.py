#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the built program: help, usage, exit codes, messages, what lands on standard output, signals.

usage: program_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import hashlib
import json
import re
import signal
import subprocess
import sys
import unittest
import zipfile

import schema
from program_case import PROGRAM, SHELL, SOURCE, SPHERES, UBIQUITIN, ProgramTest, glycine


class Help(ProgramTest):
    def test_version_and_help_go_to_standard_output(self):
        for arguments in (["--version"], ["--help"], ["--help-all"], ["surface", "--help"], ["measure", "--help"]):
            result = self.run_program(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)
            self.assertTrue(result.stdout, arguments)
        self.assertRegex(self.run_program("--version").stdout, r"^meniscus \d+\.\d+\.\d+\n$")

    def test_help_fits_a_screen_and_ends_with_examples(self):
        for arguments in ([], ["surface"], ["measure"], ["compare"], ["batch", "surface"], ["batch", "measure"]):
            lines = self.run_program(*arguments, "--help").stdout.splitlines()
            self.assertLessEqual(len(lines), 50, arguments)
            self.assertEqual([line for line in lines if len(line) > 80], [], arguments)
            self.assertIn("Examples:", lines)
        for line in self.run_program("--help-all").stdout.splitlines():
            self.assertLessEqual(len(line), 80, line)

    def test_every_option_is_in_the_full_help(self):
        text = self.run_program("surface", "--help-all").stdout
        for option in ("--probe --radii --hydrogens --model --assembly --altloc --chains --select --hetero --waters "
                       "--strict-radii --report --threads --quiet --progress --method --flow --spacing --density "
                       "--curvature --anchor --reinitialise --solver --slope --time-step --half-width --max-steps "
                       "--tolerance --history --snapshots --components --min-cavity --edge --vertex-density --adaptive "
                       "--keep-ridges --corners --simplify-topology --verify -o --memory --ascii --color --view --size "
                       "--background --depth-cue --perspective --outline").split():
            self.assertRegex(text, f"(?m)^  (-[a-z], )?{option} ")
        text = self.run_program("measure", "--help-all").stdout
        for option in ("--probe --radii --hydrogens --model --assembly --altloc --chains --select --hetero --waters "
                       "--strict-radii --report --threads --quiet --progress -o --between --per --value").split():
            self.assertRegex(text, f"(?m)^  (-[a-z], )?{option} ")


class Usage(ProgramTest):
    def test_wrong_command_lines_are_refused_in_one_line(self):
        for arguments in ([], ["surfac"], ["surface"], ["surface", "--bogus", "three.xyzr"], ["--bogus"],
                          ["surface", "three.xyzr", "three.xyzr"], ["surface", "three.xyzr", "--threads"]):
            result = self.run_program(*arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
            self.assertRegex(result.stderr, r"\Ameniscus: error: [^\n]+\n\Z")

    def test_numbers_that_make_no_sense_are_refused(self):
        for option in ("--spacing", "--probe", "--density", "--time-step", "--max-steps", "--threads", "--memory",
                       "--model", "--min-cavity"):
            for value in ("abc", "", "nan", "inf", "-inf", "1e999", "1.4x"):
                if (option, value) != ("--time-step", "inf"):
                    self.assertIn(option, self.refused("three.xyzr", option, value))
        for option, value in (("--spacing", "0"), ("--spacing", "-1"), ("--probe", "-1"), ("--density", "0"),
                              ("--density", "1"), ("--time-step", "0"), ("--max-steps", "0"), ("--threads", "0"),
                              ("--threads", "1.5"), ("--memory", "0"), ("--model", "0"), ("--model", "-1"),
                              ("--min-cavity", "-1")):
            self.assertIn(option, self.refused("three.xyzr", option, value))

    def test_records_of_a_flow_need_a_flow(self):
        self.assertIn("--method flow", self.refused("three.xyzr", "--method", "direct", "--history", "a.csv"))
        self.assertIn("--history", self.refused("three.xyzr", "--history", "a.txt"))
        self.assertIn("--snapshots", self.refused("three.xyzr", "--snapshots", "1", "-o", "a.xyzr"))
        self.assertIn("time step", self.refused("three.xyzr", "--flow", "paper", "--time-step", "inf"))
        self.refused("three.xyzr", "--half-width", "100")

    def test_what_no_output_heeds_is_refused(self):
        self.assertIn("--show", self.refused("three.xyzr", "--show", "//A", "-o", "a.dx"))
        self.assertIn("--ascii", self.refused("three.xyzr", "--ascii", "-o", "a.glb"))
        self.assertEqual(self.run_program("surface", "three.xyzr", "--ascii", "-o", "a.glb", "-o", "a.stl").returncode, 0)

    def test_unknown_words_are_refused_with_those_that_exist(self):
        self.assertIn("flow, direct, gaussian", self.refused("three.xyzr", "--method", "fast"))
        self.assertIn("anchored", self.refused("three.xyzr", "--flow", "sideways"))
        self.assertIn("ligands", self.refused("three.xyzr", "--hetero", "haem"))
        self.assertIn("json", self.refused("three.xyzr", "--progress", "loud"))
        self.refused("three.xyzr", "--radii", "nosuchset")

    def test_pictures_that_make_no_sense_are_refused(self):
        for option, value in (("--color", "fancy"), ("--color", "residue:0:1"), ("--color", "depth:2:1"),
                              ("--size", "100"), ("--size", "0x9"), ("--view", "sideways"), ("--view", "0,0,0"),
                              ("--background", "#12"), ("--depth-cue", "2"), ("--cut", "middle")):
            self.assertIn(option, self.refused("three.xyzr", "-o", "a.png", option, value))
        for option in ("--outline", "--legend"):
            self.assertIn("-o FILE.png", self.refused("three.xyzr", option))
        self.assertIn("--legend", self.refused("three.xyzr", "-o", "a.png", "--legend", "--size", "64x48"))
        self.assertIn("cavity 1", self.refused("three.xyzr", "-o", "a.png", "--cut", "cavity:1"))
        self.assertIn("-o FILE.png", self.refused("three.xyzr", "-o", "a.html", "--size", "9x9"))
        self.assertIn("FILE.html", self.refused("three.xyzr", "-o", "a.ply", "--view", "top"))

    def test_outputs_are_checked_before_anything_is_read(self):
        missing = "missing.pdb"
        self.assertIn(".ply", self.refused(missing, "-o", "a.foo"))
        self.refused(missing, "-o", "noextension")
        self.refused(missing, "-o", "a.ply", "-o", "./a.ply")
        self.refused(missing, "-o", "a.ply", "--report", "a.ply")
        self.refused(missing, "-o", "nofolder/a.ply", code=4)
        self.refused(missing, "--report", "nofolder/a.json", code=4)
        (self.folder / "folder.ply").mkdir()
        self.refused(missing, "-o", "folder.ply", code=4)
        self.refused("three.xyzr", "-o", "three.xyzr")


class Input(ProgramTest):
    def test_files_that_cannot_be_read_are_exit_3(self):
        self.assertIn("missing.pdb", self.refused("missing.pdb", code=3))
        (self.folder / "empty.pdb").write_text("")
        self.refused("empty.pdb", code=3)
        (self.folder / "bad.pdb").write_text(glycine().replace("   1.458", "   1.4x8"))
        self.assertRegex(self.refused("bad.pdb", code=3), r"bad\.pdb:2:\d+: ")

    def test_standard_input_is_told_by_content(self):
        self.assertEqual(self.report("-", text=SPHERES)["input"]["atoms"], 3)
        self.assertEqual(self.report("-", text=glycine())["input"]["atoms"], 4)
        self.refused("-", text="", code=3)

    def test_all_models_are_structures_of_their_own(self):
        models = "".join(f"MODEL     {n:4}\n{glycine(shift=n)}ENDMDL\n" for n in (1, 2))
        (self.folder / "nmr.pdb").write_text(models + "END\n")
        reports = self.report("nmr.pdb", "--model", "all", "-o", "out.ply")
        self.assertEqual([r["input"]["model"] for r in reports], [1, 2])
        self.assertEqual(self.files(), ["nmr.pdb", "out_m01.atoms.csv", "out_m01.ply", "out_m02.atoms.csv",
                                        "out_m02.ply", "three.xyzr"])
        self.surface("nmr.pdb", "--model", "all")
        self.assertTrue({"nmr_m01.ply", "nmr_m01.html", "nmr_m02.ply", "nmr_m02.html", "nmr_m02.atoms.csv"} <= set(self.files()), self.files())
        self.assertEqual(self.report("nmr.pdb", "--model", "2")["input"]["model"], 2)
        self.refused("nmr.pdb", "--model", "3", code=3)


class Streams(ProgramTest):
    def test_the_summary_is_short_and_alone_on_standard_output(self):
        result = self.surface("three.xyzr")
        self.assertEqual(result.stderr, "")
        self.assertLess(len(result.stdout.splitlines()), 12)
        self.assertIn("Å²", result.stdout)

    def test_the_first_number_is_the_exact_one(self):
        printed = self.surface(UBIQUITIN, "--spacing", "1", "-o", "a.ply").stdout.splitlines()
        self.assertRegex(printed[1], r"^  area +3892\.2387 ± \d\.\de-\d+ Å² exact; mesh [0-9.]+ Å², flat triangles [0-9.]+ Å²$")
        self.assertRegex(printed[2], r"^  volume +10056\.3033 ± \d\.\de-\d+ Å³ exact; mesh [0-9.]+ Å³, flat triangles [0-9.]+ Å³$")
        measured = self.run_program("measure", UBIQUITIN).stdout
        for line, name in ((printed[1], "SES area"), (printed[2], "SES volume")):
            value = re.search(r"[0-9.]+ ± \S+", line).group()
            self.assertRegex(measured, rf"\n  {name} +{re.escape(value)} ")

    def test_without_exact_numbers_there_are_those_of_the_mesh(self):
        exact = self.report(UBIQUITIN, "--spacing", "1", "-o", "a.ply", "-o", "a.html")
        result = self.surface(UBIQUITIN, "--spacing", "1", "-o", "b.ply", "-o", "b.html", "--no-exact", "--report", "b.json")
        self.assertRegex(result.stdout, r"\n  area +[0-9.]+ Å² \(flat triangles [0-9.]+ Å²\)\n  volume +[0-9.]+ Å³ \(flat")
        self.assertNotIn("±", result.stdout)
        self.assertEqual((self.folder / "a.ply").read_bytes(), (self.folder / "b.ply").read_bytes())
        report = json.loads((self.folder / "b.json").read_text())
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        self.assertEqual(schema.problems(report, rules), [])
        self.assertEqual((report["exact"], report["components"]), (None, None))
        self.assertIsNone(report["mesh"]["area_deviation"])
        self.assertEqual((report["options"]["exact"], exact["options"]["exact"]), (False, True))
        self.assertEqual(report["mesh"]["area"], exact["mesh"]["area"])
        self.assertLess(report["expected"]["cpu_s"], exact["expected"]["cpu_s"])
        page = (self.folder / "b.html").read_text(encoding="utf-8")
        self.assertIn("surface, exact", (self.folder / "a.html").read_text(encoding="utf-8"))
        self.assertNotIn("surface, exact", page)
        self.assertTrue(page.rstrip().endswith("</html>"))

    def test_exact_numbers_cannot_be_checked_and_left_out(self):
        error = self.surface("three.xyzr", "--no-exact", "--verify", code=2).stderr
        self.assertEqual(error, "meniscus: error: --verify checks the exact numbers, which --no-exact leaves out; "
                                "give one of them\n")

    def test_numbers_of_pieces_that_differ_are_explained(self):
        antibody = SOURCE / "examples" / "1a0q.pdb"
        printed = self.surface(antibody, "-o", "a.ply").stdout
        self.assertRegex(printed, r"\n  components  8 \(1 outer, 7 cavities\) exact; mesh 8 \(2 outer, 6 cavities\)\n"
                                  r"              .*smaller than the spacing.*\n  left out ")
        outer = self.surface(antibody, "-o", "a.ply", "--components", "outer").stdout
        self.assertRegex(outer, r"\n  area +17411\.7340 ± \S+ +Å² exact, of all pieces; mesh of outer pieces ")
        self.assertRegex(outer, r"\n  components  8 \(1 outer, 7 cavities\) exact; mesh 2 \(2 outer, 0 cavities\)\n"
                                r"              .*smaller than the spacing.*\n")
        self.assertRegex(self.surface(antibody, "-o", "a.ply", "--no-exact").stdout,
                         r"\n  components  8 \(2 outer, 6 cavities\)\n  left out ")
        (self.folder / "shell.xyzr").write_text(SHELL)
        self.assertRegex(self.surface("shell.xyzr", "-o", "a.ply", "--components", "outer").stdout,
                         r"\n  components  2 \(1 outer, 1 cavity\) exact; mesh 1 \(1 outer, 0 cavities\)\n"
                         r"              the mesh leaves out .*\n")

    def test_every_chain_and_model_has_its_exact_numbers(self):
        for options in (["--per-chain"], ["--model", "all"]):
            printed = self.surface(SOURCE / "examples" / "1a0q.pdb", "--spacing", "1", *options, "-o", "a.ply").stdout
            numbers = re.findall(r"\n  area +([0-9.]+) ± ", printed)
            self.assertEqual(len(numbers), 2 if options == ["--per-chain"] else 1, printed)
            self.assertEqual(len(set(numbers)), len(numbers))

    def test_quiet_is_silent(self):
        result = self.surface("three.xyzr", "--quiet", "--report", "r.json")
        self.assertEqual((result.stdout, result.stderr), ("", ""))
        self.assertEqual(json.loads((self.folder / "r.json").read_text())["schema"], 1)

    def test_progress_is_silent_in_a_pipe_and_json_on_demand(self):
        self.assertEqual(self.surface("three.xyzr", "--progress", "off").stderr, "")
        lines = self.surface("three.xyzr", "--progress", "json").stderr.splitlines()
        updates = [json.loads(line) for line in lines]
        self.assertTrue(all(0.0 <= u["fraction"] <= 1.0 for u in updates))
        self.assertTrue({"read", "mesh", "write"} <= {u["stage"] for u in updates}, updates)
        self.assertIn("\033[K", self.surface("three.xyzr", "--progress", "on").stderr)

    def test_what_happens_with_every_file_is_a_note_that_quiet_silences(self):
        note = "58 waters left out (keep them with --waters)"
        self.assertEqual(self.surface(UBIQUITIN, "--spacing", "1", "--report", "r.json").stderr,
                         f"meniscus: note: {UBIQUITIN}: {note}\n")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual((report["input"]["notes"], report["input"]["warnings"]), ([note], []))
        self.assertEqual(report["input"]["dropped"], {"waters": 58})
        self.assertEqual(self.surface(UBIQUITIN, "--spacing", "1", "--quiet").stderr, "")

    def test_what_may_make_a_number_wrong_is_a_warning_that_quiet_does_not_silence(self):
        (self.folder / "twice.xyzr").write_text("0 0 0 1.7\n0 0 0 1.7\n")
        for more in ([], ["--quiet"]):
            self.assertEqual(self.surface("twice.xyzr", *more).stderr,
                             "meniscus: warning: twice.xyzr: 1 atom at exactly the position of another atom\n")

    def test_notes_of_all_models_are_told_once(self):
        model = ("ATOM      1  CA  GLY A   1       0.000   0.000   0.000  1.00  0.00           C\n"
                 "HETATM    2  O   HOH A   2       9.000   0.000   0.000  1.00  0.00           O\n")
        (self.folder / "two.pdb").write_text(f"MODEL 1\n{model}ENDMDL\nMODEL 2\n{model}ENDMDL\n")
        self.assertEqual(self.surface("two.pdb", "--model", "all").stderr,
                         "meniscus: note: two.pdb: 1 water left out (keep it with --waters)\n")
        self.assertIn("meniscus: note: two.pdb: model 1 of 2 taken (choose another with --model N|all)\n",
                      self.surface("two.pdb").stderr)


class Report(ProgramTest):
    def test_reports_follow_the_schema(self):
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        for method in ("flow", "direct", "gaussian"):
            report = self.report("three.xyzr", "--method", method)
            self.assertEqual(schema.problems(report, rules), [], method)
        self.assertEqual(schema.problems(self.report("three.xyzr", "--model", "all"), rules), [])
        self.assertNotEqual(schema.problems({"schema": 1}, rules), [])

    def test_standard_output_by_its_path_has_the_report_alone(self):
        report = json.loads(self.surface("three.xyzr", "-o", "a.ply", "--report", "/dev/stdout").stdout)
        self.assertEqual(report["input"]["atoms"], 3)

    def test_numbers_of_a_mesh_with_two_components(self):
        report = self.report("three.xyzr", "--spacing", "0.25")
        mesh = report["mesh"]
        self.assertTrue(mesh["closed"] and mesh["manifold"])
        self.assertEqual(mesh["components"], 2)
        self.assertEqual(mesh["euler_characteristic"], 4)
        self.assertTrue(report["flow"]["converged"])
        self.assertAlmostEqual(mesh["corrected_area"], report["exact"]["ses_area"], delta=1.0)
        self.assertEqual([c["kind"] for c in report["components"]], ["outer", "outer"])
        # The sphere of 1.8 Å, and the closed form for the two that overlap.
        self.assertAlmostEqual(mesh["corrected_area"], 40.715 + 45.1, delta=1.0)

    def test_dropped_atoms_and_options_are_recorded(self):
        report = self.report(UBIQUITIN, "--spacing", "1", "--threads", "1", "--chains", "A")
        self.assertEqual(report["input"]["atoms"], 602)
        self.assertEqual(sum(report["input"]["dropped"].values()), 58)
        self.assertEqual(len(report["input"]["sha256"]), 64)
        self.assertEqual(report["options"]["threads"], 1)
        self.assertEqual(report["options"]["chains"], ["A"])

    def test_npz_knows_its_input_with_and_without_a_report(self):
        fingerprint = hashlib.sha256(UBIQUITIN.read_bytes()).hexdigest()
        for report in ([], ["--report", "r.json"]):
            self.surface(UBIQUITIN, "--spacing", "1", "-o", "a.npz", *report)
            with zipfile.ZipFile(self.folder / "a.npz") as archive:
                self.assertIn(fingerprint.encode("utf-32-le"), archive.read("options.npy"))
        self.assertEqual(json.loads((self.folder / "r.json").read_text())["input"]["sha256"], fingerprint)

    def test_peak_memory_is_not_that_of_the_caller(self):
        ours = bytearray(b"x") * (400 << 20)
        peak = self.report("three.xyzr")["peak_memory_mb"]
        self.assertEqual(ours[-1], ord("x"))
        self.assertGreater(peak, 1)
        self.assertLess(peak, 400)  # with the address sanitizer 305


class Limits(ProgramTest):
    def test_what_does_not_fit_is_refused_with_the_option_to_change(self):
        refusal = self.refused(UBIQUITIN, "--spacing", "0.05", "--memory", "50M", code=5)
        self.assertRegex(refusal, r"needs about [0-9.]+ [MG]B .* 50 MB are allowed; choose a spacing of 0\.\d+ Å or more")

    def test_what_it_will_take_is_told_before_and_in_the_report(self):
        report = self.report(UBIQUITIN)
        self.assertAlmostEqual(report["expected"]["vertices"], report["mesh"]["vertices"],
                               delta=0.25 * report["mesh"]["vertices"])
        lines = self.surface(UBIQUITIN, "--progress", "json").stderr.splitlines()
        self.assertTrue(any("expected_s" in line for line in lines))

    def check_signal(self, number):
        """Sends a signal while the surface is computed."""
        with subprocess.Popen([PROGRAM, "surface", UBIQUITIN, "--spacing", "0.1", "--progress", "json"],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            for line in process.stderr:
                if b'"stage"' in line and b'"read"' not in line:
                    break
            process.send_signal(number)
            process.stdout.read(), process.stderr.read()
            self.assertEqual(process.wait(timeout=60), 128 + number)
        self.assertEqual(self.files(), ["three.xyzr"])

    def test_signals_end_the_program_and_leave_nothing(self):
        self.check_signal(signal.SIGINT)
        self.check_signal(signal.SIGTERM)

    def test_signals_end_a_program_that_waits_for_input(self):
        with subprocess.Popen([PROGRAM, "surface", "-", "--progress", "json"], cwd=self.folder, stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            process.stderr.readline()
            process.send_signal(signal.SIGTERM)
            self.assertEqual(process.wait(timeout=60), 143)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

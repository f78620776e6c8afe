#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs tools/sweep on a few spheres, with our program and with programs that fail in every way it has a name for.

usage: sweep_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import csv
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()

# In place of ours: what it does depends on the name of its input, which is the second word.
FAKE = """#!/bin/sh
while [ "$#" -gt 0 ]; do
    case "$1" in
        --report) report=$2 ;;
        *.xyzr) name=$(basename "$1" .xyzr) ;;
    esac
    shift
done
case "$name" in
    crash) kill -SEGV $$ ;;
    hang) sleep 1000 ;;
    code) echo "meniscus: error: it is broken" >&2; exit 3 ;;
    large) echo "meniscus: error: needs 9 GB; try a larger --spacing" >&2; exit 5 ;;
    torn) printf '{"mesh": {' >"$report" ;;
    silent) ;;
    *) cp "$(dirname "$0")/$name.json" "$report" ;;
esac
"""
GOOD = {"input": {"atoms": 1}, "peak_memory_mb": 1,
        "mesh": {"vertices": 4, "components": 1, "mean_distance": 0.1, "max_distance": 0.2, "area": 9, "volume": 99,
                 "corrected_area": 10, "corrected_volume": 100, "smallest_triangle_angle_deg": 30},
        "exact": {"ses_area": 10, "ses_volume": 100}, "checks": [{"name": "closed", "passed": True, "value": 1, "bound": 1}]}


class SweepTest(unittest.TestCase):
    """Every test has a folder with inputs in `in` and results in `out`."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "in").mkdir()

    def write(self, name, text="0 0 0 1.7\n"):
        (self.folder / "in" / name).write_text(text, encoding="utf-8")

    def sweep(self, *words, code=0, program=PROGRAM):
        done = subprocess.run([SOURCE / "tools" / "sweep", self.folder / "in", "--out", self.folder / "out", "--program",
                               program, *words], capture_output=True, encoding="utf-8", check=False, timeout=500)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        with open(self.folder / "out" / "sweep.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file)), done.stdout

    def fake(self, names, *words, code):
        """One outcome per name, of the program that fails as the name says."""
        program = self.folder / "fake"
        program.write_text(FAKE, encoding="ascii")
        program.chmod(0o755)
        for name in names:
            self.write(f"{name}.xyzr")
        rows, _ = self.sweep("--methods", "flow", "--spacings", "1", *words, program=program, code=code)
        return {row["structure"].removesuffix(".xyzr"): row["outcome"] for row in rows}

    def report(self, name, **blocks):
        changed = {key: GOOD[key] | value if isinstance(value, dict) else value for key, value in blocks.items()}
        (self.folder / f"{name}.json").write_text(json.dumps(GOOD | changed), encoding="utf-8")

    def test_all_methods_at_two_spacings_and_one_broken_input(self):
        self.write("one.xyzr")
        self.write("two.xyzr", "0 0 0 1.7\n2 0 0 1.5\n")
        rows, _ = self.sweep("--jobs", "2")
        self.assertEqual(len(rows), 2 * 2 * 3)
        self.assertEqual({row["outcome"] for row in rows}, {"ok"})
        direct = [row for row in rows if row["method"] == "direct" and row["spacing"] == "0.25"]
        for row in direct:
            self.assertLess(abs(float(row["corrected_volume"])), 1e-3)
        self.write("broken.pdb", "ATOM      1  CA  GLY A   1       0.000   0.0x0   0.000  1.00  0.00           C\n")
        rows, printed = self.sweep(code=1)
        broken = [row for row in rows if row["structure"] == "broken.pdb"]
        self.assertEqual(len(broken), 6)
        for row in broken:
            self.assertRegex(row["outcome"], r"^failed: exit 3: meniscus: error: .*broken\.pdb:1:")
        self.assertIn("18 runs, 6 failed", printed)
        self.assertIn("### Failures", (self.folder / "out" / "sweep.md").read_text(encoding="utf-8"))

    def test_rows_that_are_there_are_kept_and_failures_tried_again(self):
        self.write("one.xyzr")
        self.write("bad.xyzr", "0 0 0\n")
        words = ("--methods", "direct", "--spacings", "1,0.5")
        self.assertEqual(len(self.sweep(*words, code=1)[1].splitlines()), 5)
        with open(self.folder / "out" / "rows.jsonl", "a", encoding="ascii") as file:
            file.write('{"cut off')
        self.write("bad.xyzr", "0 0 0 1\n")
        first, printed = self.sweep(*words)
        self.assertEqual([line.split()[0] for line in printed.splitlines()[:-1]], ["bad.xyzr"] * 2)
        second, printed = self.sweep(*words)
        self.assertEqual(second, first)
        self.assertEqual(len(printed.splitlines()), 1)
        self.assertEqual(len(self.sweep(*words, "--", "--probe", "1")[1].splitlines()), 5, "with other options: again")

    def test_every_way_to_fail_has_its_name(self):
        self.report("good")
        self.report("check", checks=[{"name": "closed", "passed": False, "value": 0, "bound": 1}])
        self.report("nothing", mesh={"volume": float("nan")})
        self.report("lacking", mesh=7)
        found = self.fake(["crash", "hang", "code", "torn", "silent", "large", "good", "check", "nothing", "lacking"],
                          "--time-limit", "3", "--jobs", "4", code=1)
        self.assertEqual(found.pop("good"), "ok")
        self.assertEqual(found.pop("check"), "failed: check closed: 0, bound 1")
        self.assertEqual(found.pop("nothing"), "failed: no number: mesh.volume")
        for name, words in {"crash": "crash: SIGSEGV", "hang": "hangs: ended after 3 s", "code": "exit 3: ",
                            "torn": "unreadable report: ", "lacking": "unreadable report: ",
                            "silent": "unreadable report: there is none", "large": "exit 5: "}.items():
            self.assertTrue(found.pop(name).startswith(f"failed: {words}"), name)
        self.assertEqual(found, {})

    def test_what_a_limit_of_memory_refuses_is_left_out_with_its_reason(self):
        self.report("good")
        found = self.fake(["good", "large"], "--memory", "1G", code=0)
        self.assertRegex(found["large"], "^left out: exit 5: .*needs 9 GB")

    def test_nothing_runs_on_when_it_is_ended(self):
        program = self.folder / "fake"
        program.write_text(f"#!/bin/sh\necho $$ >{self.folder}/started\nexec sleep 1000\n", encoding="ascii")
        program.chmod(0o755)
        self.write("one.xyzr")
        process = subprocess.Popen([SOURCE / "tools" / "sweep", self.folder / "in", "--out", self.folder / "out",
                                    "--program", program, "--methods", "flow"], stdout=subprocess.DEVNULL)
        started = self.folder / "started"
        while not (started.exists() and started.read_text(encoding="ascii").endswith("\n")):
            time.sleep(0.05)
        process.terminate()
        self.assertEqual(process.wait(timeout=100), 143)
        self.assertFalse(pathlib.Path("/proc", started.read_text(encoding="ascii").strip()).exists())

    def test_what_was_just_started_when_all_is_ended_ends_too(self):
        code = ("import measured_process as m; m.end_all(); run = m.run_process(['sleep', '1000'], '.'); "
                "print(run.code)")
        done = subprocess.run([sys.executable, "-B", "-c", code], cwd=SOURCE / "tools", capture_output=True,
                              encoding="utf-8", check=True, timeout=100)
        self.assertEqual(done.stdout, "-9\n")

    def test_more_inputs_have_options_of_their_own(self):
        self.write("two.xyzr", "0 0 0 1.7\n9 0 0 1.7\n")
        rows, _ = self.sweep("--methods", "direct", "--spacings", "1", "--also", "two.xyzr --probe 0")
        self.assertEqual([row["options"] for row in rows], ["", "--probe 0"])

    @unittest.skipUnless(shutil.which("freesasa"), "freesasa is not installed")
    def test_areas_are_held_against_freesasa(self):
        self.write("fine.xyzr", "0 0 0 1.70004\n2 0 0 1.5\n0 2 0 1.5\n0 0 0 1.2\n")
        self.sweep("--methods", "direct", "--spacings", "1", "--freesasa")
        with open(self.folder / "out" / "freesasa.csv", encoding="utf-8", newline="") as file:
            row, = csv.DictReader(file)
        self.assertLess(abs(float(row["deviation"])), float(row["tolerance"]))
        self.assertLess(float(row["tolerance"]), 1e-4)
        self.report("lying", exact={"sas_area": 1.0})
        (self.folder / "in" / "fine.xyzr").unlink()
        # A program that tells another area: its report goes to standard output, its spheres into a file.
        liar = self.folder / "liar"
        liar.write_text(f'#!/bin/sh\n[ "$1" = surface ] && exec {PROGRAM} "$@"\ncat {self.folder}/lying.json\n')
        liar.chmod(0o755)
        self.write("one.xyzr")
        _, printed = self.sweep("--methods", "direct", "--spacings", "1", "--freesasa", program=liar, code=1)
        self.assertIn("failed: areas differ by more than the slicing error", printed)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

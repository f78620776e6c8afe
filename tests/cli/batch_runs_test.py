#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs `meniscus batch` as it is built: what it survives, and that interrupted and divided runs end as whole ones do.

usage: batch_runs_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import os
import pathlib
import random
import signal
import subprocess
import sys
import tarfile
import time
import unittest

from batch_case import BatchTest, contents, spheres
from program_case import PROGRAM
from sanitized import is_sanitized


def children(pid):
    """Processes that a process has started."""
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            stat = (entry / "stat").read_text()
        except OSError:
            continue
        if int(stat.rpartition(")")[2].split()[1]) == pid:
            found.append(int(entry.name))
    return found


def is_running(pid):
    """Whether a process is there and no mere entry that nobody has asked for."""
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


def wait_until(happened, seconds=30):
    end = time.monotonic() + seconds
    while not happened():
        if time.monotonic() > end:
            raise TimeoutError
        time.sleep(0.01)


class Isolation(BatchTest):
    def test_what_hangs_is_ended(self):
        os.mkfifo(self.inputs / "never.xyzr")
        self.batch("measure", "in/never.xyzr", "in/top.XYZR", "--out", "out", "--time-limit", "1", "--jobs", "1", code=6)
        hung, done = self.results()
        self.assertEqual((hung["status"], hung["exit"], hung["error"]), ("timed out", None, "took longer than 1 s"))
        self.assertEqual(done["status"], "done")

    @unittest.skipIf(is_sanitized(PROGRAM), "sanitizers make an exit of a crash")
    def test_what_crashes_harms_no_other(self):
        os.mkfifo(self.inputs / "never.xyzr")
        process = subprocess.Popen(self.command("measure", "in/never.xyzr", "in/top.XYZR", "--out", "out", "--jobs", "2"),
                                   cwd=self.folder, stdout=subprocess.DEVNULL)
        log = self.folder / "out/.batch/shard-0-of-1.log"
        wait_until(lambda: log.exists() and b"top.XYZR" in log.read_bytes())
        hung, = children(process.pid)
        os.kill(hung, signal.SIGSEGV)
        self.assertEqual(process.wait(30), 6)
        crashed, done = self.results()
        self.assertEqual((crashed["status"], crashed["exit"], crashed["error"]), ("crashed", None, "ended by SIGSEGV"))
        self.assertEqual(done["status"], "done")

    def test_what_waits_for_its_turn_in_an_archive_costs_nothing(self):
        process = subprocess.Popen(self.command("surface", "in", "--out", "out.tar", "--jobs", "2", "--spacing", "0.3", "--quiet"),
                                   cwd=self.folder)
        self.addCleanup(process.wait)
        work = self.folder / "out.batch/shard-0-of-1.work"
        wait_until(lambda: (work / "0").exists() and children(process.pid))
        first = min(children(process.pid))  # the largest, which all others must wait for
        os.kill(first, signal.SIGSTOP)
        wait_until(lambda: (work / "12").exists() and children(process.pid) == [first])
        states = []
        for _ in range(20):
            time.sleep(0.02)
            states.append(pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[0])
        os.kill(first, signal.SIGCONT)
        self.assertEqual(process.wait(60), 6)
        self.assertGreater(states.count("S"), 15, states)

    @unittest.skipIf(is_sanitized(PROGRAM), "sanitizers need the whole address space")
    def test_memory_is_limited_for_each(self):
        self.write("x/large.xyzr", spheres(60000, 5))
        self.write("x/small.xyzr", spheres(10, 6))
        self.batch("surface", "in/x", "--out", "out", "--spacing", "0.25", "--memory-limit", "150M", "--threads", "1", code=6)
        large, small = self.results()
        self.assertEqual((large["status"], large["exit"]), ("failed", 5))
        self.assertEqual(small["status"], "done")

    def test_children_end_with_their_parent(self):
        os.mkfifo(self.inputs / "never.xyzr")
        for number in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT):
            process = subprocess.Popen(self.command("measure", "in/never.xyzr", "--out", f"out{number}"), cwd=self.folder)
            wait_until(lambda: children(process.pid))
            child, = children(process.pid)
            wait_until(lambda: b"measure" in pathlib.Path(f"/proc/{child}/cmdline").read_bytes())
            process.send_signal(number)
            code = process.wait(30)
            self.assertEqual(code, -number if number == signal.SIGKILL else 128 + number)
            wait_until(lambda: not is_running(child))
        self.assertFalse((self.folder / f"out{signal.SIGTERM}/.batch/shard-0-of-1.work").exists())

    def test_a_full_disk_ends_the_batch(self):
        self.assertIn("cannot be created", self.refused("measure", "in", "--out", "/proc/nowhere", code=4))


class Resuming(BatchTest):
    def test_killed_at_any_moment_it_ends_with_the_same_bytes(self):
        moments = random.Random(1)
        for out, words in (("killed", ("surface", "in", "--spacing", "1")), ("killed.tar", ("surface", "in", "--spacing", "1"))):
            whole = out.replace("killed", "whole")
            self.batch(*words, "--out", whole, code=6)
            for _ in range(12):
                process = subprocess.Popen(self.command(*words, "--out", out, "--resume", "--quiet"), cwd=self.folder,
                                           stderr=subprocess.DEVNULL)
                time.sleep(moments.uniform(0.01, 0.35))
                process.send_signal(moments.choice((signal.SIGKILL, signal.SIGTERM)))
                process.wait()
            self.batch(*words, "--out", out, "--resume", code=6)
            self.assertEqual(self.results(out), self.results(whole))
            if out.endswith(".tar"):
                self.assertEqual((self.folder / out).read_bytes(), (self.folder / whole).read_bytes())
            else:
                self.assertEqual(contents(self.folder / out), contents(self.folder / whole))

    def test_lines_that_were_cut_off_are_made_again(self):
        self.batch("measure", "in", "--out", "out", code=6)
        expected = contents(self.folder / "out")
        log = self.folder / "out/.batch/shard-0-of-1.log"
        text = log.read_bytes()
        for size in (len(text) - 5, len(text) // 2, text.index(b"\n") + 1, 3, 0):
            log.write_bytes(text[:size])
            (self.folder / "out/results.jsonl").unlink()
            self.batch("measure", "in", "--out", "out", "--resume", code=6)
            self.assertEqual(contents(self.folder / "out"), expected)

    def test_what_is_done_is_skipped_and_what_failed_is_tried_again(self):
        self.batch("measure", "in", "--out", "out", code=6)
        self.write("bad.xyzr", spheres(12, 3))
        self.write("a/deep/m0.xyzr", spheres(13, 4))  # another size
        text = self.batch("measure", "in", "--out", "out", "--resume").stdout
        self.assertIn("13 inputs, 0 failed, 11 already done", text)
        self.assertEqual(self.results()[0]["report"]["input"]["atoms"], 13)

    def test_new_inputs_join_and_old_ones_leave(self):
        self.batch("measure", "in/a", "--out", "out")
        (self.inputs / "a/deep/m0.xyzr").unlink()
        self.write("a/new.xyzr", spheres(12, 3))
        self.batch("measure", "in/a", "--out", "out", "--resume")
        self.assertEqual([r["input"] for r in self.results()], ["deep/m3.xyzr", "deep/m6.xyzr", "deep/m9.xyzr", "new.xyzr"])

    def test_another_run_is_not_gone_on_with(self):
        self.batch("measure", "in/a", "--out", "out")
        self.assertIn("add --resume", self.refused("measure", "in/a", "--out", "out"))
        self.assertIn("with different options", self.refused("measure", "in/a", "--out", "out", "--resume", "--probe", "1.2"))
        self.assertIn("with different options", self.refused("surface", "in/a", "--out", "out", "--resume"))

    def test_only_one_run_works_on_a_shard(self):
        os.mkfifo(self.inputs / "never.xyzr")
        process = subprocess.Popen(self.command("measure", "in/never.xyzr", "--out", "out"), cwd=self.folder)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        wait_until(lambda: children(process.pid))
        self.assertIn("another run", self.refused("measure", "in/never.xyzr", "--out", "out", "--resume"))


class Shards(BatchTest):
    def test_together_they_are_the_whole(self):
        for out in ("whole", "whole.tar"):
            self.batch("surface", "in", "--out", out, "--spacing", "1", code=6)
        codes = set()
        for out in ("parts", "parts.tar"):
            for i in range(4):
                process = subprocess.run(self.command("surface", "in", "--out", out, "--spacing", "1", "--shard", f"{i}/4"),
                                         cwd=self.folder, capture_output=True, check=False)
                codes.add(process.returncode)
            self.batch("surface", "--out", out, "--collect", code=6)
        self.assertEqual(codes, {0, 6})
        self.assertEqual(contents(self.folder / "parts"), contents(self.folder / "whole"))
        self.assertEqual(self.results("parts.tar"), self.results("whole.tar"))
        members = {}
        for i in range(4):
            with tarfile.open(self.folder / f"parts-{i}-of-4.tar") as tar:
                members.update({m.name: tar.extractfile(m).read() for m in tar})
        with tarfile.open(self.folder / "whole.tar") as tar:
            self.assertEqual(members, {m.name: tar.extractfile(m).read() for m in tar})

    def test_they_are_balanced(self):
        sizes = []
        for i in range(3):
            self.batch("measure", "in/a", "in/top.XYZR", "in/packed.xyzr.gz", "--out", "out", "--shard", f"{i}/3")
            done = (self.folder / f"out/.batch/shard-{i}-of-3.done").read_text().splitlines()[1:]
            sizes.append(len(done))
        self.assertEqual(sum(sizes), 6)
        self.assertTrue(all(sizes))

    def test_an_array_names_its_own(self):
        array = {"SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": "5", "SLURM_ARRAY_TASK_MAX": "6"}
        for task in ("5", "6"):
            self.batch("measure", "in/a", "--out", "out", environment={**array, "SLURM_ARRAY_TASK_ID": task})
        self.batch("measure", "--out", "out", "--collect")
        self.assertEqual(len(self.results()), 4)
        gaps = {**array, "SLURM_ARRAY_TASK_MAX": "9", "SLURM_ARRAY_TASK_ID": "5"}
        self.assertIn("without gaps", self.refused("measure", "in/a", "--out", "other", environment=gaps))

    def test_missing_and_unlike_shards_are_not_collected(self):
        self.assertIn("no results", self.refused("measure", "--out", "out", "--collect", code=3))
        self.batch("measure", "in/a", "--out", "out", "--shard", "0/2")
        self.assertIn("shard 1/2 is not finished", self.refused("measure", "--out", "out", "--collect", code=3))
        self.batch("measure", "in/b", "--out", "out", "--shard", "1/2")
        self.assertIn("different inputs", self.refused("measure", "--out", "out", "--collect", code=3))
        self.batch("measure", "in/a", "--out", "out", "--shard", "0/3")
        self.assertIn("of 3", self.refused("measure", "--out", "out", "--collect", code=3))

    def test_more_shards_than_inputs(self):
        for i in range(3):
            self.batch("measure", "in/top.XYZR", "--out", "out", "--shard", f"{i}/3")
        self.batch("measure", "--out", "out", "--collect")
        self.assertEqual(len(self.results()), 1)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""A batch on Slurm gives the bytes of the same batch on one machine, though tasks of it are killed and requeued.

The commands are those of docs/howto/slurm.md, in a cluster that this test starts. Skipped, saying why, where there
can be none.

usage: slurm_test.py PROGRAM SOURCE_DIR
"""
import json
import math
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import slurm_cluster

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
sys.path += [str(SOURCE / "tests" / room) for room in ("docs", "support")]

import markdown  # noqa: E402
from sanitized import is_sanitized  # noqa: E402
import shown_output  # noqa: E402

PAGE = SOURCE / "docs" / "howto" / "slurm.md"
SCRIPT = pathlib.Path("tools/slurm/meniscus-array.sh")
DATA = pathlib.Path(os.environ.get("MENISCUS_TEST_DATA", "nowhere")) / "structures"
REAL = [SOURCE / "examples" / "1ubq.pdb", SOURCE / "examples" / "1a0q.pdb", DATA / "1crn.cif", DATA / "4pti.ent",
        DATA / "1bna.pdb", DATA / "1npc.pdb.gz", DATA / "1en2.cif"]
INPUTS = 200
BROKEN = "ATOM      1  CA  GLY A   1      x.xxx   0.000   0.000\n"
SKIPPED = 77


def chain(count, seed):
    """A chain of carbon atoms, different for every seed, as PDB."""
    numbers = random.Random(seed)
    x = y = z = 0.0
    lines = []
    for i in range(1, count + 1):
        lines.append(f"ATOM  {i:5}  CA  GLY A{i:4}    {x:8.3f}{y:8.3f}{z:8.3f}  1.00 10.00           C\n")
        a, b = numbers.uniform(0, 6.28), numbers.uniform(0, 3.14)
        x, y, z = x + 1.5 * math.cos(a) * math.sin(b), y + 1.5 * math.sin(a) * math.sin(b), z + 1.5 * math.cos(b)
    return "".join(lines)


def write_structures(folder):
    """200 inputs in two folders: real structures as far as they are there, one that is broken, else generated ones."""
    for name in ("real", "made"):
        (folder / name).mkdir(parents=True)
    for path in filter(pathlib.Path.exists, REAL):
        shutil.copy(path, folder / "real")
    (folder / "broken.pdb").write_text(BROKEN)
    for i in range(INPUTS - len(list(folder.rglob("*.*")))):
        (folder / "made" / f"{i}.pdb").write_text(chain(100 + 5 * i, i))


class SlurmTest(unittest.TestCase):
    """A scratch folder with structures, the array script, and `meniscus` on the PATH of every job."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-slurm-"))
        self.cluster = slurm_cluster.Cluster(self.folder, cpus=4)
        self.addCleanup(self.cluster.stop)
        self.cluster.environment["PATH"] = f"{self.folder / 'bin'}:{os.environ['PATH']}"
        shutil.copytree(SOURCE / "examples", self.folder / "examples")
        (self.folder / SCRIPT).parent.mkdir(parents=True)
        shutil.copy(SOURCE / SCRIPT, self.folder / SCRIPT)
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "meniscus").symlink_to(PROGRAM)
        write_structures(self.folder / "structures")
        self.cluster.start()

    def execute(self, block):
        """What a block of the page prints, compared with what the page shows; its jobs are still under way."""
        command, output = block
        done = subprocess.run(["bash", "-c", "set -eo pipefail\n" + command.text], cwd=self.folder, encoding="utf-8",
                              env=self.cluster.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=120, check=False)
        where = f"{PAGE.name}:{command.line}"
        self.assertEqual(done.returncode, 0, f"{where}: {done.stdout}{self.cluster.messages()}")
        if output:
            self.assertTrue(shown_output.same_output(output.text, done.stdout), f"{where}: printed\n{done.stdout}")

    def wait_for_jobs(self):
        self.cluster.wait_until(lambda: not self.cluster.jobs(), "jobs do not end", 300)

    def shard(self, task, suffix):
        return self.folder / "measured" / ".batch" / f"shard-{task}-of-4{suffix}"

    def process_of(self, job, task):
        """The `meniscus batch` of a task; what it has started has the same words until it becomes another program."""
        found = slurm_cluster.processes_with({"SLURM_CONF": self.cluster.environment["SLURM_CONF"],
                                              "SLURM_ARRAY_JOB_ID": job, "SLURM_ARRAY_TASK_ID": str(task)})
        batches = {process: parent for process, parent, words in found if words[:2] == ["meniscus", "batch"]}
        process, = [process for process, parent in batches.items() if parent not in batches]
        return process

    def stop_half_way(self, job, task):
        """Stops a task that has done some of its inputs and not all, so that what follows finds it so; its process."""
        log = self.shard(task, ".log")
        self.cluster.wait_until(lambda: log.exists() and log.read_bytes().count(b"\n") > 5, f"task {task} does nothing")
        process = self.process_of(job, task)
        os.kill(process, signal.SIGSTOP)
        self.assertFalse(self.shard(task, ".done").exists())
        return process

    def start_again(self, job):
        """A requeued task waits for two minutes, which this test does not. Nodes refuse what was allowed within the second
        in which the task was ended, so some seconds are left."""
        self.cluster.wait_until(lambda: self.cluster.jobs().get(job) == "PENDING", f"{job} is not requeued")
        self.cluster.run("scontrol", "update", f"JobId={job}", "StartTime=now+5")

    def harm(self, array):
        """Task 1 is killed, as by a crash, and requeued once it has failed; task 2 is requeued as by preemption: Slurm ends
        it and starts it again."""
        killed, preempted = f"{array}_1", f"{array}_2"
        process = self.stop_half_way(array, 1)
        self.stop_half_way(array, 2)
        os.kill(process, signal.SIGKILL)
        self.cluster.wait_until(lambda: self.cluster.value(killed, "JobState") == "FAILED", f"{killed} does not fail")
        self.assertEqual(self.cluster.value(killed, "ExitCode"), "137:0")
        for job in (killed, preempted):
            self.cluster.run("scontrol", "requeue", job)
            self.start_again(job)
        for task in (1, 2):
            self.assertFalse(self.shard(task, ".done").exists())

    def assert_whole(self, code):
        """The results of the shards are the bytes of a batch that is not divided."""
        done = subprocess.run([PROGRAM, "batch", "measure", "structures", "--out", "whole", "--radii", "united", "--resume"],
                              cwd=self.folder, capture_output=True, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        whole = (self.folder / "whole" / "results.jsonl").read_bytes()
        self.assertEqual(whole.count(b"\n"), INPUTS)
        self.assertEqual((self.folder / "measured" / "results.jsonl").read_bytes(), whole)

    def times_done(self, task):
        """How often the inputs of a task were computed with success."""
        records = map(json.loads, self.shard(task, ".log").read_text().splitlines())
        names = [record["result"]["input"] for record in records if record.get("result", {}).get("status") == "done"]
        return {names.count(name) for name in names}

    def test_the_page(self):
        blocks = markdown.read(PAGE)[0]
        after = [*blocks[1:], None]
        on_cluster = [(block, next_one if next_one and next_one.kind == "output" else None)
                      for block, next_one in zip(blocks, after) if "slurm" in block.info]
        submit, show, mend, show_again = on_cluster

        self.execute(submit)
        array, collecting = sorted({job.partition("_")[0] for job in self.cluster.jobs()}, key=int)
        self.harm(array)
        self.wait_for_jobs()
        for task in range(4):
            printed = (self.folder / f"slurm-{array}_{task}.out").read_text()
            self.assertEqual(self.cluster.value(f"{array}_{task}", "ExitCode"), "0:0", printed + self.cluster.messages())
            self.assertEqual(self.times_done(task), {1}, "what was done is done once more")
        self.assertEqual([self.cluster.value(f"{array}_{task}", "Restarts") for task in range(4)], ["0", "1", "1", "0"])
        self.assertEqual(self.cluster.value(collecting, "ExitCode"), "6:0")
        self.execute(show)
        self.assert_whole(code=6)

        self.execute(mend)
        self.wait_for_jobs()
        self.execute(show_again)
        self.assert_whole(code=0)


if __name__ == "__main__":
    why = "sanitizers need more than --memory-limit" if is_sanitized(PROGRAM) else slurm_cluster.obstacle()
    if why:
        print("skipped:", why)
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])

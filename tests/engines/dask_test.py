#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""meniscus.map() on a Dask cluster of this machine: what it gives is what `meniscus batch` gives, killed workers or not.

MENISCUS_TEST_DATA  the smallest of the structures in its folder `structures` are among the inputs

usage: dask_test.py PROGRAM SOURCE_DIR
"""
import concurrent.futures
import importlib.util
import json
import logging
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

if importlib.util.find_spec("distributed") is None:
    print("skipped: needs distributed (python3-distributed), which packages.txt lists")
    sys.exit(77)

import distributed  # noqa: E402

import meniscus  # noqa: E402

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
sys.path.append(str(SOURCE / "tests" / "support"))

from sphere_chain import sphere_chain  # noqa: E402

REAL = pathlib.Path(os.environ.get("MENISCUS_TEST_DATA", "/nonexistent")) / "structures"
INPUTS = 200
MOST_REAL = 20


def make_inputs(folder):
    """Generated files in nested folders, one of which is no structure, and small real ones; their paths, shuffled."""
    structures = (path for path in REAL.glob("*") if path.suffix in (".pdb", ".cif", ".xyzr"))
    real = sorted(structures, key=lambda path: (path.stat().st_size, path.name))[:MOST_REAL]
    for path in [SOURCE / "examples" / "1ubq.pdb", *real]:
        target = folder / "real" / path.name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, target)
    (folder / "bad.xyzr").write_text("0 0 0 1.7\n1 2\n")
    for i in range(INPUTS - len(list(folder.rglob("*.*")))):
        path = folder / "abc"[i % 3] / "deep" / f"m{i}.xyzr"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(sphere_chain(10 + 3 * i, i))
    paths = sorted(path for path in folder.rglob("*") if path.is_file())
    random.Random(1).shuffle(paths)
    return paths


def contents(folder):
    """Every file below a folder but those of the state: path -> bytes; times are left out."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file() and ".batch" not in path.parts and path.name != "times.jsonl"}


def count_meshes(folder):
    """Those in their place; what is under way is in folders with a dot."""
    count = 0
    for _, folders, files in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        count += sum(name.endswith(".ply") for name in files)
    return count


class Dask(unittest.TestCase):
    """Two workers, each a process, for all tests."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="meniscus-dask-")
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        cls.paths = make_inputs(cls.folder / "in")
        cls.cluster = distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, host="127.0.0.1", dashboard_address=None,
            local_directory=scratch.name, silence_logs=logging.CRITICAL)
        cls.addClassCleanup(cls.cluster.close)
        cls.client = distributed.Client(cls.cluster)
        cls.addClassCleanup(cls.client.close)

    def map(self, paths, **options):
        return meniscus.map(paths, self.client, **{"program": PROGRAM, **options})

    def test_a_killed_worker_changes_nothing(self):
        subprocess.run([PROGRAM, "batch", "surface", "in", "--out", "expected", "--spacing", "1", "-o", ".ply",
                        "--mixed-radii", "--quiet"], cwd=self.folder, check=False)
        out = self.folder / "out"
        with concurrent.futures.ThreadPoolExecutor(1) as pool:
            found = pool.submit(self.map, self.paths, command="surface", out=out, outputs=[".ply"], spacing=1,
                                mixed_radii=True)
            self.kill_a_worker_when(lambda: count_meshes(out) > INPUTS // 2, found)
            found = found.result(500)
        expected = contents(self.folder / "expected")
        self.assertEqual(expected["results.jsonl"].count(b"\n"), INPUTS)
        self.assertGreater(len(expected), INPUTS)
        self.assertEqual(contents(out), expected)
        self.assertEqual(set(os.listdir(out)) - set(os.listdir(self.folder / "expected")), set())
        lines = {record["input"]: record for record in map(json.loads, expected["results.jsonl"].splitlines())}
        self.assertEqual(lines["bad.xyzr"]["status"], "failed")
        self.assertEqual(found, [lines[str(path.relative_to(self.folder / "in"))] for path in self.paths])

    def kill_a_worker_when(self, happened, running):
        while not happened():
            self.assertFalse(running.done(), "all was done before a worker could be killed")
            time.sleep(0.05)
        os.kill(next(nanny.pid for nanny in self.cluster.workers.values() if nanny.pid), signal.SIGKILL)
        self.assertFalse(running.done())

    def test_two_runs_do_not_meet(self):
        some = self.paths[:5]
        self.assertEqual(self.map(some, mixed_radii=True), meniscus.map(some, program=PROGRAM, mixed_radii=True))
        self.assertEqual(*(self.map(some, probe=probe, mixed_radii=True) for probe in (1, 1.0)))

    def test_what_is_refused_on_a_worker_is_refused_here(self):
        with self.assertRaisesRegex(meniscus.UsageError, "--probe: must be"):
            self.map(self.paths, probe=-1)
        with self.assertRaisesRegex(meniscus.UsageError, "has radii file and real/.* has radii united"):
            self.map([self.folder / "in/real/1ubq.pdb", self.folder / "in/a/deep/m0.xyzr"])
        with self.assertRaisesRegex(FileNotFoundError, "nowhere"):
            self.map(self.paths, program="/nowhere/meniscus")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

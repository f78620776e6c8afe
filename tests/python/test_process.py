# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What a long-lived process needs: no growth, other threads, Ctrl-C, children."""
import concurrent.futures
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import unittest

import numpy as np
from support import UBIQUITIN, read

import meniscus

PEPTIDE = read(UBIQUITIN, select="//A/1-20")


def resident_mb():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def use_everything(shift):
    structure = meniscus.Structure.from_arrays(PEPTIDE.xyz + shift, PEPTIDE.radii, element=PEPTIDE.element)
    surface = meniscus.surface(structure, spacing=1.0)
    points = surface.sample(0.2)
    return (surface.level_set(points.points), surface.gradient(points.points), surface.measures.cavities,
            surface.normals, surface.colors("element"), surface.mesh)


def area_in_child(queue):
    queue.put(meniscus.surface(PEPTIDE, spacing=1.0).mesh["area"])


class Process(unittest.TestCase):
    def test_a_thousand_small_proteins_leave_nothing_behind(self):
        shifts = np.random.default_rng(1).uniform(-1, 1, (1000, 3))
        for shift in shifts[:200]:
            use_everything(shift)
        before = resident_mb()
        for shift in shifts[200:]:
            use_everything(shift)
        self.assertLess(resident_mb() - before, 8.0)

    def test_reading_and_failing_leaves_nothing_behind(self):
        def once():
            read(UBIQUITIN)
            with self.assertRaises(ValueError):
                meniscus.surface(PEPTIDE, spacing=-1.0)
            with self.assertRaises(OSError):
                meniscus.read("nosuch.pdb")

        for _ in range(30):
            once()
        before = resident_mb()
        for _ in range(100):
            once()
        self.assertLess(resident_mb() - before, 4.0)

    def test_threads_get_what_one_thread_gets(self):
        shifts = [np.array([0.1 * i, 0, 0]) for i in range(16)]
        alone = [use_everything(shift)[0] for shift in shifts]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            together = [result[0] for result in pool.map(use_everything, shifts)]
        for a, b in zip(alone, together):
            self.assertTrue((a == b).all())

    def test_one_surface_may_be_used_by_several_threads(self):
        surface = meniscus.surface(PEPTIDE, method="direct", spacing=1.0)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            values = list(pool.map(lambda _: surface.level_set(PEPTIDE.xyz), range(8)))
        for v in values:
            self.assertTrue((v == values[0]).all())

    def test_other_threads_run_while_a_surface_is_computed(self):
        """Each side waits for the other: were the interpreter held, neither would go on."""
        in_progress, seen = threading.Event(), threading.Event()

        def other():
            in_progress.wait()
            seen.set()

        thread = threading.Thread(target=other)
        thread.start()

        def progress(stage, part):
            in_progress.set()
            seen.wait(60)

        meniscus.surface(PEPTIDE, progress=progress)
        self.assertTrue(seen.is_set())
        thread.join()

    def test_threads_compute_at_the_same_time(self):
        """Two surfaces meet in their callbacks, which neither could if one held the other up until its end."""
        meeting = threading.Barrier(2, timeout=60)
        met = threading.Event()

        def progress(stage, part):
            if not met.is_set():
                meeting.wait()
                met.set()

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            list(pool.map(lambda _: meniscus.surface(PEPTIDE, progress=progress), range(2)))
        self.assertTrue(met.is_set())

    def ends_at_ctrl_c(self, seconds):
        """Whether a surface that takes longer ends without a result; it looks for Ctrl-C in most of its stages."""
        result = None
        threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            result = meniscus.surface(read(UBIQUITIN), spacing=0.1)
            threading.Event().wait(60)
        return result is None

    def test_ctrl_c_ends_a_surface(self):
        self.assertTrue(any(self.ends_at_ctrl_c(seconds) for seconds in (0.2, 0.1, 0.4, 0.05, 0.8)))
        self.assertTrue(meniscus.surface(PEPTIDE, spacing=1.0).passed)

    def test_too_little_memory_is_a_memory_error(self):
        code = f"""
import pathlib, resource, sys
sys.path.insert(0, {os.path.dirname(os.path.dirname(meniscus.__file__))!r})
import meniscus
structure = meniscus.read({str(UBIQUITIN)!r})
size = int(pathlib.Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
refused = 0
for more in (0, 1, 2, 4, 8, 16, 32):
    resource.setrlimit(resource.RLIMIT_AS, (size + (more << 20), resource.RLIM_INFINITY))
    try:
        meniscus.surface(structure, spacing=0.25, threads=2)
    except MemoryError:
        refused += 1
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
assert meniscus.surface(structure, spacing=1.0).passed
print(refused)
"""
        done = subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, encoding="utf-8",
                              check=False, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(int(done.stdout), 2)

    def test_children_that_start_afresh_can_compute(self):
        meniscus.surface(PEPTIDE, spacing=1.0)
        context = multiprocessing.get_context("spawn")
        queue = context.Queue()
        child = context.Process(target=area_in_child, args=(queue,))
        child.start()
        self.assertEqual(queue.get(timeout=120), meniscus.surface(PEPTIDE, spacing=1.0).mesh["area"])
        child.join()


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Too little memory, by ulimit -v: one clear line and exit code 5, at whatever limit; never a crash, never half a file.

usage: memory_test.py FOLDER_OF_PROGRAM SOURCE_DIR [unittest arguments]
"""
import resource
import unittest

from support import MENISCUS, MSMS, NANOSHAPER, PRM, TO_XYZR, UBIQUITIN, FaultTest, is_remark, main, limits_memory

MEGABYTE = 1 << 20


def limit(size):
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size))


@limits_memory
class Memory(FaultTest):
    def setUp(self):
        super().setUp()
        (self.folder / "surfaceConfiguration.prm").write_text(PRM)

    def least(self, *command, code=0):
        """MB with which a program starts at all and ends with a code: below that the loader of libraries fails."""
        for size in range(8, 512, 4):
            if self.run_program(*command, preexec_fn=limit(size * MEGABYTE)).returncode == code:
                return size
        self.skipTest("the program does not start with 512 MB of address space")

    def sweep(self, least, *command, steps=16):
        """Runs a command at growing limits until it succeeds several times; counts refusals."""
        before = self.files()
        refused = 0
        succeeded = 0
        size = least + 0.5
        while succeeded < 3 and size < 2000:
            result = self.run_program(*command, preexec_fn=limit(int(size * MEGABYTE)))
            if result.returncode == 0:
                succeeded += 1
            else:
                self.assertEqual(result.returncode, 5, (size, command, result.stderr))
                errors = [line for line in result.stderr.splitlines() if not is_remark(line)]
                self.assertEqual(len(errors), 1, (size, command, result.stderr))
                self.assertIn("memory", errors[0])
                self.assertEqual(self.temporary(), [])
                refused += 1
            for name in set(self.files()) - set(before):
                (self.folder / name).unlink()
            size += max(0.7, size / steps)
        self.assertEqual(succeeded, 3)
        return refused

    def test_surface(self):
        least = self.least(MENISCUS, "--version")
        for threads in ("1", "4"):
            refused = self.sweep(least, MENISCUS, "surface", UBIQUITIN, "--spacing", "0.3", "-o", "a.ply", "-o",
                                 "a.html", "--report", "r.json", "--quiet", "--threads", threads)
            self.assertGreater(refused, 3)
        self.sweep(least, MENISCUS, "surface", UBIQUITIN, "--method", "direct", "--edge", "0.7", "-o", "a.png", "-o",
                   "a.dx", "--quiet", "--threads", "1")

    def test_measure_and_compare(self):
        least = self.least(MENISCUS, "--version")
        for threads in ("1", "4"):
            self.sweep(least, MENISCUS, "measure", UBIQUITIN, "-o", "a.csv", "--quiet", "--threads", threads)
        self.sweep(least, MENISCUS, "compare", UBIQUITIN, "three.xyzr")

    def test_large_pages_change_nothing(self):
        """They are used, if at all, where no limit is set to the addresses of the program."""
        meshes = []
        for keywords in ({}, {"preexec_fn": limit(1 << 40)}):
            result = self.run_program(MENISCUS, "surface", UBIQUITIN, "-o", "a.ply", "--quiet", **keywords)
            self.assertEqual(result.returncode, 0, result.stderr)
            meshes.append((self.folder / "a.ply").read_bytes())
        self.assertEqual(*meshes)

    def test_drop_ins(self):
        self.sweep(self.least(MSMS, "-h"), MSMS, "-if", "three.xyzr", "-of", "a", "-density", "10")
        self.sweep(self.least(NANOSHAPER, "no-such.prm", code=3), NANOSHAPER)
        self.sweep(self.least(TO_XYZR, "--help"), TO_XYZR, UBIQUITIN)


if __name__ == "__main__":
    main()

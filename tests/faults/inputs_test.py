#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Strange inputs: pipes, devices, files that change while they are read, files of gigabytes, bombs.

usage: inputs_test.py FOLDER_OF_PROGRAM SOURCE_DIR [unittest arguments]
"""
import gzip
import os
import resource
import shutil
import subprocess
import tempfile
import threading
import time
import unittest

from support import MENISCUS, MSMS, SPHERES, TO_XYZR, UBIQUITIN, SHADOW, FaultTest, main, limits_memory

GIGABYTE = 1 << 30
# Every program that reads, with room for one name.
READERS = ([MENISCUS, "surface"], [MENISCUS, "measure"], [MSMS, "-if"], [TO_XYZR])


def peak_of(*arguments, **keywords):
    """Exit code, standard error and peak memory (MB) of a run."""
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen([str(a) for a in arguments], stdout=subprocess.DEVNULL, stderr=errors, **keywords)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        return process.returncode, errors.read().decode("utf-8", "replace"), usage.ru_maxrss / 1024


class PipesAndDevices(FaultTest):
    def test_a_pipe_with_a_name_is_read_as_a_file(self):
        os.mkfifo(self.folder / "pipe.xyzr")
        for command in ([MENISCUS, "measure", "pipe.xyzr"], [MENISCUS, "surface", "pipe.xyzr", "-o", "a.ply"],
                        [MSMS, "-if", "pipe.xyzr"]):
            writer = threading.Thread(target=lambda: (self.folder / "pipe.xyzr").write_text(SPHERES))
            writer.start()
            result = self.run_program(*command)
            writer.join(timeout=60)
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_nothing_comes(self):
        os.mkfifo(self.folder / "pipe.xyzr")
        (self.folder / "null.xyzr").symlink_to("/dev/null")
        for command in READERS:
            writer = threading.Thread(target=lambda: (self.folder / "pipe.xyzr").write_text(""))
            writer.start()
            self.assertIn("pipe.xyzr", self.fails(3, *command, "pipe.xyzr"))
            writer.join(timeout=60)
            self.assertIn("null.xyzr", self.fails(3, *command, "null.xyzr"))
            self.assertIn("/dev/null", self.fails(3, *command, "/dev/null"))
        self.fails(3, MENISCUS, "surface", "-", stdin=subprocess.DEVNULL)
        self.fails(3, TO_XYZR, stdin=subprocess.DEVNULL)

    def test_standard_input_is_closed(self):
        for command in ([MENISCUS, "surface", "-"], [MENISCUS, "measure", "-"], [TO_XYZR, "-"]):
            self.fails(3, "sh", "-c", '"$@" <&-', "sh", *command)

    def test_folders(self):
        (self.folder / "folder.xyzr").mkdir()
        for command in READERS:
            self.fails(3, *command, "folder.xyzr")

    def test_a_file_without_permission(self):
        if os.geteuid() == 0:
            self.skipTest("root may read every file")
        (self.folder / "three.xyzr").chmod(0)
        for command in READERS:
            self.assertIn("Permission denied", self.fails(3, *command, "three.xyzr"))


class ChangingFiles(FaultTest):
    """Whatever comes of it, it is a result, or one line of error: never a crash."""

    def expect_orderly(self, change, *command):
        path = self.folder / "changing.pdb"
        path.write_bytes(UBIQUITIN.read_bytes() * 60)
        stop = threading.Event()

        def keep_changing():
            while not stop.is_set():
                change(path)

        changer = threading.Thread(target=keep_changing)
        changer.start()
        try:
            for _ in range(6):
                result = self.run_program(*command)
                self.assertIn(result.returncode, (0, 3), result.stderr)
                errors = [line for line in result.stderr.splitlines() if ": error: " in line]
                self.assertEqual(len(errors), 0 if result.returncode == 0 else 1)
        finally:
            stop.set()
            changer.join(timeout=60)

    def test_cut_off_and_grown_meanwhile(self):
        whole = UBIQUITIN.read_bytes()

        def cut(path):
            os.truncate(path, 100000)
            with open(path, "ab") as file:
                file.write(whole)

        for command in ([MENISCUS, "measure", "changing.pdb"], [TO_XYZR, "changing.pdb"]):
            self.expect_orderly(cut, *command)

    def test_replaced_meanwhile(self):
        (self.folder / "other.pdb").write_bytes(UBIQUITIN.read_bytes())

        def replace(path):
            shutil.copy(self.folder / "other.pdb", self.folder / "next")
            os.replace(self.folder / "next", path)

        self.expect_orderly(replace, MENISCUS, "measure", "changing.pdb")

    def test_a_file_that_grows_for_ever_ends_when_its_writer_ends(self):
        os.mkfifo(self.folder / "slow.xyzr")

        def write():
            with open(self.folder / "slow.xyzr", "w", encoding="ascii") as pipe:
                for line in SPHERES.splitlines(keepends=True):
                    pipe.write(line)
                    pipe.flush()
                    time.sleep(0.2)

        writer = threading.Thread(target=write)
        writer.start()
        self.assertEqual(self.run_program(MENISCUS, "measure", "slow.xyzr").returncode, 0)
        writer.join(timeout=60)


class LargeFiles(FaultTest):
    def test_two_gigabytes_of_nothing(self):
        with open(self.folder / "hole.pdb", "wb") as file:
            file.truncate(2 * GIGABYTE)
        shutil.copy(self.folder / "three.xyzr", self.folder / "ok.xyzr")
        for command in READERS:
            code, error, peak = peak_of(*command, self.folder / "hole.pdb", cwd=self.folder)
            self.assertIn(code, (3, 5), error)
            self.assertEqual(len([line for line in error.splitlines() if ": error: " in line]), 1, error)
            self.assertLess(peak, 5000 * SHADOW)

    @limits_memory
    def test_a_large_file_of_atoms_is_read_or_refused_within_its_memory(self):
        line = UBIQUITIN.read_bytes()
        with open(self.folder / "large.pdb", "wb") as file:
            for _ in range(1600):  # 100 MB
                file.write(line.replace(b"END", b"REM"))
        refused = 0
        for limit in range(500 << 20, 940 << 20, 30 << 20):  # up to what it needs: no step of reading takes it ill

            def with_little_memory():
                resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

            result = self.run_program(MENISCUS, "measure", "large.pdb", preexec_fn=with_little_memory)
            self.assertIn(result.returncode, (0, 5), (limit, result.stderr))
            if result.returncode == 5:
                self.assertIn("memory", result.stderr.splitlines()[-1])
                refused += 1
        self.assertGreater(refused, 5)


class Bombs(FaultTest):
    def bomb(self, name, block, count):
        """A gzip file whose content is a block over and over: members are repeated, not compressed anew."""
        member = gzip.compress(block, 9)
        with open(self.folder / name, "wb") as file:
            for _ in range(count):
                file.write(member)

    def test_gigabytes_of_zeros(self):
        self.bomb("bomb.pdb.gz", bytes(64 << 20), 160)  # 10 GB
        for command in (["surface", "bomb.pdb.gz"], ["measure", "bomb.pdb.gz"], ["compare", "bomb.pdb.gz", "bomb.pdb.gz"]):
            code, error, peak = peak_of(MENISCUS, *command, cwd=self.folder)
            self.assertIn(code, (3, 5), error)
            self.assertIn("decompressed", error)
            self.assertLess(peak, 1500 * SHADOW)

    def test_gigabytes_of_blank_lines(self):
        self.bomb("bomb.cif.gz", b"data_x\n" + b"\n" * (64 << 20), 160)
        code, error, peak = peak_of(MENISCUS, "surface", "bomb.cif.gz", cwd=self.folder)
        self.assertIn(code, (3, 5), error)
        self.assertLess(peak, 1500 * SHADOW)

    @limits_memory
    def test_a_bomb_within_little_memory(self):
        self.bomb("bomb.pdb.gz", bytes(64 << 20), 4)

        def with_little_memory():
            resource.setrlimit(resource.RLIMIT_AS, (200 << 20, 200 << 20))

        code, error, _ = peak_of(MENISCUS, "measure", "bomb.pdb.gz", cwd=self.folder, preexec_fn=with_little_memory)
        self.assertEqual(code, 5, error)

    def test_bombs_of_other_inputs(self):
        self.bomb("map.dx.gz", b"0 " * (32 << 20), 64)
        self.bomb("mesh.ply.gz", b"ply\n" + bytes(64 << 20), 64)
        for command in (["surface", "three.xyzr", "-o", "a.ply", "--sample", "phi=map.dx.gz"],
                        ["compare", "mesh.ply.gz", "three.xyzr"]):
            code, error, peak = peak_of(MENISCUS, *command, cwd=self.folder)
            self.assertIn(code, (2, 3, 5), error)
            self.assertLess(peak, 1500 * SHADOW)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""SIGINT and SIGTERM at any time: temporary files are gone, files are whole or not there, the exit code tells.

usage: signals_test.py FOLDER_OF_PROGRAM SOURCE_DIR [unittest arguments]
"""
import os
import signal
import subprocess
import threading
import time
import unittest

from support import MENISCUS, MSMS, NANOSHAPER, PRM, UBIQUITIN, FaultTest, is_whole_ply, main

SIGNALS = (signal.SIGINT, signal.SIGTERM)


class SignalTest(FaultTest):
    def start(self, *arguments, **keywords):
        return subprocess.Popen([str(a) for a in arguments], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, **keywords)

    def end(self, process, number):
        process.send_signal(number)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + number)
        self.assertEqual(self.temporary(), [])

    def wait_for_temporary(self, process):
        while process.poll() is None and not self.temporary():
            time.sleep(0.001)


class WhileComputing(SignalTest):
    def test_surface(self):
        for number in SIGNALS:
            process = self.start(MENISCUS, "surface", UBIQUITIN, "--spacing", "0.1", "--progress", "json", "-o", "a.ply")
            for line in process.stderr:
                if b'"flow"' in line or b'"band"' in line:
                    break
            self.end(process, number)
            self.assertEqual(self.files(), ["three.xyzr"])

    def test_measure_and_compare(self):
        atoms = UBIQUITIN.read_text()
        shifted = "".join(line[:30] + f"{float(line[30:38]) + 60 * i:8.3f}" + line[38:] for i in range(120)
                          for line in atoms.splitlines(keepends=True) if line.startswith("ATOM"))
        (self.folder / "large.pdb").write_text(shifted)
        for number in SIGNALS:
            for command in (["measure", "large.pdb", "-o", "a.csv"], ["compare", "large.pdb", "three.xyzr"]):
                process = self.start(MENISCUS, *command)
                time.sleep(0.3)
                self.end(process, number)
                self.assertEqual(self.files(), ["large.pdb", "three.xyzr"])

    def test_drop_ins(self):
        spheres = "".join(f"{3 * (i % 40)} {3 * (i // 40 % 40)} {3 * (i // 1600)} 1.8\n" for i in range(256000))
        (self.folder / "three.xyzr").write_text(spheres)
        (self.folder / "surfaceConfiguration.prm").write_text(PRM)
        for number in SIGNALS:
            for command in ([MSMS, "-if", "three.xyzr", "-of", "a"], [NANOSHAPER]):
                process = self.start(*command)
                time.sleep(0.5)
                self.end(process, number)
                self.assertEqual(self.files(), ["surfaceConfiguration.prm", "three.xyzr"])


class WhileWriting(SignalTest):
    def test_large_files_are_whole_or_not_there(self):
        for number in SIGNALS:
            for delay in (0.0, 0.002, 0.01):
                process = self.start(MENISCUS, "surface", UBIQUITIN, "--spacing", "0.25", "-o", "a.ply", "-o", "b.ply")
                self.wait_for_temporary(process)
                time.sleep(delay)
                process.send_signal(number)
                process.communicate(timeout=120)
                self.assertIn(process.returncode, (0, 128 + number))  # 0: it was done before
                self.assertEqual(self.temporary(), [])
                for name in ("a.ply", "b.ply"):
                    if (self.folder / name).exists():
                        self.assertTrue(is_whole_ply(self.folder / name))
                        (self.folder / name).unlink()

    def test_a_reader_that_does_not_read_holds_nothing_up_for_long(self):
        for number in SIGNALS:
            for command, fifo in (([MENISCUS, "surface", UBIQUITIN, "-o", "b.vert"], "b.vert"),
                                  ([MSMS, "-if", "many.xyzr", "-of", "b"], "b.vert"),
                                  ([MENISCUS, "surface", UBIQUITIN, "-o", "b.ply"], "b.ply")):
                (self.folder / "many.xyzr").write_text("".join(f"{4 * i} 0 0 1.8\n" for i in range(300)))
                os.mkfifo(self.folder / fifo)
                opened = threading.Event()
                done = threading.Event()

                def hold(path=self.folder / fifo, opened=opened, done=done):
                    with open(path, "rb"):
                        opened.set()
                        done.wait(timeout=60)

                reader = threading.Thread(target=hold)
                reader.start()
                process = self.start(*command)
                opened.wait(timeout=60)
                time.sleep(1.0)
                self.end(process, number)
                done.set()
                reader.join(timeout=60)
                (self.folder / fifo).unlink()
                self.assertEqual([name for name in self.files() if name.startswith("b")], [])

    def test_an_older_file_stays(self):
        (self.folder / "a.ply").write_text("older")
        process = self.start(MENISCUS, "surface", UBIQUITIN, "--spacing", "0.1", "--progress", "json", "-o", "a.ply")
        process.stderr.readline()
        self.end(process, signal.SIGTERM)
        self.assertEqual((self.folder / "a.ply").read_text(), "older")


class Waiting(SignalTest):
    def test_for_input_that_does_not_come(self):
        os.mkfifo(self.folder / "never.pdb")
        for number in SIGNALS:
            for command in ([MENISCUS, "surface", "never.pdb"], [MENISCUS, "measure", "never.pdb"],
                            [MSMS, "-if", "never.pdb"]):
                process = self.start(*command)
                time.sleep(0.3)
                self.end(process, number)


if __name__ == "__main__":
    main()

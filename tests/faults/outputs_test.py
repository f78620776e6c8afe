#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Outputs that cannot be written: full disks, folders without permission, devices, pipes without a reader.

usage: outputs_test.py FOLDER_OF_PROGRAM SOURCE_DIR [unittest arguments]
"""
import json
import os
import pathlib
import resource
import shutil
import stat
import subprocess
import tempfile
import threading
import unittest

from support import (IS_ROOT, MENISCUS, MSMS, NANOSHAPER, PRM, TO_XYZR, UBIQUITIN, FaultTest, is_whole_ply, main)

EVERY_MESH = ("ply", "obj", "stl", "off", "glb", "vtp", "vert", "npz")


def file_size_limit(size):
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


class FullDisk(FaultTest):
    def small_disk(self):
        """A file system of 64 KiB in a mount namespace of its own, as the start of a command line."""
        probe = ["unshare", "--map-root-user", "--mount", "mount", "-t", "tmpfs", "-o", "size=64k", "none", "/mnt"]
        if IS_ROOT:
            probe.remove("--map-root-user")
        if shutil.which("unshare") is None or subprocess.run(probe, capture_output=True, check=False).returncode != 0:
            self.skipTest("no file system can be mounted here (unshare and mount -t tmpfs do not work)")
        disk = self.folder / "disk"
        disk.mkdir()
        start = ["unshare", "--mount"] if IS_ROOT else ["unshare", "--map-root-user", "--mount"]
        return disk, [*start, "sh", "-c", f"mount -t tmpfs -o size=64k none {disk} && \"$@\"; code=$?; "
                      f"ls -A {disk} > {self.folder}/left; exit $code", "sh"]

    def expect_nothing_left(self, *names):
        self.assertEqual((self.folder / "left").read_text().split(), list(names))
        (self.folder / "left").unlink()

    def test_no_room_for_any_format(self):
        disk, start = self.small_disk()
        for suffix in (*EVERY_MESH, "html", "png", "dx", "mrc"):
            error = self.fails(4, *start, MENISCUS, "surface", UBIQUITIN, "--spacing", "1", "-o", disk / f"a.{suffix}")
            self.assertIn("No space left", error, suffix)
            self.expect_nothing_left()

    def test_files_finished_before_stay_and_are_whole(self):
        disk, start = self.small_disk()
        self.fails(4, *start, MENISCUS, "surface", UBIQUITIN, "-o", disk / "a.xyzr", "-o", disk / "b.ply")
        self.expect_nothing_left("a.xyzr")

    def test_no_room_for_measures_reports_and_drop_ins(self):
        disk, start = self.small_disk()
        fill = ["sh", "-c", f"head -c 65536 /dev/zero > {disk}/full; exec \"$@\"", "sh"]
        for command in ([MENISCUS, "measure", UBIQUITIN, "-o", disk / "a.csv"],
                        [MENISCUS, "measure", UBIQUITIN, "--report", disk / "a.json", "--quiet"],
                        [MSMS, "-if", "three.xyzr", "-of", disk / "a"],
                        [MSMS, "-if", "three.xyzr", "-af", disk / "a"]):
            self.assertIn("No space left", self.fails(4, *start, *fill, *command))
            self.expect_nothing_left("full")

    def test_a_limit_on_the_size_of_files(self):
        for suffix in EVERY_MESH:
            error = self.fails(4, MENISCUS, "surface", UBIQUITIN, "--spacing", "1", "-o", f"a.{suffix}",
                               preexec_fn=file_size_limit(20000))
            self.assertIn("File too large", error, suffix)
        (self.folder / "surfaceConfiguration.prm").write_text(PRM)
        self.assertIn("File too large", self.fails(4, NANOSHAPER, preexec_fn=file_size_limit(2000)))
        self.assertIn("File too large", self.fails(4, MSMS, "-if", "three.xyzr", "-of", "a",
                                                   preexec_fn=file_size_limit(2000)))
        self.assertEqual(self.files(), ["surfaceConfiguration.prm", "three.xyzr"])


class Folders(FaultTest):
    def test_an_output_that_is_a_folder(self):
        for name in ("a.ply", "a.csv", "a.json", "a.vert", "b.face", "a.area"):
            (self.folder / name).mkdir()
        for command in (["surface", "three.xyzr", "-o", "a.ply"], ["measure", "three.xyzr", "-o", "a.csv"],
                        ["surface", "three.xyzr", "-o", "b.vert"], ["surface", "three.xyzr", "--report", "a.json"],
                        ["measure", "three.xyzr", "--report", "a.json"],
                        ["compare", "three.xyzr", "three.xyzr", "--report", "a.json"]):
            self.assertIn("folder", self.fails(4, MENISCUS, *command).replace("directory", "folder"))
        self.fails(4, MSMS, "-if", "three.xyzr", "-of", "a")
        self.fails(4, MSMS, "-if", "three.xyzr", "-af", "a")
        self.assertEqual(self.files(), ["three.xyzr"])

    def test_a_folder_without_permission(self):
        closed = self.folder / "closed"
        closed.mkdir()
        shutil.copy(self.folder / "three.xyzr", closed)
        (closed / "surfaceConfiguration.prm").write_text(PRM)
        closed.chmod(0o555)
        self.folder.chmod(0o755)
        someone = {"user": 65534, "group": 65534, "extra_groups": []} if IS_ROOT else {}
        try:
            able = subprocess.run([MENISCUS, "--version"], capture_output=True, check=False, **someone).returncode == 0
        except PermissionError:
            able = False
        if not able:
            self.skipTest("the program's folder is closed to other users")
        for command in ([MENISCUS, "surface", "three.xyzr", "-o", "a.ply"], [MENISCUS, "surface", "three.xyzr"],
                        [MENISCUS, "surface", "three.xyzr", "--report", "a.json"],
                        [MENISCUS, "measure", "three.xyzr", "-o", "a.csv"], [MSMS, "-if", "three.xyzr", "-of", "a"],
                        [NANOSHAPER]):
            self.fails(4, *command, cwd=closed, **someone)
        self.assertEqual(self.files(closed), ["surfaceConfiguration.prm", "three.xyzr"])


class Devices(FaultTest):
    """A device is written to and never replaced: only copies of devices are touched here."""

    def test_a_device_stays_a_device(self):
        names = [f"d.{suffix}" for suffix in ("ply", "obj", "npz", "html", "png", "csv", "json", "pdb", "dx")]
        try:
            for name in names:
                os.mknod(self.folder / name, 0o666 | stat.S_IFCHR, os.makedev(1, 3))
        except PermissionError:
            self.skipTest("devices can be made by root alone")
        (self.folder / "link.ply").symlink_to("d.ply")
        result = self.run_program(MENISCUS, "surface", UBIQUITIN, "--spacing", "1", "-o", "d.ply", "-o", "link.ply",
                                  "-o", "d.obj", "-o", "d.npz", "-o", "d.html", "-o", "d.png", "--report", "d.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        result = self.run_program(MENISCUS, "measure", UBIQUITIN, "-o", "d.csv", "-o", "d.pdb")
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in names:
            self.assertTrue(stat.S_ISCHR((self.folder / name).stat().st_mode), name)
        self.assertTrue((self.folder / "link.ply").is_symlink())
        self.assertEqual(self.temporary(), [])

    def test_a_full_device(self):
        try:
            for name in ("f.ply", "f.csv", "f.vert", "f.face"):
                os.mknod(self.folder / name, 0o666 | stat.S_IFCHR, os.makedev(1, 7))
        except PermissionError:
            self.skipTest("devices can be made by root alone")
        self.assertIn("No space left", self.fails(4, MENISCUS, "surface", "three.xyzr", "-o", "f.ply"))
        self.assertIn("No space left", self.fails(4, MENISCUS, "surface", "three.xyzr", "-o", "f.vert"))
        self.assertIn("No space left", self.fails(4, MENISCUS, "measure", "three.xyzr", "-o", "f.csv"))
        self.assertTrue(stat.S_ISCHR((self.folder / "f.ply").stat().st_mode))

    def test_reports_to_a_full_device(self):
        for command in ("surface", "measure"):
            self.fails(4, MENISCUS, command, "three.xyzr", "--report", "/dev/full", "--quiet")
        self.fails(4, MENISCUS, "compare", "three.xyzr", "three.xyzr", "--report", "/dev/full")
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/full").st_mode))

    def test_a_pipe_with_a_name(self):
        os.mkfifo(self.folder / "pipe.ply")
        received = []
        reader = threading.Thread(target=lambda: received.append((self.folder / "pipe.ply").read_bytes()))
        reader.start()
        result = self.run_program(MENISCUS, "surface", "three.xyzr", "-o", "pipe.ply", "-o", "file.ply", "--quiet")
        reader.join(timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(received[0], (self.folder / "file.ply").read_bytes())
        self.assertTrue(stat.S_ISFIFO((self.folder / "pipe.ply").stat().st_mode))

    def test_a_reader_that_goes_away(self):
        os.mkfifo(self.folder / "pipe.ply")

        def read_a_little():
            with open(self.folder / "pipe.ply", "rb") as pipe:
                pipe.read(100)

        reader = threading.Thread(target=read_a_little)
        reader.start()
        self.assertIn("Broken pipe", self.fails(4, MENISCUS, "surface", UBIQUITIN, "-o", "pipe.ply"))
        reader.join(timeout=60)

    def test_standard_output_as_a_file(self):
        with open(self.folder / "log", "wb") as log:
            log.write(b"before\n")
            log.flush()
            result = self.run_program(MENISCUS, "surface", "three.xyzr", "--report", "/dev/stdout", "--quiet", "-o",
                                      "a.ply", stdout=log)
        self.assertEqual(result.returncode, 0, result.stderr)
        text = (self.folder / "log").read_text()
        self.assertTrue(text.startswith("before\n"))
        self.assertEqual(json.loads(text[7:])["schema"], 1)


class StandardOutput(FaultTest):
    COMMANDS = ([MENISCUS, "surface", "three.xyzr", "-o", "a.ply"], [MENISCUS, "measure", "three.xyzr"],
                [MENISCUS, "surface", "three.xyzr", "-o", "a.ply", "--report", "-"],
                [MENISCUS, "measure", "three.xyzr", "--report", "-"], [MENISCUS, "--help-all"],
                [MENISCUS, "--version"], [MENISCUS, "compare", "three.xyzr", "three.xyzr"],
                [MSMS, "-if", "three.xyzr"], [NANOSHAPER], [TO_XYZR, UBIQUITIN])

    def setUp(self):
        super().setUp()
        (self.folder / "surfaceConfiguration.prm").write_text(PRM)

    def test_nobody_reads_it(self):
        for command in self.COMMANDS:
            reading, writing = os.pipe()
            os.close(reading)
            self.assertIn("standard output", self.fails(4, *command, stdout=writing), command)
            os.close(writing)

    def test_it_is_full(self):
        for command in self.COMMANDS:
            with open("/dev/full", "wb") as full:
                self.assertIn("standard output", self.fails(4, *command, stdout=full), command)

    def test_it_is_closed(self):
        for command in self.COMMANDS:
            result = self.run_program("sh", "-c", '"$@" >&-', "sh", *command)
            self.assertEqual(result.returncode, 4, (command, result.stderr))
        for name in self.files():  # no file has taken the place of the closed descriptor
            if name.endswith(".ply"):
                self.assertTrue(is_whole_ply(self.folder / name))

    def test_a_silent_run_needs_none(self):
        result = self.run_program("sh", "-c", '"$@" >&- 2>&-', "sh", MENISCUS, "surface", "three.xyzr", "-o", "a.ply",
                                  "--quiet")
        self.assertEqual(result.returncode, 0)
        self.assertTrue(is_whole_ply(self.folder / "a.ply"))


if __name__ == "__main__":
    main()

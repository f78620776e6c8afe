#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Reads what we ship as the loader does: protections that are on, and nothing of the machine that built it.

usage: shipped_test.py SOURCE_DIR BUILD_DIR PROGRAM-OR-MODULE ... [-- OBJECT-ARCHIVE ...]
"""
import os
import pathlib
import platform
import pwd
import re
import socket
import subprocess
import sys
import unittest

SOURCE, BUILD = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
SPLIT = sys.argv.index("--")
BINARIES = [pathlib.Path(word).resolve() for word in sys.argv[3:SPLIT]]
ARCHIVES = [pathlib.Path(word).resolve() for word in sys.argv[SPLIT + 1:]]


def readelf(*words):
    return subprocess.run(["readelf", "--wide", *map(str, words)], capture_output=True, text=True, check=True,
                          env={**os.environ, "LC_ALL": "C"}).stdout


def traces():
    """Where, by whom and on what it was built; words of a few letters would be found by chance."""
    yield from map(str, (SOURCE, BUILD, SOURCE.parent))
    home = os.environ.get("HOME", "")
    yield from (word for word in (home, home + "/") if len(word) > 5)
    user = pwd.getpwuid(os.getuid()).pw_name
    yield from (word for word in (socket.gethostname(), user) if len(word) > 5)


class Shipped(unittest.TestCase):
    def for_each(self, check):
        self.assertGreater(len(BINARIES), 0)
        for binary in BINARIES:
            with self.subTest(binary.name):
                check(binary)

    def test_programs_run_at_any_address(self):
        def check(binary):
            self.assertRegex(readelf("-h", binary), r"Type:\s+DYN")
            if ".so" not in binary.name:
                self.assertRegex(readelf("-d", binary), r"FLAGS_1.*\bPIE\b")
        self.for_each(check)

    def test_tables_of_the_loader_are_read_only_from_the_start(self):
        def check(binary):
            self.assertIn("GNU_RELRO", readelf("-l", binary))
            self.assertRegex(readelf("-d", binary), r"BIND_NOW|FLAGS_1.*\bNOW\b")
        self.for_each(check)

    def test_nothing_is_both_written_and_executed(self):
        def check(binary):
            segments = readelf("-l", binary)
            self.assertRegex(segments, r"GNU_STACK\s.*\sRW\s")
            self.assertNotRegex(segments, r"(LOAD|GNU_STACK)\s.*\sRWE\s")
            self.assertNotIn("TEXTREL", readelf("-d", binary))
        self.for_each(check)

    def test_no_library_is_looked_for_in_folders_of_ours(self):
        self.for_each(lambda binary: self.assertNotRegex(readelf("-d", binary), "RPATH|RUNPATH"))

    def test_what_draws_is_loaded_by_who_draws_alone(self):
        self.for_each(lambda binary: self.assertNotRegex(readelf("-d", binary), "embree|freetype"))

    def test_stacks_and_buffers_are_guarded(self):
        def check(binary):
            self.assertIn("__stack_chk_fail", readelf("--dyn-syms", binary))
        self.for_each(check)
        self.assertRegex(readelf("--dyn-syms", BINARIES[0]), r"__\w+_chk\b")

    @unittest.skipUnless(platform.machine() == "x86_64", "jumps are marked on x86-64 alone")
    def test_targets_of_jumps_are_marked(self):
        for archive in ARCHIVES:
            notes = readelf("-n", archive)
            members = notes.count("\nFile: ")
            self.assertGreater(members, 0)
            self.assertEqual(len(re.findall(r"x86 feature: IBT, SHSTK", notes)), members, archive)

    def test_nothing_tells_where_and_by_whom_it_was_built(self):
        def check(binary):
            content = binary.read_bytes()
            for word in traces():
                self.assertEqual(content.find(word.encode()), -1, word)
        self.for_each(check)
        for archive in ARCHIVES:
            for word in traces():
                self.assertEqual(archive.read_bytes().find(word.encode()), -1, f"{archive}: {word}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

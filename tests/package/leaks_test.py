#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Writes every format in a folder, and under names of a user, a home and a host, that would be recognized, and looks for
them in all files, also within compressed streams. Names of files may be there, names of folders not.

usage: leaks_test.py PROGRAM SOURCE_DIR DROPINS [vdb]
"""
import base64
import gzip
import io
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import unittest
import zipfile
import zlib

import layers

PROGRAM, SOURCE, DROPINS = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
VOLUMES = "vdb" in sys.argv[4:5]  # this build writes .vdb
WORDS = ("telltale", "meniscus-leaks-")
SURROUNDINGS = {"HOME": "/home/telltalehome", "USER": "telltaleuser", "LOGNAME": "telltaleuser", "TOKEN": "telltaletoken",
                "HOSTNAME": "telltalehost", "TMPDIR": "", "EMAIL": "a@telltale.example"}
SPHERES = "".join(f"{x} {y} {z} 1.7\n" for x in (0, 3) for y in (0, 3) for z in (0, 3)) + "12 0 0 1.5\n"
TWO_CHAINS = "".join(f"ATOM  {i + 1:5}  CA  GLY {chain}{i + 1:4}    {3 * i:8.3f}{y:8.3f}   0.000  1.00 10.00           C\n"
                     for chain, y in (("A", 0), ("B", 3)) for i in range(4))
MAP = ("object 1 class gridpositions counts 2 2 2\norigin -50 -50 -50\ndelta 100 0 0\ndelta 0 100 0\ndelta 0 0 100\n"
       "object 2 class gridconnections counts 2 2 2\n"
       "object 3 class array type double rank 0 items 8 data follows\n-1 0 1\n0 1 2\n1 2\n")


def suffixes_of(command):
    """All that the program says it can write."""
    printed = subprocess.run([PROGRAM, command, "in.pdb", "-o", "a.unknown"], capture_output=True, text=True, check=False)
    return re.findall(r"\.\w+", printed.stderr.partition("choose one of")[2])


class Search(unittest.TestCase):
    """The search finds what there is, else it proves nothing."""

    def test_words_are_found_however_they_are_packed(self):
        word = bytes(range(97, 200)) + b"TellTale" + bytes(40)
        archive = io.BytesIO()
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as file:
            file.writestr("a", zlib.compress(word))
        raw = zlib.compressobj(wbits=-15)
        raw = raw.compress(word) + raw.flush()
        for content in (word, zlib.compress(word), b"head" + gzip.compress(word), archive.getvalue(), raw,
                        b"<a>" + base64.b64encode(raw) + b"</a>", base64.b64encode(b"." + word)):
            self.assertEqual(layers.mentions(content, WORDS), {"telltale"}, content)
        self.assertEqual(layers.mentions(zlib.compress(b"x" * 100), WORDS), set())


class Leaks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.top = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-leaks-"))
        cls.addClassCleanup(shutil.rmtree, cls.top)
        cls.folder = cls.top / "telltalefolder"
        cls.folder.mkdir()
        for name, text in {"spheres.xyzr": SPHERES, "chains.pdb": TWO_CHAINS, "map.dx": MAP, "rules.txt": "* C 1.8\n",
                           "values.csv": "chain,score\nA,1\nB,2\n"}.items():
            (cls.folder / name).write_text(text, encoding="ascii")

    def run_in_folder(self, program, *words):
        """With every path in full, so that folders are there to be told."""
        words = [str(self.folder / word[1:]) if str(word).startswith("/") else str(word) for word in words]
        words = [re.sub("=/", f"={self.folder}/", word) for word in words]
        done = subprocess.run([program, *words], cwd=self.folder, capture_output=True, text=True, check=False,
                              env={**os.environ, **SURROUNDINGS, "TMPDIR": str(self.folder)})
        self.assertEqual(done.returncode, 0, done.stderr)

    def expect_silence(self, *needed):
        words = {*WORDS, *(name for name in (socket.gethostname(),) if len(name) > 5)}
        files = [path for path in self.folder.rglob("*") if path.is_file()]
        suffixes = {path.suffix for path in files}
        self.assertLessEqual(set(needed), suffixes)
        for path in files:
            self.assertEqual(layers.mentions(path.read_bytes(), words), set(), path.name)

    def test_surfaces(self):
        known = [suffix for suffix in suffixes_of("surface") if suffix != ".vdb" or VOLUMES]
        self.assertGreater(len(known), 12)
        outputs = [word for i, suffix in enumerate(known) for word in ("-o", f"/out{i}{suffix}")]
        self.run_in_folder(PROGRAM, "surface", "/chains.pdb", "--spacing", "0.8", *outputs, "--report", "/report.json",
                           "--history", "/history.json", "--snapshots", "1", "--radii", "/rules.txt", "--values",
                           "/values.csv", "--sample", "phi=/map.dx", "--grid", "/map.dx", "--color", "score")
        self.run_in_folder(PROGRAM, "surface", "/spheres.xyzr", "--spacing", "0.8", "-o", "/more.ply", "--ascii",
                           "--history", "/history.csv", "--cavity-files", "--report", "/more.json")
        self.run_in_folder(PROGRAM, "surface", "/chains.pdb", "--per-chain", "-o", "/each.glb", "--report", "/each.json")
        self.expect_silence(*known, ".json", ".csv")

    def test_measures(self):
        known = suffixes_of("measure")
        outputs = [word for i, suffix in enumerate(known) for word in ("-o", f"/measured{i}{suffix}")]
        self.run_in_folder(PROGRAM, "measure", "/chains.pdb", "--between", "A:B", *outputs, "--report", "/measured.json")
        self.expect_silence(*known)

    def test_comparisons(self):
        self.run_in_folder(PROGRAM, "surface", "/spheres.xyzr", "-o", "/a.ply", "--quiet")
        self.run_in_folder(PROGRAM, "compare", "/a.ply", "/spheres.xyzr", "--report", "/compared.json", "-o", "/distance.ply")
        self.expect_silence(".json", ".ply")

    def test_programs_that_stand_in_for_others(self):
        self.run_in_folder(DROPINS / "meniscus-msms", "-if", "/spheres.xyzr", "-of", "/stand_in")
        self.expect_silence(".vert", ".face")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

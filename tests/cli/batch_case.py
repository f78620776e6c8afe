# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What tests of `meniscus batch` share."""
import gzip
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

from program_case import PROGRAM, SOURCE

sys.path.append(str(SOURCE / "tests" / "support"))

from sphere_chain import sphere_chain  # noqa: E402


def spheres(count, seed):
    return sphere_chain(count, seed).encode()


def contents(folder):
    """Every file below a folder but those of the state: path -> bytes; times are left out."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file() and ".batch" not in path.parts and path.name != "times.jsonl"}


class BatchTest(unittest.TestCase):
    """Every test has a folder of its own, with 13 inputs below `in`, one of which is no structure."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-batch-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.inputs = self.folder / "in"
        for i in range(10):
            self.write(f"{'abc'[i % 3]}/deep/m{i}.xyzr", spheres(10 + 15 * i, i))
        self.write("packed.xyzr.gz", gzip.compress(spheres(30, 77), mtime=0))
        self.write("bad.xyzr", b"0 0 0 1.7\n1 2\n")
        self.write("notes.txt", b"no structure")
        self.write("top.XYZR", spheres(25, 78))

    def write(self, name, text):
        path = self.inputs / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text)
        return path

    def command(self, *words):
        return [str(PROGRAM), "batch", *map(str, words)]

    def batch(self, *words, code=0, text=None, environment=None):
        result = subprocess.run(self.command(*words), cwd=self.folder, capture_output=True, encoding="utf-8", input=text,
                                timeout=300, check=False, env={**os.environ, **(environment or {})})
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def refused(self, *words, code=2, **keywords):
        """The one line on standard error of a run that ends at once."""
        errors = self.batch(*words, code=code, **keywords).stderr.splitlines()
        errors = [line for line in errors if not line.startswith(("meniscus: note: ", "meniscus: warning: "))]
        self.assertEqual(len(errors), 1, errors)
        return errors[0]

    def results(self, out="out"):
        path = self.folder / out
        path = path / "results.jsonl" if path.is_dir() else path.with_suffix(".jsonl")
        return [json.loads(line) for line in path.read_text().splitlines()]

    def archive(self, name, folder=None):
        with tarfile.open(self.folder / name, "w") as tar:
            tar.add(folder or self.inputs, arcname=".")
        return self.folder / name

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""tools/fit-pockets and bench/pockets on a few structures with ligands.

usage: fit_pockets_test.py PROGRAM SOURCE_DIR     with MENISCUS_TEST_DATA, else 77
"""
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
DATA = pathlib.Path(os.environ.get("MENISCUS_TEST_DATA", "")) / "pockets"
NAMES = ("A_1bcu", "A_1e66", "A_1gpk", "A_1lbk", "A_1mq6", "A_1q8t", "A_1z95", "A_2brb")
ROW = re.compile(r'^ +\{"(\S+)", (\S+), (\S+), (\S+)\},$', re.MULTILINE)


def run(script, *arguments, **environment):
    return subprocess.run([sys.executable, "-B", SOURCE / script, *map(str, arguments)], capture_output=True, text=True,
                          check=False, env={**os.environ, **environment})


class Fitting(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-fit-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.inputs, cls.kept = cls.folder / "in", cls.folder / "kept"
        for folder in (cls.inputs, cls.kept):
            folder.mkdir()
        for name in NAMES:
            shutil.copy(DATA / (name + ".pdb.gz"), cls.inputs)
        shutil.copy(DATA / "INDEX.tsv", cls.inputs)
        cls.arguments = (cls.inputs, "--program", PROGRAM, "--kept", cls.kept)
        cls.fitted = run("tools/fit-pockets", *cls.arguments, "--compare", cls.kept / "A_1e66.npz")

    def test_prints_the_table_of_the_source(self):
        self.assertEqual(self.fitted.returncode, 0, self.fitted.stderr)
        shipped = (SOURCE / "src" / "pockets" / "pocket_model.cpp").read_text(encoding="utf-8")
        ours, theirs = ROW.findall(self.fitted.stdout), ROW.findall(shipped)
        self.assertEqual(len(ours), 43)
        self.assertEqual([row[0] for row in ours], [row[0] for row in theirs])
        for name, mean, scale, _ in ours:
            self.assertGreater(float(scale), 0.0, name)
            shipped_mean, shipped_scale = next((float(row[1]), float(row[2])) for row in theirs if row[0] == name)
            self.assertLess(abs(float(mean) - shipped_mean), shipped_scale, name)

    def test_finds_much_the_same_from_a_few_structures(self):
        correlation = float(re.search(r"correlation (\S+)", self.fitted.stderr)[1])
        self.assertGreater(correlation, 0.8, self.fitted.stderr)

    def test_gives_the_same_again(self):
        self.assertEqual(run("tools/fit-pockets", *self.arguments).stdout, self.fitted.stdout)

    def test_sites_are_those_of_the_program(self):
        sys.path.insert(0, str(SOURCE / "tools"))
        import numpy as np
        import pocket_fit
        for name in NAMES[:4]:
            with np.load(self.kept / (name + ".npz")) as arrays:
                sites = pocket_fit.sites(arrays["point_xyz"], arrays["point_probability"].astype(float))
                apart = np.linalg.norm(sites[:, None] - arrays["pocket_centre"][None], axis=2)
            self.assertLess(apart.min(axis=1).max(), 0.01, name)
            self.assertEqual(apart[0].argmin(), 0, name)

    def test_the_benchmark_counts(self):
        result = run("bench/pockets", *self.arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(f"{len(NAMES)} structures", result.stdout)
        for model in ("shipped", "cross-validated"):
            first, three = map(float, re.search(rf"\| {model} \| (\S+) % .*? \| (\S+) % ", result.stdout).groups())
            self.assertLessEqual(first, three)
            self.assertGreater(three, 60.0, result.stdout)

    def test_says_what_is_missing(self):
        (self.folder / "sklearn.py").write_text("raise ModuleNotFoundError('no', name='sklearn')\n", encoding="utf-8")
        result = run("tools/fit-pockets", self.inputs, PYTHONPATH=str(self.folder))
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr, "fit-pockets: needs sklearn, which is not installed; install python3-sklearn\n")
        empty = self.folder / "empty"
        empty.mkdir()
        self.assertIn("has no structures with atoms of a residue LIG", run("tools/fit-pockets", empty).stderr)


if __name__ == "__main__":
    if not (DATA / "INDEX.tsv").exists() or importlib.util.find_spec("sklearn") is None:
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])

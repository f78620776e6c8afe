#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""PyMOL without a screen loads our OFF files, and our PLY files as text.

usage: pymol_test.py PROGRAM SOURCE_DIR

PyMOL 2.5 puts OFF at its place and multiplies the coordinates of PLY by 100. It reads neither binary PLY nor OBJ or STL.
"""
import json
import os
import subprocess

import foreign

# PyMOL's script finds its modules with the python3 that comes first.
ENVIRONMENT = {**os.environ, "PATH": "/usr/bin:/bin:" + os.environ.get("PATH", "")}
SCRIPT = """
import json
from pymol import cmd
found = {}
for name in ("off", "ply"):
    cmd.load("a." + name, name)
    found[name] = {"type": cmd.get_type(name), "extent": cmd.get_extent(name)}
    cmd.disable("all")
    cmd.enable(name)
    cmd.bg_color("white")
    cmd.png(name + ".png", 120, 90, ray=1)
print("FOUND " + json.dumps(found), flush=True)
"""


def corners_of(path):
    """Lowest and highest coordinates of the vertices of an OFF file."""
    rows = [line.split() for line in path.read_text(encoding="ascii").splitlines() if not line.startswith("#")]
    points = [tuple(map(float, row)) for row in rows[2:2 + int(rows[1][0])]]
    return [[pick(column) for column in zip(*points)] for pick in (min, max)]


class PyMol(foreign.ForeignTest):
    OPTIONS = ("-o", "a.off", "-o", "a.ply", "--ascii", "--spacing", "1", "--color", "patch")

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "look.py").write_text(SCRIPT, encoding="utf-8")
        result = subprocess.run(["pymol", "-cqr", "look.py"], cwd=cls.folder, env=ENVIRONMENT, check=True,
                                capture_output=True, encoding="utf-8")
        lines = [line for line in result.stdout.splitlines() if line.startswith("FOUND ")]
        assert lines, result.stdout + result.stderr
        cls.found = json.loads(lines[0].removeprefix("FOUND "))

    def test_meshes_are_graphics_at_their_place(self):
        expected = corners_of(self.folder / "a.off")
        for name, factor in (("off", 1), ("ply", 100)):
            self.assertEqual(self.found[name]["type"], "object:cgo", name)
            for own, theirs in zip(expected, self.found[name]["extent"], strict=True):
                for a, b in zip(own, theirs, strict=True):
                    self.assertAlmostEqual(factor * a, b, delta=1e-3 * factor, msg=name)

    def test_they_are_drawn(self):
        for name in ("off", "ply"):
            self.assertGreater((self.folder / f"{name}.png").stat().st_size, 1000, name)


foreign.main(programs=("pymol",))

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""PyMOL loads our .dx, and its isosurface at 0 has our volume.

usage: pymol_volume_test.py PROGRAM SOURCE_DIR
"""
import subprocess
import sys

import foreign

SCRIPT = """
load a.dx, field
isosurface shape, field, 0.0
save a.obj, shape
"""


def read_obj(path):
    """Corners of the triangles and the normals there, each with three columns."""
    points, normals, corners = [], [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(x) for x in words[1:4]])
        elif words[:1] == ["vn"]:
            normals.append([float(x) for x in words[1:4]])
        elif words[:1] == ["f"]:
            corners += [word.split("/") for word in words[1:4]]
    return ([points[int(corner[0]) - 1] for corner in corners], [normals[int(corner[2]) - 1] for corner in corners])


def enclosed(points):
    """Å³ within triangles, three points each; below 0 where they are clockwise seen from outside."""
    volume = 0.0
    for i in range(0, len(points), 3):
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = points[i:i + 3]
        volume += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6
    return volume


class PymolVolumeTest(foreign.ForeignTest):
    OPTIONS = ("-o", "a.dx")

    def test_the_isosurface_at_zero_is_ours(self):
        (self.folder / "script.pml").write_text(SCRIPT)
        told = subprocess.run([sys.executable, "-m", "pymol", "-cq", "script.pml"], cwd=self.folder, check=True,
                              capture_output=True, encoding="utf-8").stdout
        self.assertTrue((self.folder / "a.obj").exists(), told)
        points, normals = read_obj(self.folder / "a.obj")
        volume = enclosed(points)
        deviation = abs(volume) / self.report["mesh"]["volume"] - 1
        print(f"{volume:.1f} Å³, {100 * deviation:+.3f} %")
        self.assertLess(abs(deviation), 0.005)
        grown = [[p + 0.01 * n for p, n in zip(*corner)] for corner in zip(points, normals)]
        gained = (abs(enclosed(grown)) - abs(volume)) / (0.01 * self.report["mesh"]["area"])
        self.assertAlmostEqual(gained, 1, delta=0.1)  # the normals point outwards


foreign.main(programs=["pymol"])

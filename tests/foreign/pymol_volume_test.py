#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""PyMOL loads our .dx, and its isosurface at 0 has our volume.

usage: pymol_volume_test.py PROGRAM SOURCE_DIR
"""
import subprocess

import foreign

SCRIPT = """
load a.dx, field
isosurface shape, field, 0.0
save a.obj, shape
"""


def enclosed(path):
    """Å³ within the triangles of an OBJ; below 0 where they are clockwise seen from outside."""
    points, volume = [], 0.0
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(x) for x in words[1:4]])
        elif words[:1] == ["f"]:
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (points[int(w.split("/")[0]) - 1] for w in words[1:4])
            volume += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6
    return volume


class PymolVolumeTest(foreign.ForeignTest):
    OPTIONS = ("-o", "a.dx", "-o", "a.ply")

    def test_the_isosurface_at_zero_has_our_volume(self):
        (self.folder / "script.pml").write_text(SCRIPT)
        told = subprocess.run(["pymol", "-cq", "script.pml"], cwd=self.folder, check=True, capture_output=True,
                              encoding="utf-8").stdout
        self.assertTrue((self.folder / "a.obj").exists(), told)
        volume = enclosed(self.folder / "a.obj")
        deviation = abs(volume) / self.report["mesh"]["volume"] - 1
        print(f"{volume:.1f} Å³, {100 * deviation:+.3f} %")
        self.assertLess(abs(deviation), 0.005)


foreign.main(programs=["pymol"])

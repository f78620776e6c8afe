#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Assimp, the importer of many 3D programs, reads our GLB, OBJ, PLY and STL files with our counts.

usage: assimp_test.py PROGRAM SOURCE_DIR
"""
import re
import subprocess

import foreign


def counts_in(path):
    """Meshes, vertices and faces, as `assimp info` tells them, and the box round the vertices."""
    text = subprocess.run(["assimp", "info", path], check=True, capture_output=True, encoding="utf-8").stdout
    counts = {name: int(re.search(rf"^{name}:\s+(\d+)", text, re.M)[1]) for name in ("Meshes", "Vertices", "Faces")}
    box = [[float(x) for x in re.search(rf"^{name} point\s+\(([^)]*)\)", text, re.M)[1].split()]
           for name in ("Minimum", "Maximum")]
    return counts, box


class Assimp(foreign.ForeignTest):
    OPTIONS = [word for suffix in ("glb", "obj", "ply", "stl") for word in ("-o", f"a.{suffix}")]

    def test_counts_are_ours(self):
        mesh = self.report["mesh"]
        boxes = []
        for suffix in ("glb", "obj", "ply"):
            counts, box = counts_in(self.folder / f"a.{suffix}")
            self.assertEqual(counts, {"Meshes": 1, "Vertices": mesh["vertices"], "Faces": mesh["triangles"]}, suffix)
            boxes.append(box)
        counts, box = counts_in(self.folder / "a.stl")  # whose triangles share no corners
        self.assertEqual((counts["Meshes"], counts["Faces"]), (1, mesh["triangles"]))
        for other in (*boxes[1:], box):
            for a, b in zip(sum(boxes[0], []), sum(other, []), strict=True):
                self.assertAlmostEqual(a, b, delta=1e-3)

    def test_an_open_part_is_read_too(self):
        report = self.meniscus("surface", foreign.UBIQUITIN, "--show", "//A/10-20", "-o", "part.glb", "-o", "part.ply")
        for name in ("part.glb", "part.ply"):
            counts, _ = counts_in(self.folder / name)
            self.assertEqual(counts["Faces"], report["mesh"]["shown"]["triangles"], name)


foreign.main(programs=("assimp",))

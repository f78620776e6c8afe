#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""meshio reads our PLY, OFF, STL and OBJ files: our counts, and the values of PLY. (It does not know VTP.)

usage: meshio_test.py PROGRAM SOURCE_DIR
"""
import foreign


class MeshIo(foreign.ForeignTest):
    OPTIONS = [word for suffix in ("ply", "off", "stl", "obj") for word in ("-o", f"a.{suffix}")]

    def test_counts_are_ours(self):
        import meshio

        for suffix in ("ply", "off", "stl", "obj"):
            mesh = meshio.read(self.folder / f"a.{suffix}")
            self.assertEqual(sum(len(block.data) for block in mesh.cells), self.report["mesh"]["triangles"], suffix)
            if suffix != "stl":
                self.assertEqual(len(mesh.points), self.report["mesh"]["vertices"], suffix)

    def test_values_of_ply_are_read(self):
        import meshio

        data = meshio.read(self.folder / "a.ply").point_data
        self.assertGreaterEqual(set(data), {"atom", "residue", "patch", "component", "area", "mean_curvature"})
        self.assertAlmostEqual(float(data["area"].sum(dtype=float)) / self.report["mesh"]["area"], 1, delta=1e-5)


foreign.main(modules=("meshio", "numpy"))

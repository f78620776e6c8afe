#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""OpenVDB reads our .vdb: a sparse level set, negative inside, in Å.

usage: openvdb_test.py PROGRAM SOURCE_DIR
"""
import subprocess

import foreign


def builds_write_vdb():
    result = subprocess.run([foreign.PROGRAM, "surface", "-", "-o", "/dev/null.vdb"], input=b"", check=False,
                            capture_output=True)
    return b"cannot write .vdb" not in result.stderr


class OpenvdbTest(foreign.ForeignTest):
    OPTIONS = ("-o", "a.vdb", "-o", "a.dx")

    @classmethod
    def setUpClass(cls):
        if not builds_write_vdb():
            raise foreign.unittest.SkipTest("skipped: this build has no OpenVDB")
        super().setUpClass()

    def test_vdb_print_shows_a_level_set(self):
        told = subprocess.run(["vdb_print", "-l", "-m", "a.vdb"], cwd=self.folder, check=True, capture_output=True,
                              encoding="utf-8").stdout
        print(told)
        for word in ("surface", "level set", "Meniscus", "inside negative", "0.5"):
            self.assertIn(word, told)

    def test_it_is_sparse(self):
        size = (self.folder / "a.vdb").stat().st_size
        nodes = int((self.folder / "a.dx").read_text().split("items ")[1].split()[0])
        self.assertLess(size, 2 * nodes)

    def test_values_are_those_of_the_dx_with_the_other_sign(self):
        try:
            import pyopenvdb as openvdb
        except ImportError:
            self.skipTest("skipped: needs pyopenvdb, which packages.txt lists")
        import numpy

        grids, _ = openvdb.readAll(str(self.folder / "a.vdb"))
        grid = grids[0]
        head, values = (self.folder / "a.dx").read_text().split("data follows\n")
        counts = [int(n) for n in head.split("gridpositions counts ")[1].split()[:3]]
        origin = [float(x) for x in head.split("origin ")[1].split()[:3]]
        expected = -numpy.array(values.split("attribute")[0].split(), dtype=numpy.float32).reshape(counts)
        found = numpy.zeros(counts, numpy.float32)
        grid.copyToArray(found)
        near = numpy.abs(expected) < 1.5
        self.assertTrue((found[near] == expected[near]).all())
        self.assertTrue((numpy.sign(found[~near]) == numpy.sign(expected[~near])).all())
        self.assertTrue(numpy.allclose(grid.transform.indexToWorld((0, 0, 0)), origin))
        self.assertEqual(grid.gridClass, openvdb.GridClass.LEVEL_SET)
        points, quads = grid.convertToQuads()
        triangles = numpy.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
        a, b, c = (points[triangles[:, i]].astype(float) for i in range(3))
        volume = abs(numpy.einsum("ij,ij->", a, numpy.cross(b, c)) / 6)
        self.assertLess(abs(volume / self.report["mesh"]["volume"] - 1), 0.01)


foreign.main(programs=["vdb_print"])

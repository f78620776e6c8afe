#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""mrcfile, the reader of the MRC format's keepers, finds nothing wrong with our files.

usage: mrcfile_test.py PROGRAM SOURCE_DIR
"""
import io

import foreign


class MrcfileTest(foreign.ForeignTest):
    def test_files_are_valid(self):
        import mrcfile

        for field in ("distance", "mask", "dielectric", "ions"):
            self.meniscus("surface", foreign.UBIQUITIN, "--method", "direct", "--spacing", "1", "--field", field,
                          "-o", "a.mrc")
            told = io.StringIO()
            self.assertTrue(mrcfile.validate(self.folder / "a.mrc", print_file=told), told.getvalue())

    def test_values_and_frame_are_ours(self):
        import mrcfile

        grid = "12,20,31,0.8,30.5,29,15.25"
        self.meniscus("surface", foreign.UBIQUITIN, "--method", "direct", "--grid", grid, "-o", "a.mrc")
        with mrcfile.open(self.folder / "a.mrc") as file:
            self.assertEqual(file.data.shape, (31, 20, 12))
            self.assertAlmostEqual(float(file.voxel_size.z), 0.8, places=5)
            for axis, origin in (("x", 30.5 - 0.8 * 5.5), ("y", 29 - 0.8 * 9.5), ("z", 15.25 - 0.8 * 15)):
                self.assertAlmostEqual(float(file.header.origin[axis]), origin, places=4)
            self.assertGreater(float(file.data.max()), 1.0)  # inside
            self.assertIn(b"inside positive", file.header.label[1])


foreign.main(modules=["mrcfile", "numpy"])

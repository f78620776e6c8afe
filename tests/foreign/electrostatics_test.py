#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The manual's way from PDB2PQR to APBS and back, followed literally, gives the right numbers.

usage: electrostatics_test.py PROGRAM SOURCE_DIR
"""
import math
import os
import shutil
import subprocess
import sys

import foreign

sys.path.append(str(foreign.SOURCE / "tests" / "docs"))

import markdown  # noqa: E402

PAGES = ("electrostatics.md", "values.md")


def correlation(a, b):
    mean_a, mean_b = sum(a) / len(a), sum(b) / len(b)
    covariance = sum((x - mean_a) * (y - mean_b) for x, y in zip(a, b))
    return covariance / math.sqrt(sum((x - mean_a)**2 for x in a) * sum((y - mean_b)**2 for y in b))


class ElectrostaticsTest(foreign.ForeignTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        shutil.copytree(foreign.SOURCE / "examples", cls.folder / "examples")
        (cls.folder / ".bin").mkdir()
        (cls.folder / ".bin" / "meniscus").symlink_to(foreign.PROGRAM)
        for page in PAGES:
            for block in markdown.read(foreign.SOURCE / "docs" / "howto" / page)[0]:
                if block.kind == "sh" and "apbs" in block.info:
                    cls.run_block(block)

    @classmethod
    def run_block(cls, block):
        path = f"{cls.folder / '.bin'}:{os.environ['PATH']}"
        result = subprocess.run(["bash", "-c", "set -eo pipefail\n" + block.text], cwd=cls.folder, check=False,
                                env={**os.environ, "PATH": path}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                encoding="utf-8", errors="replace")
        if result.returncode != 0 or "warning: " in result.stdout:
            raise AssertionError(f"{block.path}:{block.line}\n{result.stdout}")

    def test_waters_are_no_part_of_the_surface(self):
        subprocess.run(["pdb2pqr30", "--ff=AMBER", "examples/1ubq.pdb", "wet.pqr"], cwd=self.folder, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        dry = self.meniscus("measure", "1ubq.pqr")
        wet = self.meniscus("measure", "wet.pqr")
        dropped = self.meniscus("measure", "wet.pqr", "--no-waters")
        self.assertEqual((dry["input"]["atoms"], dry["input"]["warnings"]), (dropped["input"]["atoms"], []))
        self.assertIn("58 waters", wet["input"]["warnings"][0])
        self.assertEqual(dropped["input"]["warnings"], [])
        area = [report["exact"]["ses_area"] for report in (dry, wet, dropped)]
        print(f"area without waters {area[0]:.1f} Å², with them {100 * (area[1] / area[0] - 1):+.1f} %")
        self.assertGreater(area[1], 1.1 * area[0])
        # PDB2PQR turns hydrogens towards the waters.
        self.assertLess(abs(area[2] / area[0] - 1), 0.01)

    def test_the_potential_with_our_maps_is_that_of_apbs(self):
        theirs, mapped = self.potential("1ubq.pqr-PE0.dx"), self.potential("mapped-PE0.dx")
        same = correlation(theirs, mapped)
        print(f"correlation of the potentials {same:.6f}")
        self.assertGreater(same, 0.99)

    def test_the_picture_is_there(self):
        self.assertGreater((self.folder / "phi.png").stat().st_size, 1000)
        self.assertGreater((self.folder / "phi.html").stat().st_size, 1000)

    def potential(self, name):
        values = (self.folder / name).read_text().split("data follows")[1].split("attribute")[0]
        return [float(value) for value in values.split()]


foreign.main(programs=["pdb2pqr30", "apbs"])

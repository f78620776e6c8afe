# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Distances between surfaces."""
import copy
import json
import os
import pathlib
import pickle
import re
import subprocess
import tempfile
import unittest

import numpy as np

import meniscus


def ball(radius):
    return meniscus.Structure.from_arrays([[1, 2, 3]], radius)


def probe_of(vtp):
    """What is written of the probe into a file of VTK."""
    return float(re.search(rb'Name="probe"[^>]*>([^<]*)<', vtp)[1])


class Compare(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="meniscus-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_surfaces_structures_and_files_in_any_pair(self):
        surface = meniscus.surface(ball(3.4), method="direct")
        surface.save(self.folder / "a.off")
        for a in (surface, self.folder / "a.off", str(self.folder / "a.off"), ball(3.4)):
            found = meniscus.compare(a, ball(3.0))
            self.assertAlmostEqual(found.a_to_b.mean, 0.4, delta=0.02)
            self.assertAlmostEqual(found.b_to_a.signed_mean, -0.4, delta=0.02)
            self.assertEqual(found.distances.shape, (len(found.vertices),))
            self.assertEqual(found.triangles.shape[1], 3)
            self.assertTrue(found.a.closed)
        self.assertLess(meniscus.compare(surface, surface).hausdorff, 1e-9)
        self.assertIn("Hausdorff", repr(found))

    def test_exact_surfaces_of_any_kind(self):
        traced = meniscus.ExactSurface(ball(2.0), surface="sas", probe=1.0)
        found = meniscus.compare(traced, meniscus.ExactSurface(ball(2.0)))
        self.assertAlmostEqual(found.a.area, traced.measures.ses_area, delta=1e-9)
        self.assertAlmostEqual(found.a_to_b.mean, 1.0, delta=1e-9)
        self.assertAlmostEqual(found.b_to_a.signed_mean, -1.0, delta=1e-9)
        self.assertEqual(meniscus.compare(meniscus.ExactSurface(ball(2.0)), ball(3.0)).a_to_b,
                         meniscus.compare(ball(2.0), ball(3.0)).a_to_b)
        with self.assertRaisesRegex(TypeError, "waters is an argument of read"):
            meniscus.compare(traced, traced, waters=True)

    def test_the_probe_that_is_written_is_that_of_the_surface(self):
        meniscus.compare(meniscus.surface(ball(2.0), probe=1.0), ball(2.0)).save(self.folder / "a.vtp")
        meniscus.surface(ball(2.0), probe=1.0).save(self.folder / "b.vtp")
        probes = [probe_of((self.folder / name).read_bytes()) for name in ("a.vtp", "b.vtp")]
        self.assertEqual(probes, [1.0, 1.0])

    def test_the_numbers_and_bytes_are_those_of_the_command_line(self):
        (self.folder / "b.xyzr").write_text("0 0 0 2\n1.5 0 0 1.5\n")
        surface = meniscus.surface(self.read(), spacing=0.4)
        surface.save(self.folder / "a.off")
        found = meniscus.compare(self.folder / "a.off", self.read())
        found.save(self.folder / "python.ply")
        result = subprocess.run([os.environ["MENISCUS_PROGRAM"], "compare", "a.off", "b.xyzr", "-o", "program.ply",
                                 "--report", "-"], cwd=self.folder, capture_output=True, check=True)
        report = json.loads(result.stdout)
        self.assertEqual(report["a_to_b"]["mean"], found.a_to_b.mean)
        self.assertEqual(report["b_to_a"]["signed_mean"], found.b_to_a.signed_mean)
        self.assertEqual((self.folder / "python.ply").read_bytes(), (self.folder / "program.ply").read_bytes())

    def test_what_was_found_can_be_pickled_and_copied(self):
        protein = ball(2.0)
        found = meniscus.compare(meniscus.surface(protein), protein)
        for again in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found), copy.copy(found)):
            self.assertEqual((again.a, again.b, again.a_to_b, again.b_to_a), (found.a, found.b, found.a_to_b, found.b_to_a))
            for name in ("vertices", "triangles", "distances"):
                self.assertEqual(getattr(again, name).tobytes(), getattr(found, name).tobytes())
                self.assertFalse(getattr(again, name).flags.writeable)
            again.save(self.folder / "again.ply")
            found.save(self.folder / "found.ply")
            self.assertEqual((self.folder / "again.ply").read_bytes(), (self.folder / "found.ply").read_bytes())

    def read(self):
        return meniscus.read(self.folder / "b.xyzr")

    def test_what_cannot_be_compared(self):
        (self.folder / "bad.off").write_text("OFF\n1 0 0\n0 0 x\n")
        with self.assertRaisesRegex(meniscus.InputError, "bad.off:3:5: "):
            meniscus.compare(self.folder / "bad.off", ball(1.0))
        with self.assertRaises(FileNotFoundError):
            meniscus.compare("none.off", ball(1.0))
        with self.assertRaisesRegex(meniscus.UsageError, "cannot hold distances"):
            meniscus.compare(ball(1.0), ball(1.0)).save(self.folder / "c.stl")
        with self.assertRaises(TypeError):
            meniscus.compare(np.zeros((3, 3)), ball(1.0))
        for options in ({"points": 0}, {"points": float("nan")}, {"spacing": -1}, {"probe": -1}, {"threads": -1}):
            with self.assertRaises(ValueError):
                meniscus.compare(ball(1.0), ball(1.0), **options)


if __name__ == "__main__":
    unittest.main()

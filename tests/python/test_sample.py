# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Points spread over a surface."""
import unittest

import numpy as np
from support import CENTRES, RADII, UBIQUITIN, read

import meniscus


def nearest(points):
    squared = ((points[:, None, :] - points[None, :, :]) ** 2).sum(axis=2)
    np.fill_diagonal(squared, np.inf)
    return np.sqrt(squared.min(axis=1))


class Sampling(unittest.TestCase):
    def test_points_are_as_many_as_asked_for_and_know_the_surface(self):
        surface = meniscus.surface(read(UBIQUITIN))
        points = surface.sample(density=0.5)
        self.assertEqual(len(points), round(0.5 * surface.mesh["area"]))
        self.assertEqual((points.points.shape, points.normals.shape), ((len(points), 3), (len(points), 3)))
        for name in ("atom", "residue", "patch", "component", "area", "mean_curvature", "gaussian_curvature",
                     "shape_index"):
            self.assertEqual(getattr(points, name).shape, (len(points),), name)
        self.assertLess(np.abs(surface.level_set(points.points)).max(), 1e-6)
        xyz = surface.structure.xyz[points.atom]
        gaps = np.linalg.norm(points.points - xyz, axis=1) - surface.structure.radii[points.atom]
        self.assertLess(np.abs(gaps[points.patch == 0]).max(), 0.2)

    def test_points_keep_their_distance(self):
        ball = meniscus.surface([[0, 0, 0]], [6.0])
        distances = nearest(ball.sample(density=1.0).points)
        packed = np.sqrt(2 / np.sqrt(3))
        self.assertGreater(distances.min(), 0.6 * packed)
        self.assertGreater(distances.mean(), 0.75 * packed)

    def test_a_seed_decides(self):
        surface = meniscus.surface(CENTRES, RADII)
        self.assertTrue((surface.sample(2.0, 7).points == surface.sample(2.0, 7).points).all())
        self.assertTrue((surface.sample(2.0).points == surface.sample(2.0, seed=0).points).all())
        self.assertFalse((surface.sample(2.0, 7).points == surface.sample(2.0, 8).points).all())
        self.assertEqual(len(surface.sample(2.0, seed=2**64 - 1)), len(surface.sample(2.0)))

    def test_curvatures_are_those_of_the_surface(self):
        points = meniscus.surface(CENTRES, RADII, method="direct").sample(5.0)
        reentrant = points.patch == 2
        self.assertTrue(reentrant.any())
        self.assertTrue(np.allclose(points.mean_curvature[reentrant], -1 / 1.4, atol=1e-6))
        self.assertTrue(np.allclose(points.shape_index[reentrant], -1))

    def test_what_makes_no_sense_is_refused(self):
        surface = meniscus.surface(CENTRES, RADII)
        for density in (0, -1, float("nan"), float("inf")):
            with self.assertRaisesRegex(ValueError, "density"):
                surface.sample(density)
        with self.assertRaises(meniscus.LimitError):
            surface.sample(1e9)
        with self.assertRaisesRegex(ValueError, "seed"):
            surface.sample(seed=-1)
        with self.assertRaises(TypeError):
            surface.sample(seed=0.5)


if __name__ == "__main__":
    unittest.main()

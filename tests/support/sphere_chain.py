# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Inputs for tests: chains of spheres."""
import math
import random


def sphere_chain(count, seed):
    """A chain of spheres, different for every seed, as xyzr."""
    numbers = random.Random(seed)
    x = y = z = 0.0
    lines = []
    for _ in range(count):
        lines.append(f"{x:.3f} {y:.3f} {z:.3f} {numbers.uniform(1.2, 1.9):.2f}")
        a, b = numbers.uniform(0, 6.28), numbers.uniform(0, 3.14)
        x, y, z = x + 1.5 * math.cos(a) * math.sin(b), y + 1.5 * math.sin(a) * math.sin(b), z + 1.5 * math.cos(b)
    return "\n".join(lines) + "\n"

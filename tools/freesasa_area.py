# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""FreeSASA's solvent-accessible area of spheres that we kept, by Lee and Richards' slices.

The spheres travel as a PDB file whose occupancy column holds the radii, which has room for three decimals.
"""
import json
import math

PROBE = 1.4  # Å, FreeSASA's and ours


def read_spheres(path):
    """The spheres of a file .xyzr, rounded as they travel, and whether that changed any of them."""
    spheres, changed = [], False
    for line in path.read_text(encoding="ascii").splitlines():
        exact = [float(word) for word in line.split()[:4]]
        spheres.append([round(number, 3) for number in exact])
        changed = changed or any(abs(a - b) > 1e-9 for a, b in zip(exact, spheres[-1]))
    return spheres, changed


def write_xyzr(path, spheres):
    path.write_text("".join(f"{x:.3f} {y:.3f} {z:.3f} {r:.3f}\n" for x, y, z, r in spheres), encoding="ascii")


def without_coincident(spheres):
    """One sphere per place, the largest, which is the same union: FreeSASA's area is not a number where there are two."""
    largest = {}
    for *centre, radius in spheres:
        largest[tuple(centre)] = max(radius, largest.get(tuple(centre), 0.0))
    return [[*centre, radius] for centre, radius in largest.items()]


def write_pdb(path, spheres):
    path.write_text("".join(
        f"ATOM  {i % 100000:5}  CA  GLY A{i % 10000:4}    {x:8.3f}{y:8.3f}{z:8.3f}{r:6.3f}  0.00           C\n"
        for i, (x, y, z, r) in enumerate(spheres)), encoding="ascii")


def command(pdb, slices):
    return ["freesasa", "--lee-richards", f"--resolution={slices}", "--n-threads=1", "--radius-from-occupancy",
            "--no-warnings", "--format=json", "--depth=structure", pdb]


def area_of(output):
    """Å², out of what the command printed."""
    return json.loads(output)["results"][0]["structure"][0]["area"]["total"]


def slices_for(count, most):
    """Fewer where there are many spheres, whose errors cancel: time grows no more from 20,000 to 100,000 spheres."""
    return max(most // 5, min(most, 20_000 * most // max(count, 1)))


def slicing_error(spheres, slices):
    """The error to expect of the area of so many slices per sphere, Å²: that of independent errors per atom."""
    # Slices cut every sphere at places that its neighbours know nothing of, and lengths of arcs begin as square roots:
    # docs/design/sweep.md, where it is measured.
    squares = sum((4 * math.pi * (r + PROBE) ** 2) ** 2 for *_, r in spheres)
    return math.sqrt(squares) * slices ** -1.5

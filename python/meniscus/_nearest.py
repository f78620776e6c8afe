# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What of an exact surface is nearest to points."""
from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt

from ._arrays import Floats, Indices


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Nearest:
    """What of an exact surface is nearest to each of m points; made by :meth:`ExactSurface.nearest`. Lengths in Å.

    The nearest point of the surface itself is ``points - distance[:, None] * normal`` where the distance is exact: see
    :meth:`ExactSurface.signed_distance`. The arrays are read-only.

    Parameters
    ----------
    distance : ndarray of float64, shape (m,)
        Signed distance from the surface, Å, negative inside.
    atom : ndarray of int32, shape (m,)
        Index of the nearest of the atoms that the patch touches.
    patch : ndarray of uint8, shape (m,)
        0 contact, 1 toroidal, 2 reentrant.
    normal : ndarray of float64, shape (m, 3)
        Gradient of the distance, a unit vector that points out of the molecule; 0 where undefined, as at the centre of the
        atom whose patch is nearest.
    mean_curvature : ndarray of float64, shape (m,)
        Å⁻¹, positive on a sphere: of the parallel surface through the point, which for a point on the surface is the
        surface; may be infinite at cusps.
    gaussian_curvature : ndarray of float64, shape (m,)
        Å⁻²: of the same surface.
    foot : ndarray of float64, shape (m, 3)
        Centre of the probe where it touches the surface there, Å, a point of the solvent-accessible surface; for sas and
        vdw a point of the surface itself.
    """

    distance: Floats
    atom: Indices
    patch: npt.NDArray[np.uint8]
    normal: Floats
    mean_curvature: Floats
    gaussian_curvature: Floats
    foot: Floats

    def __len__(self) -> int:
        return len(self.distance)

    def __repr__(self) -> str:
        return f"<meniscus.Nearest: {len(self)} points>"

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Closed pieces of an exact surface."""
from __future__ import annotations

import dataclasses
from typing import Literal

from ._arrays import Indices

Point = tuple[float, float, float]


@dataclasses.dataclass(frozen=True)
class Component:
    """A connected closed piece of the solvent-excluded surface; made by :func:`measure`.

    Parameters
    ----------
    kind : {"outer", "cavity"}
        Whether it bounds the molecule from outside or solvent inside.
    ses_area : float
        Å².
    contact_area : float
        Å², of contact patches.
    toroidal_area : float
        Å², of toroidal patches.
    reentrant_area : float
        Å², of reentrant patches.
    ses_volume : float
        Å³ enclosed, positive.
    sas_area : float
        Å², of the solvent-accessible pieces that belong to it.
    sas_volume : float
        Å³ that those pieces enclose, positive.
    sas_components : int
        Their number.
    centre : tuple of float
        Centroid of its surface, Å.
    inside_of : int or None
        Index of the component that directly encloses it.
    atoms : ndarray of int32, shape (k,)
        Indices of the atoms that touch it.
    inscribed_centre : tuple of float
        Centre of the largest sphere that fits into a cavity, Å.
    inscribed_radius : float
        Its radius, Å; 0 for outer pieces.
    errors : dict of str to float
        Absolute error estimates of the areas and volumes by name.
    """

    kind: Literal["outer", "cavity"]
    ses_area: float
    contact_area: float
    toroidal_area: float
    reentrant_area: float
    ses_volume: float
    sas_area: float
    sas_volume: float
    sas_components: int
    centre: Point
    inside_of: int | None
    atoms: Indices = dataclasses.field(repr=False, compare=False)
    inscribed_centre: Point
    inscribed_radius: float
    errors: dict[str, float] = dataclasses.field(repr=False, compare=False)

    @property
    def area(self) -> float:
        """Å²: ``ses_area``."""
        return self.ses_area

    @property
    def volume(self) -> float:
        """Å³: ``ses_volume``."""
        return self.ses_volume

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Tunnels and pores: the widest ways through a molecule."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

import numpy as np

from . import _core, _options
from ._arrays import ArrayLike, Floats, Indices, as_array, positions
from ._atoms import Atoms, Radii, as_structure, read_for_pockets
from ._component import Point
from ._errors import UsageError
from ._reading import Reading, ReadOptions

if TYPE_CHECKING:
    from typing_extensions import Unpack

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


@dataclasses.dataclass(frozen=True)
class _Way:
    bottleneck_radius: float
    bottleneck: Point
    bottleneck_atoms: list[str]
    bottleneck_at_end: bool
    certified_radius: float
    length: float
    curvature: float
    atoms: Indices = dataclasses.field(repr=False, compare=False)
    points: Floats = dataclasses.field(repr=False, compare=False)
    radii: Floats = dataclasses.field(repr=False, compare=False)
    distances: Floats = dataclasses.field(repr=False, compare=False)


@dataclasses.dataclass(frozen=True)
class _Place:
    pocket: int | None
    rank: int


@dataclasses.dataclass(frozen=True)
class Pore(_Way):
    """The widest way through a molecule; made by :func:`pore`.

    Parameters
    ----------
    bottleneck_radius : float
        Of the largest ball that passes, Å.
    bottleneck : tuple of float
        The narrowest place, Å.
    bottleneck_atoms : list of str
        The three atoms that the ball touches there, as "A:SER 195 OG".
    bottleneck_at_end : bool
        Whether the narrowest place is an end of the way instead, so that the atoms are only the nearest ones.
    certified_radius : float
        Least clearance of the whole polyline, segments included, Å: proves that a ball of this radius passes.
    length : float
        Å.
    curvature : float
        Length over the straight distance of the ends.
    atoms : ndarray of int32, shape (k,)
        Indices of ``bottleneck_atoms``.
    points : ndarray of float64, shape (n, 3)
        The polyline, from its start, Å.
    radii : ndarray of float64, shape (n,)
        Clearances of the points, Å.
    distances : ndarray of float64, shape (n,)
        From the start, along the way, Å.
    """


# The members of the last base come first.
@dataclasses.dataclass(frozen=True)
class Tunnel(_Way, _Place):
    """A way from a pocket or a point to the bulk; made by :meth:`Pockets.tunnels`.

    Parameters
    ----------
    pocket : int or None
        Rank of the pocket where it begins; None for a start that was given.
    rank : int
        Place among the tunnels of its start, from 1: the widest first.
    bottleneck_radius : float
        Of the largest ball that passes, Å.
    bottleneck : tuple of float
        The narrowest place, Å.
    bottleneck_atoms : list of str
        The three atoms that the ball touches there, as "A:SER 195 OG".
    bottleneck_at_end : bool
        Whether the narrowest place is an end of the way instead, so that the atoms are only the nearest ones.
    certified_radius : float
        Least clearance of the whole polyline, segments included, Å: proves that a ball of this radius passes.
    length : float
        Å.
    curvature : float
        Length over the straight distance of the ends.
    atoms : ndarray of int32, shape (k,)
        Indices of ``bottleneck_atoms``.
    points : ndarray of float64, shape (n, 3)
        The polyline, from its start, Å.
    radii : ndarray of float64, shape (n,)
        Clearances of the points, Å.
    distances : ndarray of float64, shape (n,)
        From the start, along the way, Å.
    """


def _way_of(along: str | ArrayLike) -> Floats:
    if isinstance(along, str):
        return np.array([_AXES[_options.one_of("along", along, _AXES)]])
    array = as_array("along", along)
    way = positions("along", array.reshape(1, 3) if array.shape == (3,) else array)
    if len(way) not in (1, 2) or (len(way) == 2 and (way[0] == way[1]).all()):
        raise UsageError("along: must be x, y or z, a direction of shape (3,), or two different points of shape (2, 3)")
    return way


def pore(atoms: Atoms, along: str | ArrayLike, radii: Radii | None = None, *, threads: int = 0,
         reading: ReadOptions | None = None, **keywords: Unpack[Reading]) -> Pore | None:
    """The widest way from one side of a molecule to the other, as ``meniscus pockets --pore`` finds it.

    Parameters
    ----------
    atoms : Structure, str, os.PathLike, file object, object of another package, or array_like, shape (n, 3)
        As for :func:`pockets`, and read as there.
    along : {"x", "y", "z"} or array_like, shape (3,) or (2, 3)
        An axis or a direction, through the middle of the atoms; or two points, Å.
    radii : array_like, shape (n,), or str, optional
        As for :func:`pockets`, Å.
    threads : int, default 0
        0: all cores; results do not depend on it.
    reading : ReadOptions, optional
        With a file or an object of another package: what to keep, and which radii.
    **keywords
        The members of ReadOptions.

    Returns
    -------
    Pore or None
        None where no ball of 0.5 Å passes.

    Raises
    ------
    UsageError
        For invalid arrays or options.
    """
    way = _way_of(along)
    sizes, to_read = read_for_pockets(atoms, radii, reading, dict(keywords))
    structure = as_structure(atoms, sizes, to_read, reading)
    found = _core.pore(structure._core, way, _options.count("threads", threads))
    return None if found is None else Pore(**found)

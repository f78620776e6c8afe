# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Pockets over several models of one molecule."""
from __future__ import annotations

import dataclasses
from collections.abc import Iterable

from . import _core
from ._errors import UsageError
from ._pockets import Pockets
from ._tunnels import Tunnel


@dataclasses.dataclass(frozen=True)
class Spread:
    """A number over models.

    Parameters
    ----------
    mean : float
        Mean.
    deviation : float
        Standard deviation of the sample; 0 for less than two values.
    values : int
        Number of models that have a value.
    """

    mean: float
    deviation: float
    values: int


@dataclasses.dataclass(frozen=True)
class PocketTrack:
    """A pocket as it comes and goes over models; made by :func:`follow_pockets`.

    Parameters
    ----------
    number : int
        Its number, from 1, in the order in which tracks appear.
    models : int
        Number of models in which it was found.
    open : int
        Number of those in which it is not a closed cavity.
    best_rank : int
        Its best rank in any model.
    score : Spread
        Over the models in which it was found, as all that follow.
    volume : Spread
        Å³.
    depth : Spread
        Å.
    mouth_radius : Spread
        Of its largest mouth or opening, Å; over the models in which it is open.
    ways : int
        Number of models in which it has a tunnel, of those that were given.
    bottleneck : Spread
        Bottleneck of its widest tunnel over these, Å.
    residues : list of str
        Residues that line it with more than 1 Å² of an atom on average, as "A:SER 195".
    """

    number: int
    models: int
    open: int
    best_rank: int
    score: Spread
    volume: Spread
    depth: Spread
    mouth_radius: Spread
    ways: int
    bottleneck: Spread
    residues: list[str] = dataclasses.field(repr=False)


@dataclasses.dataclass(frozen=True)
class PocketTracks:
    """The pockets of several models, told which are the same; made by :func:`follow_pockets`.

    Parameters
    ----------
    tracks : list of PocketTrack
        Those that look most like the places of ligands first, by the sum of their scores over the models.
    of_pockets : list of list of int
        For each model, in the order given, the number of the track of each of its pockets.
    """

    tracks: list[PocketTrack]
    of_pockets: list[list[int]]


_SPREADS = ("score", "volume", "depth", "mouth_radius", "bottleneck")


def _track_of(block: dict[str, object]) -> PocketTrack:
    spreads = {name: Spread(*block[name]) for name in _SPREADS}  # type: ignore[misc]
    return PocketTrack(**{**block, **spreads})  # type: ignore[arg-type]


def _bottlenecks(pockets: Pockets, tunnels: Iterable[Tunnel]) -> list[float]:
    """For each pocket that of its widest tunnel; 0 for none."""
    widest = [0.0] * len(pockets)
    for tunnel in tunnels:
        if tunnel.pocket is not None:
            if tunnel.pocket > len(widest):
                raise UsageError(f"tunnels: one begins in pocket {tunnel.pocket}, but the model has {len(widest)}")
            widest[tunnel.pocket - 1] = max(widest[tunnel.pocket - 1], tunnel.bottleneck_radius)
    return widest


def follow_pockets(models: Iterable[Pockets], tunnels: Iterable[Iterable[Tunnel]] | None = None) -> PocketTracks:
    """Tells which pockets of several models are the same, as ``meniscus pockets --model all`` does.

    Two pockets are alike by the area of wall that they share over the area that either has; a pocket joins the track
    whose mean wall it is most like, at least by a quarter. Atoms of different models are the same if their chains,
    residues and names are, and without names if their indices are.

    Parameters
    ----------
    models : iterable of Pockets
        The pockets of each model or frame, in order.
    tunnels : iterable of iterable of Tunnel, optional
        For each model what :meth:`Pockets.tunnels` found, for the bottlenecks.

    Returns
    -------
    PocketTracks

    Raises
    ------
    UsageError
        For tunnels that do not match the models.

    Examples
    --------
    >>> frames = [meniscus.pockets("1ubq.pdb", spacing=h) for h in (1.0, 0.9)]
    >>> followed = meniscus.follow_pockets(frames)
    >>> followed.tracks[0].models, followed.tracks[0].number == followed.of_pockets[0][0]
    (2, True)
    """
    found = list(models)
    for item in found:
        if not isinstance(item, Pockets):
            raise TypeError(f"models: must be Pockets, not {type(item).__name__}")
    ways: list[Iterable[Tunnel]] = [()] * len(found) if tunnels is None else list(tunnels)
    if len(ways) != len(found):
        raise UsageError(f"tunnels: of {len(ways)} models, but there are pockets of {len(found)}")
    blocks, of_pockets = _core.follow_pockets([(item._core, item.structure._core, _bottlenecks(item, list_of))
                                               for item, list_of in zip(found, ways)])
    return PocketTracks([_track_of(block) for block in blocks], of_pockets)

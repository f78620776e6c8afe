# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The functions that make everything in one call."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core, _options
from ._arrays import ArrayLike, Floats
from ._atoms import Atoms, Radii, as_structure
from ._errors import UsageError
from ._exact import ExactSurface, meshing_of
from ._interfaces import Between, Pairs, pairs_of
from ._keywords import MESHING_DEFAULTS, SURFACE_DEFAULTS, Meshing, Method, SurfaceKind, SurfaceOptions
from ._measures import Measures, checked
from ._meshing import given, with_keywords, with_run
from ._nouns import NOT_GIVEN, RUN_DEFAULTS, Progress, RunOptions
from ._reading import Reading, ReadOptions
from ._structure import Structure
from ._surface import Surface

if TYPE_CHECKING:
    from typing_extensions import Unpack


class SurfaceKeywords(Meshing, Reading, total=False):
    """What :func:`surface` takes beside the arguments that it names."""


@with_keywords({"threads": 0}, others="keywords")
def measure(
    atoms: Atoms,
    radii: Radii | None = None,
    probe: float = 1.4,
    *,
    between: Between = None,
    cavities: bool = True,
    depth: bool = False,
    threads: int = NOT_GIVEN,
    reading: ReadOptions | None = None,
    run: RunOptions | None = None,
    **keywords: Unpack[Reading],
) -> Measures:
    """Exact areas and volumes of the SAS and SES with error estimates, shares of atoms, components and cavities.

    Takes about 25 µs per atom; other Python threads keep running. If two evaluations do not agree, there is a
    :class:`CheckWarning`, and ``Measures.disputed`` lists the patches.

    Parameters
    ----------
    atoms : Structure, str, os.PathLike, file object, object of another package, or array_like, shape (n, 3)
        A structure, or what :func:`read` and the functions ``from_...`` make one of; or centres, Å.
    radii : array_like, shape (n,), or str, optional
        Å; required with centres. With a file or an object of another package, the name of a radius set.
    probe : float, default 1.4
        Probe radius, Å; 0 gives the van der Waals surface.
    between : str or pair or sequence of pairs, optional
        Interfaces, too: ("A", "B") or "A:B", ("A,C", "B") or (["A", "C"], "B"), a list of such pairs, or "all" for every
        pair of chains that touch. A ligand is named in parentheses, ("A", "(HEM)"), or "B(HEM)" for that of chain B; it
        must have been kept: read(..., hetero="ligands").
    cavities : bool, default True
        Also find which component encloses which, and inscribed spheres.
    depth : bool, default False
        Also measure the depth of every atom.
    threads : int, default 0
        0: all cores; results do not depend on it.
    reading : ReadOptions, optional
        With a file or an object of another package: what to keep, and which radii.
    run : RunOptions, optional
        Threads.
    **keywords
        The members of ReadOptions, waters=True, chains="A" ..., which replace those of ``reading``; and frame=N for
        trajectories.

    Returns
    -------
    Measures

    Raises
    ------
    UsageError
        For invalid arrays or options. A ValueError.
    InputError, OSError
        For a file that cannot be read.

    Examples
    --------
    >>> ball = meniscus.measure([[0, 0, 0]], [2.0], probe=1.0)
    >>> numpy.allclose([ball.ses_area, ball.sas_area], [16 * numpy.pi, 36 * numpy.pi])
    True
    >>> round(meniscus.measure("1ubq.pdb").ses_area, 1)
    3892.2
    >>> two = meniscus.Structure.from_arrays([[0, 0, 0], [3, 0, 0]], 1.7, chain=["A", "B"])
    >>> round(meniscus.measure(two, between=("A", "B")).interfaces[0].buried_sas, 1)
    62.3
    """
    structure = as_structure(atoms, radii, keywords, reading)
    options = {"probe": _options.number("probe", probe), "cavities": _options.flag("cavities", cavities),
               "depth": _options.flag("depth", depth), "threads": with_run(run, threads=threads).threads}
    pairs = pairs_of(between)
    core = _core.measure(structure._core, options)
    found = None if between is None else _interfaces(structure, pairs, options)
    asked = {"surface": "ses", "probe": core.probe, "threads": options["threads"]}
    return checked(Measures(core, structure, asked, found))


def _interfaces(structure: Structure, pairs: Pairs, options: dict[str, Any]) -> _core.Interfaces:
    try:
        return _core.measure_interfaces(structure._core, pairs, options)
    except UsageError as error:
        raise UsageError(f"between: {error}") from None


@with_keywords({**SURFACE_DEFAULTS, **RUN_DEFAULTS}, others="keywords")
def surface(
    atoms: Atoms,
    radii: Radii | None = None,
    probe: float = NOT_GIVEN,
    spacing: float | None = NOT_GIVEN,
    method: Method = NOT_GIVEN,
    *,
    surface: SurfaceKind = NOT_GIVEN,
    options: SurfaceOptions | None = None,
    reading: ReadOptions | None = None,
    run: RunOptions | None = None,
    threads: int = NOT_GIVEN,
    memory: int | str | None = NOT_GIVEN,
    progress: Progress = NOT_GIVEN,
    **keywords: Unpack[SurfaceKeywords],
) -> Surface:
    """The solvent-excluded surface of atoms: an :class:`ExactSurface` of them, meshed.

    What decides the result is in ``options``, what is kept of a file in ``reading``, and what the computation may use in
    ``run``. For convenience, every member of the three is a keyword, too; all that is given as a keyword replaces what
    the three say. A result that fails its own checks comes with a :class:`CheckWarning`. Memory grows with area /
    spacing². Other Python threads keep running.

    Parameters
    ----------
    atoms : Structure, str, os.PathLike, file object, object of another package, or array_like, shape (n, 3)
        A structure, or what :func:`read` and the functions ``from_...`` make one of; or centres, Å.
    radii : array_like, shape (n,), or str, optional
        Å; required with centres. With a file or an object of another package, the name of a radius set.
    probe : float, default 1.4
        Probe radius, Å; 0 gives the van der Waals surface.
    spacing : float, optional
        Grid spacing, Å; by default 0.5, and with edge or vertex_density half or a quarter of that for small surfaces whose
        area would otherwise be off by more than 0.5 %.
    method : {"flow", "direct", "gaussian"}, default "flow"
        flow (smooth level set), direct (exact distance, sharp ridges) or gaussian (only the start of the flow).
    surface : {"ses", "sas", "vdw"}, default "ses"
        Solvent-excluded, solvent-accessible or van der Waals (the same as probe 0).
    options : SurfaceOptions, optional
        Which surface, and how it is meshed.
    reading : ReadOptions, optional
        With a file or an object of another package: what to keep, and which radii.
    run : RunOptions, optional
        Threads, memory, progress.
    threads : int, default 0
        0: all cores; results do not depend on it.
    memory : int or str, optional
        "4G", "500M" or a number of MB: refuse what would need more.
    progress : callable, optional
        Called with the stage's name and the fraction of it that is done; see :class:`RunOptions`.
    **keywords
        The other members of SurfaceOptions and ReadOptions: edge=1.0, components="outer", waters=True ...; and frame=N for
        trajectories.

    Returns
    -------
    Surface

    Raises
    ------
    UsageError
        For invalid arrays or options. A ValueError.
    InputError, OSError
        For a file that cannot be read.
    LimitError
        For a surface that would not fit into memory. A ValueError and MemoryError.

    Examples
    --------
    >>> ball = meniscus.surface([[0, 0, 0]], [2.0], probe=1.4, spacing=0.25)
    >>> ball.vertices.dtype, ball.triangles.dtype, ball.patch.dtype
    (dtype('float64'), dtype('int32'), dtype('uint8'))
    >>> round(float(numpy.median(ball.mean_curvature)), 2)
    0.5
    """
    meshing = {name: value for name, value in keywords.items() if name in MESHING_DEFAULTS}
    to_read = {name: value for name, value in keywords.items() if name not in MESHING_DEFAULTS}
    structure = as_structure(atoms, radii, to_read, reading)
    named = given(probe=probe, surface=surface, spacing=spacing, method=method)
    asked = meshing_of(options, named, meshing)
    used = with_run(run, threads=threads, memory=memory, progress=progress)
    exact = ExactSurface(structure, probe=asked.probe, surface=asked.surface, threads=used.threads)
    return exact._meshed(asked, used)


def signed_distance(
    atoms: Atoms,
    radii: Radii | None = None,
    points: ArrayLike | None = None,
    probe: float = 1.4,
    threads: int = 0,
    *,
    reading: ReadOptions | None = None,
    **keywords: Unpack[Reading],
) -> Floats:
    """Signed distances from the exact solvent-excluded surface; negative inside.

    Exact inside and on the surface; outside, next to ridges, a lower bound with the correct zero set. Takes about
    0.1 µs per point for points as close together as those of a grid and 3 µs for isolated ones, plus the geometry of
    the atoms.

    Parameters
    ----------
    atoms : Structure, str, os.PathLike, file object, object of another package, or array_like, shape (n, 3)
        As for :func:`measure`.
    radii : array_like, shape (n,), or str, optional
        Å; required with centres. With a file or an object of another package, the name of a radius set.
    points : array_like, shape (m, 3)
        Å; anywhere; required.
    probe : float, default 1.4
        Probe radius, Å.
    threads : int, default 0
        0: all cores; results do not depend on it.
    reading : ReadOptions, optional
        With a file or an object of another package: what to keep, and which radii.
    **keywords
        The members of ReadOptions, which replace those of ``reading``; and frame=N for trajectories.

    Returns
    -------
    ndarray of float64, shape (m,)
        Å; an array of your own, which may be written to.

    Raises
    ------
    UsageError
        For invalid arrays or options. A ValueError.
    InputError, OSError
        For a file that cannot be read.

    Examples
    --------
    >>> meniscus.signed_distance([[0, 0, 0]], [2.0], [[0, 0, 5], [1, 0, 0]]).round(6).tolist()
    [3.0, -1.0]
    >>> bool(meniscus.signed_distance(meniscus.read("1ubq.pdb"), points=[[0, 0, 0]]) > 20)
    True
    """
    structure = as_structure(atoms, radii, keywords, reading)
    if points is None:
        raise TypeError("points: required, (m, 3) in Å")
    return ExactSurface(structure, probe=probe, threads=threads).signed_distance(points)

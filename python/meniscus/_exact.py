# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The exact surface of atoms, and what is made of it and held against it."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core, _options
from ._arrays import ArrayLike, Floats, positions
from ._atoms import Atoms, Radii, as_structure
from ._errors import CheckWarning, UsageError, warn
from ._keywords import MESHING_DEFAULTS, SURFACE_DEFAULTS, Meshing, Method, SurfaceKind, SurfaceOptions
from ._measures import Measures, checked
from ._meshing import given, with_keywords, with_run
from ._nearest import Nearest
from ._nouns import NOT_GIVEN, RUN_DEFAULTS, Progress, RunOptions, of_kind
from ._reading import Reading, ReadOptions
from ._structure import Structure
from ._surface import Surface

if TYPE_CHECKING:
    from typing_extensions import Unpack


class ExactSurface:
    """The surface of atoms, known analytically: exact measures, distances and curvatures, and meshes of it.

    Nothing is computed before it is asked for, and everything once: the geometry, which takes about 5 µs per atom, and
    the measures are kept, and meshes are made of the same geometry. A surface does not change, so several threads may
    use it; other Python threads keep running. What can only be found with the geometry, such as that there are no atoms,
    is a UsageError of the first method that needs it.

    Parameters
    ----------
    atoms : Structure, str, os.PathLike, file object, object of another package, or array_like, shape (n, 3)
        As for :func:`measure`.
    radii : array_like, shape (n,), or str, optional
        Å; required with centres. With a file or an object of another package, the name of a radius set.
    probe : float, default 1.4
        Probe radius, Å; 0 gives the van der Waals surface.
    surface : {"ses", "sas", "vdw"}, default "ses"
        Solvent-excluded, solvent-accessible (traced by the probe's centre) or van der Waals (of the atoms themselves).
    threads : int, default 0
        0: all cores; for all that is asked of this surface. Results do not depend on it.
    reading : ReadOptions, optional
        With a file or an object of another package: what to keep, and which radii.
    **keywords
        The members of ReadOptions, waters=True, chains="A" ..., which replace those of ``reading``; and frame=N for
        trajectories.

    Raises
    ------
    UsageError
        For invalid arrays or options. A ValueError.
    InputError, OSError
        For a file that cannot be read.

    Examples
    --------
    >>> exact = meniscus.ExactSurface("1ubq.pdb")
    >>> round(exact.measures.ses_area, 1), exact.signed_distance([[0, 0, 0]]).round(2).tolist()
    (3892.2, [27.11])
    >>> exact.mesh(spacing=1.0).exact is exact
    True
    """

    def __init__(
        self,
        atoms: Atoms,
        radii: Radii | None = None,
        probe: float = 1.4,
        *,
        surface: SurfaceKind = "ses",
        threads: int = 0,
        reading: ReadOptions | None = None,
        **keywords: Unpack[Reading],
    ) -> None:
        self._structure = as_structure(atoms, radii, keywords, reading)
        self._probe = _options.not_negative("probe", probe)
        self._kind: SurfaceKind = surface
        _options.word("surface", surface)
        self._threads = _options.count("threads", threads)
        self._measures: Measures | None = None
        self._core = _core.exact_surface(self._structure._core, self._exact_options())

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_core"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._core = _core.exact_surface(self._structure._core, self._exact_options())

    def __copy__(self) -> ExactSurface:
        return self

    def __repr__(self) -> str:
        return f"<meniscus.ExactSurface: {self.kind} of {len(self.structure)} atoms, probe {self.probe:g} Å>"

    def _exact_options(self) -> dict[str, Any]:
        """As the extension takes them, and as those of a mesh."""
        return {"surface": self._kind, "probe": 0.0 if self._kind == "vdw" else self._probe}

    @property
    def structure(self) -> Structure:
        """The atoms."""
        return self._structure

    @property
    def probe(self) -> float:
        """Probe radius, Å, as given; it does not matter for a surface vdw."""
        return self._probe

    @property
    def kind(self) -> SurfaceKind:
        """Which surface: ses, sas or vdw."""
        return self._kind

    @property
    def measures(self) -> Measures:
        """Exact areas and volumes, those of :func:`measure`; measured on first use, then kept.

        For a surface sas or vdw they are those of that surface: ses_area and sas_area are then the same. If two
        evaluations do not agree, there is a :class:`CheckWarning`. Takes about 25 µs per atom.

        Examples
        --------
        >>> ball = meniscus.ExactSurface([[0, 0, 0]], [2.0], surface="sas")
        >>> numpy.allclose(ball.measures.ses_area, 4 * numpy.pi * 3.4**2)
        True
        """
        if self._measures is None:
            asked = {**self._exact_options(), "threads": self._threads}
            self._measures = checked(Measures(self._core.measures(self._threads), self._structure, asked))
        return self._measures

    def signed_distance(self, points: ArrayLike) -> Floats:
        """Signed distances from the surface; negative inside.

        Exact inside and on the surface; outside, next to ridges, a lower bound with the correct zero set. Takes about
        0.1 µs per point for points as close together as those of a grid and 3 µs for isolated ones.

        Parameters
        ----------
        points : array_like, shape (m, 3)
            Å; anywhere.

        Returns
        -------
        ndarray of float64, shape (m,)
            Å; an array of your own, which may be written to.

        Raises
        ------
        UsageError
            For an array of another shape, and coordinates that are not finite.

        Examples
        --------
        >>> meniscus.ExactSurface([[0, 0, 0]], [2.0]).signed_distance([[0, 0, 5], [1, 0, 0]]).round(6).tolist()
        [3.0, -1.0]
        """
        return self._core.signed_distance(positions("points", points), self._threads)

    def nearest(self, points: ArrayLike) -> Nearest:
        """What is nearest to each of the points: distance, atom, patch, normal, curvatures, place of the probe.

        Takes as long as :meth:`signed_distance`.

        Parameters
        ----------
        points : array_like, shape (m, 3)
            Å; anywhere.

        Returns
        -------
        Nearest

        Raises
        ------
        UsageError
            For an array of another shape, and coordinates that are not finite.

        Examples
        --------
        >>> found = meniscus.ExactSurface([[0, 0, 0]], [2.0]).nearest([[0, 0, 5]])
        >>> found.distance.round(6).tolist(), found.normal.round(6).tolist(), found.foot.round(6).tolist()
        ([3.0], [[0.0, 0.0, 1.0]], [[0.0, 0.0, 3.4]])
        """
        return Nearest(**self._core.nearest(positions("points", points), self._threads))

    def of_same_atoms(self, probe: float | None = None, surface: SurfaceKind | None = None) -> ExactSurface:
        """Another surface of the same structure.

        What is found of it is kept as long as any surface of these atoms, so that asking again builds nothing again.

        Parameters
        ----------
        probe : float, optional
            Probe radius, Å; by default that of this surface.
        surface : {"ses", "sas", "vdw"}, optional
            Which surface; by default as this one.

        Returns
        -------
        ExactSurface

        Raises
        ------
        UsageError
            For a radius that is negative or not finite, and an unknown word.

        Examples
        --------
        >>> exact = meniscus.ExactSurface("1ubq.pdb")
        >>> exact.of_same_atoms(surface="sas")
        <meniscus.ExactSurface: sas of 602 atoms, probe 1.4 Å>
        >>> len(exact.of_same_atoms(probe=1.0).measures.cavities)
        8
        """
        other = object.__new__(ExactSurface)
        other.__dict__.update(self.__dict__, _measures=None)
        if probe is not None:
            other._probe = _options.not_negative("probe", probe)
        if surface is not None:
            _options.word("surface", surface)
            other._kind = surface
        other._core = self._core.of_same_atoms(other._exact_options())
        return other

    @with_keywords({**SURFACE_DEFAULTS, **RUN_DEFAULTS}, but=("probe", "surface", "threads"))
    def mesh(
        self,
        spacing: float | None = NOT_GIVEN,
        method: Method = NOT_GIVEN,
        *,
        options: SurfaceOptions | None = None,
        run: RunOptions | None = None,
        memory: int | str | None = NOT_GIVEN,
        progress: Progress = NOT_GIVEN,
        **keywords: Unpack[Meshing],
    ) -> Surface:
        """A mesh of this surface, as :func:`surface` makes it, without building the geometry again.

        Parameters
        ----------
        spacing : float, optional
            Grid spacing, Å; see :class:`SurfaceOptions`.
        method : {"flow", "direct", "gaussian"}, default "flow"
            How the mesh is made; see :class:`SurfaceOptions`.
        options : SurfaceOptions, optional
            How to mesh. Their probe and surface must be those of this surface, or left at their defaults.
        run : RunOptions, optional
            Threads, by default those of this surface; memory, progress.
        memory : int or str, optional
            "4G", "500M" or a number of MB; see :class:`RunOptions`.
        progress : callable, optional
            Called with stage and fraction; see :class:`RunOptions`.
        **keywords
            The other members of SurfaceOptions: components, edge, flow, quality ... All that is given as a keyword
            replaces what ``options`` and ``run`` say.

        Returns
        -------
        Surface

        Raises
        ------
        UsageError
            For invalid options. A ValueError.
        LimitError
            For a surface that would not fit into memory. A ValueError and MemoryError.

        Examples
        --------
        >>> exact = meniscus.ExactSurface([[0, 0, 0], [2, 0, 0]], [1.5, 1.5])
        >>> fine, coarse = exact.mesh(spacing=0.25), exact.mesh(method="direct")
        >>> fine.measures is coarse.measures is exact.measures
        True
        """
        asked = meshing_of(options, given(spacing=spacing, method=method), keywords)
        for name, own in (("probe", self._probe), ("surface", self._kind)):
            if getattr(asked, name) not in (own, SURFACE_DEFAULTS[name]):
                raise UsageError(f"{name} {getattr(asked, name)}: of options, but this surface has {name} {own}; "
                                 "see of_same_atoms()")
        used = with_run(run, memory=memory, progress=progress)
        return self._meshed(asked, used.replace(threads=used.threads or self._threads))

    def _meshed(self, asked: SurfaceOptions, run: RunOptions) -> Surface:
        """With options that are put together."""
        options = {"method": asked.method, **asked._given(), **self._exact_options(), "threads": run.threads}
        if run.memory is not None:
            options["memory"] = _options.megabytes("memory", run.memory)
        core = _core.mesh(self._core, options, run.progress)
        failed = [f"{c['name']} ({c['value']:g}, bound {c['bound']:g})" for c in core.mesh_checks if not c["passed"]]
        if failed:
            warn(f"the surface failed its own checks: {', '.join(failed)}", CheckWarning)
        return Surface(core, self, options)


def meshing_of(options: SurfaceOptions | None, named: dict[str, Any], keywords: Any) -> SurfaceOptions:
    """Options, of which keywords replace some; those that are None do not."""
    for name in keywords:
        if name not in MESHING_DEFAULTS:
            raise TypeError(f"unexpected keyword argument {name!r}")
    changes = {name: value for name, value in {**named, **keywords}.items() if value is not None or name == "probe"}
    return of_kind("options", options, SurfaceOptions).replace(**changes)

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The exact surface of atoms, and what is made of it and held against it."""
from __future__ import annotations

import dataclasses
import warnings
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core, _options
from ._arrays import Floats, positions
from ._errors import CheckWarning
from ._measures import Measures, checked
from ._keywords import DEFAULTS, Meshing
from ._meshing import Progress, SurfaceKeywords, meshing_options, with_keywords
from ._structure import Path, Reading, Structure, as_structure
from ._surface import Indices, Surface

if TYPE_CHECKING:
    from typing_extensions import Unpack


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Nearest:
    """What of an exact surface is nearest to each of m points; made by :meth:`ExactSurface.nearest`. Lengths in Å.

    The nearest point of the surface itself is ``points - distance[:, None] * normal`` where the distance is exact: see
    :meth:`ExactSurface.signed_distance`. The arrays are read-only.
    """

    distance: Floats
    """(m,) float64, Å: signed distance from the surface, negative inside"""
    atom: Indices
    """(m,) int32: index of the nearest of the atoms that the patch touches"""
    patch: npt.NDArray[np.uint8]
    """(m,) uint8: 0 contact, 1 toroidal, 2 reentrant"""
    normal: Floats
    """(m, 3) float64: gradient of the distance, a unit vector that points out of the molecule; 0 where undefined, as at the
    centre of the atom whose patch is nearest"""
    mean_curvature: Floats
    """(m,) float64, Å⁻¹, positive on a sphere: of the parallel surface through the point, which for a point on the
    surface is the surface; may be infinite at cusps"""
    gaussian_curvature: Floats
    """(m,) float64, Å⁻²: of the same surface"""
    foot: Floats
    """(m, 3) float64, Å: centre of the probe where it touches the surface there, a point of the solvent-accessible
    surface; for sas and vdw a point of the surface itself"""

    def __len__(self) -> int:
        return len(self.distance)

    def __repr__(self) -> str:
        return f"<meniscus.Nearest: {len(self)} points>"


class ExactSurface:
    """The surface of atoms, known analytically: exact measures, distances and curvatures, and meshes of it.

    atoms     a Structure; the path of a file; or centres (n, 3), Å
    radii     (n,), Å; required with centres. With a path, the name of a radius set
    probe     probe radius, Å; 0 gives the van der Waals surface
    surface   ses (solvent-excluded), sas (solvent-accessible, traced by the probe's centre) or vdw (van der Waals: of
              the atoms themselves)
    threads   0: all cores; for all that is asked of this surface. Results do not depend on it
    reading   with a path, the other arguments of :func:`read`: waters=True, chains="A" ...

    Nothing is computed before it is asked for, and everything once: the geometry, which takes about 5 µs per atom, and
    the measures are kept, and meshes are made of the same geometry. A surface does not change, so several threads may
    use it; other Python threads keep running.

    Raises ValueError for invalid arrays or options. What can only be found with the geometry, such as that there are no
    atoms, is a ValueError of the first method that needs it.

    >>> exact = meniscus.ExactSurface("1ubq.pdb")
    >>> round(exact.measures.ses_area, 1), exact.signed_distance([[0, 0, 0]]).round(2).tolist()
    (3892.2, [27.11])
    >>> exact.mesh(spacing=1.0).exact is exact
    True
    """

    def __init__(
        self,
        atoms: Structure | Path | npt.ArrayLike,
        radii: npt.ArrayLike | Path | None = None,
        probe: float = 1.4,
        *,
        surface: str = "ses",
        threads: int = 0,
        **reading: Unpack[Reading],
    ) -> None:
        self._structure = as_structure(atoms, radii, reading)
        self._probe = _options.not_negative("probe", probe)
        self._kind = _options.word("surface", surface)
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
    def kind(self) -> str:
        """ses, sas or vdw."""
        return self._kind

    @property
    def measures(self) -> Measures:
        """Exact areas and volumes, those of :func:`measure`; measured on first use, then kept.

        For a surface sas or vdw they are those of that surface: ses_area and sas_area are then the same. If two
        evaluations do not agree, there is a :class:`CheckWarning`. Takes about 25 µs per atom.

        >>> ball = meniscus.ExactSurface([[0, 0, 0]], [2.0], surface="sas")
        >>> numpy.allclose(ball.measures.ses_area, 4 * numpy.pi * 3.4**2)
        True
        """
        return self._measured()

    def _measured(self) -> Measures:
        """For properties: a warning names whoever asked for the property."""
        if self._measures is None:
            self._measures = checked(Measures(self._core.measures(self._threads), self._structure), stacklevel=4)
        return self._measures

    def signed_distance(self, points: npt.ArrayLike) -> Floats:
        """Signed distances from the surface, (m,), Å; negative inside.

        points  (m, 3), Å; anywhere

        Exact inside and on the surface; outside, next to ridges, a lower bound with the correct zero set. Takes about
        0.1 µs per point for points as close together as those of a grid and 3 µs for isolated ones. Raises ValueError
        for an array of another shape and for coordinates that are not finite.

        >>> meniscus.ExactSurface([[0, 0, 0]], [2.0]).signed_distance([[0, 0, 5], [1, 0, 0]]).round(6).tolist()
        [3.0, -1.0]
        """
        return self._core.signed_distance(positions("points", points), self._threads)

    def nearest(self, points: npt.ArrayLike) -> Nearest:
        """What is nearest to each of the points: distance, atom, patch, normal, curvatures, place of the probe.

        points  (m, 3), Å; anywhere

        Errors and time are those of :meth:`signed_distance`.

        >>> found = meniscus.ExactSurface([[0, 0, 0]], [2.0]).nearest([[0, 0, 5]])
        >>> found.distance.round(6).tolist(), found.normal.round(6).tolist(), found.foot.round(6).tolist()
        ([3.0], [[0.0, 0.0, 1.0]], [[0.0, 0.0, 3.4]])
        """
        return Nearest(**self._core.nearest(positions("points", points), self._threads))

    def of_same_atoms(self, probe: float | None = None, surface: str | None = None) -> ExactSurface:
        """Another surface of the same structure; what is not given is as here.

        What is found of it is kept as long as any surface of these atoms, so that asking again builds nothing again.

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
            other._kind = _options.word("surface", surface)
        other._core = self._core.of_same_atoms(other._exact_options())
        return other

    @with_keywords(DEFAULTS)
    def mesh(
        self,
        spacing: float | None = None,
        method: str = "flow",
        *,
        memory: int | str | None = None,
        progress: Progress = None,
        **options: Unpack[Meshing],
    ) -> Surface:
        """A mesh of this surface, as :func:`surface` makes it, without building the geometry again.

        spacing, method, memory, progress  as for :func:`surface`
        options                            its other arguments that say how to mesh: components, edge, flow, quality ...

        Raises what :func:`surface` raises and TypeError for an unknown argument; takes as long, less the geometry.

        >>> exact = meniscus.ExactSurface([[0, 0, 0], [2, 0, 0]], [1.5, 1.5])
        >>> fine, coarse = exact.mesh(spacing=0.25), exact.mesh(method="direct")
        >>> fine.measures is coarse.measures is exact.measures
        True
        """
        return self._meshed(meshing_options(spacing, method, memory, options), progress)

    def _meshed(self, meshing: dict[str, Any], progress: Progress) -> Surface:
        """For functions that are called from outside: a warning names their caller."""
        options = {**self._exact_options(), "threads": self._threads, **meshing}
        result = Surface(_core.mesh(self._core, options, progress), self, options)
        if not result.passed:
            failed = ", ".join(f"{c['name']} ({c['value']:g}, bound {c['bound']:g})" for c in result.checks
                               if not c["passed"])
            warnings.warn(f"the surface failed its own checks: {failed}", CheckWarning, stacklevel=3)
        return result


@with_keywords(DEFAULTS, others="reading")
def surface(
    atoms: Structure | Path | npt.ArrayLike,
    radii: npt.ArrayLike | Path | None = None,
    probe: float = 1.4,
    spacing: float | None = None,
    method: str = "flow",
    *,
    surface: str = "ses",
    threads: int = 0,
    memory: int | str | None = None,
    progress: Progress = None,
    **keywords: Unpack[SurfaceKeywords],
) -> Surface:
    """The solvent-excluded surface of atoms: an :class:`ExactSurface` of them, meshed.

    atoms     a Structure; the path of a file; or centres (n, 3), Å, as lists or arrays of any real type
    radii     (n,), Å; required with centres. With a path, the name of a radius set
    probe     probe radius, Å; 0 gives the van der Waals surface
    spacing   grid spacing, Å; None: 0.5, and with edge or vertex_density half or a quarter of that for small surfaces
              whose area would otherwise be off by more than 0.5 %
    method    flow (smooth level set), direct (exact distance, sharp ridges) or gaussian (only the start of the flow)
    surface   ses, sas (solvent-accessible) or vdw (van der Waals: the same as probe 0)
    threads   0: all cores; results do not depend on it
    memory    "4G", "500M" or a number of MB: refuse what would need more
    progress  called with the stage's name and the fraction of it that is done, 0 to 1, a few times per second; an
              exception that it raises ends the computation, as Ctrl-C does
    keywords  how to mesh, with the names and defaults of the command line: edge=1.0, components="outer" ...;
              :class:`Meshing` describes each. With a path, the other arguments of :func:`read`, too: waters=True ...

    Raises ValueError for invalid arrays or options and :class:`LimitError`, a ValueError and MemoryError, for a surface
    that would not fit into memory. A result that fails its own checks comes with a :class:`CheckWarning`. Memory grows
    with area / spacing². Other Python threads keep running.

    >>> ball = meniscus.surface([[0, 0, 0]], [2.0], probe=1.4, spacing=0.25)
    >>> ball.vertices.dtype, ball.triangles.dtype, ball.patch.dtype
    (dtype('float64'), dtype('int32'), dtype('uint8'))
    >>> round(float(numpy.median(ball.mean_curvature)), 2)
    0.5
    """
    meshing = {name: value for name, value in keywords.items() if name in DEFAULTS}
    reading = {name: value for name, value in keywords.items() if name not in DEFAULTS}
    exact = ExactSurface(as_structure(atoms, radii, reading), probe=probe, surface=surface, threads=threads)
    return exact._meshed(meshing_options(spacing, method, memory, meshing), progress)


def signed_distance(
    atoms: Structure | Path | npt.ArrayLike,
    radii: npt.ArrayLike | Path | None = None,
    points: npt.ArrayLike | None = None,
    probe: float = 1.4,
    threads: int = 0,
    **reading: Unpack[Reading],
) -> Floats:
    """Signed distances from the exact solvent-excluded surface, (m,), Å; negative inside.

    atoms     a Structure, the path of a file, or centres (n, 3), Å
    radii     (n,), Å; required with centres
    points    (m, 3), Å; anywhere; required
    probe     probe radius, Å
    threads   0: all cores; results do not depend on it
    reading   with a path, the other arguments of :func:`read`

    Exact inside and on the surface; outside, next to ridges, a lower bound with the correct zero set. Takes about
    0.1 µs per point for points as close together as those of a grid and 3 µs for isolated ones, plus the geometry of
    the atoms.

    >>> meniscus.signed_distance([[0, 0, 0]], [2.0], [[0, 0, 5], [1, 0, 0]]).round(6).tolist()
    [3.0, -1.0]
    >>> bool(meniscus.signed_distance(meniscus.read("1ubq.pdb"), points=[[0, 0, 0]]) > 20)
    True
    """
    structure = as_structure(atoms, radii, reading)
    if points is None:
        raise TypeError("points: required, (m, 3) in Å")
    return ExactSurface(structure, probe=probe, threads=threads).signed_distance(points)

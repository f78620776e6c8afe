# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The surface itself: mesh, level set, measures and points on it."""
from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, Union

import numpy as np
import numpy.typing as npt

from . import _core, _options, _writing
from ._arrays import Floats, arrays_of, positions
from ._errors import UsageError, opening, text_of_path
from ._measures import Component, Measures
from ._structure import Path, Structure

if TYPE_CHECKING:
    from ._exact import ExactSurface

Singles = npt.NDArray[np.float32]
Indices = npt.NDArray[np.int32]
Arrays = Union[None, str, Sequence[str]]


_VERTEX_ARRAYS = ("normals", "atom", "residue", "patch", "component", "area", "mean_curvature", "gaussian_curvature",
                  "shape_index")


_FURTHER_ARRAYS = ("depth",)


def _further(arrays: Arrays) -> list[str]:
    """Names of arrays that are found only when asked for."""
    names = [arrays] if isinstance(arrays, str) else list(arrays or [])
    for name in names:
        if name not in _FURTHER_ARRAYS:
            raise UsageError(f"arrays: unknown value {name!r}; choose one of {', '.join(_FURTHER_ARRAYS)}")
    return names


class _Vertices:
    """Arrays with one entry per point of the surface. They are read-only; most are views. ``numpy(copy=True)`` and the
    method ``copy()`` of every array give arrays that may be written to."""

    def __init__(self, mesh: _core.Mesh, exact: ExactSurface, threads: int) -> None:
        self._mesh = mesh
        self._exact = exact
        self._threads = threads

    def __getstate__(self) -> dict[str, Any]:
        return {"_mesh": self._mesh, "_exact": self._exact, "_threads": self._threads}

    @property
    def exact(self) -> ExactSurface:
        """The exact surface that this was made of, with all that has been found of it."""
        return self._exact

    @property
    def structure(self) -> Structure:
        """The atoms to which ``atom`` refers."""
        return self._exact.structure

    @cached_property
    def normals(self) -> Floats:
        """(n, 3) float64: unit vectors that point into the solvent, in single precision."""
        return self._mesh.normals

    @property
    def atom(self) -> Indices:
        """(n,) int32: index of the nearest of the atoms that the vertex's patch touches."""
        return self._mesh.atom

    @property
    def residue(self) -> Indices:
        """(n,) int32: index of the residue of that atom; a new array."""
        return self.structure.residue[self.atom]

    @property
    def patch(self) -> npt.NDArray[np.uint8]:
        """(n,) uint8: 0 contact, 1 toroidal, 2 reentrant."""
        return self._mesh.patch

    @property
    def component(self) -> Indices:
        """(n,) int32: 0 outer, then the others by enclosed volume, largest first."""
        return self._mesh.component

    @property
    def area(self) -> Singles:
        """(n,) float32, Å²: the area that belongs to a point; the sum is the area of the mesh."""
        return self._mesh.area

    @property
    def mean_curvature(self) -> Singles:
        """(n,) float32, Å⁻¹: positive on a sphere."""
        return self._mesh.mean_curvature

    @property
    def gaussian_curvature(self) -> Singles:
        """(n,) float32, Å⁻²."""
        return self._mesh.gaussian_curvature

    @property
    def shape_index(self) -> Singles:
        """(n,) float32, from -1 (cup) over 0 (saddle) to 1 (ball)."""
        return self._mesh.shape_index

    @cached_property
    def depth(self) -> Singles:
        """(n,) float32, Å: how deep in pockets and cavities the surface lies, which is the distance within the surface of
        a probe of 10 Å; 0 outside. Found on first use, then kept; saved with ``arrays="depth"`` and with
        ``color="depth"``.
        """
        return _core.depth_values(self._mesh, self._exact._core, self._threads)

    def _with_arrays(self, values: _writing.Values, arrays: Arrays) -> _writing.Values:
        """The values, and the further arrays that are asked for."""
        names = _further(arrays)
        twice = [name for name in names if name in (values or {})]
        if twice:
            raise UsageError(f"arrays: '{twice[0]}' is also the name of values; rename the values")
        return {**(values or {}), **{name: getattr(self, name) for name in names}} if names else values

    def colors(self, color: str = "auto", values: _writing.Values = None) -> npt.NDArray[np.uint8]:
        """(n, 4) uint8, sRGB and alpha: the colours of a scheme of ``--color``, or one colour: "tomato", "#ff6347".

        values  arrays (n,) by name, which ``color`` may also name: "phi" or "phi:-5:5"
        """
        options = {**_writing.colour_options(color), **_writing.value_options(values, len(self.normals))}
        return _core.colors(self._mesh, self.structure._core, options)

    def map_values(self, path: Path, offset: float = 0.0, interpolation: str = "linear") -> Singles:
        """(n,) float32: the values of a map (.dx, .mrc, .map, .ccp4, also .gz) at the points, NaN outside it.

        offset         distance from the surface along the normals, Å; negative: into the molecule
        interpolation  linear or cubic

        Raises :class:`InputError` for a file that is not such a map, as ``--sample`` on the command line does.
        """
        options = {"offset": _options.number("offset", offset),
                   "interpolation": _options.word("interpolation", interpolation)}
        file = text_of_path(path)
        with opening(file):
            return _core.map_values(self._mesh, file, options)

    def table_values(self, path: Path) -> dict[str, Singles]:
        """By name, (n,) float32: columns of a table of values by atom, residue or chain, NaN where there is no value.

        The table is comma-separated with a header line, as for ``--values`` on the command line. Raises
        :class:`InputError` for a file that is not such a table, or that belongs to another structure.
        """
        file = text_of_path(path)
        with opening(file):
            return _core.table_values(self._mesh, self.structure._core, file)


class Points(_Vertices):
    """Points spread evenly over a surface, in spatial order; made by :meth:`Surface.sample`."""

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"<meniscus.Points: {len(self)}>"

    @property
    def points(self) -> Floats:
        """(n, 3) float64, Å."""
        return self._mesh.vertices

    def numpy(self, copy: bool = False, arrays: Arrays = None) -> dict[str, npt.NDArray[Any]]:
        """The arrays by their names: points and those of every point.

        copy    arrays of their own, which may be written to and which ``torch.from_numpy`` takes without a warning
        arrays  "depth", too, which has to be found first
        """
        return arrays_of(self, ("points", *_VERTEX_ARRAYS, *_further(arrays)), copy)

    def save(self, path: Path, color: _writing.Color = "auto", *, values: _writing.Values = None,
             arrays: Arrays = None, ascii: bool = False) -> None:
        """Writes the points as .ply (a point cloud with all arrays) or .npz.

        values  further arrays (n,), by name
        arrays  "depth", too
        """
        _writing.save_points(text_of_path(path), self, color, self._with_arrays(values, arrays), ascii)


class Surface(_Vertices):
    """A computed surface; made by :func:`surface` and :meth:`ExactSurface.mesh`.

    Arrays are read-only views of the surface's memory: nothing is copied, and they keep the surface alive. A surface
    does not change once computed, so several threads may use it.

    >>> surface = meniscus.surface(meniscus.read("1ubq.pdb"))
    >>> surface.vertices.shape, surface.triangles.shape, surface.passed
    ((23190, 3), (46384, 3), True)
    """

    def __init__(self, core: _core.Surface, exact: ExactSurface, options: dict[str, Any]) -> None:
        super().__init__(core.mesh, exact, options["threads"])
        self._core = core
        self._options = options

    def __getstate__(self) -> dict[str, Any]:
        return {"bytes": self._core.to_bytes(), "exact": self._exact, "options": self._options}

    def __setstate__(self, state: dict[str, Any]) -> None:
        core = _core.surface_of_bytes(state["bytes"], state["exact"]._core)
        Surface.__init__(self, core, state["exact"], state["options"])

    def __copy__(self) -> Surface:
        return self

    def __repr__(self) -> str:
        return (f"<meniscus.Surface: {len(self.vertices)} vertices, {len(self.triangles)} triangles, "
                f"{self._core.area:.1f} Å²>")

    @property
    def vertices(self) -> Floats:
        """(n, 3) float64, Å, in the frame of the atoms."""
        return self._mesh.vertices

    @property
    def triangles(self) -> Indices:
        """(m, 3) int32, counter-clockwise seen from the solvent."""
        return self._mesh.triangles

    def numpy(self, copy: bool = False, arrays: Arrays = None) -> dict[str, npt.NDArray[Any]]:
        """The arrays by their names: vertices, triangles, and those of every vertex.

        copy    arrays of their own, which may be written to and which ``torch.from_numpy`` takes without a warning
        arrays  "depth", too, which has to be found first

        >>> arrays = meniscus.surface([[0, 0, 0]], [2.0]).numpy(copy=True)
        >>> arrays["triangles"].dtype, arrays["triangles"].flags.writeable
        (dtype('int32'), True)
        """
        return arrays_of(self, ("vertices", "triangles", *_VERTEX_ARRAYS, *_further(arrays)), copy)

    @property
    def options(self) -> dict[str, Any]:
        """The options given to :func:`surface`, by the names of its arguments; those not given may be missing."""
        options = {name: value for name, value in self._options.items() if name != "finer_grid"}
        if "memory_mb" in options:
            options["memory"] = options.pop("memory_mb")
        return options

    @property
    def mesh(self) -> dict[str, Any]:
        """The numbers of the mesh, as in the block ``mesh`` of the command line's report. The exact area and volume, from
        which deviations are counted, are found on first use.

        >>> ball = meniscus.surface([[0, 0, 0]], [2.0])
        >>> ball.mesh["closed"], ball.mesh["euler_characteristic"], round(ball.mesh["corrected_area"] / 50.2655, 4)
        (True, 2, 1.0)
        >>> abs(ball.mesh["corrected_area_deviation"]) < 1e-3
        True
        """
        return self._core.mesh_block(self._threads)

    @property
    def flow(self) -> dict[str, Any] | None:
        """The course of the flow, as in the block ``flow`` of the report; None for other methods."""
        return self._core.flow_block

    @property
    def checks(self) -> list[dict[str, Any]]:
        """The self-checks of the surface: name, passed, value, bound."""
        return self._core.checks

    @property
    def passed(self) -> bool:
        """Whether every check passed."""
        return self._core.passed

    @property
    def measures(self) -> Measures:
        """Exact areas and volumes for the same atoms and probe, those of ``exact``; measured on first use, then kept.

        For a surface sas or vdw they are those of that surface: ses_area and sas_area are then the same.

        >>> surface = meniscus.surface([[0, 0, 0], [2, 0, 0]], [1.5, 1.5])
        >>> abs(surface.mesh["corrected_area"] / surface.measures.ses_area - 1) < 0.01
        True
        """
        return self._exact._measured()

    @property
    def cavities(self) -> list[Component]:
        """The exact cavities of the same surface, largest volume first, whichever pieces the mesh keeps."""
        return self.measures.cavities

    def level_set(self, points: npt.ArrayLike) -> Floats:
        """Values of the level-set function, (m,), Å; negative inside.

        points  (m, 3), Å

        NaN outside the band of a few spacings around the surface; :func:`signed_distance` has no such limit. With
        method direct there is no level set: then these are exact signed distances, anywhere.

        >>> ball = meniscus.surface([[0, 0, 0]], [2.0])
        >>> ball.level_set([[0, 0, 2.1], [0, 0, 1.9], [0, 0, 50]]).round(2).tolist()
        [0.1, -0.1, nan]
        """
        return self._core.values(positions("points", points), self._threads)

    def gradient(self, points: npt.ArrayLike) -> Floats:
        """Gradients of the level-set function, (m, 3): pointing outwards, with a length near 1, NaN outside the band.

        >>> ball = meniscus.surface([[0, 0, 0]], [2.0])
        >>> abs(ball.gradient([[0, 0, 2.0]])).round(2).tolist()
        [[0.0, 0.0, 1.0]]
        """
        return self._core.gradients(positions("points", points), self._threads)

    def sample(self, density: float = 1.0, seed: int = 0) -> Points:
        """Points spread evenly over the surface, each as far from its neighbours as the others (blue noise).

        density  points per Å²; their number is density times the area of the mesh, rounded
        seed     seed of the random numbers; the same seed gives the same points on any machine

        Like the vertices, the points lie on the surface and have normals, nearest atoms, patches and curvatures.
        Raises ValueError for a density that is not positive, :class:`LimitError` for too many points.

        >>> ball = meniscus.surface([[0, 0, 0]], [2.0])
        >>> points = ball.sample(density=2.0)
        >>> len(points), numpy.allclose(numpy.linalg.norm(points.points, axis=1), 2.0, atol=0.01)
        (99, True)
        """
        mesh = self._core.sample(_options.number("density", density), _options.seed(seed), self._threads)
        return Points(mesh, self._exact, self._threads)

    def save(
        self,
        path: Path,
        color: _writing.Color = "auto",
        *,
        values: _writing.Values = None,
        arrays: Arrays = None,
        ascii: bool = False,
        show: str | None = None,
        cavity: int | None = None,
        size: tuple[int, int] = (1600, 1200),
        view: _writing.View = "auto",
        background: str = "white",
        perspective: bool = False,
        outline: bool = False,
        depth_cue: float = 0.0,
        cut: _writing.Cut = None,
        legend: bool = False,
        grid: _writing.Grid = None,
        field: str = "distance",
        eps: tuple[float, float] = (2.0, 78.54),
        ion_radius: float = 2.0,
        maps: str | None = None,
    ) -> None:
        """Writes the surface, in the format of the suffix.

        .ply .obj .stl .off .glb .vtp  the mesh; .ply, .glb and .vtp with every vertex array and colours
        .vert                          the mesh as MSMS writes it, with .face beside it
        .npz                           the arrays, named as here, with atoms (atom_xyz, atom_name ...) and options, for
                                       numpy.load
        .png                           a picture
        .html                          an interactive page, which any browser opens without a network
        .dx .mrc .vdb                  values on a regular grid
        .mls                           the level set without loss

        color       a scheme of ``--color`` ("patch", "curvature:-1:1"), the name of one of the values ("phi:-5:5"), one
                    colour by its CSS name or "#rrggbb", or (n, 3) or (n, 4) uint8, one per vertex. "depth", "bfactor"
                    and "plddt" are written as a vertex array, too
        values      further arrays (n,), by name, such as from :meth:`map_values` and :meth:`table_values`
        arrays      "depth": how deep in pockets the surface lies, whatever the colours are (``--arrays``)
        ascii       write .ply and .stl as text
        show        write only the part of a mesh that belongs to these atoms, as in "//A/10-50" (``--show``)
        cavity      write only the wall of the cavity with this number, from 1 (``--cavity-files``); meshes only

        For pictures; view and perspective also for pages:

        size        width and height in pixels
        view        auto, front, back, left, right, top, bottom; or the direction towards the viewer (x, y, z); or two
                    directions, towards the viewer and upwards
        background  white, black, transparent, another name of CSS or "#rrggbb"
        perspective, outline, depth_cue, legend   as on the command line
        cut         cuts the surface by a plane that faces the viewer: "auto" (through the largest cavity), "cavity:N",
                    a depth behind the nearest point, Å, or a point (x, y, z); or by any plane: a point and a normal
                    towards the side that is left out

        For volumes (.dx .mrc .vdb):

        grid        a .dx, .mrc, .map or .ccp4 file with the grid, or seven numbers: nodes along x, y and z, spacing,
                    centre; None: nodes at the surface's spacing around all atoms
        field       distance (Å, inside positive), mask, dielectric or ions
        eps, ion_radius   dielectric constants inside and outside; radius of ions, Å
        maps        "apbs": with "a.dx" writes a_dielx.dx, a_diely.dx, a_dielz.dx and a_kappa.dx for APBS

        Raises ValueError for an unknown suffix or option, OSError if the file cannot be written; no partial file is
        left behind.

        >>> ball = meniscus.surface([[0, 0, 0]], [2.0])
        >>> ball.save("ball.ply", color="patch")
        >>> ball.save("ball.gif")
        Traceback (most recent call last):
        meniscus.UsageError: ball.gif: unknown suffix; choose one of .ply .obj .stl .off .glb .vtp .vert .npz .png .html .dx .mrc .vdb .mls
        """
        drawing = {"size": size, "view": view, "background": background, "perspective": perspective,
                   "outline": outline, "depth_cue": depth_cue, "cut": cut, "legend": legend, "grid": grid, "field": field,
                   "eps": eps, "ion_radius": ion_radius, "maps": maps}
        part = {"show": show, "cavity_file": cavity}
        _writing.save_surface(text_of_path(path), self, color, self._with_arrays(values, arrays), ascii, part, drawing)

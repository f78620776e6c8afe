# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The surface itself: mesh, level set and measures."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core, _files, _options, _writing
from ._arrays import ArrayLike, Floats, Indices, positions
from ._choices import Drawn, Field, Maps, SurfaceFormat
from ._files import Target
from ._component import Component
from ._measures import Measures
from ._points import Arrays, OnSurface, Points

if TYPE_CHECKING:
    import pyvista  # type: ignore[import]
    import trimesh  # type: ignore[import]

    from ._exact import ExactSurface


class Surface(OnSurface):
    """A computed surface; made by :func:`surface` and :meth:`ExactSurface.mesh`.

    Arrays are read-only views of the surface's memory: nothing is copied, and they keep the surface alive. A surface
    does not change once computed, so several threads may use it.

    Examples
    --------
    >>> surface = meniscus.surface(meniscus.read("1ubq.pdb"))
    >>> surface.vertices.shape, surface.triangles.shape, surface.passed
    ((23190, 3), (46384, 3), True)
    """

    _PLACES = ("vertices", "triangles")

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

    def to_trimesh(self, color: _writing.Color = "auto", arrays: Arrays = None) -> trimesh.Trimesh:
        """The mesh as one of trimesh, with normals, colours and the vertex arrays.

        Tried with a stand-in that has the documented constructor, not with trimesh itself.

        Parameters
        ----------
        color : str or array_like of uint8, shape (n, 3) or (n, 4), default "auto"
            Colours of the vertices, as for :meth:`save`.
        arrays : "depth" or sequence of it, optional
            Depths, too, which have to be found first.

        Returns
        -------
        trimesh.Trimesh
            With the vertices and triangles of this surface in their order; ``vertex_attributes`` has the arrays.

        Raises
        ------
        ImportError
            If trimesh is not installed.
        """
        from ._export import trimesh_of
        return trimesh_of(self, color, self._arrays_but_normals(arrays))

    def to_pyvista(self, color: _writing.Color | None = None, arrays: Arrays = None) -> pyvista.PolyData:
        """The mesh as one of PyVista, with normals and the vertex arrays.

        Tried with a stand-in that has the documented constructor, not with PyVista itself.

        Parameters
        ----------
        color : str or array_like of uint8, shape (n, 3) or (n, 4), optional
            Colours of the vertices, as for :meth:`save`, in the array "colors": ``plot(scalars="colors", rgb=True)``.
        arrays : "depth" or sequence of it, optional
            Depths, too, which have to be found first.

        Returns
        -------
        pyvista.PolyData
            With the vertices and triangles of this surface in their order; ``point_data`` has the arrays, "Normals" those
            of the vertices.

        Raises
        ------
        ImportError
            If PyVista is not installed.
        """
        from ._export import pyvista_of
        return pyvista_of(self, color, self._arrays_but_normals(arrays))

    @property
    def options(self) -> dict[str, Any]:
        """The options given to :func:`surface`, by the names of its arguments; those not given may be missing."""
        return dict(self._options)

    @property
    def mesh(self) -> dict[str, Any]:
        """The numbers of the mesh, as in the block ``mesh`` of the command line's report.

        The exact area and volume, from which deviations are counted, are found on first use.

        Examples
        --------
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
        """The self-checks of the surface, as in the block ``checks`` of the report: name, passed, value, bound.

        The last, exact_agreement, is of the exact measures, which are found on first use.
        """
        return [*self._core.mesh_checks, self._core.exact_check(self._threads)]

    @property
    def passed(self) -> bool:
        """Whether every check passed."""
        return all(check["passed"] for check in self.checks)

    @property
    def measures(self) -> Measures:
        """Exact areas and volumes for the same atoms and probe, those of ``exact``; measured on first use, then kept.

        For a surface sas or vdw they are those of that surface: ses_area and sas_area are then the same.

        Examples
        --------
        >>> surface = meniscus.surface([[0, 0, 0], [2, 0, 0]], [1.5, 1.5])
        >>> abs(surface.mesh["corrected_area"] / surface.measures.ses_area - 1) < 0.01
        True
        """
        return self._exact.measures

    @property
    def cavities(self) -> list[Component]:
        """The exact cavities of the same surface, largest volume first, whichever pieces the mesh keeps."""
        return self.measures.cavities

    def level_set(self, points: ArrayLike) -> Floats:
        """Values of the level-set function; negative inside.

        With method direct there is no level set: then these are exact signed distances, anywhere.

        Parameters
        ----------
        points : array_like, shape (m, 3)
            Å.

        Returns
        -------
        ndarray of float64, shape (m,)
            Å; NaN outside the band of a few spacings around the surface. :meth:`ExactSurface.signed_distance` has no such
            limit.

        Raises
        ------
        UsageError
            For an array of another shape, and coordinates that are not finite.

        Examples
        --------
        >>> ball = meniscus.surface([[0, 0, 0]], [2.0])
        >>> ball.level_set([[0, 0, 2.1], [0, 0, 1.9], [0, 0, 50]]).round(2).tolist()
        [0.1, -0.1, nan]
        """
        return self._core.values(positions("points", points), self._threads)

    def gradient(self, points: ArrayLike) -> Floats:
        """Gradients of the level-set function.

        Parameters
        ----------
        points : array_like, shape (m, 3)
            Å.

        Returns
        -------
        ndarray of float64, shape (m, 3)
            Pointing outwards, with a length near 1; NaN outside the band.

        Raises
        ------
        UsageError
            For an array of another shape, and coordinates that are not finite.

        Examples
        --------
        >>> ball = meniscus.surface([[0, 0, 0]], [2.0])
        >>> abs(ball.gradient([[0, 0, 2.0]])).round(2).tolist()
        [[0.0, 0.0, 1.0]]
        """
        return self._core.gradients(positions("points", points), self._threads)

    def sample(self, density: float = 1.0, seed: int = 0) -> Points:
        """Points spread evenly over the surface, each as far from its neighbours as the others (blue noise).

        Like the vertices, the points lie on the surface and have normals, nearest atoms, patches and curvatures.

        Parameters
        ----------
        density : float, default 1
            Points per Å²; their number is density times the area of the mesh, rounded.
        seed : int, default 0
            Seed of the random numbers; the same seed gives the same points on any machine.

        Returns
        -------
        Points

        Raises
        ------
        UsageError
            For a density that is not positive.
        LimitError
            For too many points.

        Examples
        --------
        >>> ball = meniscus.surface([[0, 0, 0]], [2.0])
        >>> points = ball.sample(density=2.0)
        >>> len(points), numpy.allclose(numpy.linalg.norm(points.points, axis=1), 2.0, atol=0.01)
        (99, True)
        """
        mesh = self._core.sample(_options.number("density", density), _options.seed(seed), self._threads)
        return Points(mesh, self._exact, self._threads)

    def save(
        self,
        path: Target,
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
        draw: Drawn = "ligands",
        grid: _writing.Grid = None,
        field: Field = "distance",
        eps: tuple[float, float] = (2.0, 78.54),
        ion_radius: float = 2.0,
        maps: Maps | None = None,
        format: SurfaceFormat | None = None,
    ) -> None:
        """Writes the surface, in the format of the suffix.

        .ply .obj .stl .off .glb .vtp are meshes; .ply, .glb and .vtp have every vertex array and colours. .vert is the
        mesh as MSMS writes it, with .face beside it. .npz has the arrays, named as here, with atoms (atom_xyz, atom_name
        ...) and options, for numpy.load. .png is a picture, .html an interactive page, which any browser opens without a
        network. .dx .mrc .vdb are values on a regular grid, .mls is the level set without loss.

        A file appears whole or not at all.

        Parameters
        ----------
        path : str, os.PathLike or binary file object
            Where to write.
        color : str or array_like of uint8, shape (n, 3) or (n, 4), default "auto"
            A scheme of ``--color`` ("patch", "curvature:-1:1"), the name of one of the values ("phi:-5:5"), one colour by
            its CSS name or "#rrggbb", or a colour per vertex. "depth", "bfactor", "plddt" and "pocket" are
            written as a vertex array, too. Pockets are found among the atoms of the surface, see :func:`pockets`: their
            ranks are less sure with radii that are not united, or hetero atoms.
        values : dict of str to array_like, shape (n,), optional
            Further arrays by name, such as from :meth:`map_values` and :meth:`table_values`.
        arrays : "depth" or sequence of it, optional
            How deep in pockets the surface lies, whatever the colours are (``--arrays``).
        ascii : bool, default False
            Write .ply and .stl as text.
        show : str, optional
            Write only the part of a mesh that belongs to these atoms, as in "//A/10-50" (``--show``).
        cavity : int, optional
            Write only the wall of the cavity with this number, from 1 (``--cavity-files``); meshes only.
        size : tuple of int, default (1600, 1200)
            Width and height of a picture in pixels.
        view : str or array_like, shape (3,) or (2, 3), default "auto"
            Of pictures and pages: auto, front, back, left, right, top, bottom; or the direction towards the viewer; or two
            directions, towards the viewer and upwards.
        background : str, default "white"
            Of pictures: white, black, transparent, another name of CSS or "#rrggbb".
        perspective : bool, default False
            Of pictures and pages: as the eye sees, instead of parallel rays.
        outline : bool, default False
            Of pictures: lines where the surface ends in front of something.
        depth_cue : float, default 0
            Of pictures: let what is far away fade into the background, 0 to 1.
        cut : str, float or array_like, shape (3,) or (2, 3), optional
            Of pictures: cuts the surface by a plane that faces the viewer: "auto" (through the largest cavity),
            "cavity:N", a depth behind the nearest point, Å, or a point; or by any plane: a point and a normal towards the
            side that is left out.
        legend : bool, default False
            Of pictures: what the colours mean.
        draw : {"ligands", "none"}, default "ligands"
            Of pictures, pages and .glb: draw the ligands of the structure as sticks and balls beside the surface
            (:attr:`Structure.ligands`); those that belong to it are seen in pages, where it is translucent.
        grid : str, os.PathLike or array_like, shape (7,), optional
            Of volumes: a .dx, .mrc, .map or .ccp4 file with the grid, or seven numbers: nodes along x, y and z, spacing,
            Å, centre, Å; by default nodes at the surface's spacing around all atoms.
        field : {"distance", "mask", "dielectric", "ions"}, default "distance"
            Of volumes: what the values are; distance is in Å, positive inside.
        eps : tuple of float, default (2.0, 78.54)
            Of dielectric volumes: the constants inside and outside.
        ion_radius : float, default 2.0
            Of volumes of ions: their radius, Å.
        maps : "apbs", optional
            With "a.dx" writes a_dielx.dx, a_diely.dx, a_dielz.dx and a_kappa.dx for APBS.
        format : str, optional
            The format, "ply", instead of that of the suffix; required for a file object without a name.

        Raises
        ------
        UsageError
            For an unknown suffix or an option that makes no sense. A ValueError.
        OSError
            If the file cannot be written.

        Examples
        --------
        >>> ball = meniscus.surface([[0, 0, 0]], [2.0])
        >>> ball.save("ball.ply", color="patch")
        >>> ball.save("ball.gif")
        Traceback (most recent call last):
        meniscus.UsageError: ball.gif: unknown suffix; choose one of .ply .obj .stl .off .glb .vtp .vert .npz .png .html .dx .mrc .vdb .mls
        """
        drawing = {"size": size, "view": view, "background": background, "perspective": perspective,
                   "outline": outline, "depth_cue": depth_cue, "cut": cut, "legend": legend, "draw": draw, "grid": grid,
                   "field": field, "eps": eps, "ion_radius": ion_radius, "maps": maps}
        part = {"show": show, "cavity_file": cavity}

        _files.save_to(path, format, lambda inner: _writing.save_surface(
            inner, self, color, self._with_arrays(values, arrays), ascii, part, drawing))

    def write(self, file: _files.Writable, format: SurfaceFormat, color: _writing.Color = "auto", **options: Any) -> None:
        """Writes the surface to an open file: :meth:`save` for those who have a stream.

        Parameters
        ----------
        file : binary file object
            An open file, io.BytesIO, gzip.GzipFile, a socket's file ...; it stays open.
        format : str
            "ply", "glb", "npz", "html" ...: the suffixes of :meth:`save` but vert, which is two files.
        color : str or array_like of uint8, shape (n, 3) or (n, 4), default "auto"
            As for :meth:`save`.
        **options
            The other arguments of :meth:`save`.

        Raises
        ------
        UsageError
            For an unknown format or an option that makes no sense.

        Examples
        --------
        >>> import io
        >>> stream = io.BytesIO()
        >>> meniscus.surface([[0, 0, 0]], [2.0]).write(stream, format="ply")
        >>> stream.getvalue()[:3]
        b'ply'
        """
        self.save(file, color, format=format, **options)

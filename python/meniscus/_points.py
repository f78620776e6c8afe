# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What vertices of meshes and sampled points have in common, and the sampled points."""
from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, Union, get_args

import numpy as np
import numpy.typing as npt

from . import _core, _files, _options, _writing
from ._arrays import Floats, Indices, Singles, arrays_of
from ._choices import Interpolation, PointFormat, VertexArray
from ._errors import UsageError, opening
from ._files import Source, Target
from ._structure import Structure

if TYPE_CHECKING:
    import pandas  # type: ignore[import]

    from ._exact import ExactSurface

Arrays = Union[None, VertexArray, Sequence[VertexArray]]

VERTEX_ARRAYS = ("normals", "atom", "residue", "patch", "component", "area", "mean_curvature", "gaussian_curvature",
                 "shape_index")


def further(arrays: Arrays) -> list[str]:
    """Names of arrays that are found only when asked for."""
    names = [arrays] if isinstance(arrays, str) else list(arrays or [])
    return [_options.one_of("arrays", name, get_args(VertexArray)) for name in names]


class OnSurface:
    """Arrays with one entry per point of the surface. They are read-only; most are views. ``numpy(copy=True)`` and the
    method ``copy()`` of every array give arrays that may be written to."""

    _PLACES: tuple[str, ...]
    """Names of the arrays that say where the points are."""

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
        """(n,) float32, Å: how deep in pockets and cavities the surface lies.

        That is the distance within the surface of a probe of 10 Å; 0 outside. Found on first use, then kept; saved with
        ``arrays="depth"`` and with ``color="depth"``.
        """
        return _core.depth_values(self._mesh, self._exact._core, self._threads)

    def _with_arrays(self, values: _writing.Values, arrays: Arrays) -> _writing.Values:
        """The values, and the further arrays that are asked for."""
        names = further(arrays)
        twice = [name for name in names if name in (values or {})]
        if twice:
            raise UsageError(f"arrays: '{twice[0]}' is also the name of values; rename the values")
        return {**(values or {}), **{name: getattr(self, name) for name in names}} if names else values

    def _arrays_but_normals(self, arrays: Arrays) -> dict[str, npt.NDArray[Any]]:
        names = [name for name in (*VERTEX_ARRAYS, *further(arrays)) if name != "normals"]
        return arrays_of(self, names, copy=False)

    def numpy(self, copy: bool = False, arrays: Arrays = None) -> dict[str, npt.NDArray[Any]]:
        """The arrays by their names: vertices and triangles of a surface, or points, and those with an entry for each.

        Parameters
        ----------
        copy : bool, default False
            Arrays of their own, which may be written to and which ``torch.from_numpy`` and ``from_dlpack`` take.
        arrays : "depth" or sequence of it, optional
            Depths, too, which have to be found first.

        Returns
        -------
        dict of str to ndarray

        Examples
        --------
        >>> arrays = meniscus.surface([[0, 0, 0]], [2.0]).numpy(copy=True)
        >>> arrays["triangles"].dtype, arrays["triangles"].flags.writeable
        (dtype('int32'), True)
        """
        return arrays_of(self, (*self._PLACES, *VERTEX_ARRAYS, *further(arrays)), copy)

    def to_pandas(self, arrays: Arrays = None) -> pandas.DataFrame:
        """The vertices or points as a table of pandas, one row each.

        Parameters
        ----------
        arrays : "depth" or sequence of it, optional
            Depths, too, which have to be found first.

        Returns
        -------
        pandas.DataFrame
            Columns x, y, z (Å), nx, ny, nz, and the arrays by their names.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        from ._export import frame
        places = {**dict(zip("xyz", self._mesh.vertices.T)), **dict(zip(("nx", "ny", "nz"), self.normals.T))}
        return frame({**places, **self._arrays_but_normals(arrays)})

    def colors(self, color: _writing.Scheme = "auto", values: _writing.Values = None) -> npt.NDArray[np.uint8]:
        """The colours of a scheme.

        Parameters
        ----------
        color : str, default "auto"
            A scheme of ``--color``, "patch" or "curvature:-1:1"; the name of one of the values; or one colour, "tomato",
            "#ff6347".
        values : dict of str to array_like, shape (n,), optional
            Arrays by name, which ``color`` may also name: "phi" or "phi:-5:5".

        Returns
        -------
        ndarray of uint8, shape (n, 4)
            sRGB and alpha.

        Raises
        ------
        UsageError
            For an unknown scheme, and values of another shape.
        """
        options = {**_writing.colour_options(color), **_writing.value_options(values, len(self.normals))}
        return _core.colors(self._mesh, self.structure._core, self._exact._core, options)

    def map_values(self, path: Source, offset: float = 0.0, interpolation: Interpolation = "linear") -> Singles:
        """The values of a map at the points, as ``--sample`` on the command line.

        Parameters
        ----------
        path : str, os.PathLike or file object
            The map: .dx, .mrc, .map, .ccp4, each also .gz. A file object needs a name with such a suffix.
        offset : float, default 0
            Distance from the surface along the normals, Å; negative: into the molecule.
        interpolation : {"linear", "cubic"}, default "linear"
            Between the nodes of the map.

        Returns
        -------
        ndarray of float32, shape (n,)
            In the units of the map; NaN outside it.

        Raises
        ------
        InputError
            For a file that is not such a map.
        OSError
            For a file that cannot be opened.
        """
        options = {"offset": _options.number("offset", offset),
                   "interpolation": _options.word("interpolation", interpolation)}
        with _files.on_disk(path) as file, opening(file):
            return _core.map_values(self._mesh, file, options)

    def table_values(self, path: Source) -> dict[str, Singles]:
        """Columns of a table of values by atom, residue or chain, as ``--values`` on the command line.

        Parameters
        ----------
        path : str, os.PathLike or file object
            The table, comma-separated with a header line.

        Returns
        -------
        dict of str to ndarray of float32, shape (n,)
            By name; NaN where there is no value.

        Raises
        ------
        InputError
            For a file that is not such a table, or that belongs to another structure.
        OSError
            For a file that cannot be opened.
        """
        with _files.on_disk(path, "csv") as file, opening(file):
            return _core.table_values(self._mesh, self.structure._core, file)


class Points(OnSurface):
    """Points spread evenly over a surface, in spatial order; made by :meth:`Surface.sample`.

    Arrays have one entry per point and are read-only.
    """

    _PLACES = ("points",)

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"<meniscus.Points: {len(self)}>"

    @property
    def points(self) -> Floats:
        """(n, 3) float64, Å."""
        return self._mesh.vertices

    def save(self, path: Target, color: _writing.Color = "auto", *, values: _writing.Values = None,
             arrays: Arrays = None, ascii: bool = False, format: PointFormat | None = None) -> None:
        """Writes the points as .ply, a point cloud with all arrays, or .npz.

        Parameters
        ----------
        path : str, os.PathLike or binary file object
            Where to write.
        color : str or array_like of uint8, shape (n, 3) or (n, 4), default "auto"
            A scheme, the name of one of the values, one colour, or a colour per point.
        values : dict of str to array_like, shape (n,), optional
            Further arrays by name.
        arrays : "depth" or sequence of it, optional
            Depths, too.
        ascii : bool, default False
            Write .ply as text.
        format : {"ply", "npz"}, optional
            The format, instead of that of the suffix; required for a file object without a name.

        Raises
        ------
        UsageError
            For an unknown suffix or scheme, and arrays of another shape.
        OSError
            If the file cannot be written; no partial file is left behind.
        """
        _files.save_to(path, format, lambda inner: _writing.save_points(
            inner, self, color, self._with_arrays(values, arrays), ascii))

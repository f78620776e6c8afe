# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""How far two surfaces are from each other."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, Union

from . import _atoms, _core, _files, _foreign, _options
from ._arrays import Floats, Indices, Singles
from ._choices import MeshFormat
from ._errors import UsageError, opening, text_of_path
from ._exact import ExactSurface
from ._files import Source, Target
from ._reading import Reading, ReadOptions
from ._structure import Structure
from ._surface import Surface

if TYPE_CHECKING:
    from typing_extensions import Unpack

_WITH_VALUES = (".ply", ".glb", ".vtp", ".npz")

Comparable = Union[Source, Surface, ExactSurface, Structure, "_foreign.ForeignObject"]


@dataclasses.dataclass(frozen=True)
class Distance:
    """Distances from one surface to another, Å; made by :func:`compare`.

    Parameters
    ----------
    mean : float
        Mean of the absolute values, weighted by area.
    p99 : float
        99 % of the area is nearer than this.
    max : float
        The largest.
    signed_mean : float
        Mean with signs, positive where the points lie outside the other surface.
    points : int
        Number of points.
    """

    mean: float
    p99: float
    max: float
    signed_mean: float
    points: int


@dataclasses.dataclass(frozen=True)
class Compared:
    """Measures of one of the two surfaces, exact for a structure or exact surface; made by :func:`compare`.

    Parameters
    ----------
    area : float
        Å².
    volume : float
        Å³.
    outer_pieces : int
        Closed pieces that bound it from outside.
    cavities : int
        Closed pieces that bound a space inside.
    closed : bool
        Whether no edge has only one triangle.
    manifold : bool
        Whether no edge has more than two triangles.
    merged_vertices : int
        Coincident vertices that were merged, because the mesh was not closed.
    """

    area: float
    volume: float
    outer_pieces: int
    cavities: int
    closed: bool
    manifold: bool
    merged_vertices: int


class Comparison:
    """Distances between two surfaces, both ways; made by :func:`compare`.

    Attributes
    ----------
    a : Compared
        Measures of A.
    b : Compared
        Measures of B.
    a_to_b : Distance
        Distances of the points of A from B.
    b_to_a : Distance
        Distances of the points of B from A.
    distances : ndarray of float32, shape (n,)
        Signed distances of ``vertices`` to B, Å, positive outside.
    """

    def __init__(self, a: _core.ComparedSurface, b: _core.ComparedSurface, options: dict[str, float | int],
                 exact: ExactSurface | None) -> None:
        """exact: the surface that A is or approximates, where that is known."""
        self._mesh = a.mesh
        self._structure = None if exact is None else exact.structure
        self._probe: float | None = None if exact is None else exact._exact_options()["probe"]
        self.a = Compared(**a.measures)
        self.b = Compared(**b.measures)
        found = _core.compare(a, b, options)
        self.a_to_b = Distance(**found["a_to_b"])
        self.b_to_a = Distance(**found["b_to_a"])
        self.distances: Singles = found["distances"]

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self.distances.flags.writeable = False

    def __repr__(self) -> str:
        return (f"<meniscus.Comparison: mean {self.a_to_b.mean:.4g} and {self.b_to_a.mean:.4g} Å, "
                f"Hausdorff {self.hausdorff:.4g} Å>")

    @property
    def hausdorff(self) -> float:
        """The larger of the two maxima, Å."""
        return max(self.a_to_b.max, self.b_to_a.max)

    @property
    def vertices(self) -> Floats:
        """(n, 3) float64, Å: vertices of A's mesh; a view."""
        return self._mesh.vertices

    @property
    def triangles(self) -> Indices:
        """(m, 3) int32: triangles of A's mesh; a view."""
        return self._mesh.triangles

    def save(self, path: Target, range: tuple[float, float] | None = None, *, format: MeshFormat | None = None) -> None:
        """Writes A's mesh with the vertex array ``distance`` and its colours: blue inside B, red outside.

        Parameters
        ----------
        path : str, os.PathLike or binary file object
            Where to write: .ply .glb .vtp .npz.
        range : tuple of float, optional
            Distances shown in full blue and full red, Å; by default, 99 % of A's area lies between them.
        format : {"ply", "glb", "vtp", "npz"}, optional
            The format, instead of that of the suffix; required for a file object without a name.

        Raises
        ------
        UsageError
            For another format.
        OSError
            If the file cannot be written.
        """
        reach = max(self.a_to_b.p99, 1e-3)
        low, high = (-reach, reach) if range is None else range
        ends = _options.number("range", low), _options.number("range", high)
        _files.save_to(path, format, lambda inner: self._write(inner, ends))

    def _write(self, path: str, range: tuple[float, float]) -> None:
        if not path.endswith(_WITH_VALUES):
            raise UsageError(f"{path}: this format cannot hold distances; choose {' '.join(_WITH_VALUES)}")
        _core.write_compared(path, self._mesh, self.distances, range,
                             None if self._structure is None else self._structure._core, self._probe)


def _is_mesh_file(value: Comparable) -> bool:
    if _files.is_file(value):
        return _core.is_mesh_file(_files.name_of(value))
    return not _foreign.is_foreign(value) and _core.is_mesh_file(text_of_path(value))  # type: ignore[arg-type]


def _is_to_be_read(value: Comparable) -> bool:
    return not isinstance(value, (Surface, ExactSurface, Structure)) and not _is_mesh_file(value)


def _side(value: Comparable, options: dict[str, float | int], reading: Reading, wanted: ReadOptions | None
          ) -> tuple[_core.ComparedSurface, ExactSurface | None]:
    """The surface, and the exact one that it is or approximates, where that is known."""
    if isinstance(value, Surface):
        return _core.compared_mesh(value._core.mesh), value.exact
    if not isinstance(value, (Structure, ExactSurface)):
        if _is_mesh_file(value):
            with _files.on_disk(value) as path, opening(path):  # type: ignore[arg-type]
                return _core.compared_file(path), None
        value = _atoms.read_source(value, reading, wanted)
    if isinstance(value, Structure):
        value = ExactSurface(value, probe=options["probe"], threads=int(options["threads"]))
    return _core.compared_exact(value._core, options), value


def compare(
    a: Comparable,
    b: Comparable,
    *,
    probe: float = 1.4,
    points: float = 10.0,
    spacing: float = 0.5,
    threads: int = 0,
    reading: ReadOptions | None = None,
    **keywords: Unpack[Reading],
) -> Comparison:
    """Distances between two surfaces, both ways, by points spread over their triangles.

    Other Python threads keep running.

    Parameters
    ----------
    a : Surface, ExactSurface, Structure, str, os.PathLike, file object or object of another package
        A mesh; a file of one (.ply .obj .stl .off .glb .vert .face, each also .gz; a file object needs a name with such a
        suffix); an exact surface of any kind; or a structure, whose exact solvent-excluded surface is used.
    b : Surface, ExactSurface, Structure, str, os.PathLike, file object or object of another package
        The other.
    probe : float, default 1.4
        Probe radius for structures, Å.
    points : float, default 10
        Minimum number of points per Å².
    spacing : float, default 0.5
        Grid spacing of the mesh that is used to spread points over an exact surface, Å.
    threads : int, default 0
        0: all cores; results do not depend on it.
    reading : ReadOptions, optional
        What to keep of structures that are read, and which radii.
    **keywords
        The members of ReadOptions, waters=True, chains="A" ..., which replace those of ``reading``; and frame=N for
        trajectories.

    Returns
    -------
    Comparison

    Raises
    ------
    UsageError
        For invalid arguments. A ValueError.
    InputError, OSError
        For a file that cannot be read.

    Examples
    --------
    >>> protein = meniscus.read("1ubq.pdb")
    >>> found = meniscus.compare(meniscus.surface(protein), protein)
    >>> found.a_to_b.mean < 0.02, found.a.closed, round(found.b.area, 1)
    (True, True, 3892.2)
    """
    options = {"probe": _options.number("probe", probe), "points": _options.number("points", points),
               "spacing": _options.number("spacing", spacing), "threads": _options.count("threads", threads)}
    _atoms.check_reading(keywords, reading, has_source=_is_to_be_read(a) or _is_to_be_read(b))
    (first, exact), (second, _) = _side(a, options, keywords, reading), _side(b, options, keywords, reading)
    return Comparison(first, second, options, exact)

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""How far two surfaces are from each other."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, Union

from . import _core, _options
from ._arrays import Floats
from ._errors import UsageError, opening, text_of_path
from ._structure import Path, Reading, Structure, check_reading, read_for_caller
from ._surface import Indices, Singles, Surface

if TYPE_CHECKING:
    from typing_extensions import Unpack

_WITH_VALUES = (".ply", ".glb", ".vtp", ".npz")

Comparable = Union[Path, Surface, Structure]


@dataclasses.dataclass(frozen=True)
class Distance:
    """Distances from one surface to another, Å: absolute values weighted by area, except for ``signed_mean``."""

    mean: float
    p99: float
    """99 % of the area is nearer than this"""
    max: float
    signed_mean: float
    """positive where the points lie outside the other surface"""
    points: int
    """number of points"""


@dataclasses.dataclass(frozen=True)
class Compared:
    """Measures of one of the two surfaces; exact for a structure."""

    area: float
    """Å²"""
    volume: float
    """Å³"""
    outer_pieces: int
    cavities: int
    closed: bool
    manifold: bool
    merged_vertices: int
    """coincident vertices that were merged, because the mesh was not closed"""


class Comparison:
    """The result of :func:`compare`."""

    def __init__(self, a: _core.ComparedSurface, b: _core.ComparedSurface, options: dict[str, float | int],
                 structure: Structure | None) -> None:
        self._mesh = a.mesh
        self._structure = structure
        self._probe = options["probe"]
        self.a = Compared(**a.measures)
        self.b = Compared(**b.measures)
        found = _core.compare(a, b, options)
        self.a_to_b = Distance(**found["a_to_b"])
        self.b_to_a = Distance(**found["b_to_a"])
        self.distances: Singles = found["distances"]
        """(n,) float32, Å: signed distances of ``vertices`` to B, positive outside."""

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

    def save(self, path: Path, range: tuple[float, float] | None = None) -> None:
        """Writes A's mesh (.ply .glb .vtp .npz) with the vertex array ``distance`` and its colours: blue inside B, red
        outside.

        range  distances shown in full blue and full red, Å; by default, 99 % of A's area lies between them
        """
        target = text_of_path(path)
        if not target.endswith(_WITH_VALUES):
            raise UsageError(f"{target}: this format cannot hold distances; choose {' '.join(_WITH_VALUES)}")
        reach = max(self.a_to_b.p99, 1e-3)
        low, high = (-reach, reach) if range is None else range
        structure = self._structure
        _core.write_compared(target, self._mesh, self.distances,
                             (_options.number("range", low), _options.number("range", high)),
                             None if structure is None else structure._core, None if structure is None else self._probe)


def _mesh_of_file(path: str) -> _core.ComparedSurface:
    with opening(path):
        return _core.compared_file(path)


def _is_structure_file(value: Comparable) -> bool:
    return not isinstance(value, (Surface, Structure)) and not _core.is_mesh_file(text_of_path(value))


def _side(value: Comparable, options: dict[str, float | int], reading: Reading
          ) -> tuple[_core.ComparedSurface, Structure | None]:
    if isinstance(value, Surface):
        return _core.compared_mesh(value._core.mesh), value.structure
    if not isinstance(value, Structure):
        path = text_of_path(value)
        if _core.is_mesh_file(path):
            return _mesh_of_file(path), None
        value = read_for_caller(path, reading)
    return _core.compared_structure(value._core, options), value


def compare(
    a: Comparable,
    b: Comparable,
    *,
    probe: float = 1.4,
    points: float = 10.0,
    spacing: float = 0.5,
    threads: int = 0,
    **reading: Unpack[Reading],
) -> Comparison:
    """Distances between two surfaces, both ways, by points spread over their triangles.

    a, b     a :class:`Surface` or the path of a mesh (.ply .obj .stl .off .glb .vert .face, each also .gz); or a
             structure or its path, whose exact solvent-excluded surface is used
    probe    probe radius for structures, Å
    points   minimum number of points per Å²
    spacing  grid spacing of the mesh that is used to spread points over a structure's surface, Å
    threads  0: all cores; results do not depend on it
    reading  for paths of structures, the arguments of :func:`read` beside radii: waters=True, chains="A" ...

    Raises ValueError for invalid arguments, :class:`InputError` for a file that is not valid, OSError for a file that
    cannot be opened. Other Python threads keep running.

    >>> protein = meniscus.read("1ubq.pdb")
    >>> found = meniscus.compare(meniscus.surface(protein), protein)
    >>> found.a_to_b.mean < 0.02, found.a.closed, round(found.b.area, 1)
    (True, True, 3892.2)
    """
    options = {"probe": _options.number("probe", probe), "points": _options.number("points", points),
               "spacing": _options.number("spacing", spacing), "threads": _options.count("threads", threads)}
    check_reading(reading, has_path=_is_structure_file(a) or _is_structure_file(b))
    (first, structure), (second, _) = _side(a, options, reading), _side(b, options, reading)
    return Comparison(first, second, options, structure)

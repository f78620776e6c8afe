# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Exact areas, volumes and cavities, without a grid."""
from __future__ import annotations

import dataclasses
import warnings
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core, _options
from ._arrays import Floats
from ._errors import CheckWarning, UsageError, text_of_path
from ._interfaces import Between, Interface, Pairs, pairs_of
from ._structure import Path, Reading, Structure, as_structure

if TYPE_CHECKING:
    from typing_extensions import Unpack

Point = tuple[float, float, float]


@dataclasses.dataclass(frozen=True)
class Component:
    """A connected closed piece of the solvent-excluded surface."""

    kind: str
    """outer or cavity"""
    ses_area: float
    """Å²"""
    contact_area: float
    toroidal_area: float
    reentrant_area: float
    ses_volume: float
    """Å³ enclosed, positive"""
    sas_area: float
    """Å², of the solvent-accessible pieces that belong to it"""
    sas_volume: float
    sas_components: int
    centre: Point
    """centroid of its surface, Å"""
    inside_of: int | None
    """index of the component that directly encloses it"""
    atoms: npt.NDArray[np.int32] = dataclasses.field(repr=False, compare=False)
    """(k,), indices of the atoms that touch it"""
    inscribed_centre: Point
    """centre of the largest sphere that fits into a cavity, Å"""
    inscribed_radius: float
    """Å; 0 for outer pieces"""
    errors: dict[str, float] = dataclasses.field(repr=False, compare=False)
    """absolute error estimates of the areas and volumes by name"""

    @property
    def area(self) -> float:
        """``ses_area``, Å²."""
        return self.ses_area

    @property
    def volume(self) -> float:
        """``ses_volume``, Å³."""
        return self.ses_volume


class Measures:
    """The result of :func:`measure`. Areas in Å², volumes in Å³; volumes of cavities are subtracted.

    >>> exact = meniscus.measure(meniscus.read("1ubq.pdb"))
    >>> round(exact.ses_area, 3), round(exact.ses_volume, 3)
    (3892.239, 10056.303)
    >>> exact.errors["ses_area"] < 1e-3
    True
    """

    def __init__(self, core: _core.Measures, structure: Structure, interfaces: _core.Interfaces | None = None) -> None:
        self._core = core
        self._structure = structure
        self._interfaces = interfaces
        self._components: list[Component] | None = None

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_components": None}

    def __repr__(self) -> str:
        return (f"<meniscus.Measures: SES {self.ses_area:.2f} Å², {self.ses_volume:.2f} Å³; "
                f"SAS {self.sas_area:.2f} Å²; {len(self.cavities)} cavities>")

    @property
    def structure(self) -> Structure:
        return self._structure

    @property
    def probe(self) -> float:
        """Probe radius, Å."""
        return self._core.probe

    @property
    def totals(self) -> dict[str, float]:
        """sas_area, sas_volume, ses_area, ses_volume, contact_area, toroidal_area, reentrant_area."""
        return self._core.totals

    @property
    def errors(self) -> dict[str, float]:
        """Absolute error estimates of the totals, by the same names."""
        return self._core.errors

    @property
    def sas_area(self) -> float:
        return self.totals["sas_area"]

    @property
    def sas_volume(self) -> float:
        return self.totals["sas_volume"]

    @property
    def ses_area(self) -> float:
        return self.totals["ses_area"]

    @property
    def ses_volume(self) -> float:
        return self.totals["ses_volume"]

    @property
    def contact_area(self) -> float:
        return self.totals["contact_area"]

    @property
    def toroidal_area(self) -> float:
        return self.totals["toroidal_area"]

    @property
    def reentrant_area(self) -> float:
        return self.totals["reentrant_area"]

    @property
    def components(self) -> list[Component]:
        """Closed pieces of the surface, largest volume first."""
        if self._components is None:
            self._components = [Component(**fields) for fields in self._core.components]
        return self._components

    @property
    def cavities(self) -> list[Component]:
        """The components that enclose solvent, largest volume first.

        >>> shell = meniscus.Structure.from_arrays(5 * numpy.vstack([numpy.eye(3), -numpy.eye(3)]), 4.0)
        >>> [(round(c.volume, 2), round(c.inscribed_radius, 6)) for c in meniscus.measure(shell, probe=0.5).cavities]
        [(7.97, 1.0)]
        """
        return [piece for piece in self.components if piece.kind == "cavity"]

    @property
    def atom_sas_area(self) -> Floats:
        """(n,), Å²: the share of each atom; the shares sum to the total."""
        return self._core.atom_sas_area

    @property
    def atom_ses_area(self) -> Floats:
        """(n,), Å²: the sum of the three kinds of patches.

        >>> exact = meniscus.measure([[0, 0, 0], [2, 0, 0]], [1.5, 1.5])
        >>> numpy.allclose(exact.atom_ses_area.sum(), exact.ses_area)
        True
        """
        return self.atom_contact_area + self.atom_toroidal_area + self.atom_reentrant_area

    @property
    def atom_contact_area(self) -> Floats:
        return self._core.atom_contact_area

    @property
    def atom_toroidal_area(self) -> Floats:
        return self._core.atom_toroidal_area

    @property
    def atom_reentrant_area(self) -> Floats:
        return self._core.atom_reentrant_area

    @property
    def atom_depth(self) -> Floats:
        """(n,), Å: distances of the centres from the surface. Raises ValueError unless measured with ``depth=True``."""
        if not self._core.depth_measured:
            raise UsageError("depth: not measured; ask for it with measure(..., depth=True)")
        return self._core.atom_depth

    @property
    def sas_components(self) -> int:
        """Closed pieces of the solvent-accessible surface."""
        return self._core.sas_components

    @property
    def largest_sas_piece(self) -> dict[str, float]:
        """Areas of the patches of the surface that belong to the solvent-accessible piece with the largest area, Å²:
        ses_area, contact_area, toroidal_area, reentrant_area. Programs that roll one probe over the molecule call this the
        outer component.
        """
        return self._core.largest_sas_piece

    @property
    def agreed(self) -> bool:
        """Whether two evaluations with independent perturbations agree, of interfaces, too."""
        return self._core.agreed and not self.disputed

    @property
    def disputed(self) -> list[str]:
        """Patches on which they do not agree."""
        return self._core.disputed + ([] if self._interfaces is None else self._interfaces.disputed)

    @property
    def degenerate(self) -> bool:
        """Whether probe positions coincide, as on lattices; the bound for agreement is then wider."""
        return self._core.degenerate

    @property
    def interfaces(self) -> list[Interface]:
        """The interfaces that ``measure(..., between=...)`` asked for, in that order."""
        return [] if self._interfaces is None else [Interface(**block) for block in self._interfaces.blocks]

    def interface_table(self, per: str = "residue") -> dict[str, list[Any]]:
        """A list per column, one row per residue, atom or chain of each side of each interface: areas alone and in the
        complex, and what is buried; the columns are in ``docs/conventions.md``.
        """
        return self._asked_interfaces().table(self._structure._core, _options.word("per", per))

    def save_interfaces(self, path: Path, per: str = "residue") -> None:
        """Writes that table as .csv or .json. Raises OSError if it cannot be written."""
        self._asked_interfaces().save(self._structure._core, text_of_path(path), _options.word("per", per))

    def _asked_interfaces(self) -> _core.Interfaces:
        if self._interfaces is None:
            raise UsageError("between: no interface was measured; ask for one with measure(..., between=('A', 'B'))")
        return self._interfaces

    def table(self, per: str = "atom") -> dict[str, list[Any]]:
        """A list per column, one row per atom, residue, chain or cavity; the columns are in ``docs/conventions.md``.

        >>> rows = meniscus.measure(meniscus.read("1ubq.pdb")).table("residue")
        >>> rows["resname"][:3], [round(a, 1) for a in rows["sas_area"][:3]]
        (['MET', 'GLN', 'ILE'], [55.5, 75.3, 0.0])
        """
        return self._core.table(self._structure._core, _options.word("per", per))

    def save(self, path: Path, per: str = "atom") -> None:
        """Writes a table as .csv or .json. Raises OSError if it cannot be written."""
        self._core.save(self._structure._core, text_of_path(path), _options.word("per", per))


def measure(
    atoms: Structure | Path | npt.ArrayLike,
    radii: npt.ArrayLike | Path | None = None,
    probe: float = 1.4,
    *,
    between: Between = None,
    cavities: bool = True,
    depth: bool = False,
    threads: int = 0,
    **reading: Unpack[Reading],
) -> Measures:
    """Exact areas and volumes of the SAS and SES with error estimates, shares of atoms, components and cavities.

    atoms     a Structure; the path of a file; or centres (n, 3), Å
    radii     (n,), Å; required with centres. With a path, the name of a radius set
    reading   with a path, the other arguments of :func:`read`: waters=True, chains="A" ...
    probe     probe radius, Å; 0 gives the van der Waals surface
    between   interfaces, too: ("A", "B") or "A:B", ("A,C", "B") or (["A", "C"], "B"), a list of such pairs, or "all" for
              every pair of chains that touch. A ligand is named in parentheses, ("A", "(HEM)"), or "B(HEM)" for that of
              chain B; it must have been kept: read(..., hetero="ligands")
    cavities  also find which component encloses which, and inscribed spheres
    depth     also measure the depth of every atom
    threads   0: all cores; results do not depend on it

    Raises ValueError for invalid arrays or options. If two evaluations do not agree, there is a :class:`CheckWarning`,
    and ``Measures.disputed`` lists the patches. Takes about 25 µs per atom; other Python threads keep running.

    >>> ball = meniscus.measure([[0, 0, 0]], [2.0], probe=1.0)
    >>> numpy.allclose([ball.ses_area, ball.sas_area], [16 * numpy.pi, 36 * numpy.pi])
    True
    >>> round(meniscus.measure("1ubq.pdb").ses_area, 1)
    3892.2
    >>> two = meniscus.Structure.from_arrays([[0, 0, 0], [3, 0, 0]], 1.7, chain=["A", "B"])
    >>> round(meniscus.measure(two, between=("A", "B")).interfaces[0].buried_sas, 1)
    62.3
    """
    structure = as_structure(atoms, radii, reading)
    options = {"probe": _options.number("probe", probe), "cavities": bool(cavities), "depth": bool(depth),
               "threads": _options.count("threads", threads)}
    pairs = pairs_of(between)
    core = _core.measure(structure._core, options)
    found = None if between is None else _interfaces(structure, pairs, options)
    return checked(Measures(core, structure, found), stacklevel=3)


def _interfaces(structure: Structure, pairs: Pairs, options: dict[str, Any]) -> _core.Interfaces:
    try:
        return _core.measure_interfaces(structure._core, pairs, options)
    except UsageError as error:
        raise UsageError(f"between: {error}") from None


def checked(measures: Measures, stacklevel: int) -> Measures:
    """Warns if two evaluations do not agree."""
    if not measures.agreed:
        warnings.warn("exact measures: evaluations do not agree on " + ", ".join(measures.disputed), CheckWarning,
                      stacklevel=stacklevel)
    return measures

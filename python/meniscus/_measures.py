# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Exact areas, volumes and cavities, without a grid."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core, _files, _options
from ._arrays import Floats
from ._choices import Per, PerInterface, TableFormat
from ._component import Component
from ._errors import CheckWarning, UsageError, warn
from ._files import Target
from ._interfaces import Interface
from ._structure import Structure
from ._sums import Selection, Sum, sum_of

if TYPE_CHECKING:
    import pandas  # type: ignore[import]

class Measures:
    """Exact areas and volumes; made by :func:`measure`. Areas in Å², volumes in Å³; those of cavities are subtracted.

    Examples
    --------
    >>> exact = meniscus.measure(meniscus.read("1ubq.pdb"))
    >>> round(exact.ses_area, 3), round(exact.ses_volume, 3)
    (3892.239, 10056.303)
    >>> exact.errors["ses_area"] < 1e-3
    True
    """

    def __init__(self, core: _core.Measures, structure: Structure, surface: dict[str, Any],
                 interfaces: _core.Interfaces | None = None) -> None:
        """surface: the surface, probe and threads that were asked for."""
        self._core = core
        self._structure = structure
        self._interfaces = interfaces
        self._surface = surface
        self._components: list[Component] | None = None
        self._turned: list[_core.Measures] | None = None

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_components": None, "_turned": None}

    def __repr__(self) -> str:
        return (f"<meniscus.Measures: SES {self.ses_area:.2f} Å², {self.ses_volume:.2f} Å³; "
                f"SAS {self.sas_area:.2f} Å²; {len(self.cavities)} cavities>")

    @property
    def structure(self) -> Structure:
        """The atoms."""
        return self._structure

    @property
    def probe(self) -> float:
        """Probe radius, Å."""
        return self._core.probe

    @property
    def totals(self) -> dict[str, float]:
        """All totals by their names.

        The names are sas_area, sas_volume, ses_area, ses_volume, contact_area, toroidal_area and reentrant_area.
        """
        return self._core.totals

    @property
    def errors(self) -> dict[str, float]:
        """Absolute error estimates of the totals, by the same names."""
        return self._core.errors

    @property
    def sas_area(self) -> float:
        """Å²: of the solvent-accessible surface, which the centre of the probe traces."""
        return self.totals["sas_area"]

    @property
    def sas_volume(self) -> float:
        """Å³: enclosed by the solvent-accessible surface."""
        return self.totals["sas_volume"]

    @property
    def ses_area(self) -> float:
        """Å²: of the solvent-excluded surface."""
        return self.totals["ses_area"]

    @property
    def ses_volume(self) -> float:
        """Å³: enclosed by the solvent-excluded surface."""
        return self.totals["ses_volume"]

    @property
    def contact_area(self) -> float:
        """Å²: of contact patches, where the probe touches one atom."""
        return self.totals["contact_area"]

    @property
    def toroidal_area(self) -> float:
        """Å²: of toroidal patches, where it touches two."""
        return self.totals["toroidal_area"]

    @property
    def reentrant_area(self) -> float:
        """Å²: of reentrant patches, where it touches three."""
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

        Examples
        --------
        >>> shell = meniscus.Structure.from_arrays(5 * numpy.vstack([numpy.eye(3), -numpy.eye(3)]), 4.0)
        >>> [(round(c.volume, 2), round(c.inscribed_radius, 6)) for c in meniscus.measure(shell, probe=0.5).cavities]
        [(7.97, 1.0)]
        """
        return [piece for piece in self.components if piece.kind == "cavity"]

    @property
    def atom_sas_area(self) -> Floats:
        """(n,) float64, Å²: the share of each atom; the shares sum to the total."""
        return self._core.atom_sas_area

    @property
    def atom_ses_area(self) -> Floats:
        """(n,) float64, Å²: the sum of the three kinds of patches.

        Examples
        --------
        >>> exact = meniscus.measure([[0, 0, 0], [2, 0, 0]], [1.5, 1.5])
        >>> numpy.allclose(exact.atom_ses_area.sum(), exact.ses_area)
        True
        """
        return self.atom_contact_area + self.atom_toroidal_area + self.atom_reentrant_area

    @property
    def atom_contact_area(self) -> Floats:
        """(n,) float64, Å²: the share of each atom in contact patches."""
        return self._core.atom_contact_area

    @property
    def atom_toroidal_area(self) -> Floats:
        """(n,) float64, Å²: the share of each atom in toroidal patches, divided where the expanded spheres meet."""
        return self._core.atom_toroidal_area

    @property
    def atom_reentrant_area(self) -> Floats:
        """(n,) float64, Å²: the share of each atom in reentrant patches, which are divided equally."""
        return self._core.atom_reentrant_area

    @property
    def atom_depth(self) -> Floats:
        """(n,) float64, Å: distances of the centres from the surface.

        Raises
        ------
        UsageError
            Unless it was measured with ``depth=True``.
        """
        if not self._core.depth_measured:
            raise UsageError("depth: not measured; ask for it with measure(..., depth=True)")
        return self._core.atom_depth

    @property
    def sas_components(self) -> int:
        """Closed pieces of the solvent-accessible surface."""
        return self._core.sas_components

    @property
    def largest_sas_piece(self) -> dict[str, float]:
        """Areas of patches that belong to the solvent-accessible piece with the largest area, Å².

        The names are ses_area, contact_area, toroidal_area and reentrant_area. Programs that roll one probe over the
        molecule call this the outer component.
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

    def interface_table(self, per: PerInterface = "residue") -> dict[str, list[Any]]:
        """What each side of each interface buries, as a list per column.

        Parameters
        ----------
        per : {"residue", "atom", "chain"}, default "residue"
            What has a row.

        Returns
        -------
        dict of str to list
            Areas alone and in the complex, and what is buried, Å²; the columns are in ``docs/conventions.md``.

        Raises
        ------
        UsageError
            If no interface was measured.
        """
        return self._asked_interfaces().table(self._structure._core, _options.word("per", per))

    def save_interfaces(self, path: Target, per: PerInterface = "residue", *, format: TableFormat | None = None) -> None:
        """Writes the table of interfaces as .csv or .json.

        Parameters
        ----------
        path : str, os.PathLike or file object
            Where to write.
        per : {"residue", "atom", "chain"}, default "residue"
            What has a row.
        format : {"csv", "json"}, optional
            The format, instead of that of the suffix; required for a file object without a name.

        Raises
        ------
        UsageError
            If no interface was measured.
        OSError
            If the file cannot be written.
        """
        _files.save_to(path, format, lambda inner: self._asked_interfaces().save(
            self._structure._core, inner, _options.word("per", per)))

    def _asked_interfaces(self) -> _core.Interfaces:
        if self._interfaces is None:
            raise UsageError("between: no interface was measured; ask for one with measure(..., between=('A', 'B'))")
        return self._interfaces

    def sum(self, selection: Selection) -> Sum:
        """Areas of some of the atoms, with the errors.

        For the errors, the first sum measures the molecule again, turned, which takes as long as :func:`measure`.

        Parameters
        ----------
        selection : str, array_like of bool, shape (n,), array_like of int, or MDAnalysis.AtomGroup
            Which atoms: in words, as :meth:`Structure.select` takes them; a mask; indices, each of which counts once; or
            atoms of the universe that the structure was made of, or of one with the same names, of which those that were
            left out count nothing.

        Returns
        -------
        Sum
            sas_area, ses_area, contact_area, toroidal_area and reentrant_area, Å².

        Raises
        ------
        UsageError
            For an expression that is not valid or selects nothing, a mask of another length, an index out of range and atoms
            of another universe.

        Examples
        --------
        >>> exact = meniscus.measure("1ubq.pdb")
        >>> tail = exact.sum("chain A and resi 72-76")
        >>> len(tail), round(tail.sas_area, 1), round(tail.ses_area, 1)
        (39, 674.6, 471.4)
        >>> numpy.isclose(exact.sum(exact.structure.element == "S").sas_area, exact.sum("[S]").sas_area)
        True
        """
        return sum_of(self, selection)

    def table(self, per: Per = "atom") -> dict[str, list[Any]]:
        """The measures of parts, as a list per column.

        Parameters
        ----------
        per : {"atom", "residue", "chain", "cavity"}, default "atom"
            What has a row.

        Returns
        -------
        dict of str to list
            Areas in Å², volumes in Å³; the columns are in ``docs/conventions.md``.

        Examples
        --------
        >>> rows = meniscus.measure(meniscus.read("1ubq.pdb")).table("residue")
        >>> rows["resname"][:3], [round(a, 1) for a in rows["sas_area"][:3]]
        (['MET', 'GLN', 'ILE'], [55.5, 75.3, 0.0])
        """
        return self._core.table(self._structure._core, _options.word("per", per))

    def to_pandas(self, per: Per = "atom") -> pandas.DataFrame:
        """The measures of parts as a table of pandas.

        Parameters
        ----------
        per : {"atom", "residue", "chain", "cavity"}, default "atom"
            What has a row.

        Returns
        -------
        pandas.DataFrame
            With the columns of :meth:`table`.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        from ._export import frame
        return frame(self.table(per))

    def save(self, path: Target, per: Per = "atom", *, format: TableFormat | None = None) -> None:
        """Writes a table as .csv or .json.

        Parameters
        ----------
        path : str, os.PathLike or file object
            Where to write.
        per : {"atom", "residue", "chain", "cavity"}, default "atom"
            What has a row.
        format : {"csv", "json"}, optional
            The format, instead of that of the suffix; required for a file object without a name.

        Raises
        ------
        OSError
            If the file cannot be written.
        """
        _files.save_to(path, format, lambda inner: self._core.save(
            self._structure._core, inner, _options.word("per", per)))


def checked(measures: Measures) -> Measures:
    """Warns if two evaluations do not agree."""
    if not measures.agreed:
        warn("exact measures: evaluations do not agree on " + ", ".join(measures.disputed), CheckWarning)
    return measures

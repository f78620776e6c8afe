# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Exact areas of parts of a structure."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import ArrayLike, Indices, as_array
from ._errors import UsageError
from ._structure import Structure

if TYPE_CHECKING:
    from ._foreign import _WithAtoms
    from ._measures import Measures

Selection = Union[str, ArrayLike, "_WithAtoms"]

_AREAS = ("sas_area", "ses_area", "contact_area", "toroidal_area", "reentrant_area")


@dataclasses.dataclass(frozen=True)
class Sum:
    """Exact areas of some of the atoms; made by :meth:`Measures.sum`. Areas in Å².

    Parameters
    ----------
    atoms : ndarray of int32, shape (k,)
        Indices of the atoms, ascending.
    sas_area : float
        Their shares of the solvent-accessible surface.
    ses_area : float
        Their shares of the solvent-excluded surface: the sum of the next three.
    contact_area : float
        Of contact patches.
    toroidal_area : float
        Of toroidal patches, which are divided where the two expanded spheres meet.
    reentrant_area : float
        Of reentrant patches, which are divided equally among the atoms.
    errors : dict of str to float
        Absolute error estimates by the same names, from the differences to the molecule turned. They are large where
        probe positions coincide, as on lattices: then it is arbitrary how patches are divided among atoms.
    """

    atoms: Indices = dataclasses.field(repr=False, compare=False)
    sas_area: float
    ses_area: float
    contact_area: float
    toroidal_area: float
    reentrant_area: float
    errors: dict[str, float] = dataclasses.field(repr=False, compare=False)

    def __len__(self) -> int:
        return len(self.atoms)


# A rotation whose rows are unit vectors to rounding.
_TURN = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
_TURNS_OF_DEGENERATE = 3  # one may divide patches as the molecule does by chance


def sum_of(measures: Measures, selection: Selection) -> Sum:
    """The errors are those of the whole and, as in it, three times the difference of another evaluation."""
    atoms = atoms_of(measures.structure, selection)
    areas = _areas(measures._core, atoms)
    if measures._turned is None:
        measures._turned = _measure_turned(measures)
    others = [_areas(turned, atoms) for turned in measures._turned]
    errors = {name: measures.errors[name] + 3 * max(abs(other[name] - area) for other in others)
              for name, area in areas.items()}
    return Sum(atoms=atoms, errors=errors, **areas)


def _areas(core: _core.Measures, atoms: Indices) -> dict[str, float]:
    """The areas of these atoms by their names."""
    shares = {name: float(getattr(core, f"atom_{name}")[atoms].sum()) for name in _AREAS if name != "ses_area"}
    return {**shares, "ses_area": sum(shares[name] for name in ("contact_area", "toroidal_area", "reentrant_area"))}


def _measure_turned(measures: Measures) -> list[_core.Measures]:
    """Turned, the molecule has the same areas, but other rounding and other perturbations. Without a library's product of
    matrices, whose last bits depend on the machine."""
    structure, xyz = measures.structure, measures.structure.xyz
    turned = []
    for _ in range(_TURNS_OF_DEGENERATE if measures.degenerate else 1):
        xyz = np.stack([xyz[:, 0] * row[0] + xyz[:, 1] * row[1] + xyz[:, 2] * row[2] for row in _TURN], axis=1)
        atoms = _core.from_arrays(xyz, structure.radii, {})
        turned.append(_core.exact_surface(atoms, measures._surface).measures(measures._surface["threads"]))
    return turned


def atoms_of(structure: Structure, selection: Any) -> Indices:
    """Indices of the selected atoms, ascending, each once."""
    if isinstance(selection, str):
        return structure.select(selection)
    if hasattr(selection, "universe"):
        return _of_universe(structure, selection)
    array = as_array("selection", selection)
    if array.ndim == 1 and array.dtype == np.bool_:
        return _of_mask(structure, array)
    if array.ndim != 1 or array.dtype.kind not in "iu" and array.size > 0:
        given = f"{array.dtype} of shape {array.shape}" if array.dtype != np.object_ else type(selection).__name__
        raise UsageError("selection: must be an expression, a mask of shape (n,), indices or atoms of MDAnalysis, not "
                         + given)
    return _of_indices(structure, array)


def _of_universe(structure: Structure, selection: Any) -> Indices:
    """Of atoms by their places in the universe; those that were left out have no area."""
    if structure._universe is None or not structure._universe.is_of(selection.universe, structure):
        raise UsageError("selection: atoms of MDAnalysis go with a structure made of atoms of the same universe")
    atoms = getattr(selection, "atoms", selection)  # those of residues are numbered otherwise than the residues
    return np.flatnonzero(np.isin(structure.index, atoms.ix)).astype(np.int32)


def _of_mask(structure: Structure, mask: npt.NDArray[Any]) -> Indices:
    if len(mask) != len(structure):
        raise UsageError(f"selection: a mask of {len(mask)} entries for {len(structure)} atoms")
    return np.flatnonzero(mask).astype(np.int32)


def _of_indices(structure: Structure, indices: npt.NDArray[Any]) -> Indices:
    if indices.size and not (-len(structure) <= indices.min() and indices.max() < len(structure)):
        raise UsageError(f"selection: an index is out of range; there are {len(structure)} atoms")
    chosen: Indices = np.unique(indices.astype(np.int64) % max(1, len(structure))).astype(np.int32)
    return chosen

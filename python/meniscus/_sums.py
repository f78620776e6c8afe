# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Exact areas of parts of a structure."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, Union

import numpy as np
import numpy.typing as npt

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
        Absolute error estimates by the same names. They are those of the whole surface, since the evaluations that they
        come from are compared as wholes.
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


def sum_of(measures: Measures, selection: Selection) -> Sum:
    atoms = atoms_of(measures.structure, selection)
    areas = {name: float(getattr(measures, "atom_" + name)[atoms].sum()) for name in _AREAS}
    return Sum(atoms=atoms, errors={name: measures.errors[name] for name in _AREAS}, **areas)


def atoms_of(structure: Structure, selection: Any) -> Indices:
    """Indices of the selected atoms, ascending, each once."""
    if isinstance(selection, str):
        return structure.select(selection)
    if hasattr(selection, "atoms"):  # those of residues are numbered otherwise than the residues
        return _of_places(structure, selection.atoms.ix)
    array = as_array("selection", selection)
    if array.ndim == 1 and array.dtype == np.bool_:
        return _of_mask(structure, array)
    if array.ndim != 1 or array.dtype.kind not in "iu" and array.size > 0:
        raise UsageError("selection: must be an expression, a mask of shape (n,), indices or atoms of MDAnalysis, not "
                         f"{array.dtype} of shape {array.shape}")
    return _of_indices(structure, array)


def _of_places(structure: Structure, places: Any) -> Indices:
    """Of atoms by their places in the universe; those that were left out have no area."""
    if structure._origin != "MDAnalysis":
        raise UsageError("selection: atoms of MDAnalysis go with a structure made of atoms of the same universe")
    return np.flatnonzero(np.isin(structure.index, places)).astype(np.int32)


def _of_mask(structure: Structure, mask: npt.NDArray[Any]) -> Indices:
    if len(mask) != len(structure):
        raise UsageError(f"selection: a mask of {len(mask)} entries for {len(structure)} atoms")
    return np.flatnonzero(mask).astype(np.int32)


def _of_indices(structure: Structure, indices: npt.NDArray[Any]) -> Indices:
    if indices.size and not (-len(structure) <= indices.min() and indices.max() < len(structure)):
        raise UsageError(f"selection: an index is out of range; there are {len(structure)} atoms")
    chosen: Indices = np.unique(indices.astype(np.int64) % max(1, len(structure))).astype(np.int32)
    return chosen

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Which universe of MDAnalysis the atoms of a structure are of."""
from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Any

from ._columns import columns_of
from ._foreign_atoms import columns_of_mdanalysis

if TYPE_CHECKING:
    from ._structure import Structure


class Origin:
    """A universe, which may be gone before the structure is: pickles do not bring it along."""

    def __init__(self, universe: Any) -> None:
        self._universe: weakref.ref[Any] | None = weakref.ref(universe)
        self._size = len(universe.atoms)

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_universe": None}

    def is_of(self, universe: Any, structure: Structure) -> bool:
        """Whether atoms of a universe have their places in this one: it is the same, or one with the same names."""
        if self._universe is not None and self._universe() is universe:
            return True
        return len(universe.atoms) == self._size and _have_names_of(structure, universe.atoms[structure.index])


def _have_names_of(structure: Structure, atoms: Any) -> bool:
    theirs = columns_of(columns_of_mdanalysis(atoms), len(atoms))
    return "name" in theirs and all(
        _comparable(theirs[column]) == _comparable(getattr(structure, column).tolist())
        for column in ("name", "resname", "resnum", "chain") if column in theirs)


def _comparable(column: list[Any]) -> list[str]:
    return [str(value).strip().upper() for value in column]

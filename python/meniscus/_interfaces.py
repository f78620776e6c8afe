# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Interfaces of chains and ligands, as part of exact measures."""
from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any, Optional, Union

from . import _core
from ._arrays import Floats, Indices
from ._errors import UsageError

Side = Union[str, Sequence[str]]
Between = Union[None, str, tuple[Side, Side], Sequence[Union[str, tuple[Side, Side]]]]
Pairs = Optional[list[tuple[list[str], list[str]]]]


@dataclasses.dataclass(frozen=True)
class Interface:
    """The interface of two groups of chains and ligands; made by :func:`measure`. Areas in Å².

    ``docs/conventions.md`` says what the areas mean.

    Parameters
    ----------
    a : tuple of str
        Chains and ligands of side A, as asked for.
    b : tuple of str
        Those of side B.
    sas_a : float
        Solvent-accessible area of side A alone.
    sas_b : float
        That of side B alone.
    sas_ab : float
        That of both together.
    buried_sas : float
        sas_a + sas_b - sas_ab.
    interface_area : float
        Half of it: per side, as usually quoted.
    ses_a : float
        Solvent-excluded area of side A alone.
    ses_b : float
        That of side B alone.
    ses_ab : float
        That of both together.
    buried_ses : float
        ses_a + ses_b - ses_ab.
    errors : dict of str to float
        Absolute error estimates of buried_sas and buried_ses.
    atoms_a : ndarray of int32, shape (k,)
        Indices of the atoms of side A.
    atoms_b : ndarray of int32, shape (l,)
        Those of side B.
    atom_buried_sas_a : ndarray of float64, shape (k,)
        Solvent-accessible area that each atom of side A loses.
    atom_buried_sas_b : ndarray of float64, shape (l,)
        That of side B.
    atom_buried_ses_a : ndarray of float64, shape (k,)
        Solvent-excluded area that each atom of side A loses.
    atom_buried_ses_b : ndarray of float64, shape (l,)
        That of side B.
    """

    a: tuple[str, ...]
    b: tuple[str, ...]
    sas_a: float
    sas_b: float
    sas_ab: float
    buried_sas: float
    interface_area: float
    ses_a: float
    ses_b: float
    ses_ab: float
    buried_ses: float
    errors: dict[str, float] = dataclasses.field(repr=False, compare=False)
    atoms_a: Indices = dataclasses.field(repr=False, compare=False)
    atoms_b: Indices = dataclasses.field(repr=False, compare=False)
    atom_buried_sas_a: Floats = dataclasses.field(repr=False, compare=False)
    atom_buried_sas_b: Floats = dataclasses.field(repr=False, compare=False)
    atom_buried_ses_a: Floats = dataclasses.field(repr=False, compare=False)
    atom_buried_ses_b: Floats = dataclasses.field(repr=False, compare=False)


def _names(side: Any) -> list[str]:
    """"A,(HEM,NAG)" and "chain A+B" as lists; a list is one already."""
    if isinstance(side, str):
        side = _core.split_group(side)
    names = list(side)
    if not names or not all(isinstance(name, str) and name for name in names):
        raise UsageError(f"between: {side!r} names no chains; write 'A', 'A,C', ['A', 'C'], or '(HEM)' for a ligand")
    return names


def _pair(value: Any) -> tuple[list[str], list[str]]:
    sides = value.split(":") if isinstance(value, str) else list(value)
    if len(sides) != 2:
        raise UsageError(f"between: {value!r} is not a pair of groups; write ('A', 'B'), 'A,C:B' or 'all'")
    return _names(sides[0]), _names(sides[1])


def pairs_of(between: Between) -> Pairs:
    """What is asked for as a list of pairs; None for every pair of chains that touch."""
    if isinstance(between, str):
        return None if between == "all" else [_pair(between)]
    values = list(between or [])
    return [_pair(values)] if _is_one_pair(values, isinstance(between, tuple)) else [_pair(value) for value in values]


def _is_one_pair(values: list[Any], is_tuple: bool) -> bool:
    """Of ("A", "B") and (["A", "C"], ["B"]), but not of ("A:B", "A:C") and (("A", "B"), ("A", "C"))."""
    if len(values) != 2:
        return False
    if any(isinstance(value, str) for value in values):
        return any(isinstance(value, str) and ":" not in value for value in values)
    return is_tuple and not all(isinstance(value, tuple) for value in values)

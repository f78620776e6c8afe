# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Names and numbers of atoms, one of each per atom."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from ._arrays import ArrayLike, one_per, texts, whole_per

Texts = Union[str, Iterable[str]]
Strings = npt.NDArray[np.str_]
Whole = Union[Sequence[int], ArrayLike]

_TEXTS = ("element", "name", "resname", "icode", "chain", "altloc")


def columns_of(given: dict[str, Any], count: int) -> dict[str, Any]:
    """Names and numbers of atoms as the extension takes them, without those that are None."""
    columns: dict[str, Any] = {}
    for key, values in given.items():
        if values is None:
            continue
        if key in _TEXTS:
            columns[key] = texts(key, values, count)
        elif key in ("resnum", "serial"):
            columns[key] = whole_per(key, values, count)
        elif key in ("hetero", "in_polymer"):
            columns[key] = [bool(value) for value in values]
        else:
            columns[key] = one_per(key, values, count).tolist()
    return columns

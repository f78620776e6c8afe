# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Options as the extension takes them: of the right type, and only those that were given."""
from __future__ import annotations

import math
import numbers
import operator
import re
from collections.abc import Iterable
from typing import Any

import numpy as np

from ._errors import UsageError

_UNITS = {"": 1, "M": 1, "MB": 1, "MiB": 1, "G": 1024, "GB": 1024, "GiB": 1024, "T": 1024**2, "TB": 1024**2}


def number(name: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name}: must be a number, not {value!r}")
    try:
        return float(value)
    except OverflowError:
        raise UsageError(f"{name}: the number is too large") from None


def _index(name: str, value: Any) -> int:
    try:
        if isinstance(value, bool):
            raise TypeError
        return operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: must be a whole number, not {value!r}") from None


def whole(name: str, value: Any) -> int:
    result = _index(name, value)
    if not -(2**31) <= result < 2**31:
        raise UsageError(f"{name}: {result} is too large")
    return result


def count(name: str, value: Any) -> int:
    """From 0, which leaves it open."""
    result = whole(name, value)
    if result < 0:
        raise UsageError(f"{name} {result}: must be 0 (all cores) or more")
    return result


def seed(value: Any) -> int:
    result = _index("seed", value)
    if not 0 <= result < 2**64:
        raise UsageError(f"seed {result}: must be from 0 to 2**64 - 1")
    return result


def from_one(name: str, value: Any) -> int:
    result = whole(name, value)
    if result < 1:
        raise UsageError(f"{name}: must be a whole number of at least 1, not {result}")
    return result


def flag(name: str, value: Any) -> bool:
    """Python's and numpy's True and False, and 1 and 0."""
    if isinstance(value, (bool, np.bool_)) or isinstance(value, int) and value in (0, 1):
        return bool(value)
    raise TypeError(f"{name}: must be True or False, not {value!r}")


def word(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name}: must be text, not {value!r}")
    return value


def some(name: str, value: Any) -> str:
    if not word(name, value):
        raise UsageError(f"{name}: empty; leave it out, or give it a value")
    return str(value)


def character(name: str, value: Any) -> str:
    if len(word(name, value).encode("utf-8", "surrogateescape")) != 1:
        raise UsageError(f"{name}: must be one character, not {value!r}")
    return str(value)


def one_of(name: str, value: Any, words: Iterable[str]) -> str:
    if word(name, value) not in words:
        raise UsageError(f"{name}: unknown value '{value}'; choose one of {', '.join(words)}")
    return str(value)


def positive(name: str, value: Any) -> float:
    result = number(name, value)
    if not (math.isfinite(result) and result > 0):
        raise UsageError(f"{name}: must be a finite number greater than 0, not {value}")
    return result


def not_negative(name: str, value: Any) -> float:
    result = number(name, value)
    if not (math.isfinite(result) and result >= 0):
        raise UsageError(f"{name} {value:g}: must be finite and not negative")
    return result


def megabytes(name: str, value: Any) -> int:
    """4G, 500M, or a number of MB."""
    match = re.fullmatch(r"([0-9]+\.?[0-9]*|\.[0-9]+)([A-Za-z]*)", str(value))
    amount = float(match[1]) * _UNITS.get(match[2], 0) if match else 0.0
    if not 1 <= amount < 1e15:
        raise UsageError(f"{name}: must be an amount of memory of at least 1M, such as 4G or 500M, not '{value}'")
    return int(amount)


def chains(value: Any) -> list[str]:
    if not isinstance(value, Iterable) or isinstance(value, bytes):
        raise TypeError(f"chains: must be text or a list of texts, not {value!r}")
    names = value.split(",") if isinstance(value, str) else [word("chains", name) for name in value]
    if not names or "" in names:
        raise UsageError(f"chains: empty name in {value!r}; write 'A,B' or ['A', 'B']")
    return names

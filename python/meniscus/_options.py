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


def word(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name}: must be text, not {value!r}")
    return value


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
    names = value.split(",") if isinstance(value, str) else [str(name) for name in value]
    if not names or "" in names:
        raise UsageError(f"chains: empty name in {value!r}; write 'A,B' or ['A', 'B']")
    return names

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Arrays at the border: checked by type, shape and value, copied only where they have to be converted."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Protocol, Union

import numpy as np
import numpy.typing as npt

from ._errors import UsageError
from ._options import flag

Floats = npt.NDArray[np.float64]
Singles = npt.NDArray[np.float32]
Indices = npt.NDArray[np.int32]

_CPU = 1  # DLPack's number of it; 3 is memory of the CPU that is pinned for a GPU
_PINNED = 3


class SupportsDLPack(Protocol):
    """An array of PyTorch, JAX, CuPy ..."""

    def __dlpack__(self, *, stream: Any = None) -> Any: ...

    def __dlpack_device__(self) -> Any: ...


ArrayLike = Union[npt.ArrayLike, SupportsDLPack]


def as_array(name: str, values: Any) -> npt.NDArray[Any]:
    """Anything that numpy takes, or that speaks DLPack in memory of the CPU."""
    if isinstance(values, np.ma.MaskedArray) and np.any(values.mask):
        raise UsageError(f"{name}: some entries are masked; leave them out")
    if hasattr(values, "__dlpack_device__") and not isinstance(values, np.ndarray):
        if int(values.__dlpack_device__()[0]) not in (_CPU, _PINNED):
            raise UsageError(f"{name}: lies in the memory of another device; copy it to the CPU first")
        if not hasattr(values, "__array__"):
            return np.from_dlpack(values)
    try:
        return np.asarray(values)
    except ValueError as error:
        raise UsageError(f"{name}: rows have different lengths; an array of numbers is needed") from error
    except RuntimeError as error:  # PyTorch's of tensors that require gradients
        raise UsageError(f"{name}: cannot become an array: {error}") from error


def _numbers(name: str, values: Any) -> npt.NDArray[Any]:
    array = as_array(name, values)
    if array.dtype.kind not in "fiu" and array.size > 0:
        raise UsageError(f"{name}: numbers are needed, not {array.dtype}")
    return array


def _finite(name: str, array: npt.NDArray[Any]) -> Floats:
    result = np.ascontiguousarray(array, dtype=np.float64)
    if not np.isfinite(result).all():
        first = int(np.argwhere(~np.isfinite(result))[0][0])
        raise UsageError(f"{name}: entry {first} is not finite")
    return result


def positions(name: str, values: Any) -> Floats:
    """Shape (n, 3), finite; lists and arrays of any real type are converted."""
    array = _numbers(name, values)
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise UsageError(f"{name}: must have shape (n, 3), not {array.shape}")
    return _finite(name, array)


def one_per(name: str, values: Any, count: int) -> Floats:
    """Shape (count,), finite; a single number stands for all."""
    array = _numbers(name, values)
    if array.ndim == 0:
        array = np.broadcast_to(array, (count,))
    if array.shape != (count,):
        raise UsageError(f"{name}: must have shape ({count},), one per atom, not {array.shape}")
    return _finite(name, array)


def whole_per(name: str, values: Any, count: int) -> list[int]:
    """Shape (count,), whole numbers of 32 bits; a single number stands for all."""
    array = one_per(name, values, count)
    wrong = (array != np.rint(array)) | (np.abs(array) >= 2**31)
    if wrong.any():
        raise UsageError(f"{name}: entry {int(np.argmax(wrong))} is not a 32-bit whole number")
    return [int(value) for value in array]


def _text(name: str, value: Any) -> str:
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    if value is None or value is np.ma.masked:
        raise UsageError(f"{name}: {'None' if value is None else 'a masked entry'} is not text; write ''")
    return str(value)


def texts(name: str, values: Any, count: int) -> list[str]:
    """One text per atom, bytes as UTF-8; one text stands for all."""
    if isinstance(values, (str, bytes)):
        return [_text(name, values)] * count
    result = [_text(name, value) for value in values]
    if len(result) != count:
        raise UsageError(f"{name}: {len(result)} entries for {count} atoms")
    return result


def arrays_of(owner: object, names: Iterable[str], copy: bool) -> dict[str, npt.NDArray[Any]]:
    """Attributes that are arrays, by name; copied, they may be written to."""
    arrays = {name: getattr(owner, name) for name in names}
    return {name: np.array(array, copy=True) for name, array in arrays.items()} if flag("copy", copy) else arrays

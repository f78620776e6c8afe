# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What functions take as atoms: a structure, a file, an object of another package, or centres and radii."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, Union

import numpy as np

from . import _files, _foreign
from ._arrays import ArrayLike
from ._errors import UsageError
from ._files import Path, Source
from ._nouns import of_kind
from ._reading import READ_DEFAULTS, ReadOptions, read_as_asked
from ._structure import Structure

Atoms = Union[Structure, Source, ArrayLike, "_foreign.ForeignObject"]
Radii = Union[ArrayLike, Path]


def check_reading(reading: Mapping[str, object], options: ReadOptions | None, has_source: bool) -> None:
    """Refuses what is no keyword of read(), and all of them where there is nothing to read."""
    for name in reading:
        if name not in READ_DEFAULTS and name != "frame":
            raise TypeError(f"unexpected keyword argument {name!r}")
        if not has_source:
            raise TypeError(f"{name} is an argument of read(); it applies where the path of a structure is given")
    if options is not None and not has_source:
        raise TypeError("reading: applies where the path of a structure is given")


def is_source(atoms: object) -> bool:
    """Whether this has to be read: a path, an open file, or an object of another package."""
    return isinstance(atoms, (str, os.PathLike)) or _files.is_file(atoms) or _foreign.is_foreign(atoms)


def read_source(source: Any, reading: Mapping[str, Any], options: ReadOptions | None) -> Structure:
    """The structure of what is_source() tells."""
    check_reading(reading, options, has_source=True)
    given = dict(reading)
    frame = given.pop("frame", None)
    asked = of_kind("reading", options, ReadOptions).replace(**given)
    if _foreign.is_foreign(source):
        return _foreign.structure_of(source, frame, asked)
    if frame is not None:
        raise TypeError("frame: goes with trajectories of other packages; of a file, model=N is read")
    return read_as_asked(source, asked)


def _set_for_source(sizes: Radii | None) -> Mapping[str, object]:
    if sizes is None:
        return {}
    if not isinstance(sizes, (str, os.PathLike)):
        raise UsageError("radii: with a file, the name of a set such as 'bondi'; numbers go with an array of centres")
    return {"radii": sizes}


def _check_type(atoms: Any) -> None:
    """Refuses what is neither a list nor an array, such as None, bytes or a Surface."""
    if isinstance(atoms, (list, tuple)) or hasattr(atoms, "__dlpack__"):
        return
    if not isinstance(atoms, (bytes, bytearray)) and np.ndim(atoms) > 0:
        return
    hint = "; its atoms are its .structure" if isinstance(getattr(atoms, "structure", None), Structure) else ""
    raise TypeError("atoms: must be a Structure, the path of a file, or centres of shape (n, 3), not "
                    f"{type(atoms).__name__}{hint}")


def as_structure(atoms: Atoms, sizes: Radii | None, reading: Mapping[str, object],
                 options: ReadOptions | None = None) -> Structure:
    """What the functions take as atoms, as a structure."""
    if is_source(atoms):
        return read_source(atoms, {**_set_for_source(sizes), **reading}, options)
    check_reading(reading, options, has_source=False)
    if isinstance(atoms, Structure):
        if sizes is not None:
            raise UsageError("radii: a Structure has its own radii; make another with Structure.from_arrays")
        return atoms
    _check_type(atoms)
    if sizes is None:
        raise TypeError("radii: required with an array of centres, (n,) in Å; meniscus.radii() gives those of elements")
    if isinstance(sizes, (str, os.PathLike)):
        raise TypeError(f"radii: must be numbers with an array of centres; see meniscus.radii(set={sizes!r})")
    return Structure.from_arrays(atoms, sizes)  # type: ignore[arg-type]


def read_for_pockets(atoms: Atoms, radii: Radii | None, reading: ReadOptions | None,
                     keywords: Mapping[str, Any]) -> tuple[Radii | None, Mapping[str, Any]]:
    """United radii and no hetero atoms, as the ranking of pockets was fitted, where something is read and the caller
    does not say otherwise."""
    if not is_source(atoms):
        return radii, keywords
    if radii is None and (reading is None or reading.radii == "auto"):
        radii = "united"
    if "hetero" not in keywords and (reading is None or reading.hetero is None):
        keywords = {**keywords, "hetero": "none"}
    return radii, keywords


def read_whole(atoms: Atoms, radii: Radii | None, keywords: Mapping[str, Any], reading: ReadOptions | None) -> Structure:
    """What a structure was read from, with all its chains and hetero atoms.

    atoms, radii, keywords, reading     as those that as_structure() made the structure of
    """
    of_all: dict[str, Any] = {"hetero": "all", "chains": None, "select": None, "strict_radii": False}
    if isinstance(atoms, Structure) and atoms._reading is not None:
        whole = read_as_asked(atoms.file, atoms._reading.replace(**of_all))
        if whole.sha256 != atoms.sha256:
            raise UsageError(f"at: {atoms.file} has changed since the structure was read")
        return whole
    if not is_source(atoms) or atoms == "-":
        raise UsageError("at: a selection needs a file that can be read again, for its ligands; give a path, a Structure "
                         "read from one, or points")
    return as_structure(atoms, radii, {**keywords, **of_all}, reading)

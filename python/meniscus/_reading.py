# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Structure files, and what is kept of them."""
from __future__ import annotations

import dataclasses
import pathlib
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal, TypedDict, TypeVar, get_args

from . import _core, _files, _options
from ._choices import Hetero, Hydrogens, RadiusSet, ReadFormat
from ._columns import Texts
from ._errors import InputError, ReadWarning, UsageError, text_of_path, unreadable, warn
from ._files import Path, Source
from ._meshing import with_keywords
from ._nouns import Noun, defaults_of, of_kind
from ._structure import Structure

if TYPE_CHECKING:
    from typing_extensions import Unpack

Made = TypeVar("Made")


class _Choice(TypedDict, total=False):
    """The names of :class:`ReadOptions` beside radii as keywords."""

    hydrogens: Hydrogens
    model: int | Literal["join"]
    assembly: str | int | None
    altloc: str | None
    chains: Texts | None
    select: str | None
    hetero: Hetero | None
    waters: bool | None
    strict_radii: bool


class Reading(_Choice, total=False):
    """What every function takes that takes a structure's path: radii are an argument of their own there, and ``frame``
    goes with objects of other packages."""

    frame: int | None


class ReadingOfFile(_Choice, total=False):
    """The names of :class:`ReadOptions` as keywords."""

    radii: RadiusSet | Path


@dataclasses.dataclass(frozen=True, repr=False)
class ReadOptions(Noun):
    """What to keep of a structure, and which radii its atoms get.

    The words and defaults are those of the command line (``docs/conventions.md``). Immutable; equal to another with the
    same values.

    Parameters
    ----------
    radii : {"auto", "bondi", "united", "protor", "naccess", "parse"} or path of a file of rules, default "auto"
        auto: the file's own, else bondi if the structure has hydrogens, else united.
    hydrogens : {"auto", "keep", "drop"}, default "auto"
        auto: as the radii require.
    model : int or "join", default 1
        The model to read, counted from 1; "join" puts all together, copies of chain A being A-2, A-3 ... Files only.
    assembly : str or int, optional
        The biological assembly of this name in the file. Files only.
    altloc : str, optional
        The alternative location to use, one character; by default the one with the highest occupancy.
    chains : str or sequence of str, optional
        "A,B" or a list; "label:A" for mmCIF label names.
    select : str, optional
        The atoms to keep, in gemmi's syntax, "//A/10-50", "CA", "(ALA,GLY)", or in the words of PyMOL and VMD.
    hetero : {"none", "ligands", "all"}, optional
        Atoms beside the polymer. By default none, but all of PQR files and of those that have neither protein nor nucleic
        acid.
    waters : bool, optional
        Whether to keep waters. By default they are left out, but those of PQR files are kept, with a warning.
    strict_radii : bool, default False
        Treat an atom of unknown type as an error.

    Raises
    ------
    TypeError
        For a value of another type.
    UsageError
        For a value out of range, an unknown word, and for what makes no sense together.

    Examples
    --------
    >>> wet = meniscus.ReadOptions(waters=True)
    >>> wet
    ReadOptions(waters=True)
    >>> len(meniscus.read("1ubq.pdb", options=wet)), len(meniscus.read("1ubq.pdb", options=wet.replace(select="CA")))
    (660, 76)
    """

    radii: RadiusSet | Path = "auto"
    hydrogens: Hydrogens = "auto"
    model: int | Literal["join"] = 1
    assembly: str | int | None = None
    altloc: str | None = None
    chains: Texts | None = None
    select: str | None = None
    hetero: Hetero | None = None
    waters: bool | None = None
    strict_radii: bool = False

    def __post_init__(self) -> None:
        self._set_defaults()
        if self.chains is not None and not isinstance(self.chains, str):
            object.__setattr__(self, "chains", tuple(_options.chains(self.chains)))
        self._for_core()

    def replace(self, **changes: Unpack[ReadingOfFile]) -> ReadOptions:
        """Other options, with some values changed.

        Parameters
        ----------
        **changes
            New values by the names of the options.

        Returns
        -------
        ReadOptions
        """
        return self._changed(changes)

    def _for_core(self) -> dict[str, Any]:
        joins = isinstance(self.model, str) and self.model == "join"
        if isinstance(self.model, str) and not joins:
            raise TypeError(f"model: must be a whole number or \"join\", not {self.model!r}; read_models() reads every "
                            "model")
        if joins and self.assembly is not None:
            raise UsageError('model="join": the models of a file are not to be copied by assembly; give one of the two')
        options = {"radii": text_of_path(self.radii), "join_models": joins,
                   **({} if joins else {"model": _options.from_one("model", self.model)})}
        given = {name: getattr(self, name) for name in _CHECKS}
        return {**options, **{name: _CHECKS[name](name, value) for name, value in given.items() if value is not None}}


def _word(name: str, value: Any) -> str:
    return _options.one_of(name, value, _core.words[name])


def _name_or_number(name: str, value: Any) -> str:
    return _options.some(name, value if isinstance(value, str) else str(_options.whole(name, value)))


_CHECKS: dict[str, Callable[[str, Any], Any]] = {
    "hydrogens": _word,
    "strict_radii": _options.flag,
    "assembly": _name_or_number,
    "altloc": _options.character,
    "chains": lambda name, value: _options.chains(value),
    "select": _options.some,
    "hetero": _word,
    "waters": _options.flag,
}


READ_DEFAULTS = defaults_of(ReadOptions)
_OF_MODELS = {name: default for name, default in READ_DEFAULTS.items() if name != "model"}


@with_keywords(READ_DEFAULTS)
def read(
    path: Source,
    *,
    options: ReadOptions | None = None,
    format: ReadFormat | None = None,
    name: str | None = None,
    **keywords: Unpack[ReadingOfFile],
) -> Structure:
    """Reads PDB, mmCIF, BinaryCIF, GROMACS, PDBQT, PQR, xyzr or xyzrn, each possibly gzipped.

    What was assumed and may make a number wrong is a :class:`ReadWarning`, and kept in ``Structure.warnings``. What
    happens with every ordinary file is in ``Structure.notes`` alone. Atoms that were left out are counted in
    ``Structure.dropped``. Other Python threads keep running.

    Parameters
    ----------
    path : str, os.PathLike or file object
        The file; "-" is standard input. Of an open file, io.BytesIO, io.StringIO or gzip.GzipFile all is read that is
        still to be read.
    options : ReadOptions, optional
        What to keep, and which radii.
    format : {"pdb", "cif", "bcif", "gro", "pdbqt", "pqr", "xyzr", "xyzrn"}, optional
        The format, where neither the name nor, of a file object, the content tells: PQR without REMARK, xyzrn.
    name : str, optional
        What messages and ``Structure.file`` call the file; its suffix is a format, too.
    **keywords
        The members of :class:`ReadOptions`; they replace those of ``options``.

    Returns
    -------
    Structure

    Raises
    ------
    InputError
        For a file that is not valid: "FILE:LINE:COLUMN: what is wrong; what to do". A ValueError.
    OSError
        For a file that cannot be opened: FileNotFoundError, PermissionError ...
    UsageError
        For an option that makes no sense.

    Examples
    --------
    >>> calphas = meniscus.read("1ubq.pdb", select="CA", radii="united")
    >>> len(calphas), calphas.radii_set
    (76, 'united')
    >>> with open("1ubq.pdb", "rb") as file:
    ...     meniscus.read(file)
    <meniscus.Structure 1ubq: 602 atoms, 76 residues, radii united>
    """
    asked = of_kind("options", options, ReadOptions).replace(**keywords)
    return read_as_asked(path, asked, format, name)


@with_keywords(_OF_MODELS)
def read_models(
    path: Source,
    *,
    options: ReadOptions | None = None,
    format: ReadFormat | None = None,
    name: str | None = None,
    **keywords: Unpack[ReadingOfFile],
) -> list[Structure]:
    """Reads all models of a file, each as a structure of its own.

    Parameters
    ----------
    path : str, os.PathLike or file object
        The file, as for :func:`read`.
    options : ReadOptions, optional
        What to keep, and which radii; ``model`` does not matter.
    format : str, optional
        The format, as for :func:`read`.
    name : str, optional
        The name, as for :func:`read`.
    **keywords
        The members of :class:`ReadOptions` but ``model``; they replace those of ``options``.

    Returns
    -------
    list of Structure
        In the order of the file; ``stem`` ends in _m01, _m02 ...

    Raises
    ------
    InputError
        For a file that is not valid, at the first model that cannot be read.
    OSError
        For a file that cannot be opened.
    UsageError
        For an option that makes no sense.

    Examples
    --------
    >>> [model.stem for model in meniscus.read_models("1ubq.pdb")]
    ['1ubq_m01']
    """
    if "model" in keywords:
        raise TypeError("unexpected keyword argument 'model': every model is read")
    given = of_kind("options", options, ReadOptions).replace(**keywords).replace(model=1)
    asked = given._for_core()
    is_in_memory = _is_in_memory(path, format, name)
    if is_in_memory:
        cores = _core.read_models_of_bytes(*_content_and_name(path, format, name), asked)
    else:
        cores = _opened(path, lambda text: _core.read_models(text, asked))
    structures = [Structure(core) for core in cores]
    if not is_in_memory and path != "-":
        for number, structure in enumerate(structures, 1):
            structure._reading = given.replace(model=number)
    warn_of(structures)
    return structures


def read_as_asked(source: Source, options: ReadOptions, format: str | None = None, name: str | None = None) -> Structure:
    """As read() does, with options that are put together."""
    asked = options._for_core()
    if _is_in_memory(source, format, name):
        structure = Structure(_core.read_bytes(*_content_and_name(source, format, name), asked))
    else:
        structure = Structure(_opened(source, lambda text: _core.read(text, asked)))
        if source != "-":
            structure._reading = options
    warn_of([structure])
    return structure


def _opened(path: Any, read_path: Callable[[str], Made]) -> Made:
    text = text_of_path(path)
    try:
        return read_path(text)
    except InputError as error:
        raise (unreadable(text, str(error)) if text != "-" else None) or error from None


_SUFFIXES = tuple("." + format for format in get_args(ReadFormat))


def _is_in_memory(source: Source, format: str | None, name: str | None) -> bool:
    """Whether the bytes are read here: of an open file, and of a path that does not tell the format."""
    return _files.is_file(source) or format is not None or name is not None


def _content_and_name(source: Any, format: str | None, name: str | None) -> tuple[bytes, str]:
    if _files.is_file(source):
        data, called = _files.content_of(source), _options.word("name", name or _files.name_of(source))
    else:
        path = text_of_path(source)
        data = sys.stdin.buffer.read() if path == "-" else pathlib.Path(path).read_bytes()
        called = _options.word("name", name or ("" if path == "-" else path))
    return data, _named(called, data, format, is_told=bool(name))


def _named(called: str, data: bytes, format: str | None, is_told: bool) -> str:
    """What bytes are called; in angle brackets where their name does not tell the format."""
    if called.lower().endswith(".gz"):
        called = called[:-3]
    if format is not None:
        suffix = "." + _options.one_of("format", format, get_args(ReadFormat))
        called = called if called.lower().endswith(suffix) else (called or "data") + suffix
    elif not (is_told or called.lower().rstrip("0123456789").endswith(_SUFFIXES)):
        return "<data>"
    # What gzip.open() gives is decompressed already, under the name of what is not.
    return called + ".gz" if data.startswith(b"\x1f\x8b") else called


def warn_of(structures: list[Structure]) -> None:
    """Warns of what may make a number of structures wrong, of each only once."""
    for line in dict.fromkeys(line for structure in structures for line in structure.warnings):
        warn(line, ReadWarning)

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Atoms with radii and names: read from files, or made of arrays."""
from __future__ import annotations

import inspect
import os
import pathlib
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypedDict, Union

import numpy as np
import numpy.typing as npt

from . import _core, _options
from ._arrays import Floats, arrays_of, one_per, positions, texts, whole_per
from ._errors import InputError, ReadWarning, UsageError, text_of_path, unreadable

Path = Union[str, "os.PathLike[str]"]
Texts = Union[str, Iterable[str]]
Strings = npt.NDArray[np.str_]


class Structure:
    """Atoms with radii and, where known, their names; made by :func:`read` or :meth:`from_arrays`.

    Every column has one entry per kept atom, in the order of the file:

    ========== =================================================
    xyz        (n, 3) float64, Å; a read-only view
    radii      (n,) float64, Å; a read-only view
    element    (n,) text, upper case; empty where unknown
    name       (n,) text: CA, OXT
    chain      (n,) text; copies of an assembly or in joined models are A, A-2, A-3
    resname    (n,) text: ALA
    resnum     (n,) int32, as in the file
    icode      (n,) text; blank if there is none
    residue    (n,) int32, from 0, over the kept residues
    altloc     (n,) text; blank if there is none
    serial     (n,) int32
    b_factor   (n,) float64
    occupancy  (n,) float64
    charge     (n,) float64, e
    ========== =================================================

    >>> protein = meniscus.read("1ubq.pdb")
    >>> protein
    <meniscus.Structure 1ubq: 602 atoms, 76 residues, radii united>
    >>> protein.xyz.shape, protein.name[:3].tolist(), protein.resname[0]
    ((602, 3), ['N', 'CA', 'C'], 'MET')
    """

    def __init__(self, core: _core.Structure) -> None:
        self._core = core
        self._residues: dict[str, Any] | None = None

    def __getstate__(self) -> dict[str, Any]:
        return {"_core": self._core, "_residues": None}

    @classmethod
    def from_arrays(
        cls,
        xyz: npt.ArrayLike,
        radii: npt.ArrayLike | str = "bondi",
        *,
        element: Texts | None = None,
        name: Texts | None = None,
        resname: Texts | None = None,
        resnum: Sequence[int] | npt.ArrayLike | None = None,
        icode: Texts | None = None,
        chain: Texts | None = None,
        serial: Sequence[int] | npt.ArrayLike | None = None,
        b_factor: npt.ArrayLike | None = None,
        occupancy: npt.ArrayLike | None = None,
        charge: npt.ArrayLike | None = None,
    ) -> Structure:
        """Makes a structure of atoms from another program.

        xyz     (n, 3), Å
        radii   (n,), Å, or one number for all, or the name of a set: see :func:`radii`
        others  (n,) each, or one text for all; what is not given is left empty. Residues are runs of atoms with the
                same chain, resname, resnum and icode

        >>> water = meniscus.Structure.from_arrays([[0, 0, 0], [0.96, 0, 0], [-0.24, 0.93, 0]], element=["O", "H", "H"])
        >>> water.radii.tolist()
        [1.52, 1.2, 1.2]
        """
        centres = positions("xyz", xyz)
        n = len(centres)
        columns: dict[str, Any] = {}
        for key, words in (("element", element), ("name", name), ("resname", resname), ("icode", icode),
                           ("chain", chain)):
            if words is not None:
                columns[key] = texts(key, words, n)
        for key, values in (("resnum", resnum), ("serial", serial)):
            if values is not None:
                columns[key] = whole_per(key, values, n)
        for key, values in (("b_factor", b_factor), ("occupancy", occupancy), ("charge", charge)):
            if values is not None:
                columns[key] = one_per(key, values, n).tolist()
        if isinstance(radii, str):
            empty = [""] * n
            sizes = _core.radii(columns.get("element", empty), columns.get("name", empty),
                                columns.get("resname", empty), radii)
        else:
            sizes = one_per("radii", radii, n)
        return cls(_core.from_arrays(centres, sizes, columns))

    def __len__(self) -> int:
        return len(self._core)

    def __repr__(self) -> str:
        label = self.stem or "from arrays"
        return (f"<meniscus.Structure {label}: {len(self)} atoms, {len(self._per_residue['name'])} residues, "
                f"radii {self.radii_set}>")

    @property
    def file(self) -> str:
        """Path of the file, as given; empty for arrays."""
        return self._core.file

    @property
    def stem(self) -> str:
        """Name of the file without folder and suffix."""
        return self._core.name

    @property
    def sha256(self) -> str:
        """SHA-256 of the file, hexadecimal."""
        return self._core.sha256

    @property
    def radii_set(self) -> str:
        """The radius set in use: bondi, united ..., "file" for radii from PQR or xyzr, "given" for arrays."""
        return self._core.radii_set

    @property
    def dropped(self) -> dict[str, int]:
        """How many atoms were left out, by reason.

        >>> meniscus.read("1ubq.pdb").dropped
        {'waters': 58}
        """
        return self._core.dropped

    @property
    def notes(self) -> list[str]:
        """What was done as with every ordinary file, such as waters left out: one line per kind.

        >>> meniscus.read("1ubq.pdb").notes
        ['58 waters left out (keep them with waters=True)']
        """
        return self._core.notes

    @property
    def warnings(self) -> list[str]:
        """What was assumed while reading and may make a number wrong: one line per kind, each also a ReadWarning."""
        return self._core.warnings

    @property
    def xyz(self) -> Floats:
        return self._core.xyz

    @property
    def radii(self) -> Floats:
        return self._core.radii

    @property
    def element(self) -> Strings:
        return np.array(self._core.element, dtype=np.str_)

    @property
    def name(self) -> Strings:
        return np.array(self._core.name_of_atoms, dtype=np.str_)

    @property
    def altloc(self) -> Strings:
        return np.array(self._core.altloc, dtype=np.str_)

    @property
    def residue(self) -> npt.NDArray[np.int32]:
        return self._core.residue

    @property
    def serial(self) -> npt.NDArray[np.int32]:
        return self._core.serial

    @property
    def b_factor(self) -> Floats:
        return self._core.b_factor

    @property
    def occupancy(self) -> Floats:
        return self._core.occupancy

    @property
    def charge(self) -> Floats:
        return self._core.charge

    def numpy(self, copy: bool = False) -> dict[str, npt.NDArray[Any]]:
        """The columns of numbers by their names: xyz, radii, resnum, residue, serial, b_factor, occupancy, charge.

        copy  arrays of their own, which may be written to and which ``torch.from_numpy`` takes without a warning

        >>> meniscus.read("1ubq.pdb").numpy(copy=True)["xyz"].flags.writeable
        True
        """
        names = ("xyz", "radii", "resnum", "residue", "serial", "b_factor", "occupancy", "charge")
        return arrays_of(self, names, copy)

    @property
    def _per_residue(self) -> dict[str, Any]:
        if self._residues is None:
            columns = self._core.residues
            self._residues = {key: np.asarray(columns[key]) for key in ("chain", "name", "number", "icode")}
        return self._residues

    def _of_residues(self, key: str) -> npt.NDArray[Any]:
        column: npt.NDArray[Any] = self._per_residue[key]
        return column[self.residue] if len(self) else column

    @property
    def chain(self) -> Strings:
        return self._of_residues("chain")

    @property
    def resname(self) -> Strings:
        return self._of_residues("name")

    @property
    def resnum(self) -> npt.NDArray[np.int32]:
        return self._of_residues("number")

    @property
    def icode(self) -> Strings:
        return self._of_residues("icode")

    def split_chains(self) -> list[Structure]:
        """One structure per chain, with the radii that the atoms have here.

        >>> [chain.chain[0] for chain in meniscus.read("1ubq.pdb").split_chains()]
        ['A']
        """
        return [Structure(core) for core in _core.split_chains(self._core)]

    def save(self, path: Path, values: npt.ArrayLike | None = None) -> None:
        """Writes the atoms, in the format of the suffix.

        .xyzr .xyzrn  centres and radii
        .csv          the table of atoms, which a mesh's ``atom`` indexes
        .pdb .cif     the atoms, with ``values``, (n,), instead of the B factor

        Raises OSError if the file cannot be written; no partial file is left behind.
        """
        text = text_of_path(path)
        suffix = pathlib.PurePath(text).suffix
        if suffix in (".xyzr", ".xyzrn"):
            _core.write_spheres(text, self._core)
        elif suffix == ".csv":
            _core.write_atom_table(text, self._core)
        elif suffix in (".pdb", ".cif"):
            column = self.b_factor if values is None else one_per("values", values, len(self))
            _core.write_structure_copy(text, self._core, column)
        else:
            raise UsageError(f"{text}: unknown suffix; choose one of .xyzr .xyzrn .csv .pdb .cif")


def read(
    path: Path,
    *,
    radii: Path = "auto",
    hydrogens: str = "auto",
    model: int | str = 1,
    assembly: str | int | None = None,
    altloc: str | None = None,
    chains: Texts | None = None,
    select: str | None = None,
    hetero: str | None = None,
    waters: bool | None = None,
    strict_radii: bool = False,
) -> Structure:
    """Reads PDB, mmCIF, BinaryCIF, GROMACS, PDBQT, PQR, xyzr or xyzrn, each possibly gzipped; "-" reads standard input.

    The options, their words and defaults are those of the command line (``docs/conventions.md``).

    radii         bondi, united, protor, naccess, parse, a file of rules, or auto: the file's own, else bondi if the
                  structure has hydrogens, else united
    hydrogens     auto (as the radii require), keep or drop
    model         model to read, counted from 1; "join" puts all together, copies of chain A being A-2, A-3 ...;
                  :func:`read_models` reads each as a structure of its own
    assembly      biological assembly named in the file
    altloc        alternative location to use, one character; by default the one with the highest occupancy
    chains        "A,B" or a list; "label:A" for mmCIF label names
    select        atoms to keep, in gemmi's syntax: "//A/10-50", "CA", "(ALA,GLY)"
    hetero        none, ligands or all: atoms beside the polymer. By default none, but all of PQR files and of those that
                  have neither protein nor nucleic acid
    waters        whether to keep waters. By default they are left out, but those of PQR files are kept, with a warning
    strict_radii  treat an atom of unknown type as an error

    What was assumed and may make a number wrong is a :class:`ReadWarning`, and kept in ``Structure.warnings``. What
    happens with every ordinary file is in ``Structure.notes`` alone. Atoms that were left out are counted in
    ``Structure.dropped``. Raises :class:`InputError`, a ValueError, for a file that is not valid, and
    OSError (FileNotFoundError, PermissionError ...) for a file that cannot be opened. Other Python threads keep
    running.

    >>> calphas = meniscus.read("1ubq.pdb", select="CA", radii="united")
    >>> len(calphas), calphas.radii_set
    (76, 'united')
    """
    options = _read_options(radii=radii, hydrogens=hydrogens, model=model, assembly=assembly, altloc=altloc,
                            chains=chains, select=select, hetero=hetero, waters=waters, strict_radii=strict_radii)
    return _read(path, options, stacklevel=4)


def _read(path: Path, options: dict[str, Any], stacklevel: int) -> Structure:
    text = text_of_path(path)
    try:
        structure = Structure(_core.read(text, options))
    except InputError as error:
        raise (unreadable(text, str(error)) if text != "-" else None) or error from None
    _warn(structure.warnings, stacklevel)
    return structure


def read_models(
    path: Path,
    *,
    radii: Path = "auto",
    hydrogens: str = "auto",
    assembly: str | int | None = None,
    altloc: str | None = None,
    chains: Texts | None = None,
    select: str | None = None,
    hetero: str | None = None,
    waters: bool | None = None,
    strict_radii: bool = False,
) -> list[Structure]:
    """Reads all models of a file, each as a structure of its own; the options are those of :func:`read`.

    >>> [model.stem for model in meniscus.read_models("1ubq.pdb")]
    ['1ubq_m01']
    """
    options = _read_options(radii=radii, hydrogens=hydrogens, model=1, assembly=assembly, altloc=altloc,
                            chains=chains, select=select, hetero=hetero, waters=waters, strict_radii=strict_radii)
    text = text_of_path(path)
    try:
        structures = [Structure(core) for core in _core.read_models(text, options)]
    except InputError as error:
        raise (unreadable(text, str(error)) if text != "-" else None) or error from None
    _warn((line for structure in structures for line in structure.warnings), stacklevel=3)
    return structures


def radii(
    element: Texts,
    name: Texts | None = None,
    resname: Texts | None = None,
    *,
    set: Path = "bondi",
) -> Floats:
    """Van der Waals radii of atoms from another program, (n,) float64, Å.

    element  symbols, in any case
    name     atom names; they and residue names are required by every set except bondi
    resname  residue names
    set      bondi, united, protor, naccess, parse, or a file of rules

    Atoms that are not in the set get the radius of their element. Hydrogens get 0 from sets whose radii already include
    them (united, protor, naccess): leave them out. Raises ValueError for an unknown set and for an atom that is neither
    in the set nor of a known element.

    >>> meniscus.radii(["C", "N", "O"]).tolist()
    [1.7, 1.55, 1.52]
    >>> meniscus.radii(["C", "O", "H"], ["CA", "O", "HA"], "GLY", set="united").tolist()
    [2.0, 1.4, 0.0]
    """
    elements = [element] if isinstance(element, str) else [str(symbol) for symbol in element]
    n = len(elements)
    names = texts("name", "" if name is None else name, n)
    resnames = texts("resname", "" if resname is None else resname, n)
    return _core.radii(elements, names, resnames, text_of_path(set))


def _read_options(**given: Any) -> dict[str, Any]:
    joins = isinstance(given["model"], str) and given["model"] == "join"
    options: dict[str, Any] = {
        "radii": text_of_path(given["radii"]),
        "hydrogens": _options.word("hydrogens", given["hydrogens"]),
        "join_models": joins,
        "strict_radii": bool(given["strict_radii"]),
    }
    if isinstance(given["model"], str) and not joins:
        raise TypeError(f"model: must be a whole number or \"join\", not {given['model']!r}; read_models() reads every "
                        "model")
    if not joins:
        options["model"] = _options.whole("model", given["model"])
    if given["hetero"] is not None:
        options["hetero"] = _options.word("hetero", given["hetero"])
    if given["waters"] is not None:
        options["waters"] = bool(given["waters"])
    for name in ("assembly", "altloc", "select"):
        if given[name] is not None:
            options[name] = str(given[name])
    if given["chains"] is not None:
        options["chains"] = _options.chains(given["chains"])
    return options


class Reading(TypedDict, total=False):
    """The keywords of :func:`read` beside radii, which every function takes that takes the path of a structure."""

    hydrogens: str
    model: int | str
    assembly: str | int | None
    altloc: str | None
    chains: Texts | None
    select: str | None
    hetero: str | None
    waters: bool | None
    strict_radii: bool


_DEFAULTS = {name: parameter.default for name, parameter in inspect.signature(read).parameters.items()
             if parameter.kind is parameter.KEYWORD_ONLY}


def check_reading(reading: Mapping[str, object], has_path: bool) -> None:
    """Refuses what is no keyword of read(), and all of them where no path is given."""
    for name in reading:
        if name not in _DEFAULTS:
            raise TypeError(f"unexpected keyword argument {name!r}")
        if not has_path:
            raise TypeError(f"{name} is an argument of read(); it applies where the path of a structure is given")


def read_for_caller(path: Path, reading: Mapping[str, object]) -> Structure:
    """As read() does, for a function that was called from outside and calls a function that calls this one."""
    check_reading(reading, has_path=True)
    return _read(path, _read_options(**{**_DEFAULTS, **reading}), stacklevel=6)


def _warn(lines: Iterable[str], stacklevel: int) -> None:
    for line in dict.fromkeys(lines):
        warnings.warn(line, ReadWarning, stacklevel=stacklevel)


def _set_for_file(sizes: npt.ArrayLike | Path | None) -> Mapping[str, object]:
    if sizes is None:
        return {}
    if not isinstance(sizes, (str, os.PathLike)):
        raise UsageError("radii: with a file, the name of a set such as 'bondi'; numbers go with an array of centres")
    return {"radii": sizes}


def _check_type(atoms: Any) -> None:
    """Refuses what is neither a list nor an array, such as None, bytes, an open file or a Surface."""
    if isinstance(atoms, (list, tuple)) or (not isinstance(atoms, (bytes, bytearray)) and np.ndim(atoms) > 0):
        return
    hint = "; its atoms are its .structure" if isinstance(getattr(atoms, "structure", None), Structure) else ""
    raise TypeError("atoms: must be a Structure, the path of a file, or centres of shape (n, 3), not "
                    f"{type(atoms).__name__}{hint}")


def as_structure(atoms: Structure | Path | npt.ArrayLike, sizes: npt.ArrayLike | Path | None,
                 reading: Mapping[str, object]) -> Structure:
    """What the functions take as atoms: a structure, a file and keywords of read(), or centres and radii."""
    if isinstance(atoms, (str, os.PathLike)):
        return read_for_caller(atoms, {**_set_for_file(sizes), **reading})
    check_reading(reading, has_path=False)
    if isinstance(atoms, Structure):
        if sizes is not None:
            raise UsageError("radii: a Structure has its own radii; make another with Structure.from_arrays")
        return atoms
    _check_type(atoms)
    if sizes is None:
        raise TypeError("radii: required with an array of centres, (n,) in Å; meniscus.radii() gives those of elements")
    if isinstance(sizes, (str, os.PathLike)):
        raise TypeError(f"radii: must be numbers with an array of centres; see meniscus.radii(set={sizes!r})")
    return Structure.from_arrays(atoms, sizes)

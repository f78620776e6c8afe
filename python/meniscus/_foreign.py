# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Structures of objects of other packages, with the radii and the choice of atoms that their files would get."""
from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol, Union

from . import _core, _foreign_atoms
from ._arrays import positions
from ._columns import columns_of
from ._foreign_atoms import Found
from ._meshing import Function, with_keywords
from ._nouns import of_kind
from ._reading import READ_DEFAULTS, ReadingOfFile, ReadOptions, warn_of
from ._structure import Structure
from ._universe import Origin

if TYPE_CHECKING:
    from typing_extensions import Unpack


class _WithAtoms(Protocol):
    """Universe and groups of MDAnalysis."""

    @property
    def atoms(self) -> Any: ...


class _WithTopology(Protocol):
    """Trajectory of MDTraj; Simulation, Modeller and files of OpenMM."""

    @property
    def topology(self) -> Any: ...


class _Entity(Protocol):
    """Structure, Model, Chain and Residue of Biopython."""

    def get_atoms(self) -> Any: ...


class _AtomArray(Protocol):
    """AtomArray and AtomArrayStack of Biotite."""

    @property
    def coord(self) -> Any: ...


class _Gemmi(Protocol):
    """Structure, Model and Chain of gemmi."""

    def clone(self) -> Any: ...


ForeignObject = Union[_WithAtoms, _WithTopology, _Entity, _AtomArray, _Gemmi]

_Extract = Callable[[Any, Union[int, None]], Found]
_PACKAGES: dict[str, tuple[str, _Extract]] = {
    "MDAnalysis": ("MDAnalysis", _foreign_atoms.of_mdanalysis),
    "mdtraj": ("MDTraj", _foreign_atoms.of_mdtraj),
    "Bio": ("Biopython", _foreign_atoms.of_biopython),
    "biotite": ("Biotite", _foreign_atoms.of_biotite),
    "gemmi": ("gemmi", _foreign_atoms.of_gemmi),
    "openmm": ("OpenMM", _foreign_atoms.of_openmm),
    "simtk": ("OpenMM", _foreign_atoms.of_openmm),
}
# Options that say what of a file is read.
_OF_FILES = ("model", "assembly")
_KEYWORDS = {name: default for name, default in READ_DEFAULTS.items() if name not in _OF_FILES}


def _package_of(value: object) -> str | None:
    """Which of the packages an object, or the first atom of a list, belongs to."""
    if isinstance(value, list) and value:
        value = value[0]
    roots = (base.__module__.partition(".")[0] for base in type(value).__mro__)
    return next((root for root in roots if root in _PACKAGES), None)


def is_foreign(value: object) -> bool:
    """Whether this is an object of a package that is known here."""
    return _package_of(value) is not None


def structure_of(source: Any, frame: int | None, options: ReadOptions) -> Structure:
    """The structure of what is_foreign() tells."""
    name, extract = _PACKAGES[_package_of(source) or ""]
    return _made(name, extract(source, frame), options)


def _made(name: str, found: Found, options: ReadOptions) -> Structure:
    for option in _OF_FILES:
        if getattr(options, option) != READ_DEFAULTS[option]:
            raise TypeError(f"{option}: says what of a file is read; of an object of {name}, frame=N is taken")
    centres = positions("positions", found.xyz)
    origin = {"source": name, "name": found.stem, "notes": found.notes}
    columns = columns_of(found.columns, len(centres))
    core, chosen = _core.read_atoms(centres, columns, origin, options._for_core())
    universe = None if found.universe is None else Origin(found.universe)
    structure = Structure(core, chosen if found.index is None else found.index[chosen], name, universe)
    warn_of([structure])
    return structure


def _from(name: str, found: Found, options: ReadOptions | None, keywords: Any) -> Structure:
    return _made(name, found, of_kind("options", options, ReadOptions).replace(**keywords))


_SHARED_PARAMETERS = """
options : ReadOptions, optional
    What to keep, and which radii; the defaults are those of files.
**keywords
    The members of :class:`ReadOptions` but model and assembly; they replace those of ``options``."""
_SHARED_ERRORS = """Raises
------
TypeError
    For an object of another kind.
InputError
    If no atoms are left.
UsageError
    For an option that makes no sense, and coordinates that are not finite."""


def _reader(function: Function) -> Function:
    """Adds what is the same for every package to a function's text, and makes help() show the keywords."""
    if function.__doc__:  # not with python -OO
        parameters, *rest = re.split(r"\n\n(?=Returns\n|Examples\n)", inspect.cleandoc(function.__doc__))
        function.__doc__ = "\n\n".join([parameters + _SHARED_PARAMETERS, rest[0], _SHARED_ERRORS, *rest[1:]])
    return with_keywords(_KEYWORDS)(function)


@_reader
def from_mdanalysis(
    atoms: Any,
    *,
    frame: int | None = None,
    options: ReadOptions | None = None,
    **keywords: Unpack[ReadingOfFile],
) -> Structure:
    """A structure of atoms of MDAnalysis, at the current frame of their trajectory.

    Parameters
    ----------
    atoms : MDAnalysis.Universe, AtomGroup, ResidueGroup or SegmentGroup
        The atoms. Chains are chainIDs, or where there are none segids; charges and radii are taken where the topology has
        them.
    frame : int, optional
        Another frame, from 0, or from the end if negative. Afterwards the trajectory is where it was.

    Returns
    -------
    Structure
        Its ``index`` has the place of each atom in the universe, ``ix``.

    Examples
    --------
    >>> import MDAnalysis
    >>> protein = MDAnalysis.Universe("1ubq.pdb").select_atoms("protein")
    >>> meniscus.from_mdanalysis(protein)
    <meniscus.Structure 1ubq: 602 atoms, 76 residues, radii united>
    """
    return _from("MDAnalysis", _foreign_atoms.of_mdanalysis(atoms, frame), options, keywords)


@_reader
def from_mdtraj(
    trajectory: Any,
    *,
    frame: int | None = None,
    options: ReadOptions | None = None,
    **keywords: Unpack[ReadingOfFile],
) -> Structure:
    """A structure of a frame of an MDTraj trajectory, in Å.

    Parameters
    ----------
    trajectory : mdtraj.Trajectory
        The trajectory, in nm. MDTraj keeps no B factors, insertion codes, alternative locations and HETATM records, and
        before its version 1.9.8 no names of chains: these are then A, B, C ... in their order.
    frame : int, optional
        The frame, from 0, or from the end if negative; by default the first, with a note if there are more.

    Returns
    -------
    Structure
        Its ``index`` has the place of each atom in the topology.

    Examples
    --------
    >>> import mdtraj
    >>> meniscus.from_mdtraj(mdtraj.load("1ubq.pdb"))
    <meniscus.Structure from MDTraj: 602 atoms, 76 residues, radii united>
    """
    return _from("MDTraj", _foreign_atoms.of_mdtraj(trajectory, frame), options, keywords)


@_reader
def from_biopython(
    entity: Any,
    *,
    frame: int | None = None,
    options: ReadOptions | None = None,
    **keywords: Unpack[ReadingOfFile],
) -> Structure:
    """A structure of atoms of Biopython, alternative locations among them.

    Parameters
    ----------
    entity : Bio.PDB Structure, Model, Chain or Residue, or list of Atom
        The atoms.
    frame : int, optional
        Of a Structure, the model, from 0, or from the end if negative; by default the first, with a note if there are more.

    Returns
    -------
    Structure
        Its ``index`` has the place of each atom in the order of iteration over chains, residues and, unpacked, atoms.

    Examples
    --------
    >>> from Bio.PDB import PDBParser
    >>> entity = PDBParser(QUIET=True).get_structure("ubiquitin", "1ubq.pdb")
    >>> meniscus.from_biopython(entity)
    <meniscus.Structure ubiquitin: 602 atoms, 76 residues, radii united>
    """
    return _from("Biopython", _foreign_atoms.of_biopython(entity, frame), options, keywords)


@_reader
def from_biotite(
    array: Any,
    *,
    frame: int | None = None,
    options: ReadOptions | None = None,
    **keywords: Unpack[ReadingOfFile],
) -> Structure:
    """A structure of a Biotite array.

    Tried with a stand-in that has the documented attributes, not with Biotite itself.

    Parameters
    ----------
    array : biotite.structure.AtomArray or AtomArrayStack
        The atoms, with b_factor, occupancy, charge, atom_id and altloc_id where they were loaded.
    frame : int, optional
        Of a stack, the model, from 0, or from the end if negative; by default the first, with a note if there are more.

    Returns
    -------
    Structure
        Its ``index`` has the place of each atom in the array.
    """
    return _from("Biotite", _foreign_atoms.of_biotite(array, frame), options, keywords)


@_reader
def from_gemmi(
    structure: Any,
    *,
    frame: int | None = None,
    options: ReadOptions | None = None,
    **keywords: Unpack[ReadingOfFile],
) -> Structure:
    """A structure of atoms of gemmi, alternative locations among them.

    Parameters
    ----------
    structure : gemmi.Structure, Model or Chain
        The atoms.
    frame : int, optional
        Of a Structure, the model, from 0, or from the end if negative; by default the first, with a note if there are more.

    Returns
    -------
    Structure
        Its ``index`` has the place of each atom in the order of iteration over chains, residues and atoms.

    Examples
    --------
    >>> import gemmi
    >>> meniscus.from_gemmi(gemmi.read_structure("1ubq.pdb"))
    <meniscus.Structure 1ubq: 602 atoms, 76 residues, radii united>
    """
    return _from("gemmi", _foreign_atoms.of_gemmi(structure, frame), options, keywords)


@_reader
def from_openmm(
    source: Any,
    positions: Any = None,
    *,
    frame: int | None = None,
    options: ReadOptions | None = None,
    **keywords: Unpack[ReadingOfFile],
) -> Structure:
    """A structure of a system of OpenMM, in Å.

    Tried with a stand-in that has the documented attributes, not with OpenMM itself. OpenMM keeps no B factors, alternative
    locations and HETATM records.

    Parameters
    ----------
    source : openmm.app Simulation, Modeller, PDBFile, PDBxFile or Topology
        What has the topology.
    positions : Quantity or array_like, shape (n, 3), optional
        Positions of a Topology, or instead of the source's own; plain numbers are nm.
    frame : int, optional
        Of a file with several frames, the frame, from 0, or from the end if negative; by default the first, with a note if
        there are more.

    Returns
    -------
    Structure
        Its ``index`` has the place of each atom in the topology.
    """
    return _from("OpenMM", _foreign_atoms.of_openmm(source, frame, positions), options, keywords)

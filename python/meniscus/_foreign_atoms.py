# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What objects of other packages know of their atoms. Nothing is imported: each object brings its package along."""
from __future__ import annotations

import contextlib
import dataclasses
import importlib
import pathlib
import string
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from ._errors import InputError, UsageError

_PER_NANOMETRE = 10.0  # Å


@dataclasses.dataclass
class Found:
    """Atoms as an object of another package has them."""

    xyz: Any
    """(n, 3), Å"""
    columns: dict[str, Any]
    """as Structure.from_arrays takes them; and hetero, in_polymer, radius"""
    index: npt.NDArray[np.int32] | None = None
    """place of each atom in the object; None for 0, 1, 2 ..."""
    stem: str = ""
    universe: Any = None
    """of MDAnalysis, whose atoms index counts"""
    notes: list[str] = dataclasses.field(default_factory=list)


def _wrong(package: str, needed: str, source: object) -> TypeError:
    return TypeError(f"from_{package}: {needed} is needed, not {type(source).__name__}")


def _checked_frame(frame: int, count: int) -> int:
    """A frame counted from 0, or from the end if negative."""
    if isinstance(frame, bool) or not hasattr(frame, "__index__"):
        raise TypeError(f"frame: must be a whole number, not {frame!r}")
    if not -count <= frame < count:
        raise UsageError(f"frame {frame}: there {'is 1' if count == 1 else f'are {count}'}, counted from 0")
    return frame % count


def _taken(frames: Any, frame: int | None, what: str, package: str) -> tuple[Any, list[str]]:
    """The first of the frames unless another is asked for; that there are others is a note."""
    count = len(frames)
    if count == 0:
        raise InputError(f"{package}: no {what}s, and so no atoms; check where they were read or chosen")
    told = frame is None and count > 1
    return (frames[0 if frame is None else _checked_frame(frame, count)],
            [f"{what} 0 of {count} taken (choose another with frame=N)"] if told else [])


def _refuse_frame(frame: int | None, why: str) -> None:
    if frame is not None:
        raise UsageError(f"frame: {why}")


# MDAnalysis has lengths in Å. What a topology does not have raises an AttributeError.

@contextlib.contextmanager
def _at_frame(trajectory: Any, frame: int | None) -> Iterator[None]:
    """At the current frame, or at another, after which the trajectory is where it was."""
    before = trajectory.ts.frame
    wanted = before if frame is None else _checked_frame(frame, len(trajectory))
    if wanted == before:
        yield
        return
    try:
        trajectory[wanted]
        yield
    finally:
        trajectory[before]


def _chains_of_mdanalysis(atoms: Any) -> list[str] | None:
    """Chain identifiers, and where there is none the segment, but not the one that stands for no segments."""
    segments = getattr(atoms, "segids", None)
    chains = getattr(atoms, "chainIDs", segments)
    if chains is None or segments is None:
        return None if chains is None else [str(chain) for chain in chains]
    return [str(chain) or ("" if segment == "SYSTEM" else str(segment)) if chain != "SYSTEM" else ""
            for chain, segment in zip(chains, segments)]


def of_mdanalysis(source: Any, frame: int | None) -> Found:
    if not hasattr(getattr(source, "atoms", None), "positions"):
        if hasattr(source, "universe") and hasattr(source, "atoms"):
            raise InputError("MDAnalysis: the universe has no coordinates; load a trajectory into it (load_new)")
        raise _wrong("mdanalysis", "a Universe or a group of atoms, residues or segments", source)
    file = getattr(source.universe, "filename", None)
    with _at_frame(source.universe.trajectory, frame):
        atoms = source.atoms  # of groups that are updated, those of this frame
        return Found(atoms.positions.copy(), columns_of_mdanalysis(atoms), np.array(atoms.ix, dtype=np.int32),
                     pathlib.PurePath(file).stem if isinstance(file, str) else "", source.universe)


def columns_of_mdanalysis(atoms: Any) -> dict[str, Any]:
    columns = {name: getattr(atoms, theirs, None) for name, theirs in (
        ("element", "elements"), ("name", "names"), ("resname", "resnames"), ("resnum", "resids"), ("icode", "icodes"),
        ("altloc", "altLocs"), ("serial", "ids"), ("b_factor", "tempfactors"), ("occupancy", "occupancies"),
        ("radius", "radii"))}
    charges, records = getattr(atoms, "charges", None), getattr(atoms, "record_types", None)
    columns.update(chain=_chains_of_mdanalysis(atoms),
                   charge=getattr(atoms, "formalcharges", None) if charges is None else charges,
                   hetero=None if records is None else [record == "HETATM" for record in records])
    return columns


# MDTraj has lengths in nm.

def _letters(index: int) -> str:
    """Names of chains that have only a number: A to Z, a to z, 0 to 9, then 62, 63 ..."""
    letters = string.ascii_uppercase + string.ascii_lowercase + string.digits
    return letters[index] if index < len(letters) else str(index)


def _symbol(element: Any) -> str:
    return str(getattr(element, "symbol", "") or "")


def of_mdtraj(source: Any, frame: int | None) -> Found:
    if not (hasattr(source, "topology") and getattr(getattr(source, "xyz", None), "ndim", 0) == 3):
        raise _wrong("mdtraj", "a Trajectory", source)
    xyz, notes = _taken(source.xyz, frame, "frame", "MDTraj")
    atoms = list(source.topology.atoms)
    chains = [getattr(atom.residue.chain, "chain_id", None) or _letters(atom.residue.chain.index) for atom in atoms]
    columns = {
        "element": [_symbol(atom.element) for atom in atoms],
        "name": [atom.name for atom in atoms],
        "resname": [atom.residue.name for atom in atoms],
        "resnum": [atom.residue.resSeq for atom in atoms],
        "chain": chains,
        "serial": [i + 1 if atom.serial is None else atom.serial for i, atom in enumerate(atoms)],
    }
    return Found(_PER_NANOMETRE * np.asarray(xyz, dtype=np.float64), columns, notes=notes)


# Biopython has entities within entities: structure, models, chains, residues, atoms. Its atoms hide their alternatives.

def _residues_of_biopython(entity: Any) -> Iterator[Any]:
    """Residues, all alternatives of point mutations among them."""
    level = entity.level
    if level == "R":
        yield from entity.disordered_get_list() if entity.is_disordered() == 2 else [entity]
    elif level == "C":
        yield from entity.get_unpacked_list()
    else:
        for child in entity:
            yield from _residues_of_biopython(child)


def _atoms_of_biopython(source: Any, frame: int | None) -> tuple[list[Any], list[str]]:
    level = getattr(source, "level", None)
    notes: list[str] = []
    if level == "S":
        source, notes = _taken(list(source), frame, "model", "Biopython")
    else:
        _refuse_frame(frame, "goes with a whole Structure of Biopython")
    if level is None and isinstance(source, Iterable):
        return _chosen_of_biopython(list(source)), notes
    if level not in ("S", "M", "C", "R"):
        raise _wrong("biopython", "a Structure, Model, Chain, Residue or a list of atoms", source)
    return [atom for residue in _residues_of_biopython(source) for atom in residue.get_unpacked_list()], notes


def _chosen_of_biopython(atoms: list[Any]) -> list[Any]:
    """Atoms that the caller has listed."""
    for atom in atoms:
        if not hasattr(atom, "get_parent") or not hasattr(atom, "coord"):
            raise TypeError(f"from_biopython: a list of atoms is needed, not one with {type(atom).__name__}")
        if atom.get_parent() is None:
            raise InputError(f"Biopython: atom {atom.name} belongs to no residue, which tells its kind; add it to one")
    return atoms


def of_biopython(source: Any, frame: int | None) -> Found:
    atoms, notes = _atoms_of_biopython(source, frame)
    bare = next((atom for atom in atoms if atom.coord is None), None)
    if bare is not None:
        raise InputError(f"Biopython: atom {bare.name} has no coordinates; set them, or leave it out")
    residues = [atom.get_parent() for atom in atoms]
    radii = [getattr(atom, "radius", None) for atom in atoms]
    columns = {
        "element": [atom.element or "" for atom in atoms],
        "name": [atom.name for atom in atoms],
        "altloc": [atom.altloc for atom in atoms],
        "b_factor": [atom.bfactor or 0.0 for atom in atoms],
        "occupancy": [1.0 if atom.occupancy is None else atom.occupancy for atom in atoms],
        "serial": [atom.serial_number or 0 for atom in atoms],
        "charge": [getattr(atom, "pqr_charge", None) or 0.0 for atom in atoms],
        "radius": None if None in radii else radii,
        "hetero": [residue.id[0] != " " for residue in residues],
        "resname": [residue.resname for residue in residues],
        "resnum": [residue.id[1] for residue in residues],
        "icode": [residue.id[2] for residue in residues],
        "chain": [_chain_of_biopython(residue) for residue in residues],
    }
    whole = getattr(source, "level", None) == "S"
    return Found(np.array([atom.coord for atom in atoms]).reshape(-1, 3), columns, notes=notes,
                 stem=str(source.id) if whole else "")


def _chain_of_biopython(residue: Any) -> str:
    chain = residue.get_parent()
    return "" if chain is None else str(chain.id).strip()


# Biotite has arrays of annotations, some of which are there only if they were asked for.

_OF_BIOTITE = (("element", "element"), ("name", "atom_name"), ("resname", "res_name"), ("resnum", "res_id"),
               ("icode", "ins_code"), ("chain", "chain_id"), ("hetero", "hetero"), ("altloc", "altloc_id"),
               ("serial", "atom_id"), ("b_factor", "b_factor"), ("occupancy", "occupancy"), ("charge", "charge"))


def of_biotite(source: Any, frame: int | None) -> Found:
    if not (hasattr(source, "coord") and hasattr(source, "get_annotation_categories")):
        raise _wrong("biotite", "an AtomArray or AtomArrayStack", source)
    xyz = source.coord
    notes: list[str] = []
    if np.ndim(xyz) == 3:
        xyz, notes = _taken(xyz, frame, "model", "Biotite")
    else:
        _refuse_frame(frame, "goes with an AtomArrayStack of Biotite")
    known = set(source.get_annotation_categories())
    columns = {name: getattr(source, theirs) for name, theirs in _OF_BIOTITE if theirs in known}
    if "altloc" in columns:
        columns["altloc"] = ["" if letter == "." else letter for letter in columns["altloc"]]
    return Found(xyz, columns, notes=notes)


# gemmi has structures, models, chains and residues, each of which is iterated over.

def _residues_of_gemmi(source: Any) -> Iterator[tuple[str, Any]]:
    """Names of chains, and their residues."""
    kind = type(source).__name__
    if kind == "Model":
        for chain in source:
            yield from _residues_of_gemmi(chain)
    elif kind == "Chain":
        yield from ((source.name, residue) for residue in source)
    else:
        raise _wrong("gemmi", "a Structure, Model or Chain", source)


def _polymer(residue: Any) -> bool:
    return getattr(getattr(residue, "entity_type", None), "name", "") == "Polymer"


def of_gemmi(source: Any, frame: int | None) -> Found:
    stem = ""
    notes: list[str] = []
    if type(source).__name__ == "Structure":
        stem = str(source.name)
        source, notes = _taken(source, frame, "model", "gemmi")
    else:
        _refuse_frame(frame, "goes with a whole Structure of gemmi")
    rows = [(chain, residue, atom) for chain, residue in _residues_of_gemmi(source) for atom in residue]
    flags = {"H": True, "A": False}
    hetero = [flags.get(residue.het_flag) for _, residue, _ in rows]
    columns = {
        "element": [atom.element.name for _, _, atom in rows],
        "name": [atom.name for _, _, atom in rows],
        "altloc": [atom.altloc.replace("\0", "") for _, _, atom in rows],
        "b_factor": [atom.b_iso for _, _, atom in rows],
        "occupancy": [atom.occ for _, _, atom in rows],
        "serial": [atom.serial for _, _, atom in rows],
        "charge": [atom.charge for _, _, atom in rows],
        "hetero": None if None in hetero else hetero,
        "in_polymer": [_polymer(residue) for _, residue, _ in rows],
        "resname": [residue.name for _, residue, _ in rows],
        "resnum": [residue.seqid.num or 0 for _, residue, _ in rows],
        "icode": [residue.seqid.icode for _, residue, _ in rows],
        "chain": [chain for chain, _, _ in rows],
    }
    return Found(np.array([atom.pos.tolist() for _, _, atom in rows]).reshape(-1, 3), columns, stem=stem, notes=notes)


# OpenMM has a topology and, elsewhere, positions with their unit.

def _in_angstrom(positions: Any) -> Any:
    """Quantities by their unit; plain numbers are nanometres, as everywhere in OpenMM."""
    if hasattr(positions, "value_in_unit"):
        unit = importlib.import_module(type(positions).__module__.split(".")[0] + ".unit")
        return np.array(positions.value_in_unit(unit.angstrom), dtype=np.float64)
    if len(positions) and hasattr(positions[0], "value_in_unit"):
        return np.array([_in_angstrom(position) for position in positions])
    return _PER_NANOMETRE * np.asarray(positions, dtype=np.float64)


def _positions_of_openmm(source: Any, frame: int | None) -> tuple[Any, list[str]]:
    """Those of a Simulation, a Modeller or a file."""
    if hasattr(source, "context"):
        _refuse_frame(frame, "a Simulation has only its current one")
        return source.context.getState(getPositions=True).getPositions(), []
    if hasattr(source, "getNumFrames"):
        chosen, notes = _taken(range(source.getNumFrames()), frame, "frame", "OpenMM")
        return source.getPositions(frame=chosen), notes
    _refuse_frame(frame, "goes with a file of OpenMM that has several")
    return source.positions, []


def of_openmm(source: Any, frame: int | None, positions: Any = None) -> Found:
    topology = getattr(source, "topology", source)
    notes: list[str] = []
    if not callable(getattr(topology, "atoms", None)):
        raise _wrong("openmm", "a Simulation, Modeller, PDBFile or a Topology with positions", source)
    if positions is None:
        if topology is source:
            raise TypeError("from_openmm: a Topology has no positions; give them, too")
        positions, notes = _positions_of_openmm(source, frame)
    else:
        _refuse_frame(frame, "the positions are given")
    atoms = list(topology.atoms())
    columns = {
        "element": [_symbol(atom.element) for atom in atoms],
        "name": [atom.name for atom in atoms],
        "serial": [_number(atom.id, i + 1) for i, atom in enumerate(atoms)],
        "resname": [atom.residue.name for atom in atoms],
        "resnum": [_number(atom.residue.id, atom.residue.index + 1) for atom in atoms],
        "icode": [getattr(atom.residue, "insertionCode", "") for atom in atoms],
        "chain": [str(atom.residue.chain.id).strip() for atom in atoms],
    }
    return Found(_in_angstrom(positions), columns, notes=notes)


def _number(text: Any, otherwise: int) -> int:
    """Identifiers of OpenMM are texts, and need not be numbers."""
    try:
        return int(text)
    except (TypeError, ValueError):
        return otherwise

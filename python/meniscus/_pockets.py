# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Pockets: where a molecule leaves room for a ligand."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy.typing as npt

from . import _core, _files, _options
from ._arrays import Floats, Indices
from ._atoms import Atoms, Radii, as_structure, is_source
from ._choices import PocketField, PocketFormat, PocketRank
from ._component import Point
from ._errors import CheckWarning, UsageError, warn
from ._files import Target
from ._meshing import with_keywords, with_run
from ._nouns import NOT_GIVEN, RunOptions
from ._reading import Reading, ReadOptions
from ._structure import Structure

if TYPE_CHECKING:
    import pandas  # type: ignore[import]
    from typing_extensions import Unpack


@dataclasses.dataclass(frozen=True)
class Mouth:
    """Where a pocket is open.

    Parameters
    ----------
    area : float
        Å².
    radius : float
        Of a disc of that area, Å.
    centre : tuple of float
        Centroid, Å.
    """

    area: float
    radius: float
    centre: Point


@dataclasses.dataclass(frozen=True)
class Pocket:
    """A place where a molecule leaves room for a ligand; made by :func:`pockets`.

    ``docs/design/pockets.md`` says what belongs to a pocket.

    Parameters
    ----------
    rank : int
        Place in the list, from 1.
    score : float
        Amount of space that resembles the places of ligands; no probability. 0 for cavities that do not.
    probability : float
        Largest probability of a point in it to be one of a ligand's, 0 to 1; not calibrated.
    tied_with : list of int
        Ranks of pockets whose scores are within 10 %.
    cavity : bool
        Whether it is a closed cavity, whose volume is exact.
    volume : float
        Å³.
    wall_area : float
        Å², of the surface that lines it.
    depth : float
        Largest depth below the surface of the large probe, Å.
    centre : tuple of float
        Centre of the space that resembles the places of ligands, Å.
    deepest : tuple of float
        The grid point at the largest depth, Å.
    mouths : list of Mouth
        Where it meets the bulk, largest first.
    openings : list of Mouth
        Where it goes on in other pocket space, largest first.
    hydrophobicity : float
        Mean of Kyte and Doolittle's scale over its wall, -4.5 to 4.5.
    charge : int
        e: lining ARG and LYS less lining ASP and GLU.
    donors : int
        Number of lining atoms that give hydrogen bonds.
    acceptors : int
        Number of lining atoms that take hydrogen bonds.
    residues : list of str
        Residues that line it with more than 1 Å² of an atom, as "A:SER 195".
    atoms : ndarray of int32, shape (k,)
        Indices of the atoms that line it with more than 1 Å².
    wall_atoms : ndarray of int32, shape (l,)
        Indices of all atoms of its wall.
    wall_atom_areas : ndarray of float64, shape (l,)
        Their shares of the wall, Å², which sum to ``wall_area``.
    voxels : ndarray of int32, shape (m,)
        Indices into the arrays of :attr:`Pockets.voxels`.
    """

    rank: int
    score: float
    probability: float
    tied_with: list[int]
    cavity: bool
    volume: float
    wall_area: float
    depth: float
    centre: Point
    deepest: Point
    mouths: list[Mouth] = dataclasses.field(repr=False)
    openings: list[Mouth] = dataclasses.field(repr=False)
    hydrophobicity: float
    charge: int
    donors: int
    acceptors: int
    residues: list[str] = dataclasses.field(repr=False)
    atoms: Indices = dataclasses.field(repr=False, compare=False)
    wall_atoms: Indices = dataclasses.field(repr=False, compare=False)
    wall_atom_areas: Floats = dataclasses.field(repr=False, compare=False)
    voxels: Indices = dataclasses.field(repr=False, compare=False)


def _pocket_of(block: dict[str, Any]) -> Pocket:
    values = {field.name: block[field.name] for field in dataclasses.fields(Pocket)}
    for name in ("mouths", "openings"):
        values[name] = [Mouth(**mouth) for mouth in values[name]]
    return Pocket(**values)


class Pockets:
    """The pockets of a molecule, best first; made by :func:`pockets`.

    Arrays are read-only. Pockets can be pickled and copied.

    Examples
    --------
    >>> found = meniscus.pockets("1ubq.pdb")
    >>> numpy.isclose(sum(pocket.volume for pocket in found) + found.rest_volume, found.volume)
    True
    """

    def __init__(self, core: _core.Pockets, structure: Structure, options: dict[str, Any]) -> None:
        self._core = core
        self._structure = structure
        self._options = options
        self._pockets: list[Pocket] | None = None
        self._voxels: dict[str, npt.NDArray[Any]] | None = None

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_pockets": None, "_voxels": None}

    def __repr__(self) -> str:
        return f"<meniscus.Pockets: {len(self)} pockets in {self.volume:.2f} Å³ of pocket space>"

    def __len__(self) -> int:
        return len(self.pockets)

    def __getitem__(self, index: int) -> Pocket:
        return self.pockets[index]

    @property
    def structure(self) -> Structure:
        """The atoms."""
        return self._structure

    @property
    def options(self) -> dict[str, Any]:
        """The options in force, by the names of the arguments of :func:`pockets`."""
        return dict(self._options)

    @property
    def pockets(self) -> list[Pocket]:
        """The pockets by rank, closed cavities among them. ``len()``, indices and loops go over these, too."""
        if self._pockets is None:
            self._pockets = [_pocket_of(block) for block in self._core.descriptions(self._structure._core)]
        return list(self._pockets)

    @property
    def totals(self) -> dict[str, float]:
        """Pocket space as a whole, as in the block ``total`` of the command line's report.

        The names are volume, large_probe, rest_volume, scale, wall_area and mouth_area.
        """
        return self._core.totals

    @property
    def volume(self) -> float:
        """Å³ of pocket space, exact: inside the SES of the large probe and outside that of the small one."""
        return self.totals["volume"]

    @property
    def rest_volume(self) -> float:
        """Å³ of pocket space in no pocket; with the volumes of all pockets it adds up to ``volume``."""
        return self.totals["rest_volume"]

    @property
    def scale(self) -> float:
        """Factor by which volumes from the grid were multiplied for that; near 1."""
        return self.totals["scale"]

    @property
    def checks(self) -> list[dict[str, Any]]:
        """The self-checks, as in the block ``checks`` of the report: name, passed, value, bound."""
        return self._core.checks

    @property
    def passed(self) -> bool:
        """Whether every check passed."""
        return all(check["passed"] for check in self.checks)

    @property
    def voxels(self) -> dict[str, npt.NDArray[Any]]:
        """The grid points whose cube lies in pocket space, at least in part, as arrays by their names.

        xyz (n, 3) float64, Å; share (n,) float32, of the cube in pocket space; depth (n,) float32, Å below the surface of
        the large probe; probability (n,) float32, of a ligand's atom, 0 where an atom is closer than 1 Å; pocket (n,)
        int32, the index of the pocket, -1 for none.

        Examples
        --------
        >>> found = meniscus.pockets("1ubq.pdb")
        >>> numpy.array_equal(numpy.flatnonzero(found.voxels["pocket"] == 0), found.pockets[0].voxels)
        True
        """
        if self._voxels is None:
            self._voxels = self._core.voxels
        return dict(self._voxels)

    def table(self) -> dict[str, list[Any]]:
        """The pockets as a list per column.

        Returns
        -------
        dict of str to list
            The columns of ``meniscus pockets -o FILE.csv``; areas in Å², volumes in Å³.
        """
        return self._core.table(self._structure._core)

    def to_pandas(self) -> pandas.DataFrame:
        """The pockets as a table of pandas, one row each.

        Returns
        -------
        pandas.DataFrame
            With the columns of :meth:`table`.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        from ._export import frame
        return frame(self.table())

    def save(self, path: Target, *, field: PocketField = "pockets", format: PocketFormat | None = None) -> None:
        """Writes the pockets, in the format of the suffix, as ``meniscus pockets -o`` does.

        .csv and .json are tables; .pdb and .cif have the atoms, with the rank of the pocket that they line as B factor, and
        the grid points as pseudo-atoms; .dx, .mrc and .vdb are maps; .npz has the arrays of ``docs/reference/pockets.md``.

        Parameters
        ----------
        path : str, os.PathLike or binary file object
            Where to write.
        field : {"pockets", "probability"}, default "pockets"
            Of maps: ranks of pockets, or the probability of a ligand's atom.
        format : {"csv", "json", "pdb", "cif", "dx", "mrc", "vdb", "npz"}, optional
            The format, instead of that of the suffix; required for a file object without a name.

        Raises
        ------
        UsageError
            For an unknown suffix or field.
        OSError
            If the file cannot be written.

        Examples
        --------
        >>> meniscus.pockets("1ubq.pdb").save("pockets.npz")
        >>> numpy.load("pockets.npz")["point_features"].shape[1]
        43
        """
        content = _options.one_of("field", field, _core.words["pocket_field"])
        _files.save_to(path, format, lambda inner: self._write(inner, content))

    def write(self, file: Target, format: PocketFormat | None = None, *, field: PocketField = "pockets") -> None:
        """Writes the pockets to an open file: :meth:`save` for those who have a stream.

        Parameters
        ----------
        file : binary file object, str or os.PathLike
            An open file, io.BytesIO ...; it stays open.
        format : str, optional
            "csv", "npz" ...: the suffixes of :meth:`save`; required for a file without a name.
        field : {"pockets", "probability"}, default "pockets"
            As for :meth:`save`.

        Raises
        ------
        UsageError
            For an unknown format or field.
        """
        self.save(file, field=field, format=format)

    def _write(self, path: str, field: str) -> None:
        suffix = _files.suffix_of(path, None)
        if suffix in (".csv", ".json"):
            self._core.save_table(self._structure._core, path)
        elif suffix in (".pdb", ".cif"):
            self._core.save_atoms(self._structure._core, path)
        elif suffix in (".dx", ".mrc", ".vdb"):
            self._core.save_volume(path, field)
        elif suffix == ".npz":
            self._core.save_arrays(path)
        else:
            raise UsageError(f"{path}: unknown suffix; choose one of .csv .json .pdb .cif .dx .mrc .vdb .npz")


def _as_the_ranking_was_fitted(atoms: Atoms, radii: Radii | None, reading: ReadOptions | None,
                               keywords: dict[str, Any]) -> tuple[Radii | None, dict[str, Any]]:
    """United radii and no hetero atoms, where something is read and the caller does not say otherwise."""
    if not is_source(atoms):
        return radii, keywords
    if radii is None and (reading is None or reading.radii == "auto"):
        radii = "united"
    if "hetero" not in keywords and (reading is None or reading.hetero is None):
        keywords = {**keywords, "hetero": "none"}
    return radii, keywords


@with_keywords({"threads": 0}, others="keywords")
def pockets(
    atoms: Atoms,
    radii: Radii | None = None,
    probe: float = 1.4,
    *,
    large_probe: float = 10.0,
    spacing: float = 1.0,
    count: int = 10,
    rank: PocketRank = "score",
    threads: int = NOT_GIVEN,
    reading: ReadOptions | None = None,
    run: RunOptions | None = None,
    **keywords: Unpack[Reading],
) -> Pockets:
    """Pockets and cavities, ranked by how much they resemble the places of ligands, and measured.

    Takes some 0.2 ms per atom; other Python threads keep running. The ranking was fitted to heavy atoms of proteins with
    united radii at a spacing of 1 Å; volumes and areas hold for all. A result that fails its own checks comes with a
    :class:`CheckWarning`.

    Parameters
    ----------
    atoms : Structure, str, os.PathLike, file object, object of another package, or array_like, shape (n, 3)
        As for :func:`measure`. A structure is taken as it is.
    radii : array_like, shape (n,), or str, optional
        Å; required with centres. With a file or an object of another package, the name of a radius set, by default
        "united".
    probe : float, default 1.4
        Radius of the probe that reaches into pockets, Å.
    large_probe : float, default 10
        Radius of the probe that closes pockets off from the bulk, Å; larger than ``probe``.
    spacing : float, default 1
        Grid spacing, Å, at most 2.
    count : int, default 10
        Number of pockets looked for; closed cavities come in addition.
    rank : {"score", "volume", "depth"}, default "score"
        What pockets are sorted by.
    threads : int, default 0
        0: all cores; results do not depend on it.
    reading : ReadOptions, optional
        With a file or an object of another package: what to keep, and which radii.
    run : RunOptions, optional
        Threads.
    **keywords
        The members of ReadOptions, hetero="ligands", chains="A" ..., which replace those of ``reading``; and frame=N for
        trajectories. Hetero atoms are left out by default.

    Returns
    -------
    Pockets

    Raises
    ------
    UsageError
        For invalid arrays or options. A ValueError.
    InputError, OSError
        For a file that cannot be read.
    LimitError
        For a grid that would not fit into memory.

    Examples
    --------
    >>> best = meniscus.pockets("1ubq.pdb", count=3).pockets[0]
    >>> best.rank, best.cavity, best.residues[0]
    (1, False, 'A:THR 7')
    """
    sizes, to_read = _as_the_ranking_was_fitted(atoms, radii, reading, dict(keywords))
    structure = as_structure(atoms, sizes, to_read, reading)
    options = {"probe": probe, "large_probe": large_probe, "spacing": spacing, "count": count, "rank": rank}
    core = _core.pockets(structure._core, options, with_run(run, threads=threads).threads)
    return _checked(Pockets(core, structure, options))


def _checked(found: Pockets) -> Pockets:
    failed = [check["name"] for check in found.checks if not check["passed"]]
    if failed:
        warn("pockets: checks failed: " + ", ".join(failed), CheckWarning)
    return found

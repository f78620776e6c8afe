# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Pockets: where a molecule leaves room for a ligand."""
from __future__ import annotations

import dataclasses
import numbers
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Union

import numpy.typing as npt

from . import _core, _files, _options, _writing
from ._arrays import ArrayLike, Floats, Indices, as_array, positions
from ._atoms import Atoms, Radii, as_structure, read_for_pockets, read_whole
from ._choices import Drawn, PocketField, PocketFormat, PocketRank
from ._component import Point
from ._errors import CheckWarning, UsageError, warn
from ._files import Target
from ._meshing import with_keywords, with_run
from ._nouns import NOT_GIVEN, RunOptions
from ._reading import Reading, ReadOptions
from ._structure import Structure
from ._tunnels import Pore, Tunnel

if TYPE_CHECKING:
    import pandas  # type: ignore[import]
    from typing_extensions import Unpack

Place = Union[str, Structure, ArrayLike]
Ways = Union[None, Tunnel, Pore, Sequence[Union[Tunnel, Pore]]]

_WITH_TUNNELS = (".pdb", ".cif", ".glb", ".png", ".html")
_ALL_SUFFIXES = (".csv", ".json", ".pdb", ".cif", ".ply", ".glb", ".png", ".html", ".dx", ".mrc", ".vdb", ".npz")

# Å; those of the command line: where a ligand's atoms lie that touch the wall, and as far as a site's own points.
_REACH_OF_ATOM = 4.0
_REACH_OF_POINT = 8.0


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
class LigandFit:
    """How a ligand sits in a pocket.

    Parameters
    ----------
    atoms : int
        Number of its atoms.
    inside : int
        Number of those whose centres lie inside the SES of the large probe.
    sas_area : float
        Å², exact, of the ligand alone.
    buried_area : float
        Å², the part of it that the molecule's atoms bury.
    """

    atoms: int
    inside: int
    sas_area: float
    buried_area: float


@dataclasses.dataclass(frozen=True)
class Pocket:
    """A place where a molecule leaves room for a ligand; made by :func:`pockets`.

    ``docs/design/pockets.md`` says what belongs to a pocket.

    Parameters
    ----------
    rank : int
        Place in the list, from 1.
    at : str
        The place that was asked for: "A:HEM 142" of a ligand; empty for pockets that were found.
    score : float
        Amount of space that resembles the places of ligands; no probability. 0 for cavities that do not.
    probability : float
        Largest probability of a point in it to be one of a ligand's, 0 to 1; not calibrated.
    tied_with : list of int
        Ranks of pockets whose scores are within 10 %.
    site : int
        At a place: rank that the pocket would have among those found, judged by the first site whose centre is within 4 Å
        of the place; 0 for none.
    ligand : LigandFit or None
        Of the ligand that lies at the place; None where there is none, or where only its centres were given.
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
    at: str
    score: float
    probability: float
    tied_with: list[int]
    site: int
    ligand: LigandFit | None
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
    if values["ligand"] is not None:
        values["ligand"] = LigandFit(**values["ligand"])
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
    def doubt(self) -> str:
        """Why the ranking is less sure than for what it was fitted to: heavy atoms of a protein at 1 Å. Empty if it is not."""
        return self._core.doubt(self._structure._core)

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

    def tunnels(self, from_: str | ArrayLike | Sequence[str | ArrayLike] | None = None, radius: float = 0.9,
                count: int = 3, *, threads: int = 0) -> list[Tunnel]:
        """The widest ways to the bulk, as ``meniscus pockets --tunnels`` finds them.

        Parameters
        ----------
        from_ : str, array_like, shape (3,) or (n, 3), or list of these, optional
            Where they begin: in the middle of the atoms that a text selects, or at points, Å. By default in every pocket.
        radius : float, default 0.9
            Least radius of their bottlenecks, Å.
        count : int, default 3
            Number of tunnels from each start.
        threads : int, default 0
            0: all cores; results do not depend on it.

        Returns
        -------
        list of Tunnel
            By start, the widest first.

        Raises
        ------
        UsageError
            For invalid starts or options.
        """
        ranks: list[int | None]
        if from_ is None:
            begin = [pocket for pocket in self.pockets if len(pocket.voxels) or pocket.cavity]
            starts, ranks = [pocket.deepest for pocket in begin], [pocket.rank for pocket in begin]
        else:
            starts = self._starts(from_)
            ranks = [None] * len(starts)
        least, most = _options.positive("radius", radius), _options.from_one("count", count)
        found = _core.tunnels(self._structure._core, positions("from_", starts), least, most,
                              self.totals["large_probe"], _options.count("threads", threads)) if starts else []
        return [Tunnel(pocket=ranks[start], rank=rank, **way) for start, rank, way in found]

    def _starts(self, given: Any) -> list[Any]:
        if isinstance(given, str):
            middle = self._structure.xyz[self._structure.select(given)].sum(axis=0)
            return [middle * (1.0 / len(self._structure.select(given)))]
        if isinstance(given, (list, tuple)) and any(isinstance(item, str) for item in given):
            return [start for item in given for start in self._starts(item)]
        array = as_array("from_", given)
        return list(positions("from_", array.reshape(1, 3) if array.shape == (3,) else array))

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

    def save(
        self,
        path: Target,
        *,
        field: PocketField = "pockets",
        tunnels: Ways = None,
        size: tuple[int, int] = (1600, 1200),
        view: _writing.View = "auto",
        background: str = "white",
        perspective: bool = False,
        outline: bool = False,
        depth_cue: float = 0.0,
        cut: _writing.Cut = None,
        legend: bool = False,
        draw: Drawn = "ligands",
        format: PocketFormat | None = None,
    ) -> None:
        """Writes the pockets, in the format of the suffix, as ``meniscus pockets -o`` does.

        .csv and .json are tables; .pdb and .cif have the atoms, with the rank of the pocket that they line as B factor, and
        the grid points as pseudo-atoms; .ply has a closed mesh for each pocket; .glb, .png and .html show the surface in
        the colours of its pockets with their bodies in it, .html as a page with a list of them; .dx, .mrc and .vdb are maps;
        .npz has the arrays of ``docs/reference/pockets.md``.

        Parameters
        ----------
        path : str, os.PathLike or binary file object
            Where to write.
        field : {"pockets", "probability"}, default "pockets"
            Of maps: ranks of pockets, or the probability of a ligand's atom.
        tunnels : Tunnel, Pore, or sequence of these, optional
            Of .pdb, .cif, .glb, .png and .html: tunnels of these pockets, and at most one pore, as pseudo-atoms or tubes.
        size : tuple of int, default (1600, 1200)
            Width and height of a picture in pixels.
        view : str or array_like, shape (3,) or (2, 3), default "auto"
            Of pictures and pages, as for :meth:`Surface.save`; "auto" shows a pore from the side.
        background : str, default "white"
            Of pictures.
        perspective : bool, default False
            Of pictures and pages: as the eye sees, instead of parallel rays.
        outline : bool, default False
            Of pictures: lines where the surface ends in front of something.
        depth_cue : float, default 0
            Of pictures: let what is far away fade into the background, 0 to 1.
        cut : str, float or array_like, shape (3,) or (2, 3), optional
            Of pictures: cuts all by a plane, as for :meth:`Surface.save`.
        legend : bool, default False
            Of pictures: what the colours mean.
        draw : {"ligands", "none"}, default "ligands"
            Of pictures, pages and .glb: draw the ligands of the structure as sticks and balls.
        format : {"csv", "json", "pdb", "cif", "ply", "glb", "png", "html", "dx", "mrc", "vdb", "npz"}, optional
            The format, instead of that of the suffix; required for a file object without a name.

        Raises
        ------
        UsageError
            For an unknown suffix or field, and an option that makes no sense.
        OSError
            If the file cannot be written.

        Examples
        --------
        >>> meniscus.pockets("1ubq.pdb").save("pockets.npz")
        >>> numpy.load("pockets.npz")["point_features"].shape[1]
        43
        """
        drawing = {"size": size, "view": view, "background": background, "perspective": perspective,
                   "outline": outline, "depth_cue": depth_cue, "cut": cut, "legend": legend, "draw": draw}
        content = _options.one_of("field", field, _core.words["pocket_field"])
        ways = _ways_of(tunnels)
        options = _writing.picture_options(drawing)
        _files.save_to(path, format, lambda inner: self._write(inner, content, ways, options))

    def write(self, file: Target, format: PocketFormat | None = None, *, field: PocketField = "pockets",
              **drawing: Any) -> None:
        """Writes the pockets to an open file: :meth:`save` for those who have a stream.

        Parameters
        ----------
        file : binary file object, str or os.PathLike
            An open file, io.BytesIO ...; it stays open.
        format : str, optional
            "csv", "npz" ...: the suffixes of :meth:`save`; required for a file without a name.
        field : {"pockets", "probability"}, default "pockets"
            As for :meth:`save`.
        **drawing
            The other arguments of :meth:`save`.

        Raises
        ------
        UsageError
            For an unknown format or field.
        """
        self.save(file, field=field, format=format, **drawing)

    def _write(self, path: str, field: str, ways: tuple[list[Tunnel], Pore | None], options: dict[str, Any]) -> None:
        suffix = _files.suffix_of(path, None)
        structure = self._structure._core
        if suffix not in _ALL_SUFFIXES:
            raise UsageError(f"{path}: unknown suffix; choose one of {' '.join(_ALL_SUFFIXES)}")
        if ways != ([], None) and suffix not in _WITH_TUNNELS:
            raise UsageError(f"{path}: has no room for tunnels; choose one of {' '.join(_WITH_TUNNELS)}")
        if suffix in (".csv", ".json"):
            self._core.save_table(structure, path)
        elif suffix in (".pdb", ".cif"):
            self._core.save_atoms(structure, path, *ways)
        elif suffix in (".dx", ".mrc", ".vdb"):
            self._core.save_volume(path, field)
        elif suffix == ".npz":
            self._core.save_arrays(path)
        elif suffix == ".ply":
            self._core.save_bodies(path)
        else:
            self._core.save_drawn(structure, path, *ways, options)


def _ways_of(tunnels: Any) -> tuple[list[Tunnel], Pore | None]:
    given = [] if tunnels is None else [tunnels] if isinstance(tunnels, (Tunnel, Pore)) else list(tunnels)
    for way in given:
        if not isinstance(way, (Tunnel, Pore)):
            raise TypeError(f"tunnels: must be made by Pockets.tunnels() or pore(), not {type(way).__name__}")
    pores = [way for way in given if isinstance(way, Pore)]
    if len(pores) > 1:
        raise UsageError(f"tunnels: {len(pores)} pores; at most one can be written")
    return [way for way in given if isinstance(way, Tunnel)], pores[0] if pores else None


def _is_point(value: object) -> bool:
    return isinstance(value, (list, tuple)) and len(value) == 3 and all(isinstance(x, numbers.Real) for x in value)


def _places_of(at: Any) -> list[Any]:
    """What is asked for, one by one. A list holds places, but for three numbers, which are a point."""
    if not isinstance(at, list) or _is_point(at):
        return [at]
    if not at:
        raise UsageError('at: empty; write for instance "(HEM)", "//A/57" or a point')
    return at


def _place_of(item: Any, reach: float | None) -> _core.Place:
    if isinstance(item, Structure):
        return _core.place(item.stem or f"{len(item)} atoms", item.xyz, item.radii, reach or _REACH_OF_ATOM)
    array = as_array("at", item)
    if array.shape == (3,):
        point = positions("at", array.reshape(1, 3))
        return _core.place(",".join(f"{x:.6g}" for x in point[0]), point, None, reach or _REACH_OF_POINT)
    centres = positions("at", array)
    if not len(centres):
        raise UsageError("at: a ligand without atoms")
    return _core.place(f"{len(centres)} atoms", centres, None, reach or _REACH_OF_ATOM)


def _find_places(at: list[Any], reach: float | None, molecule: Structure,
                 whole_of_file: Callable[[], Structure]) -> list[_core.Place]:
    whole: Structure | None = None
    places: list[_core.Place] = []
    for item in at:
        if not isinstance(item, str):
            places.append(_place_of(item, reach))
            continue
        expression = _options.some("at", item)
        whole = whole or whole_of_file()
        places += _core.places_of_selection(molecule._core, whole._core, expression, reach or _REACH_OF_ATOM)
    return places


@with_keywords({"threads": 0}, others="keywords")
def pockets(
    atoms: Atoms,
    radii: Radii | None = None,
    probe: float = 1.4,
    *,
    at: Place | Sequence[Place] | None = None,
    at_reach: float | None = None,
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
    at : str, array_like, shape (3,) or (n, 3), Structure, or list of these, optional
        Where pockets are asked for, instead of those that are found; one for each place, in this order. Text selects
        ligands, "(HEM)", or residues, "//A/57 + //A/102", among all atoms of the file, so that ``atoms`` must be something
        that can be read again. Three numbers are a point, Å; an array of shape (n, 3) has the centres of a ligand's
        atoms; a structure is a ligand with radii. A list holds several places.
    at_reach : float, optional
        How far these pockets reach, Å; from atoms 4, from a point 8 unless given.
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
    >>> beside = meniscus.pockets("1ubq.pdb", at="//A/44 + //A/70").pockets[0]
    >>> beside.at, beside.ligand
    ('//A/44 + //A/70', None)
    """
    asked = [] if at is None else _places_of(at)
    reach = None if at_reach is None else _options.positive("at_reach", at_reach)
    if _files.is_file(atoms) and any(isinstance(item, str) for item in asked):
        atoms = _files.Kept(atoms)
    sizes, to_read = read_for_pockets(atoms, radii, reading, dict(keywords))
    structure = as_structure(atoms, sizes, to_read, reading)
    places = _find_places(asked, reach, structure, lambda: read_whole(atoms, sizes, to_read, reading))
    options = {"probe": probe, "large_probe": large_probe, "spacing": spacing, "count": count, "rank": rank}
    core = _core.pockets(structure._core, options, places, with_run(run, threads=threads).threads)
    return _checked(Pockets(core, structure, {"at": at, "at_reach": reach, **options}))


def _checked(found: Pockets) -> Pockets:
    failed = [check["name"] for check in found.checks if not check["passed"]]
    if failed:
        warn("pockets: checks failed: " + ", ".join(failed), CheckWarning)
    return found

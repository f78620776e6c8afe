# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Atoms with radii and names."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core, _files, _options
from ._arrays import ArrayLike, Floats, Indices, arrays_of, one_per, positions
from ._choices import AtomFormat, RadiusSet
from ._columns import Strings, Texts, Whole, columns_of
from ._errors import UsageError
from ._files import Target

if TYPE_CHECKING:
    import pandas  # type: ignore[import]

    from ._reading import ReadOptions
    from ._universe import Origin

_NUMBERS = ("xyz", "radii", "resnum", "residue", "serial", "b_factor", "occupancy", "charge")
_COLUMNS = ("serial", "name", "element", "altloc", "resname", "resnum", "icode", "chain", "residue", "radii", "b_factor",
            "occupancy", "charge")


class Structure:
    """Atoms with radii and, where known, their names; made by :func:`read`, :meth:`from_arrays` and ``from_...``.

    Every column has one entry per kept atom, in the order of the file. Columns of numbers are read-only.

    Examples
    --------
    >>> protein = meniscus.read("1ubq.pdb")
    >>> protein
    <meniscus.Structure 1ubq: 602 atoms, 76 residues, radii united>
    >>> protein.xyz.shape, protein.name[:3].tolist(), protein.resname[0]
    ((602, 3), ['N', 'CA', 'C'], 'MET')
    """

    def __init__(self, core: _core.Structure, index: Indices | None = None, origin: str = "arrays",
                 universe: Origin | None = None) -> None:
        self._core = core
        self._index = index
        self._origin = origin
        self._universe = universe
        self._residues: dict[str, Any] | None = None
        # How it was read, where it can be read again: of a file by its path.
        self._reading: ReadOptions | None = None

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_residues": None}

    @classmethod
    def from_arrays(
        cls,
        xyz: ArrayLike,
        radii: ArrayLike | RadiusSet | str = "bondi",
        *,
        element: Texts | None = None,
        name: Texts | None = None,
        resname: Texts | None = None,
        resnum: Whole | None = None,
        icode: Texts | None = None,
        chain: Texts | None = None,
        altloc: Texts | None = None,
        serial: Whole | None = None,
        b_factor: ArrayLike | None = None,
        occupancy: ArrayLike | None = None,
        charge: ArrayLike | None = None,
    ) -> Structure:
        """Makes a structure of arrays; nothing is left out.

        Every column but the first two may be one text or number for all atoms; what is not given is left empty.

        Parameters
        ----------
        xyz : array_like, shape (n, 3)
            Centres, Å.
        radii : array_like, shape (n,), or float, or str, default "bondi"
            Radii, Å; one number for all; or the name of a set: see :func:`radii`.
        element : str or sequence of str, optional
            Symbols.
        name : str or sequence of str, optional
            Names of the atoms: CA, OXT.
        resname : str or sequence of str, optional
            Names of the residues: ALA.
        resnum : int or array_like, shape (n,), optional
            Numbers of the residues. Residues are runs of atoms with the same chain, resname, resnum and icode.
        icode : str or sequence of str, optional
            Insertion codes, one letter each.
        chain : str or sequence of str, optional
            Chains.
        altloc : str or sequence of str, optional
            Alternative locations, one letter each.
        serial : int or array_like, shape (n,), optional
            Serial numbers; 1, 2, 3 ... if not given.
        b_factor : float or array_like, shape (n,), optional
            B factors, Å².
        occupancy : float or array_like, shape (n,), optional
            Occupancies; 1 if not given.
        charge : float or array_like, shape (n,), optional
            Charges, e.

        Returns
        -------
        Structure

        Raises
        ------
        UsageError
            For an array of another shape, numbers that are not finite, and an atom without a radius in the set.

        Examples
        --------
        >>> water = meniscus.Structure.from_arrays([[0, 0, 0], [0.96, 0, 0], [-0.24, 0.93, 0]], element=["O", "H", "H"])
        >>> water.radii.tolist()
        [1.52, 1.2, 1.2]
        """
        centres = positions("xyz", xyz)
        given = {"element": element, "name": name, "resname": resname, "icode": icode, "chain": chain, "altloc": altloc,
                 "resnum": resnum, "serial": serial, "b_factor": b_factor, "occupancy": occupancy, "charge": charge}
        columns = columns_of(given, len(centres))
        if isinstance(radii, str):
            empty = [""] * len(centres)
            sizes = _core.radii(columns.get("element", empty), columns.get("name", empty),
                                columns.get("resname", empty), radii)
        else:
            sizes = one_per("radii", radii, len(centres))
        return cls(_core.from_arrays(centres, sizes, columns))

    def __len__(self) -> int:
        return len(self._core)

    def __repr__(self) -> str:
        label = self.stem or f"from {self._origin}"
        return (f"<meniscus.Structure {label}: {len(self)} atoms, {len(self._per_residue['name'])} residues, "
                f"radii {self.radii_set}>")

    @property
    def file(self) -> str:
        """Path of the file, as given; empty for arrays and objects of other packages."""
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

        Examples
        --------
        >>> meniscus.read("1ubq.pdb").dropped
        {'waters': 58}
        """
        return self._core.dropped

    @property
    def ligands(self) -> dict[str, int]:
        """How many ligands pictures, pages and .glb may show, by residue name, whether they belong to the surface or not.

        Examples
        --------
        >>> meniscus.read("1ubq.pdb").ligands
        {}
        """
        return self._core.ligands

    @property
    def notes(self) -> list[str]:
        """What was done as with every ordinary file, such as waters left out: one line per kind.

        Examples
        --------
        >>> meniscus.read("1ubq.pdb").notes
        ['58 waters left out (keep them with waters=True)']
        """
        return self._core.notes

    @property
    def warnings(self) -> list[str]:
        """What was assumed while reading and may make a number wrong: one line per kind, each also a ReadWarning."""
        return self._core.warnings

    @property
    def index(self) -> Indices:
        """(n,) int32, from 0: the place of each atom in the object that the structure was made of.

        That is ``ix`` of MDAnalysis, ``index`` of MDTraj and OpenMM, the position in a Biotite array, and the position in
        the order of iteration for Biopython and gemmi. Of files and arrays it counts the kept atoms.

        Examples
        --------
        >>> meniscus.read("1ubq.pdb").index[:3].tolist()
        [0, 1, 2]
        """
        return np.arange(len(self), dtype=np.int32) if self._index is None else self._index

    @property
    def xyz(self) -> Floats:
        """(n, 3) float64, Å: centres; a view."""
        return self._core.xyz

    @property
    def radii(self) -> Floats:
        """(n,) float64, Å; a view."""
        return self._core.radii

    @property
    def element(self) -> Strings:
        """(n,) text, upper case; empty where unknown."""
        return np.array(self._core.element, dtype=np.str_)

    @property
    def name(self) -> Strings:
        """(n,) text: names of the atoms: CA, OXT."""
        return np.array(self._core.name_of_atoms, dtype=np.str_)

    @property
    def altloc(self) -> Strings:
        """(n,) text: alternative locations; blank if there is none."""
        return np.array(self._core.altloc, dtype=np.str_)

    @property
    def residue(self) -> Indices:
        """(n,) int32, from 0: counts the kept residues."""
        return self._core.residue

    @property
    def serial(self) -> Indices:
        """(n,) int32: serial numbers, as in the file."""
        return self._core.serial

    @property
    def b_factor(self) -> Floats:
        """(n,) float64, Å², or the pLDDT of a predicted model."""
        return self._core.b_factor

    @property
    def occupancy(self) -> Floats:
        """(n,) float64, as in the file."""
        return self._core.occupancy

    @property
    def charge(self) -> Floats:
        """(n,) float64, e: from PQR or PDBQT, else the formal charge."""
        return self._core.charge

    def numpy(self, copy: bool = False) -> dict[str, npt.NDArray[Any]]:
        """The columns of numbers by their names.

        Parameters
        ----------
        copy : bool, default False
            Arrays of their own, which may be written to and which ``torch.from_numpy`` and ``from_dlpack`` take.

        Returns
        -------
        dict of str to ndarray
            xyz, radii, resnum, residue, serial, b_factor, occupancy, charge, as the properties of these names.

        Examples
        --------
        >>> meniscus.read("1ubq.pdb").numpy(copy=True)["xyz"].flags.writeable
        True
        """
        return arrays_of(self, _NUMBERS, copy)

    def to_pandas(self) -> pandas.DataFrame:
        """The atoms as a table of pandas, one row each.

        Returns
        -------
        pandas.DataFrame
            Columns x, y, z (Å), serial, name, element, altloc, resname, resnum, icode, chain, residue, radii (Å),
            b_factor, occupancy, charge.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        from ._export import frame
        places = dict(zip("xyz", self.xyz.T))
        return frame({**places, **{name: getattr(self, name) for name in _COLUMNS}})

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
        """(n,) text; copies of an assembly or in joined models are A, A-2, A-3."""
        return self._of_residues("chain")

    @property
    def resname(self) -> Strings:
        """(n,) text: names of the residues: ALA."""
        return self._of_residues("name")

    @property
    def resnum(self) -> Indices:
        """(n,) int32: numbers of the residues, as in the file."""
        return self._of_residues("number")

    @property
    def icode(self) -> Strings:
        """(n,) text: insertion codes; blank if there is none."""
        return self._of_residues("icode")

    def select(self, expression: str) -> Indices:
        """Which atoms an expression selects.

        Parameters
        ----------
        expression : str
            In gemmi's syntax, "//A/10-50", or in the words of PyMOL and VMD: "chain A and resi 10-50", as ``--select`` of
            the command line takes it.

        Returns
        -------
        ndarray of int32, shape (k,)
            Indices of the atoms, ascending.

        Raises
        ------
        UsageError
            For an expression that is not valid or selects nothing.

        Examples
        --------
        >>> len(meniscus.read("1ubq.pdb").select("chain A and resi 10-50"))
        319
        """
        return _core.select(self._core, _options.word("expression", expression), "selection")

    def split_chains(self) -> list[Structure]:
        """Splits the structure by chains.

        Returns
        -------
        list of Structure
            One per chain, in the order of their first atoms, with the radii that the atoms have here.

        Examples
        --------
        >>> [chain.chain[0] for chain in meniscus.read("1ubq.pdb").split_chains()]
        ['A']
        """
        chains, index = self.chain, self.index
        return [Structure(core, index[chains == core.residues["chain"][0]], self._origin, self._universe)
                for core in _core.split_chains(self._core)]

    def save(self, path: Target, values: ArrayLike | None = None, *, format: AtomFormat | None = None) -> None:
        """Writes the atoms, in the format of the suffix: .xyzr .xyzrn .csv .pdb .cif.

        .xyzr and .xyzrn hold centres and radii, .csv the table of atoms that a mesh's ``atom`` indexes. No partial file
        is left behind.

        Parameters
        ----------
        path : str, os.PathLike or binary file object
            Where to write.
        values : array_like, shape (n,), optional
            Written to .pdb and .cif instead of the B factors.
        format : {"xyzr", "xyzrn", "csv", "pdb", "cif"}, optional
            The format, instead of that of the suffix; required for a file object without a name.

        Raises
        ------
        UsageError
            For an unknown suffix.
        OSError
            If the file cannot be written.
        """
        _files.save_to(path, format, lambda inner: self._write(inner, values))

    def _write(self, path: str, values: ArrayLike | None) -> None:
        suffix = _files.suffix_of(path, None)
        if suffix in (".xyzr", ".xyzrn"):
            _core.write_spheres(path, self._core)
        elif suffix == ".csv":
            _core.write_atom_table(path, self._core)
        elif suffix in (".pdb", ".cif"):
            column = self.b_factor if values is None else one_per("values", values, len(self))
            _core.write_structure_copy(path, self._core, column)
        else:
            raise UsageError(f"{path}: unknown suffix; choose one of .xyzr .xyzrn .csv .pdb .cif")

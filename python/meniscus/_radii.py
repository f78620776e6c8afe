# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Radii of atoms by their names."""
from __future__ import annotations

from . import _core
from ._arrays import Floats, texts
from ._choices import RadiusSet
from ._columns import Texts
from ._errors import text_of_path
from ._files import Path


def radii(
    element: Texts,
    name: Texts | None = None,
    resname: Texts | None = None,
    *,
    set: RadiusSet | Path = "bondi",
) -> Floats:
    """Van der Waals radii of atoms.

    Atoms that are not in the set get the radius of their element. Hydrogens get 0 from sets whose radii already include
    them (united, protor, naccess): leave them out.

    Parameters
    ----------
    element : str or sequence of str
        Symbols, in any case; a single text is one atom.
    name : str or sequence of str, optional
        Names of the atoms; they and those of residues are required by every set except bondi.
    resname : str or sequence of str, optional
        Names of the residues.
    set : {"bondi", "united", "protor", "naccess", "parse"} or path of a file of rules, default "bondi"
        The radius set; ``docs/conventions.md`` says where they come from.

    Returns
    -------
    ndarray of float64, shape (n,)
        Å.

    Raises
    ------
    UsageError
        For an unknown set, and for an atom that is neither in the set nor of a known element.

    Examples
    --------
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

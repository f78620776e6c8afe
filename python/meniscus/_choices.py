# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The words of choices as types; a test holds them against those of the library. Those of meshing are in _keywords.py."""
from __future__ import annotations

from typing import Literal

Hydrogens = Literal["auto", "keep", "drop"]
Hetero = Literal["none", "ligands", "all"]
RadiusSet = Literal["auto", "bondi", "united", "protor", "naccess", "parse"]
Command = Literal["measure", "surface"]
Per = Literal["residue", "atom", "chain", "cavity"]
PerInterface = Literal["residue", "atom", "chain"]
Interpolation = Literal["linear", "cubic"]
Field = Literal["distance", "mask", "dielectric", "ions"]
ColorScheme = Literal["auto", "single", "patch", "element", "chain", "residue", "residue-patch", "hydrophobicity",
                      "curvature", "component", "depth", "bfactor", "pocket", "plddt"]
ViewName = Literal["auto", "front", "back", "left", "right", "top", "bottom"]
Drawn = Literal["ligands", "none"]
VertexArray = Literal["depth"]
Maps = Literal["apbs"]
ReadFormat = Literal["pdb", "ent", "cif", "mmcif", "bcif", "gro", "pdbqt", "pqr", "xyzr", "xyzrn"]
AtomFormat = Literal["xyzr", "xyzrn", "csv", "pdb", "cif"]
SurfaceFormat = Literal["ply", "obj", "stl", "off", "glb", "vtp", "npz", "png", "html", "dx", "mrc", "vdb", "mls"]
MeshFormat = Literal["ply", "glb", "vtp", "npz"]
PointFormat = Literal["ply", "npz"]
PocketRank = Literal["score", "volume", "depth"]
PocketField = Literal["pockets", "probability"]
PocketFormat = Literal["csv", "json", "pdb", "cif", "ply", "glb", "png", "html", "dx", "mrc", "vdb", "npz"]
TableFormat = Literal["csv", "json"]

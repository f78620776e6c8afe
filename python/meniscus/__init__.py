# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Solvent-excluded surfaces of proteins and other molecules.

Examples
--------
>>> protein = meniscus.read("1ubq.pdb")
>>> surface = meniscus.surface(protein)
>>> surface.vertices.shape
(23190, 3)
>>> round(surface.measures.ses_area, 1)
3892.2
>>> surface.save("1ubq.ply", color="patch")

Lengths are in Å, areas in Å², volumes in Å³, curvatures in Å⁻¹. The level-set function is negative inside the molecule;
normals point into the solvent. Arrays of results are read-only views: nothing is copied. ``numpy(copy=True)`` of a
surface or structure, and ``copy()`` of any array, give arrays of your own. Indices are int32.

Structures, surfaces, exact surfaces, measures, pockets, comparisons and options can be pickled and copied, to the bit; a pickle is
for the version that made it.

Wherever atoms are expected, an object of MDAnalysis, MDTraj, Biopython, Biotite, gemmi or OpenMM will do, too.

A tutorial is in ``docs/python.md``.
"""
from ._calls import measure, signed_distance, surface
from ._compare import Compared, Comparison, Distance, compare
from ._component import Component
from ._core import version as __version__
from ._errors import CheckWarning, InputError, LimitError, OutputError, ReadWarning, UsageError
from ._exact import ExactSurface
from ._foreign import from_biopython, from_biotite, from_gemmi, from_mdanalysis, from_mdtraj, from_openmm
from ._interfaces import Interface
from ._keywords import Meshing, SurfaceOptions
from ._map import map
from ._measures import Measures
from ._nearest import Nearest
from ._nouns import RunOptions
from ._pockets import LigandFit, Mouth, Pocket, Pockets, pockets
from ._points import Points
from ._radii import radii
from ._reading import ReadOptions, read, read_models
from ._structure import Structure
from ._sums import Sum
from ._surface import Surface
from ._tracks import PocketTrack, PocketTracks, Spread, follow_pockets
from ._tunnels import Pore, Tunnel, pore

__all__ = [
    "CheckWarning",
    "Compared",
    "Comparison",
    "Component",
    "Distance",
    "ExactSurface",
    "InputError",
    "Interface",
    "LigandFit",
    "LimitError",
    "Measures",
    "Meshing",
    "Mouth",
    "Nearest",
    "OutputError",
    "Pocket",
    "PocketTrack",
    "PocketTracks",
    "Pockets",
    "Points",
    "Pore",
    "ReadOptions",
    "ReadWarning",
    "RunOptions",
    "Spread",
    "Structure",
    "Sum",
    "Surface",
    "SurfaceOptions",
    "Tunnel",
    "UsageError",
    "__version__",
    "compare",
    "follow_pockets",
    "from_biopython",
    "from_biotite",
    "from_gemmi",
    "from_mdanalysis",
    "from_mdtraj",
    "from_openmm",
    "map",
    "measure",
    "pockets",
    "pore",
    "radii",
    "read",
    "read_models",
    "signed_distance",
    "surface",
]

# People see these under the name by which they reach them.
for _name in __all__:
    if hasattr(globals()[_name], "__module__"):
        globals()[_name].__module__ = "meniscus"
del _name

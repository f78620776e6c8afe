# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The keywords of meshing; made by tools/make-reference."""
from __future__ import annotations

from typing import Any, TypedDict


class Meshing(TypedDict, total=False):
    """How to mesh: keywords of :func:`surface` and :meth:`ExactSurface.mesh`. None leaves an option at its
    default.

    components          Which closed pieces the mesh keeps (all, outer, cavities)
    min_cavity          Drop cavities that enclose less than V Å³ and what lies in them; outer pieces stay
    fill_cavities       Drop cavities that enclose less than V Å³, and count their space as inside in volumes
    density             Constant of the Gaussian map, Å⁻², negative; for method="gaussian", and for flows that start
                        from the map (flow="paper", flow="parallel" or a finite time_step)
    flow                Which flow; the options below modify it. Only anchored ends at the solvent-excluded surface;
                        paper is the flow of Pan and Tai (anchored, parallel, paper)
    curvature           The curvature field: parallel, or paper for flow="paper" (parallel, sharp, paper, paper-literal)
    anchor              Strength of the anchor in units of 1/H²: 16 for anchored, else 0 (none)
    reinitialise        What makes the level set a signed distance again before each step: none for anchored,
                        closest-point for parallel, paper for paper (none, closest-point, paper, paper-literal, godunov)
    solver              Solver of the linear systems: richardson, or gmres for flow="paper" (richardson, cg, gmres)
    slope               The factor |∇Φ| of the curvature: unit, or computed for flow="paper" (unit, computed)
    time_step           Time step in units of H²: inf (one solve) for anchored, else 1
    half_width          Half-width of the band: unknowns are the nodes within K spacings of the surface; 3, or 4 for
                        flow="paper"
    max_steps           Maximum number of steps: 30 for anchored, else 100
    tolerance           Stop when E spacings are left to go (anchored, 10⁻⁴), or when the speed is down to E (else, 10⁻²
                        Å⁻¹)
    edge                Even triangles with edges near L Å, instead of those of the grid, whose spacing is at most 0.5 Å
                        then; at least 97 % of the edges are between 0.6 and 1.5 L. The topology stays that of the
                        grid's mesh. A surface with folds narrower than L all over (van der Waals surfaces with 2 Å,
                        envelopes of gaussian) is refused: choose a smaller L
    vertex_density      The same as edge, given as vertices per Å²; use only one of the two
    adaptive            With edge: shorter edges where the surface bends more
    keep_ridges         With edge: edges run along the creases of the surface
    corners             With edge: where vertices lie. near: as near to the surface as keeps the triangles within 0.03
                        L² Å of it on average (with 1 Å on molecules, vertices are 0.01 Å off on average), or balanced
                        where nothing else is near enough. on-surface: on the surface, wherever the triangles then are
                        (0.037 Å off with 1 Å); with keep_ridges or method="gaussian", near means this. balanced: so
                        that the triangles lie on both sides of the surface (0.019 Å off; vertices 0.03 Å off) (near,
                        on-surface, balanced)
    simplify_topology   With edge: cut handles, close tunnels and drop pieces narrower than an edge
    history             Keep a record of every step of the flow
    initial_area        Measure the area of the Gaussian map, too, where the flow can do without it
    quality             Also find the angles, edges and aspect ratios of the triangles
    two_sided_distance  Measure how far mesh and exact surface are from each other between vertices, too
    verify              Also make the expensive self-checks: the mesh nowhere passes through itself, 20,000 points are
                        on the correct side, the exact measures are evaluated twice; exit code 6 if one fails
    """

    components: str | None
    min_cavity: float | None
    fill_cavities: float | None
    density: float | None
    flow: str | None
    curvature: str | None
    anchor: float | None
    reinitialise: str | None
    solver: str | None
    slope: str | None
    time_step: float | str | None
    half_width: float | None
    max_steps: int | None
    tolerance: float | None
    edge: float | None
    vertex_density: float | None
    adaptive: bool
    keep_ridges: bool
    corners: str | None
    simplify_topology: bool
    history: bool
    initial_area: bool
    quality: bool
    two_sided_distance: bool
    verify: bool


DEFAULTS: dict[str, Any] = {
    "components": "all",
    "min_cavity": 0.0,
    "fill_cavities": 0.0,
    "density": -0.5,
    "flow": "anchored",
    "curvature": None,
    "anchor": None,
    "reinitialise": None,
    "solver": None,
    "slope": None,
    "time_step": None,
    "half_width": None,
    "max_steps": None,
    "tolerance": None,
    "edge": None,
    "vertex_density": None,
    "adaptive": False,
    "keep_ridges": False,
    "corners": "near",
    "simplify_topology": False,
    "history": False,
    "initial_area": False,
    "quality": False,
    "two_sided_distance": False,
    "verify": False,
}

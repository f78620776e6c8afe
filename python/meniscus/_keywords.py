# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The options of surfaces, and their words as types; made by tools/make-reference."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Literal, TypedDict

from . import _core, _options
from ._nouns import Noun, defaults_of

if TYPE_CHECKING:
    from typing_extensions import Unpack

Method = Literal["flow", "direct", "gaussian"]
SurfaceKind = Literal["ses", "sas", "vdw"]
Components = Literal["all", "outer", "cavities"]
FlowName = Literal["anchored", "parallel", "paper"]
Curvature = Literal["parallel", "sharp", "paper", "paper-literal"]
Reinitialise = Literal["none", "closest-point", "paper", "paper-literal", "godunov"]
Solver = Literal["richardson", "cg", "gmres"]
Slope = Literal["unit", "computed"]
Corners = Literal["near", "on-surface", "balanced"]


class Meshing(TypedDict, total=False):
    """How to mesh: keywords of :func:`surface` and :meth:`ExactSurface.mesh`.

    :class:`SurfaceOptions` describes each. None leaves an option at its default.
    """

    components: Components | None
    min_cavity: float | None
    fill_cavities: float | None
    density: float | None
    flow: FlowName | None
    curvature: Curvature | None
    anchor: float | None
    reinitialise: Reinitialise | None
    solver: Solver | None
    slope: Slope | None
    time_step: float | Literal["inf"] | None
    half_width: float | None
    max_steps: int | None
    tolerance: float | None
    edge: float | None
    vertex_density: float | None
    adaptive: bool | None
    keep_ridges: bool | None
    corners: Corners | None
    simplify_topology: bool | None
    history: bool | None
    initial_area: bool | None
    quality: bool | None
    two_sided_distance: bool | None
    verify: bool | None


class SurfaceKeywordsAll(Meshing, total=False):
    """The names of :class:`SurfaceOptions` as keywords."""

    probe: float
    method: Method
    surface: SurfaceKind
    spacing: float | None


@dataclasses.dataclass(frozen=True, repr=False)
class SurfaceOptions(Noun):
    """Everything that decides what a surface is: which surface, and how it is meshed.

    Immutable; equal to another with the same values. None stands for the default that the text names.

    Parameters
    ----------
    probe : float, default 1.4
        Probe radius, Å; 0 gives the van der Waals surface.
    method : {"flow", "direct", "gaussian"}, default "flow"
        flow: a smooth surface, the steady state of the anchored flow, found in one solve; twice differentiable, with
        ridges rounded at the scale of the grid. direct: the exact distance, with sharp ridges. gaussian: only the
        envelope of the Gaussian map, which is not the solvent-excluded surface.
    surface : {"ses", "sas", "vdw"}, default "ses"
        Which surface: solvent-excluded, solvent-accessible (traced by the centre of the probe), or van der Waals (the
        same as probe 0). With method="flow" or direct.
    spacing : float (H), optional
        Grid spacing, Å; time and memory grow as 1/H². With edge and without spacing, small surfaces whose corrected
        area would be more than 0.5 % off are computed at 0.25 or 0.125 Å, unless their flow does not converge;
        summary and report say so.
    components : {"all", "outer", "cavities"}, default "all"
        Which closed pieces the mesh keeps.
    min_cavity : float (V), default 0.0
        Drop cavities that enclose less than V Å³ and what lies in them; outer pieces stay.
    fill_cavities : float (V), default 0.0
        Drop cavities that enclose less than V Å³, and count their space as inside in volumes.
    density : float, default -0.5
        Constant of the Gaussian map, Å⁻², negative; for method="gaussian", and for flows that start from the map
        (flow="paper", flow="parallel" or a finite time_step).
    flow : {"anchored", "parallel", "paper"}, default "anchored"
        Which flow; the options below modify it. Only anchored ends at the solvent-excluded surface; paper is the flow
        of Pan and Tai.
    curvature : {"parallel", "sharp", "paper", "paper-literal"}, optional
        The curvature field: parallel, or paper for flow="paper".
    anchor : float, optional
        Strength of the anchor in units of 1/H²: 16 for anchored, else 0 (none).
    reinitialise : {"none", "closest-point", "paper", "paper-literal", "godunov"}, optional
        What makes the level set a signed distance again before each step: none for anchored, closest-point for
        parallel, paper for paper.
    solver : {"richardson", "cg", "gmres"}, optional
        Solver of the linear systems: richardson, or gmres for flow="paper".
    slope : {"unit", "computed"}, optional
        The factor |∇Φ| of the curvature: unit, or computed for flow="paper".
    time_step : float or "inf", optional
        Time step in units of H²: inf (one solve) for anchored, else 1.
    half_width : float (K), optional
        Half-width of the band: unknowns are the nodes within K spacings of the surface; 3, or 4 for flow="paper".
    max_steps : int, optional
        Maximum number of steps: 30 for anchored, else 100.
    tolerance : float (E), optional
        Stop when E spacings are left to go (anchored, 10⁻⁴), or when the speed is down to E (else, 10⁻² Å⁻¹).
    edge : float (L), optional
        Even triangles with edges near L Å, instead of those of the grid, whose spacing is at most 0.5 Å then; at
        least 97 % of the edges are between 0.6 and 1.5 L. The topology stays that of the grid's mesh. A surface with
        folds narrower than L all over (van der Waals surfaces with 2 Å, envelopes of gaussian) is refused: choose a
        smaller L.
    vertex_density : float, optional
        The same as edge, given as vertices per Å²; use only one of the two.
    adaptive : bool, default False
        With edge: shorter edges where the surface bends more.
    keep_ridges : bool, default False
        With edge: edges run along the creases of the surface.
    corners : {"near", "on-surface", "balanced"}, default "near"
        With edge: where vertices lie. near: as near to the surface as keeps the triangles within 0.03 L² Å of it on
        average (with 1 Å on molecules, vertices are 0.01 Å off on average), or balanced where nothing else is near
        enough. on-surface: on the surface, wherever the triangles then are (0.037 Å off with 1 Å); with keep_ridges
        or method="gaussian", near means this. balanced: so that the triangles lie on both sides of the surface (0.019
        Å off; vertices 0.03 Å off).
    simplify_topology : bool, default False
        With edge: cut handles, close tunnels and drop pieces narrower than an edge.
    history : bool, default False
        Keep a record of every step of the flow.
    initial_area : bool, default False
        Measure the area of the Gaussian map, too, where the flow can do without it.
    quality : bool, default False
        Also find the angles, edges and aspect ratios of the triangles.
    two_sided_distance : bool, default False
        Measure how far mesh and exact surface are from each other between vertices, too.
    verify : bool, default False
        Also make the expensive self-checks: the mesh nowhere passes through itself, 20,000 points are on the correct
        side, the exact measures are evaluated twice; exit code 6 if one fails.

    Raises
    ------
    TypeError
        For a value of another type.
    UsageError
        For a value out of range, and for options that have no effect together.

    Examples
    --------
    >>> options = meniscus.SurfaceOptions(method="direct", spacing=1.0)
    >>> options
    SurfaceOptions(method='direct', spacing=1.0)
    >>> meniscus.surface([[0, 0, 0]], [2.0], options=options).passed
    True
    """

    probe: float = 1.4
    method: Method = "flow"
    surface: SurfaceKind = "ses"
    spacing: float | None = None
    components: Components = "all"
    min_cavity: float = 0.0
    fill_cavities: float = 0.0
    density: float = -0.5
    flow: FlowName = "anchored"
    curvature: Curvature | None = None
    anchor: float | None = None
    reinitialise: Reinitialise | None = None
    solver: Solver | None = None
    slope: Slope | None = None
    time_step: float | Literal["inf"] | None = None
    half_width: float | None = None
    max_steps: int | None = None
    tolerance: float | None = None
    edge: float | None = None
    vertex_density: float | None = None
    adaptive: bool = False
    keep_ridges: bool = False
    corners: Corners = "near"
    simplify_topology: bool = False
    history: bool = False
    initial_area: bool = False
    quality: bool = False
    two_sided_distance: bool = False
    verify: bool = False

    def __post_init__(self) -> None:
        self._set_defaults(but=("probe",))
        _options.not_negative("probe", self.probe)
        _core.check_surface_options(self._values())

    def replace(self, **changes: Unpack[SurfaceKeywordsAll]) -> SurfaceOptions:
        """Other options, with some values changed.

        Parameters
        ----------
        **changes
            New values by the names of the options.

        Returns
        -------
        SurfaceOptions

        Raises
        ------
        TypeError
            For a name that is no option, and for a value of another type.
        UsageError
            For a value out of range, and for options that have no effect together.

        Examples
        --------
        >>> meniscus.SurfaceOptions(edge=1.0).replace(edge=2.0, adaptive=True)
        SurfaceOptions(edge=2.0, adaptive=True)
        """
        return self._changed(changes)


SURFACE_DEFAULTS = defaults_of(SurfaceOptions)
MESHING_DEFAULTS = {name: SURFACE_DEFAULTS[name] for name in Meshing.__annotations__}

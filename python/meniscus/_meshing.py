# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Options of meshing, as keywords and as the extension takes them."""
from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Optional, TypedDict

from . import _options
from ._errors import UsageError

Progress = Optional[Callable[[str, float], object]]


class Meshing(TypedDict, total=False):
    """The keywords of :func:`surface` that say how to mesh, beside spacing, method, memory and progress."""

    components: str
    min_cavity: float
    fill_cavities: float
    edge: float | None
    vertex_density: float | None
    adaptive: bool
    keep_ridges: bool
    corners: str
    simplify_topology: bool
    density: float
    flow: str
    curvature: str | None
    anchor: float | None
    reinitialise: str | None
    solver: str | None
    slope: str | None
    time_step: float | str | None
    half_width: float | None
    max_steps: int | None
    tolerance: float | None
    history: bool
    initial_area: bool
    quality: bool
    two_sided_distance: bool
    verify: bool


_Check = Callable[[str, Any], Any]

_CHECKS: dict[str, _Check] = {
    "components": _options.word,
    "min_cavity": _options.number,
    "fill_cavities": _options.number,
    "adaptive": _options.flag,
    "keep_ridges": _options.flag,
    "corners": _options.word,
    "simplify_topology": _options.flag,
    "density": _options.number,
    "flow": _options.word,
    "history": _options.flag,
    "initial_area": _options.flag,
    "quality": _options.flag,
    "two_sided_distance": _options.flag,
    "verify": _options.flag,
}

# None leaves them to the library.
_CHECKS_UNLESS_NONE: dict[str, _Check] = {
    "edge": _options.positive,
    "vertex_density": _options.positive,
    "curvature": _options.word,
    "anchor": _options.number,
    "reinitialise": _options.word,
    "solver": _options.word,
    "slope": _options.word,
    "time_step": _options.time_step,
    "half_width": _options.number,
    "max_steps": _options.whole,
    "tolerance": _options.number,
}

_PIECES_OF_THE_FLOW = ("curvature", "anchor", "reinitialise", "solver", "slope", "time_step", "half_width", "max_steps",
                       "tolerance")


def meshing_options(spacing: float | None, method: str, memory: int | str | None,
                    given: Mapping[str, Any]) -> dict[str, Any]:
    """The options as the extension takes them."""
    options: dict[str, Any] = {"finer_grid": spacing is None, "method": _options.word("method", method)}
    if spacing is not None:
        options["spacing"] = _options.number("spacing", spacing)
    if memory is not None:
        options["memory_mb"] = _options.megabytes("memory", memory)
    for name, value in given.items():
        if name in _CHECKS:
            options[name] = _CHECKS[name](name, value)
        elif name not in _CHECKS_UNLESS_NONE:
            raise TypeError(f"unexpected keyword argument {name!r}")
        elif value is not None:
            options[name] = _CHECKS_UNLESS_NONE[name](name, value)
    _check_together(options)
    return options


def _check_together(options: dict[str, Any]) -> None:
    if "edge" in options and "vertex_density" in options:
        raise UsageError("edge and vertex_density set the same thing; give one of them")
    even = "edge" in options or "vertex_density" in options
    shaped = options.get("corners", "near") != "near" or any(
        options.get(name) for name in ("adaptive", "keep_ridges", "simplify_topology"))
    if shaped and not even:
        raise UsageError("adaptive, keep_ridges, corners and simplify_topology shape even triangles; ask for them with "
                         "edge")
    if options["method"] != "flow":
        given = [name for name in _PIECES_OF_THE_FLOW if name in options]
        if options.get("flow", "anchored") != "anchored":
            given.append("flow")
        if options.get("history"):
            given.append("history")
        if given:
            raise UsageError(f"{given[0]} applies to the flow; use method='flow'")

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Files of surfaces, each format chosen by the suffix."""
from __future__ import annotations

import io
import os
import pathlib
import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, Union, get_args

import numpy as np
import numpy.typing as npt

from . import _core, _options
from ._arrays import ArrayLike, as_array
from ._choices import ColorScheme, Drawn, Maps, ViewName
from ._errors import UsageError, opening
from ._files import write_whole

if TYPE_CHECKING:
    from ._points import Points
    from ._surface import Surface

Scheme = Union[ColorScheme, str]
Color = Union[Scheme, npt.NDArray[np.uint8]]
Values = Union[None, Mapping[str, ArrayLike]]
View = Union[ViewName, Sequence[float], Sequence[Sequence[float]], npt.NDArray[Any]]
Cut = Union[None, Literal["auto"], str, float, Sequence[float], Sequence[Sequence[float]], npt.NDArray[Any]]

Grid = Union[None, str, "os.PathLike[str]", Sequence[float], npt.NDArray[Any]]

_VIEWS = {
    "front": ((0, 0, 1), (0, 1, 0)),
    "back": ((0, 0, -1), (0, 1, 0)),
    "left": ((-1, 0, 0), (0, 1, 0)),
    "right": ((1, 0, 0), (0, 1, 0)),
    "top": ((0, 1, 0), (0, 0, -1)),
    "bottom": ((0, -1, 0), (0, 0, 1)),
}
_TRANSPARENT = (255, 255, 255, 0)


def colour_options(color: Color) -> dict[str, Any]:
    """A scheme, SCHEME:MIN:MAX, or one colour per vertex."""
    if not isinstance(color, str):
        return {"colors": _checked_colours(color)}
    scheme, *ends = color.split(":")
    if not ends:
        return {"color": scheme}
    try:
        low, high = (float(end) for end in ends)
    except ValueError:
        raise UsageError(f"color: '{color}' is neither a scheme nor SCHEME:MIN:MAX") from None
    return {"color": scheme, "range": (low, high)}


def value_options(values: Values, count: int) -> dict[str, Any]:
    """Arrays by name, in single precision, one number per vertex."""
    if not isinstance(values, (Mapping, type(None))):
        raise TypeError(f"values: must be arrays by name, such as {{'area': array}}, not {type(values).__name__}")
    arrays = {}
    for name, array in (values or {}).items():
        given = as_array(f"values: '{name}'", array)
        if given.dtype.kind not in "fiub":
            raise UsageError(f"values: '{name}' must be numbers, not {given.dtype}")
        with np.errstate(over="ignore"):
            arrays[str(name)] = single = np.ascontiguousarray(given, dtype=np.float32)
        if np.isinf(single).any():
            raise UsageError(f"values: '{name}' has a number beyond single precision; NaN is for missing values")
        if single.shape != (count,):
            raise UsageError(f"values: '{name}' must have the shape ({count},), one number per vertex, not "
                             f"{single.shape}")
    return {"values": arrays} if arrays else {}


def _checked_colours(color: Any) -> npt.NDArray[np.uint8]:
    array = as_array("color", color)
    if array.dtype != np.uint8 or array.ndim != 2 or array.shape[1] not in (3, 4):
        raise UsageError(f"color: must be a scheme or a uint8 array of shape (n, 3) or (n, 4), not {array.dtype} of "
                         f"shape {array.shape}")
    if array.shape[1] == 3:
        array = np.hstack([array, np.full((len(array), 1), 255, np.uint8)])
    return np.ascontiguousarray(array)


def _directions(view: View) -> tuple[Sequence[float], Sequence[float]] | None:
    if isinstance(view, str):
        if view == "auto":
            return None
        if view not in _VIEWS:
            raise UsageError(f"view: unknown value '{view}'; choose one of auto, {', '.join(_VIEWS)}, or directions")
        return _VIEWS[view]
    array = np.asarray(view, dtype=np.float64)
    if array.shape == (3,):
        upright = array[0] == 0 and array[2] == 0
        up = (0.0, 0.0, float(np.copysign(1.0, -array[1]))) if upright else (0.0, 1.0, 0.0)
        return array.tolist(), up
    if array.shape == (2, 3):
        return array[0].tolist(), array[1].tolist()
    raise UsageError(f"view: must be one or two directions, of shape (3,) or (2, 3), not {array.shape}")


def _background(background: str) -> tuple[int, ...]:
    colour = _TRANSPARENT if background == "transparent" else _core.named_color(_options.word("background", background))
    if colour is None:
        raise UsageError(f"background: '{background}' is not a colour; choose white, black, transparent or, "
                         "for instance, navy or #ffcc00")
    return colour


def _cut(cut: Cut) -> dict[str, Any] | None:
    if cut is None:
        return None
    if isinstance(cut, str):
        if cut == "auto":
            return {}
        match = re.fullmatch("cavity:([0-9]+)", cut)
        if not match or int(match[1]) < 1:
            raise UsageError(f"cut: unknown value '{cut}'; choose one of auto, cavity:N, a depth in Å, a point, or a "
                             "point and a normal")
        return {"cavity": int(match[1])}
    array = np.asarray(cut, dtype=np.float64)
    if array.shape == ():
        return {"depth": float(array)}
    if array.shape == (3,):
        return {"point": array.tolist()}
    if array.shape == (2, 3):
        return {"point": array[0].tolist(), "normal": array[1].tolist()}
    raise UsageError(f"cut: must be a point, or point and normal, of shape (3,) or (2, 3), not {array.shape}")


def _pair(name: str, values: Any) -> tuple[Any, Any]:
    try:
        first, second = values
    except (TypeError, ValueError):
        raise UsageError(f"{name}: two numbers are needed, not {values!r}") from None
    return first, second


def picture_options(drawing: dict[str, Any]) -> dict[str, Any]:
    width, height = _pair("size", drawing["size"])
    options: dict[str, Any] = {
        "width": _options.whole("size", width),
        "height": _options.whole("size", height),
        "background": _background(drawing["background"]),
        "outline": _options.flag("outline", drawing["outline"]),
        "depth_cue": _options.number("depth_cue", drawing["depth_cue"]),
        "legend": _options.flag("legend", drawing["legend"]),
        **_view_options(drawing),
    }
    cut = _cut(drawing["cut"])
    if cut is not None:
        options["cut"] = cut
    return options


def _ligands(drawing: dict[str, Any]) -> bool:
    """Whether ligands are drawn."""
    return _options.one_of("draw", drawing["draw"], get_args(Drawn)) == "ligands"


def _view_options(drawing: dict[str, Any]) -> dict[str, Any]:
    """What pages heed, too."""
    directions = _directions(drawing["view"])
    options: dict[str, Any] = {"perspective": _options.flag("perspective", drawing["perspective"]),
                               "ligands": _ligands(drawing)}
    return options if directions is None else {**options, "view": directions}


def _save_mesh(path: str, surface: Surface, options: dict[str, Any], drawing: dict[str, Any]) -> None:
    _core.write_mesh(path, surface._core, surface.structure._core, {**options, "ligands": _ligands(drawing)})


def _save_picture(path: str, surface: Surface, options: dict[str, Any], drawing: dict[str, Any]) -> None:
    _core.write_picture(path, surface._core, surface.structure._core, {**options, **picture_options(drawing)})


def _save_page(path: str, surface: Surface, options: dict[str, Any], drawing: dict[str, Any]) -> None:
    _core.write_page(path, surface._core, surface.structure._core, surface.measures._core,
                     {**options, **_view_options(drawing)})


def _save_level_set(path: str, surface: Surface, options: dict[str, Any], drawing: dict[str, Any]) -> None:
    _core.write_level_set(path, surface._core)


def _grid_options(grid: Grid) -> dict[str, Any]:
    if grid is None:
        return {}
    if isinstance(grid, (str, os.PathLike)):
        return {"grid_file": os.fspath(grid)}
    array = np.asarray(grid, dtype=np.float64)
    if array.shape != (7,):
        raise UsageError(f"grid: must be a file or seven numbers (nx, ny, nz, h, cx, cy, cz), not {array.shape}")
    if not (np.isfinite(array).all() and (array[:3] == np.rint(array[:3])).all()):
        raise UsageError("grid: the numbers of nodes must be whole, and all seven numbers finite")
    counts = tuple(_options.whole("grid", int(n)) for n in array[:3])
    return {"grid": (counts, _options.positive("grid", array[3]), tuple(array[4:].tolist()))}


def _volume_options(drawing: dict[str, Any]) -> dict[str, Any]:
    inner, outer = _pair("eps", drawing["eps"])
    return {
        "field": _options.word("field", drawing["field"]),
        "eps": (_options.positive("eps", inner), _options.positive("eps", outer)),
        "ion_radius": _options.number("ion_radius", drawing["ion_radius"]),
        **_grid_options(drawing["grid"]),
    }


def _save_volume(path: str, surface: Surface, options: dict[str, Any], drawing: dict[str, Any]) -> None:
    asked = {"threads": options["threads"], **_volume_options(drawing)}
    maps = drawing["maps"]
    if maps is None:
        with opening(asked.get("grid_file", "")):
            return _core.write_volume(path, surface._core, asked)
    _options.one_of("maps", maps, get_args(Maps))
    stem, suffix = os.path.splitext(path)
    if suffix != ".dx":
        raise UsageError(f"{path}: APBS reads its maps as .dx; name a file with that suffix")
    if drawing["grid"] is None:
        raise UsageError("maps='apbs' needs the grid of APBS; set grid to a .dx file or seven numbers")
    with opening(asked.get("grid_file", "")):
        for name in ("dielx", "diely", "dielz", "kappa"):
            _core.write_volume(f"{stem}_{name}.dx", surface._core, {**asked, "map": name})
    return None


def _save_point_arrays(path: str, points: Points, more: dict[str, npt.NDArray[Any]]) -> None:
    packed = io.BytesIO()
    np.savez_compressed(packed, **{**more, **points.numpy()})
    write_whole(path, packed.getvalue())


# A format is one line here, one in _choices.py and one in Surface.save's text.
_SURFACE_WRITERS: dict[str, Callable[[str, Surface, dict[str, Any], dict[str, Any]], None]] = {
    ".ply": _save_mesh,
    ".obj": _save_mesh,
    ".stl": _save_mesh,
    ".off": _save_mesh,
    ".glb": _save_mesh,
    ".vtp": _save_mesh,
    ".vert": _save_mesh,
    ".npz": _save_mesh,
    ".png": _save_picture,
    ".html": _save_page,
    ".dx": _save_volume,
    ".mrc": _save_volume,
    ".vdb": _save_volume,
    ".mls": _save_level_set,
}


def _unknown_suffix(path: str, known: Sequence[str]) -> UsageError:
    return UsageError(f"{path}: unknown suffix; choose one of {' '.join(known)}")


def _part_options(path: str, writer: Any, part: dict[str, Any]) -> dict[str, Any]:
    """What of a mesh is written; nothing for all of it."""
    given = {name: value for name, value in part.items() if value is not None}
    if given and writer is not _save_mesh:
        raise UsageError(f"{path}: show and cavity apply to meshes; choose a mesh format")
    if len(given) > 1:
        raise UsageError("show and cavity cannot be combined; give one of them")
    if "show" in given and not _options.word("show", given["show"]):
        raise UsageError("show: empty; write for instance //A/10-50")
    if "cavity_file" in given and _options.whole("cavity", given["cavity_file"]) < 1:
        raise UsageError(f"cavity {given['cavity_file']}: cavities are counted from 1")
    return given


def save_surface(path: str, surface: Surface, color: Color, values: Values, ascii: bool, part: dict[str, Any],
                 drawing: dict[str, Any]) -> None:
    writer = _SURFACE_WRITERS.get(pathlib.PurePath(path).suffix)
    if writer is None:
        raise _unknown_suffix(path, list(_SURFACE_WRITERS))
    for check in (picture_options, _volume_options):  # of every format: one set of options may go to several files
        check(drawing)
    options = {**colour_options(color), **value_options(values, len(surface.normals)),
               **_part_options(path, writer, part), "ascii": _options.flag("ascii", ascii),
               "threads": surface.options["threads"]}
    writer(path, surface, options, drawing)


def save_points(path: str, points: Points, color: Color, values: Values, ascii: bool) -> None:
    suffix = pathlib.PurePath(path).suffix
    if suffix == ".ply":
        options = {**colour_options(color), **value_options(values, len(points)),
                   "ascii": _options.flag("ascii", ascii)}
        _core.write_points(path, points._mesh, points.structure._core, points.exact._core, options)
    elif suffix == ".npz":
        _save_point_arrays(path, points, value_options(values, len(points)).get("values", {}))
    else:
        raise _unknown_suffix(path, [".ply", ".npz"])

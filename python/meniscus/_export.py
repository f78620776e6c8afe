# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Tables and meshes as objects of other packages, which are imported only here and only when asked for."""
from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ._surface import Surface


def package(module: str, method: str, name: str) -> Any:
    """A package that is not required, or one line that says what to install."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ImportError(f"{method}() needs {name}, which is not installed; install it: pip install {module}",
                          name=module) from error


def frame(columns: Mapping[str, Any]) -> Any:
    """A table of pandas."""
    return package("pandas", "to_pandas", "pandas").DataFrame(dict(columns))


def _colours(surface: Surface, color: Any) -> Any:
    return surface.colors(color) if isinstance(color, str) else np.asarray(color)


def trimesh_of(surface: Surface, color: Any, arrays: dict[str, Any]) -> Any:
    """Without trimesh's own processing, which would merge and reorder vertices."""
    trimesh = package("trimesh", "to_trimesh", "trimesh")
    return trimesh.Trimesh(vertices=surface.vertices.copy(), faces=surface.triangles.copy(),
                           vertex_normals=surface.normals.copy(), vertex_colors=_colours(surface, color),
                           vertex_attributes=arrays, process=False)


def pyvista_of(surface: Surface, color: Any, arrays: dict[str, Any]) -> Any:
    """Faces are given as VTK has them: 3, a, b, c."""
    pyvista = package("pyvista", "to_pyvista", "PyVista")
    faces = np.hstack([np.full((len(surface.triangles), 1), 3, np.int64), surface.triangles])
    mesh = pyvista.PolyData(surface.vertices.copy(), faces.ravel())
    for name, values in {"Normals": surface.normals, **arrays}.items():
        mesh.point_data[name] = values.copy()
    if color is not None:
        mesh.point_data["colors"] = _colours(surface, color)
    return mesh

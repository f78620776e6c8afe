# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Keywords of meshing, as the extension takes them."""
from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Any, Optional, TypeVar

from . import _options
from ._keywords import DEFAULTS, Meshing
from ._structure import Reading

Progress = Optional[Callable[[str, float], object]]
Function = TypeVar("Function", bound=Callable[..., Any])


class SurfaceKeywords(Meshing, Reading, total=False):
    """What :func:`surface` takes beside the arguments that it names."""


def meshing_options(spacing: float | None, method: str, memory: int | str | None,
                    given: Mapping[str, Any]) -> dict[str, Any]:
    """The options as the extension takes them."""
    for name in given:
        if name not in DEFAULTS:
            raise TypeError(f"unexpected keyword argument {name!r}")
    options = {"method": method, "spacing": spacing, **given}
    if memory is not None:
        options["memory"] = _options.megabytes("memory", memory)
    return {name: value for name, value in options.items() if value is not None}


def with_keywords(keywords: Mapping[str, Any], others: str = "") -> Callable[[Function], Function]:
    """Makes help() and completion show keywords with their defaults, and **others if there are any."""
    def decorate(function: Function) -> Function:
        signature = inspect.signature(function)
        parameters = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        parameters += [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=value)
                       for name, value in keywords.items()]
        if others:
            parameters.append(inspect.Parameter(others, inspect.Parameter.VAR_KEYWORD))
        function.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
        return function
    return decorate

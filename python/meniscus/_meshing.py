# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""How functions that take options both as an object and as keywords put them together."""
from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Mapping
from typing import Any, TypeVar

from ._nouns import NOT_GIVEN, RunOptions, of_kind

Function = TypeVar("Function", bound=Callable[..., Any])


def given(**keywords: Any) -> dict[str, Any]:
    """Those that the caller has given."""
    return {name: value for name, value in keywords.items() if value is not NOT_GIVEN}


def with_run(run: RunOptions | None, **keywords: Any) -> RunOptions:
    """The options of a run, of which keywords replace some."""
    return of_kind("run", run, RunOptions).replace(**given(**keywords))


def with_keywords(keywords: Mapping[str, Any], others: str = "", but: Collection[str] = ()
                  ) -> Callable[[Function], Function]:
    """Makes help() and completion show keywords with their defaults, but not some, and **others if there are any."""
    def decorate(function: Function) -> Function:
        signature = inspect.signature(function)
        named = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        parameters = [p.replace(default=keywords[p.name]) if p.default is NOT_GIVEN else p for p in named]
        parameters += [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=value)
                       for name, value in keywords.items() if name not in (*signature.parameters, *but)]
        if others:
            parameters.append(inspect.Parameter(others, inspect.Parameter.VAR_KEYWORD))
        function.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
        return function
    return decorate

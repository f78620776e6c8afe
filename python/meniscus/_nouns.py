# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Options as immutable objects: what they have in common, and those of a run."""
from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Optional, TypedDict, TypeVar

from . import _options

if TYPE_CHECKING:
    from typing_extensions import Unpack

Progress = Optional[Callable[[str, float], object]]

NOT_GIVEN: Any = object()
"""The default of keywords that may also stand in an object of options."""


Options = TypeVar("Options", bound="Noun")


@dataclasses.dataclass(frozen=True, repr=False)
class Noun:
    """Base of dataclasses that hold options."""

    def _set_defaults(self, but: tuple[str, ...] = ()) -> None:
        for field in dataclasses.fields(self):
            if field.name not in but and getattr(self, field.name) is None:
                object.__setattr__(self, field.name, field.default)

    def _values(self) -> dict[str, Any]:
        """All but those that are None."""
        values = {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}
        return {name: value for name, value in values.items() if value is not None}

    def _given(self) -> dict[str, Any]:
        """Those that do not have their default values."""
        defaults = defaults_of(type(self))
        return {name: value for name, value in self._values().items() if value != defaults[name]}

    def _changed(self: Options, changes: Mapping[str, Any]) -> Options:
        for name in changes:
            if name not in defaults_of(type(self)):
                raise TypeError(f"unexpected keyword argument {name!r}")
        return dataclasses.replace(self, **changes)

    def __repr__(self) -> str:
        given = ", ".join(f"{name}={value!r}" for name, value in self._given().items())
        return f"{type(self).__name__}({given})"


def defaults_of(kind: type[Noun]) -> dict[str, Any]:
    """The default values of options by their names."""
    return {field.name: field.default for field in dataclasses.fields(kind)}


def of_kind(name: str, value: Options | None, kind: type[Options]) -> Options:
    """Options that a caller gives, or those with all defaults."""
    if value is None:
        return kind()
    if not isinstance(value, kind):
        raise TypeError(f"{name}: must be {kind.__name__}, not {type(value).__name__}")
    return value


class Running(TypedDict, total=False):
    """The names of :class:`RunOptions` as keywords."""

    threads: int
    memory: int | str | None
    progress: Progress


@dataclasses.dataclass(frozen=True, repr=False)
class RunOptions(Noun):
    """What a computation may use, and what is called while it runs. The result does not depend on it.

    Immutable; equal to another with the same values.

    Parameters
    ----------
    threads : int, default 0
        Number of threads; 0: all cores.
    memory : int or str, optional
        "4G", "500M" or a number of MB: refuse what would need more. None: what the machine has available.
    progress : callable, optional
        Called with the name of the stage and the fraction of it that is done, 0 to 1, a few times per second. An
        exception that it raises ends the computation, as Ctrl-C does.

    Raises
    ------
    TypeError
        For a value of another type.
    UsageError
        For a number of threads below 0, and for what is no amount of memory.

    Examples
    --------
    >>> run = meniscus.RunOptions(threads=1, memory="4G")
    >>> meniscus.surface([[0, 0, 0]], [2.0], run=run).passed
    True
    >>> run.replace(threads=2)
    RunOptions(threads=2, memory='4G')
    """

    threads: int = 0
    memory: int | str | None = None
    progress: Progress = None

    def __post_init__(self) -> None:
        _options.count("threads", self.threads)
        if self.memory is not None:
            _options.megabytes("memory", self.memory)
        if self.progress is not None and not callable(self.progress):
            raise TypeError(f"progress: must be a function of stage and fraction, not {self.progress!r}")

    def replace(self, **changes: Unpack[Running]) -> RunOptions:
        """Other options, with some values changed.

        Parameters
        ----------
        **changes
            New values by the names of the options.

        Returns
        -------
        RunOptions
        """
        return self._changed(changes)


RUN_DEFAULTS = defaults_of(RunOptions)

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What can go wrong, with the words of the command line, and what is worth a warning."""
from __future__ import annotations

import contextlib
import errno
import os
import sys
import warnings
from collections.abc import Iterator


class UsageError(ValueError):
    """An invalid option or array: unknown word, value out of range, wrong shape."""


class InputError(ValueError):
    """A file whose content is not valid; the message is "FILE:LINE:COLUMN: what is wrong; what to do"."""


class OutputError(OSError):
    """A file that cannot be written; no partial file is left behind."""


class LimitError(ValueError, MemoryError):
    """A computation that would exceed the memory; the message says which option to change."""


class ReadWarning(UserWarning):
    """An assumption made while reading a file that may make a number wrong; ``Structure.warnings`` has the same line."""


class CheckWarning(UserWarning):
    """A result that failed its own checks; the checks are in ``Surface.checks``."""


def warn(message: str, category: type[Warning]) -> None:
    """A warning that names the line from which this package was called."""
    frame, level = sys._getframe(), 1
    while frame.f_back is not None and frame.f_globals["__name__"].partition(".")[0] == __package__:
        frame, level = frame.f_back, level + 1
    warnings.warn(message, category, stacklevel=level)


def unreadable(path: str, message: str) -> OSError | None:
    """The error of opening a file with the reader's message; None if the file can be opened."""
    try:
        with open(path, "rb"):
            return None
    except OSError as error:
        renamed = type(error)(message)
        renamed.errno = error.errno or errno.EIO
        return renamed


@contextlib.contextmanager
def opening(path: str) -> Iterator[None]:
    """What is read of a file inside; one that cannot be opened is an OSError instead of an InputError."""
    try:
        yield
    except InputError as error:
        raise unreadable(path, str(error)) or error from None


def text_of_path(path: str | os.PathLike[str]) -> str:
    text = os.fspath(path)
    if not isinstance(text, str):
        raise TypeError(f"a path must be text, not {type(text).__name__}")
    if "\0" in text:
        raise UsageError(f"{text!r}: a path has no null characters")
    return text

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Paths and open files: what is read from either, and written to either."""
from __future__ import annotations

import contextlib
import io
import os
import pathlib
import tempfile
from collections.abc import Callable, Iterator
from typing import Any, Protocol, Union

from . import _core, _options
from ._errors import InputError, OutputError, UsageError, text_of_path

Path = Union[str, "os.PathLike[str]"]


class Readable(Protocol):
    """An open file, io.BytesIO, io.StringIO, gzip.GzipFile ..."""

    def read(self) -> bytes | str: ...


class Writable(Protocol):
    """An open file, io.BytesIO, gzip.GzipFile ..."""

    def write(self, data: Any, /) -> object: ...


Source = Union[Path, Readable]
Target = Union[Path, Writable]


def is_file(value: object) -> bool:
    """Whether this is an open file that can be read, and not the path of one."""
    return not isinstance(value, (str, os.PathLike)) and hasattr(value, "read")


def name_of(file: object) -> str:
    """The path that a file was opened by; empty if it has none."""
    name = getattr(file, "name", "")
    return name if isinstance(name, str) else ""


def content_of(file: Any) -> bytes:
    """All that is still to be read from a file; text as UTF-8."""
    data = file.read()
    if isinstance(data, str):
        return data.encode("utf-8", "surrogateescape")
    if not isinstance(data, (bytes, bytearray, memoryview)):
        raise TypeError(f"read() of the file must give bytes or text, not {type(data).__name__}")
    return bytes(data)


class Kept:
    """The content of an open file, which can be read more than once."""

    def __init__(self, file: Any) -> None:
        self.name = name_of(file)
        self._content = content_of(file)

    def read(self) -> bytes:
        return self._content


def suffix_of(path: str, format: str | None) -> str:
    """The suffix that says how to write: of the format, else of the path."""
    if format is None:
        return pathlib.PurePath(path).suffix
    letters = _options.some("format", format).lstrip(".")
    if not letters.isalnum():
        raise UsageError(f"format: unknown value {format!r}; write for instance format=\"ply\"")
    return "." + letters


def save_to(target: Target, format: str | None, save: Callable[[str], object]) -> None:
    """Saves to a path or an open file, also where the suffix is not that of the format.

    save     writes to a path with the right suffix
    """
    if not isinstance(target, (str, os.PathLike)) and hasattr(target, "write"):
        _write_to(target, _single_file(suffix_of(name_of(target), format), save))
        return
    path = text_of_path(target)  # type: ignore[arg-type]
    suffix = suffix_of(path, format)
    if suffix == pathlib.PurePath(path).suffix:
        save(path)
    else:
        write_whole(path, _single_file(suffix, save))


def _single_file(suffix: str, save: Callable[[str], object]) -> bytes:
    if not suffix:
        raise UsageError('format: required for a file without a name; write for instance format="ply"')
    with tempfile.TemporaryDirectory(prefix="meniscus-") as folder:
        with _without_folder(folder):
            save(os.path.join(folder, "output" + suffix))
        files = list(pathlib.Path(folder).iterdir())
        if len(files) != 1:
            raise UsageError(f"format {suffix[1:]}: makes several files; give a path ending in {suffix}")
        return files[0].read_bytes()


def _write_to(file: Any, data: bytes) -> None:
    if not isinstance(file, io.TextIOBase):
        _write_all(file, data)
        return
    try:
        file.write(data.decode("utf-8"))
    except UnicodeDecodeError:
        raise UsageError("the file was opened as text, but this format is binary; open it with mode 'wb'") from None


def _write_all(file: Any, data: bytes) -> None:
    """Unbuffered files may take a part only, and tell how much; what tells nothing has taken all."""
    rest: bytes | memoryview = data
    while len(rest) > 0:
        taken = file.write(rest)
        if isinstance(taken, int) and taken <= 0 or taken is None and isinstance(file, io.RawIOBase):
            raise OutputError(f"{name_of(file) or 'the file'}: took only {len(data) - len(rest)} of {len(data)} bytes")
        rest = memoryview(rest)[taken if isinstance(taken, int) else len(rest):]


def write_whole(path: str, data: bytes) -> None:
    """A file appears whole or not at all, links are followed, and a pipe or device gets the bytes, as from every writer."""
    _core.write_bytes(os.fsencode(path), data)


@contextlib.contextmanager
def _without_folder(folder: str) -> Iterator[None]:
    """Messages do not name the folder of temporary files, of which the caller knows nothing."""
    try:
        yield
    except (InputError, UsageError) as error:
        raise type(error)(str(error).replace(folder + os.sep, "")) from None


@contextlib.contextmanager
def on_disk(source: Source, format: str | None = None) -> Iterator[str]:
    """The path of a file with the content of an open one; a path as it is. Messages have the name without the folder."""
    if not is_file(source):
        yield text_of_path(source)  # type: ignore[arg-type]
        return
    name = os.path.basename(name_of(source)) or "data"
    if format:
        name = pathlib.PurePath(name).stem + suffix_of(name, format)
    with tempfile.TemporaryDirectory(prefix="meniscus-") as folder:
        path = os.path.join(folder, name)
        pathlib.Path(path).write_bytes(content_of(source))
        with _without_folder(folder):
            yield path

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""One input of map(), computed by the program in a process of its own."""
from __future__ import annotations

import concurrent.futures
import dataclasses
import errno
import json
import os
import subprocess
import tempfile
import threading
from collections.abc import Sequence

from ._errors import InputError, LimitError, OutputError, UsageError
from ._program import find as find_program

_ERRORS: dict[int, type[Exception]] = {2: UsageError, 3: InputError, 4: OutputError, 5: LimitError}
_ERROR_MARK = "meniscus: error: "


@dataclasses.dataclass(frozen=True)
class Task:
    """One input."""

    name: str
    """its path below the base"""
    path: str
    size: int
    """bytes; -1 where there is no such file"""
    endings: tuple[str, ...]
    """of its outputs, as the program is given them"""


@dataclasses.dataclass(frozen=True)
class Lines:
    """What the program wrote of one input, as it wrote it."""

    result: bytes
    times: bytes


class Children:
    """Processes that can be ended from another thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._running: set[subprocess.Popen[str]] = set()
        self._ended = False

    def run(self, words: Sequence[str], folder: str | None) -> tuple[int, str]:
        """A program's exit code and what it wrote to standard error."""
        with self._lock:
            if self._ended:
                raise concurrent.futures.CancelledError
            process = subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.PIPE, encoding="utf-8", errors="replace")
            self._running.add(process)
        try:
            messages = process.communicate()[1]
        finally:
            with self._lock:
                self._running.discard(process)
        return process.returncode, messages

    def end(self) -> None:
        """Ends them all, and those that are still to be started."""
        with self._lock:
            self._ended = True
            for process in self._running:
                process.terminate()


@dataclasses.dataclass(frozen=True)
class Work:
    """What all inputs have in common; it goes to the workers."""

    program: str | None
    words: tuple[str, ...]
    base: str
    folder: str
    """from where files named in options are looked for"""
    out: str | None
    scratch: str | None
    """holds what is under way; None for the system's folder"""

    def compute(self, task: Task, children: Children | None = None) -> Lines:
        """One input by one run of `meniscus batch`, whose record it is."""
        program = self.program or find_program()
        if program is None:
            raise FileNotFoundError(errno.ENOENT, "the program is neither in this package nor on the PATH; install it "
                                                  "(docs/install.md), or name it with program=", "meniscus")
        with tempfile.TemporaryDirectory(prefix="meniscus-", dir=self.scratch) as scratch:
            endings = [word for ending in task.endings for word in ("-o", ending)]
            # A worker may be in a task of a Slurm array, of which a batch would take its part.
            words = [program, "batch", *self.words, *endings, f"--base={self.base}", f"--out={scratch}", "--jobs=1",
                     "--shard=0/1", "--quiet", "--progress=off", *_input_words(task, scratch)]
            code, messages = (children or Children()).run(words, self.folder if os.path.isdir(self.folder) else None)
            if code not in (0, 6):
                raise _error_of(program, code, messages)
            lines = Lines(_content(scratch, "results.jsonl"), _content(scratch, "times.jsonl"))
            if self.out is not None:
                _move(json.loads(lines.result)["outputs"], scratch, self.out)
        return lines


def _input_words(task: Task, scratch: str) -> list[str]:
    """A file that is missing stands in a list: then it is a line of the results, and does not end the batch."""
    if task.size >= 0:
        return ["--", task.path]
    path = os.path.join(scratch, "list")
    with open(path, "wb") as file:
        file.write(os.fsencode(task.path))
    return [f"--list={path}"]


def _content(folder: str, name: str) -> bytes:
    with open(os.path.join(folder, name), "rb") as file:
        return file.read()


def _error_of(program: str, code: int, messages: str) -> Exception:
    told = [line[len(_ERROR_MARK):] for line in messages.splitlines() if line.startswith(_ERROR_MARK)]
    if code in _ERRORS and told:
        return _ERRORS[code](told[-1])
    how = f"ended with exit code {code}" if code >= 0 else f"was ended by signal {-code}"
    return RuntimeError(f"{program}: {how}: {messages.strip()}")


def _move(outputs: Sequence[str], scratch: str, out: str) -> None:
    for output in outputs:
        target = os.path.join(out, output)
        try:
            os.makedirs(os.path.dirname(target), exist_ok=True)
            os.replace(os.path.join(scratch, output), target)
        except OSError as error:
            raise OutputError(f"{target}: cannot be written: {error.strerror}") from error

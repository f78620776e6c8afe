# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Many inputs, each computed by the program in a process of its own, here or on the workers of a Dask cluster."""
from __future__ import annotations

import collections
import concurrent.futures
import dataclasses
import errno
import os
import re
import shutil
import tempfile
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Protocol, Union, get_args

from . import _options
from ._choices import Command
from ._errors import OutputError, UsageError, text_of_path
from ._files import Path
from ._records import collect
from ._work import Children, Lines, Task, Work

_SUFFIX = re.compile(r"(?<=.)\.(pdb[0-9]{0,2}|ent|cif|mmcif|pdbqt|pqr|xyzr|xyzrn)(\.gz)?\Z", re.ASCII | re.DOTALL | re.IGNORECASE)

# Options of `meniscus batch` that are of no use for one input, or parameters of map().
_OWN = ("collect", "help", "help_all", "list", "o", "progress", "quiet", "report", "resume", "shard")

# Of a task that failed for what may pass: a full disk, a program that the system ended. Tasks of workers that are gone
# run again anyway.
_RETRIES = 2


class Client(Protocol):
    """What is used of a ``distributed.Client``."""

    def map(self, func: Callable[..., Any], *iterables: Any, key: str, pure: bool, retries: int) -> Any: ...
    def gather(self, futures: Any) -> Any: ...
    def cancel(self, futures: Any) -> Any: ...


def _option_words(options: dict[str, Any]) -> list[str]:
    """Keywords as the command line has them: min_cavity=5 as --min-cavity=5."""
    words = []
    for name, value in options.items():
        if name in _OWN:
            raise UsageError(f"{name}: is not an option of map()")
        option = "--" + name.replace("_", "-")
        for one in value if isinstance(value, (list, tuple)) else [value]:
            if one is False and name == "waters":
                words.append("--no-waters")
            elif one is not None and one is not False:
                words.append(option if one is True else f"{option}={one}")
    return words


def _common_folder(paths: Sequence[str]) -> str:
    return os.path.commonpath([os.path.dirname(path) for path in paths]) if paths else os.getcwd()


def _name(path: str, base: str) -> str:
    name = os.path.relpath(path, base)
    if name.split(os.sep)[0] == os.pardir:
        raise UsageError(f"{path}: is not below {base}; base must be a folder that holds all inputs")
    return name


def _size(path: str) -> int:
    """-1 where there is no such file; what hinders its reading is told by the program."""
    try:
        size = os.stat(path).st_size
    except OSError:
        return -1
    if os.path.isdir(path) or path.lower().endswith(".tar"):
        raise UsageError(f"{path}: holds many inputs; name each file in it, or use meniscus batch")
    return size


def _tasks(paths: Iterable[str], base: str, endings: Sequence[str]) -> list[Task]:
    """A task for every file, largest first."""
    names = {path: _name(path, base) for path in paths}
    stems = {name: _SUFFIX.sub("", name) for name in names.values()}
    uses = collections.Counter(stems.values())
    tasks = []
    for path, name in names.items():
        # Names that differ only in their suffix keep it, so that their outputs differ.
        kept = name[len(stems[name]):] if uses[stems[name]] > 1 else ""
        tasks.append(Task(name, path, _size(path), tuple(kept + ending for ending in endings)))
    if tasks and all(task.size < 0 for task in tasks):
        raise FileNotFoundError(errno.ENOENT, "none of the files is there", tasks[0].path)
    return sorted(tasks, key=lambda task: -task.size)


def _run_here(work: Work, tasks: Sequence[Task], jobs: int) -> list[Lines]:
    children = Children()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        futures = [pool.submit(work.compute, task, children) for task in tasks]
        try:
            done = concurrent.futures.wait(futures, return_when=concurrent.futures.FIRST_EXCEPTION).done
            for future in done:
                future.result()
            return [future.result() for future in futures]
        except BaseException:
            for future in futures:
                future.cancel()
            children.end()
            raise


def _run_on(client: Client, work: Work, tasks: Sequence[Task]) -> list[Lines]:
    futures = client.map(work.compute, tasks, key=f"meniscus-{work.words[0]}", pure=False, retries=_RETRIES)
    try:
        return list(client.gather(futures))
    except BaseException:
        client.cancel(futures)
        raise


def _run(client: Client | None, work: Work, tasks: Sequence[Task], jobs: int) -> list[Lines]:
    """In a folder for what is under way; it is among the outputs, so that these can be moved into place."""
    if work.out is None:
        return _run_here(work, tasks, jobs) if client is None else _run_on(client, work, tasks)
    try:
        os.makedirs(work.out, exist_ok=True)
        scratch = tempfile.mkdtemp(prefix=".map-", dir=work.out)
    except OSError as error:
        raise OutputError(f"{work.out}: cannot be written: {error.strerror}") from error
    try:
        work = dataclasses.replace(work, scratch=scratch)
        return _run_here(work, tasks, jobs) if client is None else _run_on(client, work, tasks)
    finally:
        shutil.rmtree(scratch, ignore_errors=True)


def _program(program: Path | None) -> str | None:
    """A name without a folder is looked for on the PATH of the process that starts it."""
    text = None if program is None else text_of_path(program)
    return os.path.abspath(text) if text and os.sep in text else text


def _folder(name: str, folder: Path | None) -> str | None:
    if folder is None:
        return None
    text = text_of_path(folder)
    if not text or text.endswith((".tar", ".tar.gz", ".tgz", ".zip")):
        raise UsageError(f"{name}: must be a folder, not '{text}'")
    return os.path.abspath(text)


def _files(paths: Iterable[Path]) -> list[str]:
    if isinstance(paths, (str, bytes, os.PathLike)):
        raise TypeError("paths: must be a list of paths, not one")
    return [os.path.abspath(text_of_path(path)) for path in paths]


def _endings(command: str, outputs: str | Sequence[str], out: str | None) -> tuple[str, ...]:
    _options.one_of("command", command, get_args(Command))
    endings = (outputs,) if isinstance(outputs, str) else tuple(outputs)
    if endings and out is None:
        raise UsageError("outputs: give a folder for them, out=")
    return (".ply",) if command == "surface" and out is not None and not endings else endings


def _jobs(client: Client | None, jobs: int | None) -> int:
    if jobs is None:
        return _cores()
    if client is not None:
        raise UsageError("jobs: the workers of the client decide this; leave it out")
    if _options.whole("jobs", jobs) < 1:
        raise UsageError(f"jobs {jobs}: must be at least 1")
    return jobs


def _cores() -> int:
    return len(os.sched_getaffinity(0))


def _threads(client: Client | None, jobs: int) -> int:
    """Of each process, where that was left open: a worker runs as many tasks at once as it has threads."""
    return 1 if client is not None else max(1, _cores() // jobs)


def map(
    paths: Iterable[Path],
    client: Client | None = None,
    *,
    command: Command = "measure",
    out: Path | None = None,
    outputs: Union[str, Sequence[str]] = (),
    base: Path | None = None,
    time_limit: float | str | None = None,
    memory_limit: str | None = None,
    mixed_radii: bool = False,
    program: Path | None = None,
    jobs: int | None = None,
    **options: Any,
) -> list[dict[str, Any]]:
    """Computes many files; returns what ``meniscus batch`` records of each, in the order of ``paths``.

    Every file is computed by the program in a process of its own, so a file that cannot be read, crashes or takes too
    long has a record that says so and does not affect the others. A record is what ``meniscus batch`` writes as a line
    of JSON: ``input`` (its name), ``status`` ("done", "failed", "checks failed", "timed out", "crashed"), ``exit``,
    ``error``, ``outputs`` and ``report``.

    Parameters
    ----------
    paths : sequence of str or os.PathLike
        Files of structures.
    client : distributed.Client, optional
        Its workers compute, and if one is lost, others take over its part. They need this package and the program, and
        must see files under the same paths. By default, this machine computes.
    command : {"measure", "surface"}, default "measure"
        What is computed.
    out : str or os.PathLike, optional
        A folder for outputs, ``results.jsonl`` and ``times.jsonl``: the files that ``meniscus batch`` writes. By default,
        only the returned records are kept.
    outputs : str or sequence of str, optional
        Endings of outputs, such as ".csv" or "_a.ply"; by default ".ply" for surfaces.
    base : str or os.PathLike, optional
        A folder that holds all files; files are named by their paths below it. By default the deepest such folder.
    time_limit : float or str, optional
        For each file, in seconds, or as in "15m" and "2h".
    memory_limit : str, optional
        For each file: "500M", "4G".
    mixed_radii : bool, default False
        Whether the radius set may differ from file to file.
    program : str or os.PathLike, optional
        Path of ``meniscus``; by default the one that was installed with this package, else found on the PATH.
    jobs : int, optional
        Files computed at a time without a client; by default the number of cores.
    **options
        Options of the command: ``min_cavity=5`` is ``--min-cavity=5``, ``waters=True`` is ``--waters``, ``waters=False``
        is ``--no-waters``, and a list repeats an option.

    Returns
    -------
    list of dict
        The records, in the order of ``paths``.

    Raises
    ------
    UsageError
        For invalid arguments and for mixed radii. A ValueError.
    OSError
        If none of the files is there, for outputs that cannot be written and if the program is not found. Ctrl-C ends the
        processes on this machine; workers finish the files that they have begun.

    Examples
    --------
    >>> found = meniscus.map(["1ubq.pdb"], probe=1.2)
    >>> found[0]["status"], round(found[0]["report"]["exact"]["ses_area"], 1)
    ('done', 4102.3)
    """
    place = _folder("out", out)
    endings = _endings(command, outputs, place)
    files = _files(paths)
    root = _folder("base", base) or _common_folder(files)
    at_once = _jobs(client, jobs)
    limits = {"time_limit": time_limit, "memory_limit": memory_limit,
              "mixed_radii": _options.flag("mixed_radii", mixed_radii)}
    words = _option_words({"threads": _threads(client, at_once), **options, **limits})
    tasks = _tasks(files, root, endings)
    work = Work(_program(program), (command, *words), root, os.getcwd(), place, None)
    lines = dict(zip(tasks, _run(client, work, tasks, at_once)))
    may_mix = mixed_radii or options.get("radii", "auto") != "auto"
    records = collect(lines, place, may_mix)
    return [records[path] for path in files]

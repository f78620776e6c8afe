# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What map() returns and writes: the records of all inputs."""
from __future__ import annotations

import json
import os
from collections.abc import Iterable
from typing import Any

from ._errors import OutputError, UsageError
from ._files import write_whole
from ._work import Lines, Task


def _radii(record: dict[str, Any]) -> str:
    report = record["report"]
    one = report[0] if isinstance(report, list) and report else report
    return str(one["input"]["radii"]) if one else ""


def _refuse_mixed_radii(records: Iterable[dict[str, Any]]) -> None:
    found: dict[str, str] = {}
    for record in records:
        found.setdefault(_radii(record), record["input"])
    found.pop("", None)
    if len(found) > 1:
        (first, one), (second, other) = sorted(found.items())[:2]
        raise UsageError(f"{one} has radii {first} and {other} has radii {second}: their results are not comparable; "
                         "choose one set with radii=, or allow this with mixed_radii=True")


def _refuse_shared_outputs(records: Iterable[dict[str, Any]]) -> None:
    owners: dict[str, str] = {}
    for record in records:
        for output in record["outputs"]:
            if owners.setdefault(output, record["input"]) != record["input"]:
                raise OutputError(f"{output}: is also an output of {owners[output]}; give the inputs different names")


def collect(lines: dict[Task, Lines], out: str | None, may_mix_radii: bool) -> dict[str, dict[str, Any]]:
    """Writes the files of results, by the bytes of names; a record for each path."""
    tasks = sorted(lines, key=lambda task: os.fsencode(task.name))
    records = {task.path: json.loads(lines[task].result) for task in tasks}
    if not may_mix_radii:
        _refuse_mixed_radii(records.values())
    if out is None:
        for record in records.values():
            record["outputs"] = []
        return records
    _refuse_shared_outputs(records.values())
    write_whole(os.path.join(out, "results.jsonl"), b"".join(lines[task].result for task in tasks))
    write_whole(os.path.join(out, "times.jsonl"), b"".join(lines[task].times for task in tasks))
    return records

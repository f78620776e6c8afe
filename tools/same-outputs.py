#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Compares what two builds have written: the bytes of all files, but of reports only what does not differ from run to run,
and not the times of a batch.

usage: same-outputs.py EXPECTED_FOLDER FOLDER    exit code 1 if anything differs or is missing
"""
import json
import pathlib
import sys

FROM_RUN_TO_RUN = {"time_s", "expected", "peak_memory_mb", "threads", "seconds"}


def steady(value):
    """Without what depends on the machine and its load."""
    if isinstance(value, dict):
        return {key: steady(each) for key, each in value.items() if key not in FROM_RUN_TO_RUN}
    return [steady(each) for each in value] if isinstance(value, list) else value


def same(expected, found):
    if expected.suffix == ".json":
        return steady(json.loads(expected.read_bytes())) == steady(json.loads(found.read_bytes()))
    return expected.read_bytes() == found.read_bytes()


def main():
    expected, found = map(pathlib.Path, sys.argv[1:])
    names = sorted(path.name for path in expected.iterdir() if path.is_file() and not path.name.endswith("times.jsonl"))
    differing = [name for name in names if not (found / name).is_file() or not same(expected / name, found / name)]
    if not names or differing:
        sys.exit(f"{found}: differ or are missing: {', '.join(differing) or 'all'}")


main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Which tests a change needs: all quick ones, and the slow ones that cover a file that has changed.

usage: choose-tests.py BUILD    prints a regular expression of the tests to leave out, for ctest -E;
                                writes what is left out, and why, to BUILD/left-out.txt

A test with the label `slow` has labels `covers:PATH`, too (tests/labels.cmake). What has the label `full` is run by
./test --full alone.
"""
import json
import pathlib
import re
import subprocess
import sys

import changes


def labels_of(test):
    return next((p["value"] for p in test.get("properties", []) if p["name"] == "LABELS"), [])


def is_needed(labels):
    if "full" in labels:
        return False
    covers = [label.removeprefix("covers:") for label in labels if label.startswith("covers:")]
    return "slow" not in labels or changes.touches(*covers)


def listed_tests(build):
    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=False)
    if listed.returncode != 0:
        print(listed.stderr or listed.stdout, end="", file=sys.stderr)
        sys.exit(f"choose-tests: {build}: ctest cannot list its tests; configure and build it")
    return json.loads(listed.stdout)["tests"]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1])
    tests = {test["name"]: labels_of(test) for test in listed_tests(build)}
    left_out = [name for name, labels in tests.items() if not is_needed(labels)]
    slow = [name for name in left_out if "full" not in tests[name]]
    full = [name for name in left_out if "full" in tests[name]]
    since = (changes.base() or "")[:9]
    reasons = {f"slow tests left out, since nothing that they cover has changed since {since}": slow,
               "tests left to ./test --full": full}
    lines = [f"{len(names)} {reason}: {' '.join(names)}\n" for reason, names in reasons.items() if names]
    (build / "left-out.txt").write_text("".join(lines))
    print("^(" + "|".join(re.escape(name) for name in left_out) + ")$")


main()

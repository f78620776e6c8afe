#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Lists every header with what its first lines say it is for.

usage: header-list.py [--check]    --check prints only headers without licence lines or description, and fails
"""
import sys

from sources import ROOT, sources

LICENCE = ["// SPDX-FileCopyrightText: 2026 The Meniscus authors", "// SPDX-License-Identifier: Apache-2.0"]


def description(path):
    """The comment after the licence lines, up to the first line that is none; empty if the licence is missing."""
    lines = (ROOT / path).read_text().splitlines()
    if lines[:2] != LICENCE:
        return ""
    words = []
    for line in lines[2:]:
        if not line.startswith("//"):
            break
        words.append(line.lstrip("/ "))
    return " ".join(words)


def main():
    check = "--check" in sys.argv
    described = {path: description(path) for path in sources(".h")}
    for path, text in described.items():
        if not check:
            print(f"{path}\n    {text}")
        elif not text:
            print(f"{path}: does not begin with the licence lines and what it is for")
    return 1 if check and not all(described.values()) else 0


sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Compiles every header alone, so that none leans on what its users happen to include first."""
import os
import pathlib
import sys

from sources import INCLUDE_PATHS, Cache, sources

COMPILER = os.environ.get("CXX", "c++")
FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
         "-fsyntax-only"] + [f"-I{path}" for path in INCLUDE_PATHS]
FLAGS += ["-fvisibility=hidden"]  # as pybind11 wants it
FLAGS += [f"-isystem{path}" for path in sorted(pathlib.Path("/usr/include").glob("python3.*"))]


def main():
    cache = Cache("headers", COMPILER, *FLAGS)
    failed = cache.run(sources(".h"), lambda path: [COMPILER, *FLAGS, "-include", str(path), "-x", "c++", "/dev/null"])
    for path in failed:
        print(f"{path}: does not compile alone")
    return 1 if failed else 0


sys.exit(main())

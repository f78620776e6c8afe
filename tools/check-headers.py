#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Compiles every header alone, so that none leans on what its users happen to include first.

What a source of the library or of the program includes before all else has been compiled so with it.
"""
import os
import pathlib
import sys

from sources import INCLUDE_PATHS, Cache, first_include, sources

COMPILER = os.environ.get("CXX", "c++")
FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
         "-fsyntax-only"] + [f"-I{path}" for path in INCLUDE_PATHS]
FLAGS += ["-fvisibility=hidden"]  # as pybind11 wants it
FLAGS += [f"-isystem{path}" for path in sorted(pathlib.Path("/usr/include").glob("python3.*"))]


def main():
    cache = Cache("headers", COMPILER, *FLAGS)
    first = {first_include(path) for path in sources(".cpp") if path.parts[0] in ("src", "cli")}
    alone = [path for path in sources(".h") if path not in first]
    failed = cache.run(alone, lambda paths: [COMPILER, *FLAGS, "-include", str(paths[0]), "-x", "c++", "/dev/null"])
    for path in failed:
        print(f"{path}: does not compile alone")
    return 1 if failed else 0


sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy on every source file that has changed, or includes something that has, since it last passed.

usage: check-tidy.py BUILD    BUILD holds compile_commands.json
"""
import json
import pathlib
import re
import subprocess
import sys

from sources import ROOT, Cache, configurations, sources


# Compiled only where the library that they are about is installed (packages.txt, section [full]).
OPTIONAL = {pathlib.Path("src/volume/vdb_module.cpp")}
# -Wno-unknown-warning-option: the commands are GCC's.
ARGUMENTS = ["--quiet", "--extra-arg=-Wno-unknown-warning-option", "--extra-arg=-Wreserved-identifier"]


# What GCC has compiled beforehand clang cannot read, and sources must not need it.
PRECOMPILED = re.compile(r" -Winvalid-pch -include \S+")


def main():
    entries = json.loads((pathlib.Path(sys.argv[1]) / "compile_commands.json").read_text())
    for entry in entries:
        entry["command"] = PRECOMPILED.sub("", entry["command"])
    commands = ROOT / "build" / "checked" / "commands"
    commands.mkdir(parents=True, exist_ok=True)
    (commands / "compile_commands.json").write_text(json.dumps(entries))
    compiled = {pathlib.Path(entry["file"]) for entry in entries}
    paths = [path for path in sources(".cpp") if ROOT / path in compiled]
    forgotten = set(sources(".cpp")) - set(paths) - OPTIONAL
    for path in forgotten:
        print(f"{path}: not in any target")
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    cache = Cache("tidy", version, *ARGUMENTS, *configurations(".clang-tidy"))
    failed = cache.run(paths, lambda path: ["clang-tidy", "-p", str(commands), *ARGUMENTS, str(path)])
    return 1 if failed or forgotten else 0


sys.exit(main())

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy on source files that have not passed yet as they are, with all that they include.

usage: check-tidy.py BUILD [--changed SECONDS]    BUILD holds compile_commands.json, each source with a command of its own
    --changed SECONDS    only on sources that the change touches (tools/changes.py), then on those that include a header
                         that it touches, in the order of their names; after so many seconds no other is begun. Those that
                         are left are listed: ./test --full looks at all

Most of its time goes into the headers of the standard library, which it looks through as it does ours. Sources that are
compiled alike are therefore looked at together, in a file that includes them.
"""
import json
import pathlib
import re
import shlex
import subprocess
import sys
import time

import changes
from sources import ROOT, Cache, closure, configurations, named, sources


# Compiled only where the library that they are about is installed (packages.txt, section [full]) or chosen.
OPTIONAL = set(map(pathlib.Path, """
src/volume/vdb_module.cpp src/core/threads/none.cpp src/core/threads/standard.cpp
src/reading/no_gunzip.cpp src/volume/plain_byte_source.cpp src/structure/no_sha256.cpp src/io/no_zlib.cpp src/io/no_png.cpp
src/io/png_standard_error.cpp src/page/no_pages.cpp src/render/no_pictures.cpp tests/render/no_pictures_test.cpp
cli/batch/unused_formats.cpp""".split()))
# -Wno-unknown-warning-option: the commands are GCC's.
ARGUMENTS = ["--quiet", "--extra-arg=-Wno-unknown-warning-option", "--extra-arg=-Wreserved-identifier"]
SETTINGS = ".clang-tidy"
COMMANDS = ROOT / "build" / "checked" / "commands"
TOGETHER = 12  # sources at most
TOGETHER_IN_TIME = 4  # where time is short: a bundle that has begun is not cut off

# What GCC has compiled beforehand clang cannot read, and sources must not need it.
PRECOMPILED = re.compile(r' -Winvalid-pch -include ("[^"]*"|\S+)')
# What a line without indentation declares, but for members.
DECLARED = re.compile(r"^(?!TEST|template|namespace|static_assert)\w[^\n({=;]*?(?<!:)\b(\w+)(?= ?[({=;[]| : | final\b)",
                      re.MULTILINE)


def arguments_of(command):
    """What a compiler is told that does not name the source and what is made of it."""
    words = iter(shlex.split(command)[1:])
    found = []
    for word in words:
        if word in ("-o", "-c", "-MT", "-MF"):
            next(words)
        elif word != "-MD":
            found.append(word)
    return tuple(found)


def settled_in(folder):
    """The folder whose settings for clang-tidy hold for a source of this one."""
    return next(above for above in (folder, *folder.parents) if (ROOT / above / SETTINGS).is_file())


def copy_settings():
    """To where the files lie that bundles are."""
    for settings in named(SETTINGS):
        copy = COMMANDS / settings
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes((ROOT / settings).read_bytes())


class Bundles:
    """Which sources are looked at together: those that are compiled alike and declare nothing of the same name."""

    def __init__(self, commands, together):
        self.commands = commands  # by path
        self.together = together  # sources at most

    def __call__(self, paths):
        bundles = {}
        for path in paths:
            text = (ROOT / path).read_text()
            names = set(DECLARED.findall(text))
            alike = (arguments_of(self.commands[path]), settled_in(path.parent))
            if '.inc"' in text:  # what is compiled for several sets of instructions declares more than stands there
                alike += (path,)
            for together, known in bundles.setdefault(alike, []):
                if len(together) < self.together and not names & known:
                    together.append(path)
                    known |= names
                    break
            else:
                bundles[alike].append(([path], names))
        return [together for alike in bundles.values() for together, _ in alike]

    def command(self, paths):
        """What looks at these sources."""
        if len(paths) == 1:
            return ["clang-tidy", "-p", str(COMMANDS), *ARGUMENTS, str(paths[0])]
        bundle = COMMANDS / settled_in(paths[0].parent) / f"{'-'.join(paths[0].parts)}.{len(paths)}.cpp"
        bundle.write_text("".join(f'#include "{ROOT / path}"  // NOLINT(bugprone-suspicious-include)\n' for path in paths))
        return ["clang-tidy", *ARGUMENTS, str(bundle), "--", *arguments_of(self.commands[paths[0]])]


def touched(paths):
    """The sources that the change touches, and those that include a header that it touches."""
    if changes.changed() is None or changes.touches(*named(SETTINGS), "tools/check-tidy.py", "cmake/settings.cmake"):
        return list(paths), []
    itself = [path for path in paths if path in changes.changed()]
    through_headers = [path for path in paths if path not in changes.changed() and changes.changed() & set(closure(path))]
    return itself, through_headers


def main():
    entries = json.loads((pathlib.Path(sys.argv[1]) / "compile_commands.json").read_text())
    for entry in entries:
        entry["command"] = PRECOMPILED.sub("", entry["command"])
    copy_settings()
    (COMMANDS / "compile_commands.json").write_text(json.dumps(entries))
    commands = {pathlib.Path(entry["file"]): entry["command"] for entry in entries}
    commands = {path: commands[ROOT / path] for path in sources(".cpp") if ROOT / path in commands}
    forgotten = set(sources(".cpp")) - set(commands) - OPTIONAL
    for path in forgotten:
        print(f"{path}: not in any target")
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    cache = Cache("tidy", version, *ARGUMENTS, *configurations(SETTINGS))
    in_time = sys.argv[2:3] == ["--changed"]
    bundles = Bundles(commands, TOGETHER_IN_TIME if in_time else TOGETHER)
    failed = []
    if in_time:
        until = time.monotonic() + float(sys.argv[3])
        for paths in touched(commands):
            failed += cache.run(paths, bundles.command, bundles, until)
        if cache.left:
            print(f"clang-tidy: {len(cache.left)} sources left to ./test --full:", *cache.left)
    else:
        failed += cache.run(list(commands), bundles.command, bundles)
    return 1 if failed or forgotten else 0


if __name__ == "__main__":
    sys.exit(main())

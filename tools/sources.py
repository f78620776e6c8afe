# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The project's C++ files, what they include, and a cache of checks that passed."""
import concurrent.futures
import hashlib
import os
import pathlib
import re
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("include", "src", "cli", "python", "tests", "bench", "fuzz")
INCLUDE_PATHS = ("include", "src", "cli", "tests")
# A file may also be named by a macro, for another to include (src/simd/kernel_sets.inc).
INCLUDE = re.compile(r'^\s*#\s*(?:include|define\s+\w+)\s*"([^"]+)"', re.MULTILINE)


def sources(*suffixes):
    """Paths relative to the root of all files with these suffixes, sorted."""
    found = []
    for folder in FOLDERS:
        found += [p for p in (ROOT / folder).rglob("*") if p.suffix in suffixes and p.is_file()]
    return sorted(p.relative_to(ROOT) for p in found)


def named(name):
    """Paths relative to the root of all files of this name, in it and in all folders of sources, sorted."""
    found = [ROOT / name, *(path for folder in FOLDERS for path in (ROOT / folder).rglob(name))]
    return sorted(path.relative_to(ROOT) for path in found if path.is_file())


def configurations(name):
    """What every file of this name says, with its place."""
    return [f"{path}\n{(ROOT / path).read_text()}" for path in named(name)]


def includes(path):
    """Project files that a file includes directly, or names for another one to include, relative to the root."""
    found = []
    for name in INCLUDE.findall((ROOT / path).read_text()):
        for base in (path.parent, *INCLUDE_PATHS):
            candidate = pathlib.Path(os.path.normpath(pathlib.Path(base) / name))
            if (ROOT / candidate).is_file():
                found.append(candidate)
                break
    return found


def first_include(path):
    """The project file that a file includes before all else, relative to the root, or None."""
    found = re.search(r'^#include (\S+)', (ROOT / path).read_text(), re.MULTILINE)
    return includes(path)[0] if found and found[1].startswith('"') else None


def closure(path):
    """The file and every project file it includes, directly or not, sorted."""
    seen, todo = set(), [path]
    while todo:
        current = todo.pop()
        if current not in seen:
            seen.add(current)
            todo += includes(current)
    return sorted(seen)


class Cache:
    """Remembers which files have passed a check, by the content of all that the check saw."""

    def __init__(self, name, *context):
        self.folder = ROOT / "build" / "checked" / name
        self.folder.mkdir(parents=True, exist_ok=True)
        self.context = "\0".join(context).encode()
        self.left = []  # what run() has not begun in time

    def stamp(self, path):
        digest = hashlib.sha256(self.context)
        for part in closure(path):
            digest.update(str(part).encode() + b"\0" + (ROOT / part).read_bytes())
        return self.folder / digest.hexdigest()

    def run(self, paths, command, bundle=lambda todo: [[path] for path in todo], until=float("inf")):
        """Runs command(paths), a list of words, for all paths that have not passed yet; returns those that fail alone.

        bundle(todo) tells which of them are looked at together: lists of paths. Both halves of a list that fails are looked
        at anew. What has not begun at the time `until` of time.monotonic() is added to `left`.
        """
        stamps = {path: self.stamp(path) for path in paths}
        failed = []

        def check(together):
            if time.monotonic() > until:
                self.left += together
                return
            result = run(command(together))
            if result.returncode == 0:
                for path in together:
                    stamps[path].touch()
            elif len(together) > 1:
                check(together[:len(together) // 2])
                check(together[len(together) // 2:])
            else:
                failed.extend(together)
                print(result.stdout, end="")

        bundles = bundle([path for path in paths if not stamps[path].exists()])
        with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
            list(pool.map(check, bundles))
        return sorted(failed)


def run(words):
    return subprocess.run(words, cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)

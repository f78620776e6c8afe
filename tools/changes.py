#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What a change touches: the files that differ from where the change began.

usage: changes.py PATH ...    ends with 0 if a file has changed that is one of these or below one of these folders, with 1
                              if none has, with 2 where that cannot be told
"""
import functools
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def git(*words):
    """The output of a git command, stripped; None where it fails or git is absent."""
    try:
        done = subprocess.run(["git", *words], cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return None
    return done.stdout.strip() if done.returncode == 0 else None


@functools.cache
def base():
    """The commit that a change began at; None where that cannot be known.

    It is MENISCUS_BASE if that is set, else the merge base with the default branch of origin if HEAD is ahead of it,
    else the commit before HEAD.
    """
    if os.environ.get("MENISCUS_BASE"):
        found = git("rev-parse", "--verify", os.environ["MENISCUS_BASE"] + "^{commit}")
        if found is None:
            print(f"MENISCUS_BASE={os.environ['MENISCUS_BASE']}: not a commit of this repository; name one, or unset it",
                  file=sys.stderr)
            raise SystemExit(2)
        return found
    merge_base = git("merge-base", "HEAD", "refs/remotes/origin/HEAD")
    if merge_base and merge_base != git("rev-parse", "HEAD"):
        return merge_base
    return git("rev-parse", "--verify", "HEAD~1")


@functools.cache
def changed():
    """Paths relative to the root that differ from base(), those that git does not know yet included.

    None where base() is not known: everything counts as changed then.
    """
    own = pathlib.Path(__file__).resolve()
    if base() is None or git("ls-files", "--error-unmatch", str(own)) is None:  # unpacked within another repository
        return None
    differing = git("diff", "--relative", "-z", "--name-only", "--no-renames", base())
    unknown = git("ls-files", "-z", "--others", "--exclude-standard")
    if differing is None or unknown is None:
        return None
    return frozenset(pathlib.Path(name) for name in (differing + "\0" + unknown).split("\0") if name)


def touches(*prefixes):
    """Whether a changed file is one of these or lies below one of these folders."""
    if changed() is None:
        return True
    return any(pathlib.Path(prefix) in (path, *path.parents) for path in changed() for prefix in prefixes)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    sys.exit(0 if touches(*sys.argv[1:]) else 1)

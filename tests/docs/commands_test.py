#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs every command of the manual and compares what it prints with what the manual shows.

    ```sh                  run; every page has a scratch folder with examples/, ./run and meniscus
    ```sh exit=2           run; ends with this exit code
    ```sh not-run          shown only: needs the network, root or another program; listed by this test
    ```                    likewise
    ```sh not-run slurm    run by tests/engines/slurm_test.py where Slurm is installed
    ```python              run with the interpreter that MENISCUS_DOCS_PYTHON names, which has the package; else, and
                           without the package that it imports (Dask's, PyTorch), listed. Blocks with >>> belong to tests/python
    ```output              what the block before it prints; "..." for what differs from run to run

usage: commands_test.py PROGRAM SOURCE_DIR
"""
import functools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import markdown
import shown_output

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()

# ./run without its first half, which installs packages and builds.
RUN = """#!/bin/sh
case "$1" in
    surface | measure | compare | batch | --version | --help | --help-all | -h) exec meniscus "$@" ;;
    *) exec meniscus surface "$@" ;;
esac
"""


# An interpreter that finds the package, with the folder it is in; empty where the package was not built.
PYTHON = os.environ.get("MENISCUS_DOCS_PYTHON", "")
PACKAGE = os.environ.get("MENISCUS_DOCS_PYTHONPATH", "")


@functools.lru_cache(maxsize=None)
def has_module(name):
    """Whether that interpreter has a module."""
    code = "import importlib.util, sys; sys.exit(importlib.util.find_spec(sys.argv[1]) is None)"
    return subprocess.run([PYTHON, "-c", code, name], check=False).returncode == 0


def has_engines(block):
    """Whether the packages are there that a block of Python imports: Debian's, which no other page needs."""
    return all(has_module(name) for name in re.findall(r"^(?:from|import) (distributed|torch)\b", block.text, re.MULTILINE))


def is_run(block):
    """Whether a block is something that this test runs."""
    if block.kind == "python":
        return bool(PYTHON) and ">>>" not in block.text and has_engines(block)
    return block.kind == "sh" and "not-run" not in block.info


def is_left_out(block):
    """Whether a block has commands of the manual that nothing runs."""
    if block.kind == "python":
        return ">>>" not in block.text and not is_run(block)
    return not is_run(block) and any(line.split()[:1] in (["./run"], ["./test"], ["meniscus"]) for line in block.lines)


def exit_code(block):
    return next((int(word.removeprefix("exit=")) for word in block.info if word.startswith("exit=")), 0)


class Page:
    """A scratch folder in which the commands of one page run one after another."""

    def __init__(self, folder):
        self.folder = folder
        shutil.copytree(SOURCE / "examples", folder / "examples")
        (folder / "run").write_text(RUN)
        (folder / "run").chmod(0o755)
        (folder / ".bin").mkdir()
        (folder / ".bin" / "meniscus").symlink_to(PROGRAM)
        for name in ("meniscus-msms", "meniscus-nanoshaper", "pdb_to_xyzr", "pdb_to_xyzrn"):
            (folder / ".bin" / name).symlink_to(PROGRAM.parent / "dropins" / name)
        self.environment = {**os.environ, "PATH": f"{folder / '.bin'}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8",
                            "DASK_TEMPORARY_DIRECTORY": str(folder)}

    def run(self, block):
        command, environment = ["bash", "-c", "set -eo pipefail\n" + block.text], self.environment
        if block.kind == "python":
            command, environment = [PYTHON, "-W", "ignore", "-c", block.text], {**environment, "PYTHONPATH": PACKAGE}
        return subprocess.run(command, cwd=self.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, encoding="utf-8", timeout=300, check=False)


class Commands(unittest.TestCase):
    def check_page(self, path):
        """Runs the blocks of a page in order; returns how many were run."""
        with tempfile.TemporaryDirectory(prefix="meniscus-docs-") as folder:
            page, before, printed, count = Page(pathlib.Path(folder)), "", None, 0
            for block in markdown.read(path)[0]:
                where = f"{path.relative_to(SOURCE)}:{block.line}"
                if is_run(block):
                    result = page.run(block)
                    printed, count = result.stdout, count + 1
                    self.assertEqual(result.returncode, exit_code(block), f"{where}\n{block.text}{printed}")
                elif block.kind == "output":
                    self.assertIn(before, ("sh", "python"), f"{where}: no command before this output")
                    self.assertTrue(printed is None or shown_output.same_output(block.text, printed),
                                    f"{where}: shown\n{block.text}\nprinted\n{printed}")
                else:
                    printed = None
                before = block.kind
            return count

    def test_commands_do_what_the_manual_shows(self):
        run = 0
        for path in markdown.pages(SOURCE):
            with self.subTest(page=str(path.relative_to(SOURCE))):
                run += self.check_page(path)
        self.assertGreater(run, 20)
        print(f"{run} blocks of commands run")

    def test_what_is_not_run_is_marked(self):
        """Commands are in fenced blocks, so that none escapes; those that are not run are listed."""
        for path in markdown.pages(SOURCE):
            blocks, prose = markdown.read(path)
            for number, line in prose:
                hidden = line.startswith("    ") and line.split()[:1] in (["./run"], ["meniscus"])
                self.assertFalse(hidden, f"{path}:{number}: a command outside a fenced block")
            for block in blocks:
                if is_left_out(block):
                    print(f"not run: {path.relative_to(SOURCE)}:{block.line}: {block.lines[0]}")


class ShownOutput(unittest.TestCase):
    """The comparison itself."""

    def test_words_and_numbers(self):
        self.assertTrue(shown_output.same_output("area  3.14 Å²\n", "area 3.144 Å²\n"))
        self.assertFalse(shown_output.same_output("area  3.14 Å²\n", "area 3.16 Å²\n"))
        self.assertFalse(shown_output.same_output("602 atoms\n", "603 atoms\n"))
        self.assertTrue(shown_output.same_output("± 3.8e-06\n", "± 3.75e-06\n"))

    def test_what_may_differ(self):
        self.assertTrue(shown_output.same_output("time ... s on ... MB\n", "time 0.3 s on 2 threads, 9 MB\n"))
        self.assertTrue(shown_output.same_output("a\n...\nd\n", "a\nb\nc\nd\n"))
        self.assertFalse(shown_output.same_output("a\n...\nd\n", "a\nb\nc\n"))
        self.assertFalse(shown_output.same_output("a\n", "a\nb\n"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)

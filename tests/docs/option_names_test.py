#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Messages that reach Python, C or the web do not name options as only the command line has them: `--model`.

usage: option_names_test.py SOURCE_FOLDER
"""
import ast
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2]
OPTION = re.compile(r"(?<![-\w])--[a-z]")
LITERAL = re.compile(r'"(?:[^"\\]|\\.)*"')
DESCRIPTIONS = re.compile(r"describe_\w+\.h$")  # of the manual of the command line
OF_OTHER_PROGRAMS = "PDB2PQR"
COMMAND_LINES = ("_map.py", "_work.py")  # which run the program


def literals_of_cpp(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    return [(i, text) for i, line in enumerate(lines, 1) if not line.lstrip().startswith("//")
            for text in LITERAL.findall(line)]


def literals_of_python(path):
    """Without docstrings, and other strings that are statements."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    texts = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    return [(node.lineno, node.value) for node in ast.walk(tree)
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in texts]


class Messages(unittest.TestCase):
    def expect_none(self, paths, literals_of):
        self.assertGreater(len(paths), 10)
        found = [f"{path.relative_to(ROOT)}:{line}: {text}" for path in paths for line, text in literals_of(path)
                 if OPTION.search(text) and OF_OTHER_PROGRAMS not in text]
        self.assertEqual(found, [])

    def test_of_the_library(self):
        paths = [path for folder in ("src", "include", "c", "python/src", "web")
                 for path in sorted((ROOT / folder).rglob("*.[ch]*")) if path.suffix in (".cpp", ".h", ".c")]
        self.expect_none([path for path in paths if not DESCRIPTIONS.search(path.name) and "node_modules" not in path.parts],
                         literals_of_cpp)

    def test_of_the_python_package(self):
        paths = sorted((ROOT / "python" / "meniscus").glob("*.py"))
        self.expect_none([path for path in paths if path.name not in COMMAND_LINES], literals_of_python)

    def test_finds_them(self):
        self.assertTrue(OPTION.search('"--model 0: models"') and OPTION.search("(keep them with --waters)"))
        self.assertFalse(OPTION.search("a--b") or OPTION.search("-- a"))


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""A check that passed is done again where anything that it saw has changed.

usage: sources_test.py SOURCE_DIR
"""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from shlex import quote

SOURCE = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(SOURCE / "tools"))
import sources  # noqa: E402

KERNELS = """#include <vector>
#include "core/bits.h"
#define MENISCUS_KERNELS "flow/kernels.inc"
#define MENISCUS_WORD "flow"
#include "core/sets.inc"
"""


class SourcesTest(unittest.TestCase):
    """Every test has a project of a few files."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.addCleanup(setattr, sources, "ROOT", sources.ROOT)
        sources.ROOT = self.folder
        self.write("src/flow/kernels.cpp", KERNELS)
        self.write("src/flow/kernels.inc", '#include "core/vectors.inc"\n')
        self.write("src/core/bits.h")
        self.write("src/core/sets.inc", "#include MENISCUS_KERNELS\n")
        self.write("src/core/vectors.inc")

    def write(self, name, text=""):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="ascii")

    def test_files_that_a_macro_names_are_included_too(self):
        found = [str(path) for path in sources.closure(pathlib.Path("src/flow/kernels.cpp"))]
        self.assertEqual(found, ["src/core/bits.h", "src/core/sets.inc", "src/core/vectors.inc",
                                 "src/flow/kernels.cpp", "src/flow/kernels.inc"])

    def test_a_pass_holds_until_something_that_was_seen_changes(self):
        path = pathlib.Path("src/flow/kernels.cpp")

        def checked():
            done = []
            sources.Cache("test", *sources.configurations(".config")).run([path], lambda p: done.append(p) or ["true"])
            return bool(done)

        self.assertTrue(checked())
        self.assertFalse(checked())
        for name in ("src/core/vectors.inc", "src/flow/kernels.inc", ".config", "src/.config", "src/flow/deep/.config"):
            self.write(name, "// another\n")
            self.assertTrue(checked(), name)
            self.assertFalse(checked(), name)


    def test_what_fails_together_is_looked_at_in_halves(self):
        paths = [pathlib.Path(f"src/flow/{name}.cpp") for name in "abcdefg"]
        for path in paths:
            self.write(str(path), f"// {path}\n")
        bad = paths[2:3] + paths[5:6]
        looked_at = []

        def command(together):
            looked_at.append(list(together))
            return ["false" if set(bad) & set(together) else "true"]

        cache = sources.Cache("test")
        self.assertEqual(cache.run(paths, command, lambda todo: [todo]), bad)
        self.assertEqual(looked_at[0], paths)
        self.assertIn(paths[3:5], looked_at)
        self.assertNotIn(paths[3:4], looked_at)
        looked_at.clear()
        self.assertEqual(cache.run(paths, command), bad)
        self.assertEqual(sorted(looked_at), [[path] for path in bad])

    def test_what_a_file_includes_first(self):
        self.write("src/flow/own.cpp", '// What it does.\n#include "core/bits.h"\n#include <vector>\n')
        self.assertEqual(sources.first_include(pathlib.Path("src/flow/own.cpp")), pathlib.Path("src/core/bits.h"))
        self.assertIsNone(sources.first_include(pathlib.Path("src/flow/kernels.cpp")))


class TidyTest(unittest.TestCase):
    """Bundles of sources of the project."""

    def setUp(self):
        if shutil.which("clang-tidy") is None:
            self.skipTest("clang-tidy is not installed")
        path = SOURCE / "tools" / "check-tidy.py"
        spec = importlib.util.spec_from_file_location("check_tidy", path)
        self.tidy = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(self.tidy)
        self.addCleanup(setattr, self.tidy, "COMMANDS", self.tidy.COMMANDS)
        build = SOURCE / "build"
        build.mkdir(exist_ok=True)
        self.tidy.COMMANDS = pathlib.Path(tempfile.mkdtemp(prefix="tidy-", dir=build))
        self.addCleanup(shutil.rmtree, self.tidy.COMMANDS)
        self.tidy.copy_settings()

    def bundles_of(self, *names):
        command = f"c++ {quote(f'-I{SOURCE}/src')} {quote(f'-I{SOURCE}/include')} -std=c++20 -o x.o -c "
        return self.tidy.Bundles({pathlib.Path(name): command + quote(str(SOURCE / name)) for name in names}, self.tidy.TOGETHER)

    def test_sources_pass_together(self):
        """Else each would be looked at alone, which nobody would see."""
        names = ["src/platform/files/loaded_library.cpp", "src/platform/memory.cpp"]
        bundles = self.bundles_of(*names)
        paths = [pathlib.Path(name) for name in names]
        self.assertEqual(bundles(paths), [paths])
        result = sources.run(bundles.command(paths))
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_what_declares_the_same_stays_apart(self):
        names = ["src/flow/closest_points.cpp", "src/mesh/cut_edges.cpp"]  # kGrain
        self.assertEqual(len(self.bundles_of(*names)([pathlib.Path(name) for name in names])), 2)

    def test_what_is_checked_differently_stays_apart(self):
        names = ["src/platform/memory.cpp", "tests/core/parallel_test.cpp"]
        self.assertEqual(len(self.bundles_of(*names)([pathlib.Path(name) for name in names])), 2)


class ProjectTest(unittest.TestCase):
    def test_every_file_to_include_is_seen_by_a_source_file(self):
        seen = {part for path in sources.sources(".cpp") for part in sources.closure(path)}
        self.assertEqual([path for path in sources.sources(".inc") if path not in seen], [])

    def test_every_test_is_run(self):
        rooms = (SOURCE / "tests" / "CMakeLists.txt").read_text()
        for path in sorted((SOURCE / "tests").glob("*/*")):
            if path.name == "CMakeLists.txt":
                self.assertRegex(rooms, rf"\b{path.parent.name}\b", "tests/CMakeLists.txt does not name this room")
            elif path.match("*_test.cpp") or path.match("*_test.py") or path.match("test_*.py"):
                listed = (path.parent / "CMakeLists.txt").read_text()
                name = path.stem.removeprefix("test_").removesuffix("_test")
                self.assertRegex(listed, rf"\b{name}(_test)?\b", f"{path.parent}/CMakeLists.txt does not name {path.name}")

    def test_what_a_change_touches(self):
        """In a repository of its own, also where that lies below another, and with names that git would quote."""
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder) / "vendor" / "m"
            (place / "tools").mkdir(parents=True)
            shutil.copy(SOURCE / "tools" / "changes.py", place / "tools")
            (place / "src").mkdir()
            (place / "src" / "a.cpp").write_text("1")

            def git(*words):
                subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x@y", *words], cwd=folder, check=True,
                               capture_output=True)

            def code(*words, base=""):
                environment = {**os.environ, "MENISCUS_BASE": base}
                return subprocess.run([sys.executable, place / "tools" / "changes.py", *words], cwd=place, env=environment,
                                      capture_output=True, check=False).returncode

            git("init", "-q")
            self.assertEqual(code("src"), 0, "not in the repository: everything counts as changed")
            git("add", ".")
            git("commit", "-qm", "first")
            (place / "src" / "a.cpp").write_text("2")
            git("commit", "-qam", "second")
            self.assertEqual((code("src"), code("tests"), code("src", base="HEAD"), code("src", base="none"), code()),
                             (0, 1, 1, 2, 2))
            (place / "tests").mkdir()
            (place / "tests" / "änderung.cpp").write_text("3")
            self.assertEqual(code("tests/änderung.cpp"), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

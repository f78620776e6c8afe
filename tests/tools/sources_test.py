#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""A check that passed is done again where anything that it saw has changed.

usage: sources_test.py SOURCE_DIR
"""
import pathlib
import shutil
import sys
import tempfile
import unittest

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


class ProjectTest(unittest.TestCase):
    def test_every_file_to_include_is_seen_by_a_source_file(self):
        seen = {part for path in sources.sources(".cpp") for part in sources.closure(path)}
        self.assertEqual([path for path in sources.sources(".inc") if path not in seen], [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What docstrings and docs/python.md show is what happens."""
import doctest
import importlib.util
import os
import re
import shutil
import unittest
import unittest.mock
import warnings

import numpy
from support import PROGRAM, ROOT, UBIQUITIN, InScratchFolder

import meniscus

FLAGS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS
TUTORIAL = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
FENCE = re.compile(r"```python\n(.*?)```", re.DOTALL)


class Examples(InScratchFolder):
    def setUp(self):
        super().setUp()
        shutil.copy(UBIQUITIN, ".")
        self.enterContext(warnings.catch_warnings())
        warnings.simplefilter("ignore", meniscus.ReadWarning)
        path = os.pathsep.join([os.path.dirname(PROGRAM), os.environ["PATH"]])
        self.enterContext(unittest.mock.patch.dict(os.environ, PATH=path))

        self.runner = doctest.DocTestRunner(optionflags=FLAGS)
        self.output = []

    def try_out(self, test):
        self.runner.run(test, out=self.output.append, clear_globs=False)

    def try_out_if_possible(self, test, code):
        """Unless it needs a package that is not installed, which is then said."""
        wanted = set(re.findall(r"^(?:>>> )?(?:import|from) (\w+)", code, re.MULTILINE))
        missing = [package for package in sorted(wanted) if importlib.util.find_spec(package) is None]
        if missing:
            print(f"left out: {test.name}: no {', '.join(missing)}")
            return
        with warnings.catch_warnings():
            if wanted - {"io", "meniscus", "numpy", "pathlib", "pickle"}:
                warnings.simplefilter("ignore")  # of those packages
            self.try_out(test)

    def expect_all_true(self):
        self.assertEqual(self.runner.failures, 0, "".join(self.output))
        self.assertGreater(self.runner.tries, 20)


class Docstrings(Examples):
    def test_examples_are_true(self):
        names = {"meniscus": meniscus, "numpy": numpy}
        finder = doctest.DocTestFinder()
        for name, thing in {"": meniscus, **{name: getattr(meniscus, name) for name in meniscus.__all__}}.items():
            for test in finder.find(thing, f"meniscus.{name}", module=False if name else None, extraglobs=names):
                self.try_out_if_possible(test, "".join(example.source for example in test.examples))
        self.expect_all_true()

    def test_whatever_is_public_has_one(self):
        for name in meniscus.__all__:
            thing = getattr(meniscus, name)
            if name != "__version__":
                self.assertTrue(thing.__doc__, name)


class Tutorial(Examples):
    def test_examples_are_true(self):
        """Section by section; those that need a program that is not installed are left out, and said to be."""
        names = {}
        for section in re.split(r"\n(?=##+ )", TUTORIAL):
            code = "\n".join(FENCE.findall(section))
            test = doctest.DocTestParser().get_doctest(code, names, section.splitlines()[0], "docs/python.md", 0)
            self.try_out_if_possible(test, code)
            names.update(test.globs)
        self.expect_all_true()


if __name__ == "__main__":
    unittest.main(verbosity=2)

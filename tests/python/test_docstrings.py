# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Whatever is public has a docstring in numpydoc's form that names every parameter, and the shapes of arrays."""
import dataclasses
import functools
import inspect
import re
import unittest

import meniscus

HEADING = re.compile(r"^(\w[\w ]*)\n(-{3,})$", re.MULTILINE)
KNOWN = ["Parameters", "Attributes", "Returns", "Raises", "Examples"]
ENTRY = re.compile(r"^(\**\w+)(?: : (.*))?$", re.MULTILINE)
# Made by functions of the package; their constructors are not for users.
MADE = ("Comparison", "Measures", "Pockets", "Points", "Structure", "Surface")


def sections(text):
    """Heading -> text, in their order; what stands before the first is the key ""."""
    parts = HEADING.split(inspect.cleandoc(text))
    found = {"": parts[0]}
    for name, dashes, body in zip(parts[1::3], parts[2::3], parts[3::3]):
        assert len(name) == len(dashes), name
        found[name] = body
    return found


def parameters_of(function):
    """As they are written, whatever help() shows."""
    code = function.__code__
    names = list(code.co_varnames[:code.co_argcount + code.co_kwonlyargcount])
    if code.co_flags & inspect.CO_VARKEYWORDS:
        names.append("**" + code.co_varnames[len(names)])
    return [name for name in names if name not in ("self", "cls")]


def public_members(thing):
    for base in thing.__mro__:
        if base.__module__.startswith("meniscus"):
            for name, member in vars(base).items():
                if not name.startswith("_"):
                    yield name, member


class Form(unittest.TestCase):
    def setUp(self):
        self.checked = 0

    def check_form(self, name, text):
        self.checked += 1
        self.assertTrue(text, f"{name} has no docstring")
        found = sections(text)
        summary = found[""].split("\n\n")[0]
        self.assertRegex(summary, r"\A[A-Z(0-9Å\"].*[.:]\Z", f"{name}: the summary is no sentence")
        self.assertNotIn("\n", summary, f"{name}: the summary is longer than a line")
        headings = [heading for heading in found if heading]
        self.assertEqual(headings, sorted(headings, key=KNOWN.index), f"{name}: order of sections")
        for line in inspect.cleandoc(text).splitlines():
            self.assertLessEqual(len(line), 150, name)
        return found

    def check_parameters(self, name, found, parameters, section="Parameters"):
        entries = dict(ENTRY.findall(found.get(section, "")))
        self.assertEqual(list(entries), parameters, f"{name}: {section}")
        for parameter, kind in entries.items():
            if not parameter.startswith("**"):
                self.assertTrue(kind, f"{name}: {parameter} has no type")
            if "array" in kind and "sequence" not in kind and "of int" not in kind:
                self.assertIn("shape", kind, f"{name}: {parameter} has no shape")

    def check_function(self, name, function):
        found = self.check_form(name, function.__doc__)
        self.check_parameters(name, found, parameters_of(function))
        returns = function.__annotations__["return"] != "None"
        self.assertEqual("Returns" in found, returns, f"{name}: Returns")

    def check_class(self, name, thing):
        found = self.check_form(name, thing.__doc__)
        if dataclasses.is_dataclass(thing):
            self.check_parameters(name, found, [field.name for field in dataclasses.fields(thing)])
        elif not issubclass(thing, (BaseException, dict)) and name not in MADE:
            self.check_parameters(name, found, parameters_of(thing.__init__))
        for member_name, member in public_members(thing):
            self.check_member(f"{name}.{member_name}", member)

    def check_member(self, name, member):
        if isinstance(member, (classmethod, staticmethod)):
            member = member.__func__
        if inspect.isfunction(member):
            self.check_function(name, member)
        elif isinstance(member, (property, functools.cached_property)):
            self.check_form(name, member.__doc__)

    def test_of_everything_public(self):
        for name in meniscus.__all__:
            thing = getattr(meniscus, name)
            with self.subTest(name=name):
                if inspect.isclass(thing):
                    self.check_class(name, thing)
                elif inspect.isfunction(thing):
                    self.check_function(name, thing)

        self.assertGreater(self.checked, 150)

    def test_attributes_of_a_comparison(self):
        found = sections(meniscus.Comparison.__doc__)
        ball = meniscus.Structure.from_arrays([[0, 0, 0]], 2.0)
        made = [name for name in vars(meniscus.compare(ball, ball)) if not name.startswith("_")]
        self.check_parameters("Comparison", found, made, "Attributes")

    def test_the_check_finds_what_is_missing(self):
        def function(one, two: int) -> int:
            """Adds.

            Parameters
            ----------
            one : int
                The one.
            """
        for text, message in ((function.__doc__, "Parameters"), ("", "no docstring"), ("lower case.", "no sentence")):
            function.__doc__ = text
            function.__annotations__["return"] = "int"
            with self.assertRaisesRegex(AssertionError, message):
                self.check_function("function", function)


if __name__ == "__main__":
    unittest.main()

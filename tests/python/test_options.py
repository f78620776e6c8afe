# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Options as objects, and as keywords; words as types."""
import copy
import dataclasses
import inspect
import pickle
import typing
import unittest

import numpy as np
from support import CENTRES, RADII, UBIQUITIN, read

import meniscus
from meniscus import _choices, _core, _reading, _writing


class Objects(unittest.TestCase):
    examples = (meniscus.SurfaceOptions(edge=1.0, keep_ridges=True, method="direct"),
                meniscus.ReadOptions(waters=True, chains=["A", "B"]),
                meniscus.RunOptions(threads=2, memory="4G", progress=print))

    def test_are_values(self):
        for options in self.examples:
            kind = type(options)
            with self.subTest(kind=kind.__name__):
                for again in (copy.deepcopy(options), options.replace(), pickle.loads(pickle.dumps(options)),
                              copy.copy(options)):
                    self.assertEqual(again, options)
                    self.assertEqual(hash(again), hash(options))
                self.assertNotEqual(options, kind())
                self.assertEqual(len({options, kind(), options.replace()}), 2)
                with self.assertRaises(dataclasses.FrozenInstanceError):
                    setattr(options, dataclasses.fields(options)[0].name, None)

    def test_show_what_differs_from_the_defaults(self):
        self.assertEqual([repr(options) for options in self.examples],
                         ["SurfaceOptions(method='direct', edge=1.0, keep_ridges=True)",
                          "ReadOptions(chains=('A', 'B'), waters=True)",
                          "RunOptions(threads=2, memory='4G', progress=<built-in function print>)"])
        names = {"SurfaceOptions": meniscus.SurfaceOptions, "ReadOptions": meniscus.ReadOptions}
        for options in self.examples[:2]:
            self.assertEqual(eval(repr(options), names), options)

    def test_none_is_the_default(self):
        self.assertEqual(meniscus.SurfaceOptions(components=None, min_cavity=None), meniscus.SurfaceOptions())

    def test_are_checked_when_they_are_made(self):
        for make, error, message in (
                (lambda: meniscus.SurfaceOptions(method="fast"), meniscus.UsageError, "method: unknown value 'fast'"),
                (lambda: meniscus.SurfaceOptions(probe=-1), meniscus.UsageError, "probe -1: must be finite"),
                (lambda: meniscus.SurfaceOptions(probe=None), TypeError, "probe: must be a number"),
                (lambda: meniscus.SurfaceOptions(adaptive=True), meniscus.UsageError, "adaptive"),
                (lambda: meniscus.SurfaceOptions(edge="1"), TypeError, "edge: must be a number"),
                (lambda: meniscus.SurfaceOptions().replace(edgy=1.0), TypeError, "edgy"),
                (lambda: meniscus.ReadOptions(hetero="some"), meniscus.UsageError, "choose one of none, ligands, all"),
                (lambda: meniscus.ReadOptions(model=1.5), TypeError, "model: must be a whole number"),
                (lambda: meniscus.ReadOptions(model=0), meniscus.UsageError, "model: must be a whole number of at least 1, not 0"),
                (lambda: meniscus.ReadOptions(model=-1), meniscus.UsageError, "of at least 1, not -1"),
                (lambda: meniscus.ReadOptions(model="join", assembly=1), meniscus.UsageError, "by assembly; give one of"),
                (lambda: meniscus.ReadOptions(waters="no"), TypeError, "waters: must be True or False, not 'no'"),
                (lambda: meniscus.ReadOptions(strict_radii="no"), TypeError, "strict_radii: must be True or False, not 'no'"),
                (lambda: meniscus.ReadOptions(strict_radii=2), TypeError, "must be True or False, not 2"),
                (lambda: meniscus.ReadOptions(select=5), TypeError, "select: must be text, not 5"),
                (lambda: meniscus.ReadOptions(select=""), meniscus.UsageError, "select: empty"),
                (lambda: meniscus.ReadOptions(altloc="AB"), meniscus.UsageError, "altloc: must be one character, not 'AB'"),
                (lambda: meniscus.ReadOptions(altloc=""), meniscus.UsageError, "altloc: must be one character, not ''"),
                (lambda: meniscus.ReadOptions(altloc=1), TypeError, "altloc: must be text, not 1"),
                (lambda: meniscus.ReadOptions(assembly=1.0), TypeError, "assembly: must be a whole number, not 1.0"),
                (lambda: meniscus.ReadOptions(assembly=""), meniscus.UsageError, "assembly: empty"),
                (lambda: meniscus.ReadOptions(chains=5), TypeError, "chains: must be text or a list of texts, not 5"),
                (lambda: meniscus.ReadOptions(chains=["A", 5]), TypeError, "chains: must be text, not 5"),
                (lambda: meniscus.ReadOptions(radii=5), TypeError, "int"),
                (lambda: meniscus.RunOptions(threads=-1), meniscus.UsageError, "threads -1"),
                (lambda: meniscus.RunOptions(memory="much"), meniscus.UsageError, "memory: must be an amount"),
                (lambda: meniscus.RunOptions(progress=3), TypeError, "progress: must be a function")):
            with self.assertRaisesRegex(error, message):
                make()


    def test_flags_and_words_of_every_call(self):
        ball = meniscus.surface([[0, 0, 0]], [2.0], spacing=1.0)
        for call, name in ((lambda: meniscus.measure(CENTRES, RADII, cavities="no"), "cavities"),
                           (lambda: meniscus.measure(CENTRES, RADII, depth="no"), "depth"),
                           (lambda: ball.save("x.ply", ascii="no"), "ascii"),
                           (lambda: ball.sample().save("x.ply", ascii="no"), "ascii"),
                           (lambda: ball.save("x.png", outline="no"), "outline"),
                           (lambda: ball.save("x.png", legend="no"), "legend"),
                           (lambda: ball.save("x.html", perspective="no"), "perspective"),
                           (lambda: ball.numpy(copy="no"), "copy")):
            with self.assertRaisesRegex(TypeError, f"{name}: must be True or False, not 'no'"):
                call()
        for call, name in ((lambda: ball.save("x.png", background=5), "background"), (lambda: ball.save("x", format=5), "format"),
                           (lambda: meniscus.read(UBIQUITIN, name=5), "name"), (lambda: meniscus.read(UBIQUITIN, format=5), "format")):
            with self.assertRaisesRegex(TypeError, f"{name}: must be text, not 5"):
                call()
        for format in ("", "/../x.ply", "a/b", "\0"):
            with self.assertRaisesRegex(meniscus.UsageError, "format: (empty|unknown value)"):
                ball.save("x", format=format)

    def test_numpy_flags_are_flags(self):
        for true in (True, 1, np.True_):
            self.assertEqual(len(read(UBIQUITIN, waters=true)), 660)
        for false in (False, 0, np.False_):
            self.assertEqual(len(read(UBIQUITIN, waters=false, strict_radii=false)), 602)

    def test_of_another_kind_are_refused(self):
        reading, run = meniscus.ReadOptions(), meniscus.RunOptions()
        for call, message in ((lambda: meniscus.surface(CENTRES, RADII, options=reading), "options: must be SurfaceOptions, not Read"),
                              (lambda: meniscus.surface(CENTRES, RADII, options={"probe": 1}), "must be SurfaceOptions, not dict"),
                              (lambda: meniscus.surface(CENTRES, RADII, run=4), "run: must be RunOptions, not int"),
                              (lambda: meniscus.measure(UBIQUITIN, reading=run), "reading: must be ReadOptions, not Run"),
                              (lambda: meniscus.read(UBIQUITIN, options=run), "options: must be ReadOptions, not RunOptions"),
                              (lambda: meniscus.read(UBIQUITIN, watters=True), "unexpected keyword argument 'watters'")):
            with self.assertRaisesRegex(TypeError, message):
                call()


class InUse(unittest.TestCase):
    def mesh(self, **options):
        return meniscus.surface(CENTRES, RADII, **options).vertices.tobytes()

    def test_objects_and_keywords_are_the_same(self):
        keywords = {"probe": 1.2, "spacing": 0.4, "method": "direct", "surface": "sas", "components": "outer"}
        options = meniscus.SurfaceOptions(**keywords)
        self.assertEqual(self.mesh(options=options), self.mesh(**keywords))
        self.assertNotEqual(self.mesh(options=options), self.mesh())

    def test_keywords_replace_members(self):
        options = meniscus.SurfaceOptions(probe=1.2, spacing=0.4, edge=1.0)
        self.assertEqual(self.mesh(options=options, probe=1.4), self.mesh(spacing=0.4, edge=1.0))
        self.assertEqual(self.mesh(options=options, spacing=None), self.mesh(probe=1.2, spacing=0.4, edge=1.0))
        self.assertEqual(self.mesh(options=options, edge=2.0), self.mesh(options=options.replace(edge=2.0)))
        seen = []
        run = meniscus.RunOptions(threads=1, progress=lambda stage, part: seen.append(stage))
        self.assertEqual(self.mesh(run=run, threads=2), self.mesh())
        self.assertTrue(seen)

    def test_what_a_surface_remembers_makes_it_again(self):
        options = meniscus.SurfaceOptions(spacing=0.4, edge=1.0, quality=True)
        made = meniscus.surface(CENTRES, RADII, options=options)
        self.assertEqual(self.mesh(**made.options), made.vertices.tobytes())

    def test_of_an_exact_surface(self):
        exact = meniscus.ExactSurface(CENTRES, RADII, 1.2)
        options = meniscus.SurfaceOptions(spacing=0.4, probe=1.2)
        self.assertEqual(exact.mesh(options=options).vertices.tobytes(), self.mesh(options=options))
        self.assertEqual(exact.mesh(options=options.replace(probe=1.4)).options["probe"], 1.2)
        for other in ({"probe": 1.1}, {"surface": "sas"}):
            with self.assertRaisesRegex(meniscus.UsageError, "of options, but this surface has .*of_same_atoms"):
                exact.mesh(options=options.replace(**other))
        with self.assertRaises(meniscus.LimitError):
            exact.mesh(spacing=0.001, run=meniscus.RunOptions(memory="100M"))

    def test_of_reading(self):
        wet = meniscus.ReadOptions(waters=True, radii="bondi")
        self.assertEqual(len(read(UBIQUITIN, options=wet)), 660)
        self.assertEqual(meniscus.read_models(UBIQUITIN, options=wet)[0].radii_set, "bondi")
        for call in (meniscus.measure, meniscus.ExactSurface, lambda *a, **o: meniscus.surface(*a, spacing=1.0, **o)):
            self.assertEqual(len(call(UBIQUITIN, reading=wet).structure), 660)
            self.assertEqual(len(call(UBIQUITIN, reading=wet, waters=False).structure), 602)
            self.assertEqual(call(UBIQUITIN, "united", reading=wet).structure.radii_set, "united")
            with self.assertRaisesRegex(TypeError, "reading: applies where"):
                call(CENTRES, RADII, reading=wet)

    def test_help_shows_every_keyword_with_its_default(self):
        shown = inspect.signature(meniscus.surface).parameters
        for options in (meniscus.SurfaceOptions(), meniscus.RunOptions()):
            for field in dataclasses.fields(options):
                self.assertEqual(shown[field.name].default, field.default, field.name)
        self.assertEqual(inspect.signature(meniscus.read).parameters["hydrogens"].default, "auto")


class Words(unittest.TestCase):
    def test_types_have_the_words_of_the_library(self):
        for name, kind in (("hydrogens", _choices.Hydrogens), ("hetero", _choices.Hetero), ("per", _choices.Per),
                           ("field", _choices.Field), ("interpolation", _choices.Interpolation),
                           ("color", _choices.ColorScheme), ("rank", _choices.PocketRank),
                           ("pocket_field", _choices.PocketField)):
            self.assertEqual(typing.get_args(kind), _core.words[name], name)

    def told(self, call, *arguments, **options):
        """The words that the message of a wrong one names."""
        with self.assertRaises(meniscus.UsageError) as caught:
            call(*arguments, **options)
        return str(caught.exception).partition("choose one of ")[2].rstrip("\n")

    def test_radius_sets_and_views(self):
        sets = self.told(meniscus.radii, ["C"], set="nosuch")
        self.assertEqual(list(typing.get_args(_choices.RadiusSet)), ["auto", *sets.split(", ")[:-1]])
        self.assertEqual(list(typing.get_args(_choices.ViewName)), ["auto", *_writing._VIEWS])

    def test_formats(self):
        ball = meniscus.surface([[0, 0, 0]], [2.0])
        for call, kind, more in ((ball.save, _choices.SurfaceFormat, ["vert"]), (ball.sample().save, _choices.PointFormat, []),
                                 (ball.structure.save, _choices.AtomFormat, []),
                                 (meniscus.pockets([[0, 0, 0]], [2.0]).save, _choices.PocketFormat, [])):
            suffixes = self.told(call, "a.gif").split()
            self.assertEqual(sorted(suffixes), sorted("." + word for word in [*typing.get_args(kind), *more]))

    def test_keywords_have_the_types_of_the_options(self):
        """The two lists of reading, of which one is for functions and one for mypy."""
        options = meniscus.ReadOptions.__annotations__
        for keywords in (_reading.Reading, _reading.ReadingOfFile):
            for name, kind in keywords.__annotations__.items():
                if name != "frame":
                    self.assertEqual(kind.__forward_arg__, options[name], name)


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The exact surface: how it is made, the same numbers as measure() and surface(), closed forms, copies, what is refused."""
import concurrent.futures
import copy
import inspect
import math
import os
import pathlib
import pickle
import unittest

import numpy as np
from support import CENTRES, RADII, UBIQUITIN, InScratchFolder, read

import meniscus

KINDS = ("ses", "sas", "vdw")
COLUMNS = {"distance": np.float64, "atom": np.int32, "patch": np.uint8, "normal": np.float64,
           "mean_curvature": np.float64, "gaussian_curvature": np.float64, "foot": np.float64}


def places(count=500):
    return np.random.default_rng(1).uniform(-8, 8, (count, 3))


class Making(InScratchFolder):
    def test_of_a_structure_a_path_or_arrays(self):
        protein = read(UBIQUITIN)
        exact = meniscus.ExactSurface(protein)
        self.assertIs(exact.structure, protein)
        self.assertEqual((exact.probe, exact.kind), (1.4, "ses"))
        for path in (UBIQUITIN, pathlib.Path(UBIQUITIN)):
            self.assertEqual(meniscus.ExactSurface(path).measures.totals, exact.measures.totals)
        self.assertEqual(meniscus.ExactSurface(UBIQUITIN, "bondi").structure.radii_set, "bondi")
        wet = meniscus.ExactSurface(UBIQUITIN, waters=True, probe=1.2, surface="sas")
        self.assertEqual((len(wet.structure), wet.probe, wet.kind), (660, 1.2, "sas"))
        self.assertEqual(meniscus.ExactSurface(CENTRES, RADII).structure.radii.tolist(), RADII)

    def test_warnings_of_reading_name_the_line_of_the_caller(self):
        pathlib.Path("odd.pqr").write_text("ATOM 1 N ALA 1 0 0 0 0 1.5\nATOM 2 O HOH 2 5 0 0 0 1.5\n", encoding="ascii")
        for call in (meniscus.ExactSurface, lambda path: meniscus.signed_distance(path, points=[[0, 0, 0]])):
            with self.assertWarns(meniscus.ReadWarning) as caught:
                call("odd.pqr")
            self.assertEqual(os.path.basename(caught.filename), "test_exact.py")

    def test_what_makes_no_sense_is_refused(self):
        for options, message in (({"surface": "skin"}, "surface: unknown value 'skin'; choose one of ses, sas, vdw"),
                                 ({"probe": -1}, "probe -1: must be finite and not negative"),
                                 ({"probe": math.inf}, "probe inf: must be finite and not negative"),
                                 ({"threads": -1}, "threads -1: must be 0")):
            with self.assertRaisesRegex(meniscus.UsageError, message):
                meniscus.ExactSurface(CENTRES, RADII, **options)
        for options in ({"probe": "1.4"}, {"surface": 1}, {"threads": 1.5}):
            with self.assertRaises(TypeError):
                meniscus.ExactSurface(CENTRES, RADII, **options)
        with self.assertRaisesRegex(TypeError, "unexpected keyword argument 'watters'"):
            meniscus.ExactSurface(UBIQUITIN, watters=True)
        with self.assertRaisesRegex(TypeError, r"waters is an argument of read\(\)"):
            meniscus.ExactSurface(CENTRES, RADII, waters=True)
        with self.assertRaises(FileNotFoundError):
            meniscus.ExactSurface("no-such-file.pdb")
        with self.assertRaisesRegex(TypeError, "radii: required"):
            meniscus.ExactSurface(CENTRES)

    def test_what_only_the_geometry_tells_is_refused_when_it_is_needed(self):
        for centres, radii in (([], []), ([[0, 0, 0]], [-1.0]), ([[0, 0, 0]], [0.0])):
            exact = meniscus.ExactSurface(centres, radii)
            for ask in (lambda: exact.measures, lambda: exact.nearest([[0, 0, 0]]), lambda: exact.mesh()):
                with self.assertRaises(ValueError):
                    ask()


class SameNumbers(unittest.TestCase):
    def test_as_measure(self):
        for probe in (1.4, 0.8, 0.0):
            exact = meniscus.ExactSurface(CENTRES, RADII, probe).measures
            alone = meniscus.measure(CENTRES, RADII, probe)
            self.assertEqual((exact.totals, exact.errors, exact.probe), (alone.totals, alone.errors, alone.probe))
            self.assertEqual(exact.atom_ses_area.tobytes(), alone.atom_ses_area.tobytes())
            self.assertEqual(exact.components, alone.components)

    def test_as_signed_distance(self):
        exact = meniscus.ExactSurface(CENTRES, RADII, probe=1.0)
        alone = meniscus.signed_distance(CENTRES, RADII, places(), probe=1.0)
        self.assertEqual(exact.signed_distance(places()).tobytes(), alone.tobytes())
        self.assertEqual(exact.nearest(places()).distance.tobytes(), alone.tobytes())

    def test_as_surface(self):
        for kind in KINDS:
            exact = meniscus.ExactSurface(CENTRES, RADII, surface=kind)
            for options in ({}, {"method": "direct", "spacing": 0.4}, {"edge": 1.0, "keep_ridges": True}):
                mesh = exact.mesh(**options)
                alone = meniscus.surface(CENTRES, RADII, surface=kind, **options)
                for name, array in mesh.numpy().items():
                    self.assertEqual(array.tobytes(), getattr(alone, name).tobytes(), (kind, options, name))
                self.assertEqual((mesh.mesh, mesh.flow, mesh.checks), (alone.mesh, alone.flow, alone.checks))
                self.assertEqual(mesh.options, {name: alone.options[name] for name in mesh.options})
                self.assertEqual(mesh.measures.totals, alone.measures.totals)

    def test_whatever_number_of_threads(self):
        one, all_cores = (meniscus.ExactSurface(CENTRES, RADII, threads=threads) for threads in (1, 0))
        self.assertEqual(one.measures.totals, all_cores.measures.totals)
        self.assertEqual(one.mesh().vertices.tobytes(), all_cores.mesh().vertices.tobytes())
        for name in COLUMNS:
            self.assertEqual(getattr(one.nearest(places()), name).tobytes(),
                             getattr(all_cores.nearest(places()), name).tobytes(), name)

    def test_several_threads_may_ask_at_once(self):
        exact = meniscus.ExactSurface(read(UBIQUITIN))
        alone = meniscus.signed_distance(exact.structure, points=places())
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            found = list(pool.map(lambda _: (exact.signed_distance(places()), exact.measures.totals), range(8)))
        for distances, totals in found:
            self.assertEqual(distances.tobytes(), alone.tobytes())
            self.assertEqual(totals, exact.measures.totals)


class Sharing(unittest.TestCase):
    def test_measures_are_kept(self):
        exact = meniscus.ExactSurface(CENTRES, RADII)
        self.assertIs(exact.measures, exact.measures)
        self.assertIs(exact.measures.structure, exact.structure)

    def test_meshes_and_points_keep_the_surface_that_they_are_of(self):
        exact = meniscus.ExactSurface(CENTRES, RADII)
        mesh = exact.mesh(spacing=0.4)
        self.assertIs(mesh.exact, exact)
        self.assertIs(mesh.measures, exact.measures)
        self.assertIs(mesh.structure, exact.structure)
        self.assertIs(mesh.sample().exact, exact)
        made = meniscus.surface(CENTRES, RADII, probe=1.0, surface="sas")
        self.assertEqual((made.exact.probe, made.exact.kind), (1.0, "sas"))
        self.assertIs(made.measures, made.exact.measures)
        self.assertLess(np.median(abs(made.exact.signed_distance(made.vertices))), 0.01)

    def test_other_surfaces_of_the_same_atoms(self):
        exact = meniscus.ExactSurface(CENTRES, RADII, probe=1.0, threads=1)
        for given, probe, kind in (({}, 1.0, "ses"), ({"surface": "sas"}, 1.0, "sas"), ({"probe": 2.0}, 2.0, "ses"),
                                   ({"probe": 2.0, "surface": "sas"}, 2.0, "sas"), ({"surface": "vdw"}, 1.0, "vdw")):
            other = exact.of_same_atoms(**given)
            self.assertIs(other.structure, exact.structure)
            self.assertEqual((other.probe, other.kind), (probe, kind))
            alone = meniscus.ExactSurface(CENTRES, RADII, probe, surface=kind)
            self.assertEqual(other.measures.totals, alone.measures.totals)
            self.assertEqual(other.signed_distance(places()).tobytes(), alone.signed_distance(places()).tobytes())
            self.assertEqual(other.mesh().options["threads"], 1)
        self.assertEqual(exact.of_same_atoms(surface="vdw").of_same_atoms(surface="ses").measures.totals,
                         exact.measures.totals)
        with self.assertRaisesRegex(meniscus.UsageError, "probe -1"):
            exact.of_same_atoms(probe=-1)
        with self.assertRaisesRegex(meniscus.UsageError, "surface: unknown value"):
            exact.of_same_atoms(surface="skin")


class ClosedForms(unittest.TestCase):
    def check(self, found, **wanted):
        for name, values in wanted.items():
            self.assertTrue(np.allclose(getattr(found, name), values, atol=1e-8), (name, getattr(found, name)))

    def test_arrays_are_as_documented(self):
        found = meniscus.ExactSurface(CENTRES, RADII).nearest(places(7))
        self.assertEqual(len(found), 7)
        for name, dtype in COLUMNS.items():
            array = getattr(found, name)
            self.assertEqual(array.dtype, dtype, name)
            self.assertEqual(array.shape, (7, 3) if name in ("normal", "foot") else (7,), name)
            self.assertFalse(array.flags.writeable, name)
        self.assertEqual(meniscus.ExactSurface(CENTRES, RADII).nearest(np.zeros((0, 3))).foot.shape, (0, 3))

    def test_one_sphere(self):
        centre, radius, probe = np.array([0.5, -1.0, 2.0]), 2.0, 1.4
        direction = np.array([1.0, 2.0, -2.0]) / 3.0
        heights = np.array([[0.5], [2.0], [2.5], [6.0]])
        for kind, of_surface, of_foot in (("ses", radius, radius + probe), ("sas", radius + probe, radius + probe),
                                          ("vdw", radius, radius)):
            exact = meniscus.ExactSurface([centre], [radius], probe, surface=kind)
            self.check(exact.nearest(centre + heights * direction), distance=heights[:, 0] - of_surface, atom=0, patch=0,
                       normal=direction, mean_curvature=1 / heights[:, 0], gaussian_curvature=1 / heights[:, 0] ** 2,
                       foot=centre + of_foot * direction)
            self.assertAlmostEqual(exact.measures.ses_area, 4 * math.pi * of_surface**2, 7)
            self.assertAlmostEqual(exact.measures.ses_volume, 4 / 3 * math.pi * of_surface**3, 7)

    def test_two_spheres_and_the_torus_between_them(self):
        """The probe's centre runs round the x axis on a circle; in the plane between the atoms the torus is nearest."""
        half, radius, probe = 1.0, 1.5, 1.0
        circle = math.sqrt((radius + probe) ** 2 - half**2)
        exact = meniscus.ExactSurface([[-half, 0, 0], [half, 0, 0]], [radius, radius], probe)
        heights = np.array([0.5, 0.9, 1.0, 1.2])
        across = circle - heights
        zero = np.zeros(4)
        found = exact.nearest(np.column_stack([zero, heights, zero]))
        self.check(found, distance=probe - across, patch=1, normal=[0, 1, 0],
                   mean_curvature=(1 / heights - 1 / across) / 2, gaussian_curvature=-1 / (heights * across),
                   foot=[0, circle, 0])
        self.check(exact.nearest([[-half - radius, 0, 0], [half, 0, 2.0]]), distance=[0, 0.5], atom=[0, 1], patch=0,
                   mean_curvature=[1 / radius, 0.5])
        without = exact.of_same_atoms(surface="vdw").nearest([[0.0, 0.3, 0.4]])
        edge = math.sqrt(radius**2 - half**2)
        self.check(without, distance=0.5 - edge, patch=1, normal=[0, 0.6, 0.8], foot=[0, 0.6 * edge, 0.8 * edge])

    def test_the_nearest_point_of_the_surface(self):
        exact = meniscus.ExactSurface(CENTRES, RADII)
        found = exact.nearest(places())
        inside = found.distance < 0
        self.assertGreater(inside.sum(), 5)
        on_surface = places() - found.distance[:, None] * found.normal
        self.assertLess(abs(exact.signed_distance(on_surface[inside])).max(), 1e-9)
        self.assertTrue(np.allclose(np.linalg.norm(found.foot[inside] - on_surface[inside], axis=1), 1.4))

    def test_points_are_checked(self):
        exact = meniscus.ExactSurface(CENTRES, RADII)
        for ask in (exact.signed_distance, exact.nearest):
            with self.assertRaisesRegex(meniscus.UsageError, "points: must have shape"):
                ask([1, 2, 3])
            with self.assertRaisesRegex(ValueError, "points: .*finite"):
                ask([[0, 0, math.nan]])


class Meshing(unittest.TestCase):
    def test_keywords_are_those_of_surface(self):
        keywords = set(meniscus.Meshing.__annotations__)
        of_mesh = set(inspect.signature(meniscus.ExactSurface.mesh).parameters) - {"self"}
        of_exact = set(inspect.signature(meniscus.ExactSurface).parameters)
        self.assertTrue(keywords < of_mesh)
        self.assertEqual(of_mesh | of_exact, set(inspect.signature(meniscus.surface).parameters))

    def test_what_makes_no_sense_is_refused(self):
        exact = meniscus.ExactSurface(CENTRES, RADII)
        for options, message in (({"method": "fast"}, "method: unknown value 'fast'"),
                                 ({"spacing": 0}, "spacing: must be a finite number greater than 0"),
                                 ({"adaptive": True}, "ask for them with edge"),
                                 ({"history": True, "method": "direct"}, "history"),
                                 ({"flow": "paper", "method": "direct"}, "flow applies to the flow")):
            with self.assertRaisesRegex(meniscus.UsageError, message):
                exact.mesh(**options)
        with self.assertRaisesRegex(TypeError, "unexpected keyword argument 'edgy'"):
            exact.mesh(edgy=1.0)
        with self.assertRaisesRegex(TypeError, "flow: must be text"):
            exact.mesh(flow=3)
        with self.assertRaises(meniscus.LimitError):
            exact.mesh(spacing=0.001, memory="100M")

    def test_values_of_another_type_are_refused_by_name(self):
        class Breaks:
            def __index__(self):
                raise KeyError("mine")

        exact = meniscus.ExactSurface(CENTRES, RADII)
        for options, message in (({"quality": np.array([True, False])}, "quality: must be True or False"),
                                 ({"verify": "no"}, "verify: must be True or False"),
                                 ({"history": "steps.csv"}, "history: must be True or False"),
                                 ({"edge": True}, "edge: must be a number"),
                                 ({"edge": np.array([1.0])}, "edge: must be a number"),
                                 ({"max_steps": 2.5}, "max_steps: must be a whole number")):
            with self.assertRaisesRegex(TypeError, message):
                exact.mesh(**options)
        with self.assertRaisesRegex(meniscus.UsageError, "max_steps: 1000000000000 is too large"):
            exact.mesh(max_steps=10**12)
        with self.assertRaisesRegex(KeyError, "mine"):
            exact.mesh(max_steps=Breaks())
        with self.assertRaisesRegex(meniscus.UsageError, "unknown value 'flow"):
            exact.mesh(method="flow\0x")
        for name in ("edge", "spacing"):
            with self.assertRaisesRegex(meniscus.UsageError, f"{name}: the number is too large"):
                exact.mesh(**{name: 10**400})
        with self.assertRaisesRegex(meniscus.UsageError, "edge 1e-200: must be"):
            exact.mesh(edge=1e-200)
        with self.assertRaises(UnicodeError):
            exact.mesh(method="\udcff")
        mesh = exact.mesh(spacing=np.float32(0.5), quality=np.bool_(True), history=1)
        self.assertIsNotNone(mesh.mesh["quality"])

    def test_a_mesh_that_fails_its_checks_is_warned_of(self):
        with self.assertWarnsRegex(meniscus.CheckWarning, "converged") as caught:
            meniscus.ExactSurface(CENTRES, RADII).mesh(flow="paper", max_steps=1)
        self.assertEqual(caught.filename, __file__)

    def test_progress_may_end_it(self):
        def stop(stage, part):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            meniscus.ExactSurface(CENTRES, RADII).mesh(progress=stop)


class Copies(unittest.TestCase):
    def test_have_the_same_numbers(self):
        for kind in KINDS:
            exact = meniscus.ExactSurface(CENTRES, RADII, 1.2, surface=kind, threads=1)
            for measured in (False, True):
                if measured:
                    exact.measures
                for way in (lambda value: pickle.loads(pickle.dumps(value)), copy.deepcopy, copy.copy):
                    again = way(exact)
                    self.assertEqual((again.probe, again.kind), (exact.probe, exact.kind))
                    self.assertEqual(again.measures.totals, meniscus.ExactSurface(CENTRES, RADII, 1.2,
                                                                                  surface=kind).measures.totals)
                    self.assertIs(again.measures.structure, again.structure)
                    self.assertEqual(again.signed_distance(places()).tobytes(),
                                     exact.signed_distance(places()).tobytes())
                    self.assertEqual(again.mesh().vertices.tobytes(), exact.mesh().vertices.tobytes())

    def test_what_several_share_stays_one(self):
        exact = meniscus.ExactSurface(CENTRES, RADII)
        mesh, again, points = pickle.loads(pickle.dumps((exact.mesh(), exact, exact.mesh().sample())))
        self.assertIs(mesh.exact, again)
        self.assertIs(points.exact, again)
        self.assertIs(mesh.measures, again.measures)

    def test_of_what_is_nearest(self):
        found = meniscus.ExactSurface(CENTRES, RADII).nearest(places())
        again = pickle.loads(pickle.dumps(found))
        for name in COLUMNS:
            self.assertEqual(getattr(again, name).tobytes(), getattr(found, name).tobytes(), name)


if __name__ == "__main__":
    unittest.main()

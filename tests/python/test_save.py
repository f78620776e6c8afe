# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Files: the same bytes as the command line's, every format, what is refused."""
import os
import pathlib
import subprocess
import unittest

import numpy as np
from support import CENTRES, PROGRAM, RADII, UBIQUITIN, InScratchFolder, read

import meniscus


def content(path):
    return pathlib.Path(path).read_bytes()


@unittest.skipUnless(PROGRAM, "MENISCUS_PROGRAM names no program to compare with")
class AsTheProgram(InScratchFolder):
    def test_files_have_the_same_bytes(self):
        names = ["mesh.ply", "mesh.obj", "mesh.stl", "mesh.off", "mesh.glb", "mesh.vert", "picture.png", "page.html"]
        outputs = [word for name in names for word in ("-o", f"cli_{name}")]
        options = ["--color", "curvature:-1:1", "--size", "400x300", "--view", "top", "--background", "#202020",
                   "--cut", "12", "--legend"]
        subprocess.run([PROGRAM, "surface", UBIQUITIN, "--quiet", *options, *outputs], check=True, capture_output=True)
        surface = meniscus.surface(read(UBIQUITIN))
        for name in names:
            surface.save(name, color="curvature:-1:1", size=(400, 300), view="top", background="#202020", cut=12,
                         legend=True)
            self.assertTrue(content(name) == content(f"cli_{name}"), name)
        self.assertTrue(content("mesh.face") == content("cli_mesh.face"))
        surface.structure.save("mesh.atoms.csv")
        self.assertTrue(content("mesh.atoms.csv") == content("cli_mesh.atoms.csv"))

    def test_defaults_are_the_same(self):
        subprocess.run([PROGRAM, "surface", UBIQUITIN, "--quiet", "-o", "cli.ply"], check=True, capture_output=True)
        meniscus.surface(read(UBIQUITIN)).save("own.ply")
        self.assertTrue(content("own.ply") == content("cli.ply"))


class Saving(InScratchFolder):
    def setUp(self):
        super().setUp()
        self.surface = meniscus.surface(CENTRES, RADII)

    def test_npz_holds_the_arrays_by_name(self):
        self.surface.save("surface.npz")
        with np.load("surface.npz") as arrays:
            self.assertEqual(set(arrays), {"vertices", "triangles", "normals", "atom", "residue", "patch", "component",
                                           "area", "mean_curvature", "gaussian_curvature", "shape_index"})
            for name in arrays:
                self.assertTrue((arrays[name] == getattr(self.surface, name)).all(), name)

    def test_text_is_written_when_asked_for(self):
        self.surface.save("surface.ply", ascii=True)
        self.assertIn(b"format ascii 1.0", content("surface.ply")[:40])

    def test_a_page_holds_the_surface_and_its_numbers(self):
        self.surface.save("surface.html", color="patch", view="top", perspective=True)
        page = pathlib.Path("surface.html").read_text(encoding="utf-8")
        self.assertTrue(page.startswith("<!doctype html>"))
        self.assertIn(f"{self.surface.measures.ses_area:.1f} Å²", page)
        with self.assertRaisesRegex(ValueError, "schemes"):
            self.surface.save("other.html", color=self.surface.colors("patch"))

    def test_cuts_open_the_surface(self):
        self.surface.save("whole.png", size=(64, 48), view="front")
        cuts = ["auto", 1.0, (1, 0, 0), ((1, 0, 0), (1, 0, 0))]
        for i, cut in enumerate(cuts):
            self.surface.save(f"cut{i}.png", size=(64, 48), view="front", cut=cut)
        self.assertEqual(len({content(path) for path in os.listdir()}), 5)
        shell = meniscus.surface(5 * np.vstack([np.eye(3), -np.eye(3)]), [4.0] * 6, probe=0.5)
        shell.save("cavity.png", size=(64, 48), cut="cavity:1")
        for cut in ("cavity:2", "cavity:0", "half", (1, 2), float("nan")):
            with self.assertRaises(ValueError):
                shell.save("bad.png", size=(64, 48), cut=cut)

    def test_paths_of_pathlib_are_taken(self):
        self.surface.save(pathlib.Path("surface.off"))
        self.assertTrue(content("surface.off").startswith(b"OFF"))

    def test_colours_may_be_given_per_vertex(self):
        red = np.tile(np.array([255, 0, 0], np.uint8), (len(self.surface.vertices), 1))
        self.surface.save("red.ply", color=red)
        self.surface.save("plain.ply", color="single")
        self.assertEqual(len(content("red.ply")), len(content("plain.ply")))
        self.assertNotEqual(content("red.ply"), content("plain.ply"))
        self.surface.save("red.png", color=red, size=(64, 48))
        with self.assertRaises(ValueError):
            self.surface.save("red.ply", color=red[1:])
        with self.assertRaisesRegex(ValueError, "uint8"):
            self.surface.save("red.ply", color=red / 255)

    def test_schemes_give_their_colours(self):
        colours = self.surface.colors("patch")
        self.assertEqual((colours.shape, colours.dtype), ((len(self.surface.vertices), 4), np.uint8))
        self.assertEqual(len(np.unique(colours[self.surface.patch == 0], axis=0)), 1)
        named = meniscus.Structure.from_arrays(CENTRES, RADII, element=["C", "N", "O", "S"])
        self.assertEqual(len(np.unique(meniscus.surface(named).colors("element"), axis=0)), 4)

    def test_level_sets_are_kept(self):
        self.surface.save("surface.mls")
        self.assertTrue(content("surface.mls").startswith(b"\x8dMLS"))
        with self.assertRaisesRegex(ValueError, "no level set"):
            meniscus.surface(CENTRES, RADII, method="direct").save("surface.mls")

    def test_points_are_a_cloud(self):
        points = self.surface.sample()
        points.save("points.ply", color="patch", ascii=True)
        self.assertIn(f"element vertex {len(points)}".encode(), content("points.ply"))
        points.save("points.npz")
        with np.load("points.npz") as arrays:
            self.assertTrue((arrays["points"] == points.points).all())

    def test_what_makes_no_sense_is_a_value_error_and_leaves_nothing(self):
        for path, options, message in (("x.gif", {}, "known are .ply"),
                                       ("x.ply", {"color": "rainbow"}, "color: unknown value 'rainbow'"),
                                       ("x.ply", {"color": "curvature:1"}, "SCHEME:MIN:MAX"),
                                       ("x.ply", {"color": "curvature:1:0"}, "range"),
                                       ("x.ply", {"color": "patch:0:1"}, "range"),
                                       ("x.png", {"view": "behind"}, "view: unknown value"),
                                       ("x.png", {"view": (1, 2)}, "shape"),
                                       ("x.png", {"background": "mauve"}, "is no colour"),
                                       ("x.png", {"size": (0, 10)}, "size|width|pixel")):
            with self.assertRaisesRegex(ValueError, message):
                self.surface.save(path, **options)
        self.assertEqual(os.listdir(), [])

    def test_what_cannot_be_written_is_an_os_error_and_leaves_nothing(self):
        for suffix in ("ply", "npz", "png", "mls", "stl", "glb", "html"):
            with self.assertRaisesRegex(OSError, f"nosuch/x.{suffix}: cannot be written"):
                self.surface.save(f"nosuch/x.{suffix}", size=(8, 8))
            os.mkdir(f"x.{suffix}")
            with self.assertRaises(OSError):
                self.surface.save(f"x.{suffix}", size=(8, 8))
            os.rmdir(f"x.{suffix}")
        self.assertEqual(os.listdir(), [])


if __name__ == "__main__":
    unittest.main()

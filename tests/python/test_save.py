# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Files: the same bytes as the command line's, every format, what is refused."""
import json
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
        names = ["mesh.ply", "mesh.obj", "mesh.stl", "mesh.off", "mesh.glb", "mesh.vtp", "mesh.vert", "mesh.npz", "picture.png", "page.html"]
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

    def test_ligands_have_the_same_bytes(self):
        antibody = UBIQUITIN.replace("1ubq", "1a0q")
        names = ["a.png", "a.glb", "a.html"]
        protein = read(antibody, chains=["H"])
        self.assertEqual(protein.ligands, {"HEP": 1})
        surface = meniscus.surface(protein, spacing=1)
        for draw in ("ligands", "none"):
            outputs = [word for name in names for word in ("-o", f"cli_{draw}_{name}")]
            subprocess.run([PROGRAM, "surface", antibody, "--quiet", "--chains", "H", "--spacing", "1", "--size", "64x48",
                            "--draw", draw, *outputs], check=True, capture_output=True)
            for name in names:
                surface.save(f"{draw}_{name}", size=(64, 48), draw=draw)
                self.assertTrue(content(f"{draw}_{name}") == content(f"cli_{draw}_{name}"), (draw, name))
        for name in names:
            self.assertFalse(content(f"ligands_{name}") == content(f"none_{name}"), name)
        with self.assertRaisesRegex(ValueError, "draw: .*ligands, none"):
            surface.save("b.png", draw="waters")

    def test_pockets_have_the_same_colours(self):
        names = ["a.ply", "a.glb", "a.vtp", "a.npz", "a.png", "a.html"]
        for kind in ("ses", "sas"):
            outputs = [word for name in names for word in ("-o", f"cli_{kind}_{name}")]
            subprocess.run([PROGRAM, "surface", UBIQUITIN, "--quiet", "--spacing", "1", "--surface", kind, "--color", "pocket",
                            "--arrays", "depth", "--size", "320x240", "--legend", *outputs], check=True, capture_output=True)
            surface = meniscus.surface(read(UBIQUITIN), spacing=1, surface=kind)
            for name in names:
                surface.save(f"{kind}_{name}", color="pocket", arrays="depth", size=(320, 240), legend=True)
                self.assertTrue(content(f"{kind}_{name}") == content(f"cli_{kind}_{name}"), (kind, name))
        with np.load("ses_a.npz") as arrays:
            ranks = arrays["pocket"]
        self.assertTrue(np.isnan(ranks).any())
        self.assertGreater(np.nanmax(ranks), 1)
        given = np.ones(len(surface.normals))
        surface.save("given.npz", color="pocket", values={"pocket": given})
        with np.load("given.npz") as arrays:
            self.assertTrue((arrays["pocket"] == given).all())

    def test_values_are_the_same(self):
        pathlib.Path("t.csv").write_text("chain,resnum,score\nA,8,0.5\nA,44,1\n", encoding="ascii")
        subprocess.run([PROGRAM, "surface", UBIQUITIN, "--quiet", "--values", "t.csv", "--color", "score", "-o", "cli.ply",
                        "-o", "cli.html"], check=True, capture_output=True)
        subprocess.run([PROGRAM, "surface", UBIQUITIN, "--quiet", "--color", "bfactor", "-o", "cli_b.ply"], check=True,
                       capture_output=True)
        surface = meniscus.surface(read(UBIQUITIN))
        for name in ("ply", "html"):
            surface.save(f"own.{name}", values=surface.table_values("t.csv"), color="score")
            self.assertTrue(content(f"own.{name}") == content(f"cli.{name}"), name)
        surface.save("own_b.ply", color="bfactor")
        self.assertTrue(content("own_b.ply") == content("cli_b.ply"))

    def test_volumes_have_the_same_bytes(self):
        for options, keywords in (([], {}), (["--grid", "20,21,22,0.8,30,29,15", "--field", "dielectric", "--eps", "4,80"],
                                             {"grid": (20, 21, 22, 0.8, 30, 29, 15), "field": "dielectric",
                                              "eps": (4, 80)}),
                                  (["--grid", "cli.mrc", "--field", "ions", "--ion-radius", "1.5"],
                                   {"grid": "cli.mrc", "field": "ions", "ion_radius": 1.5})):
            outputs = ["-o", "cli_a.dx"] if "cli.mrc" in options else ["-o", "cli_a.dx", "-o", "cli.mrc"]
            subprocess.run([PROGRAM, "surface", UBIQUITIN, "--quiet", *options, *outputs], check=True,
                           capture_output=True)
            surface = meniscus.surface(read(UBIQUITIN))
            for name in outputs[1::2]:
                surface.save(f"own{name}", **keywords)
                self.assertTrue(content(f"own{name}") == content(name), (name, options))

    def test_maps_of_apbs_have_the_same_bytes(self):
        subprocess.run([PROGRAM, "surface", UBIQUITIN, "--quiet", "--maps", "apbs", "--grid", "9,9,9,3,30,29,15", "-o",
                        "cli.dx"], check=True, capture_output=True)
        meniscus.surface(read(UBIQUITIN)).save("own.dx", maps="apbs", grid=(9, 9, 9, 3, 30, 29, 15))
        for name in ("dielx", "diely", "dielz", "kappa"):
            self.assertTrue(content(f"own_{name}.dx") == content(f"cli_{name}.dx"), name)

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
            names = {"vertices", "triangles", "normals", "atom", "residue", "patch", "component", "area",
                     "mean_curvature", "gaussian_curvature", "shape_index"}
            columns = {"xyz", "radius", "name", "element", "altloc", "chain", "resname", "icode", "resnum", "residue",
                       "serial", "b_factor", "occupancy", "charge"}
            self.assertEqual(set(arrays), names | {f"atom_{name}" for name in columns} | {"colors", "options", "layout"})
            for name in names:
                array, own = arrays[name], getattr(self.surface, name)
                self.assertEqual((array.dtype, array.shape), (own.dtype, own.shape), name)
                self.assertTrue((array == own).all(), name)
            self.assertTrue((arrays["colors"] == self.surface.colors()).all())
            self.assertEqual(arrays["layout"], 1)

    def test_npz_holds_the_atoms_and_options(self):
        structure = read(UBIQUITIN)
        meniscus.surface(structure, probe=1.5, spacing=1).save("surface.npz")
        with np.load("surface.npz", allow_pickle=False) as arrays:
            for name in ("xyz", "name", "element", "altloc", "chain", "resname", "icode", "resnum", "residue", "serial",
                         "b_factor", "occupancy", "charge"):
                array, own = arrays[f"atom_{name}"], getattr(structure, name)
                self.assertEqual(array.shape, own.shape, name)
                self.assertTrue((array == own).all(), name)
            self.assertTrue((arrays["atom_radius"] == structure.radii).all())
            told = json.loads(str(arrays["options"]))
            self.assertEqual((told["input"]["probe"], told["options"]["spacing"]), (1.5, 1))
            self.assertEqual(told["input"]["sha256"], structure.sha256)

    def test_parts_have_the_bytes_of_the_program(self):
        if not PROGRAM:
            self.skipTest("MENISCUS_PROGRAM names no program to compare with")
        subprocess.run([PROGRAM, "surface", UBIQUITIN, "--quiet", "--spacing", "0.8", "--surface", "sas", "--show",
                        "//A/1-30", "-o", "cli.ply", "-o", "cli.npz"], check=True, capture_output=True)
        surface = meniscus.surface(read(UBIQUITIN), spacing=0.8, surface="sas")
        for suffix in ("ply", "npz"):
            surface.save(f"own.{suffix}", show="//A/1-30")
            self.assertTrue(content(f"own.{suffix}") == content(f"cli.{suffix}"), suffix)
        self.assertAlmostEqual(surface.measures.ses_area, surface.measures.sas_area, delta=1e-3)
        self.assertAlmostEqual(surface.measures.sas_area, meniscus.measure(surface.structure).sas_area, delta=1e-3)

    def test_a_cavity_alone_and_what_is_no_part(self):
        shell = meniscus.surface(5 * np.vstack([np.eye(3), -np.eye(3)]), [4.0] * 6, probe=0.5)
        shell.save("cavity.npz", cavity=1)
        with np.load("cavity.npz") as arrays:
            self.assertTrue((arrays["component"] == 1).all())
            self.assertEqual(len(arrays["vertices"]), int((shell.component == 1).sum()))
        for options, message in (({"cavity": 2}, "cavity 2: the mesh has 1"), ({"cavity": 0}, "counted from 1"),
                                 ({"show": "//Z"}, "selects none"), ({"show": ""}, "empty"),
                                 ({"show": "//A", "cavity": 1}, "one of them")):
            with self.assertRaisesRegex(ValueError, message):
                shell.save("bad.ply", **options)
        with self.assertRaisesRegex(ValueError, "mesh format"):
            shell.save("bad.png", cavity=1)

    def test_npz_keeps_letters_of_every_alphabet(self):
        names = ["C", "Cα", "酸", "😀"]
        structure = meniscus.Structure.from_arrays(CENTRES, RADII, name=names)
        meniscus.surface(structure, spacing=1).save("surface.npz")
        with np.load("surface.npz") as arrays:
            self.assertEqual(arrays["atom_name"].tolist(), names)

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

    def test_values_go_along_by_name(self):
        height = self.surface.vertices[:, 2]
        self.surface.save("v.ply", values={"height": height}, color="height:-1:1", ascii=True)
        self.assertIn(b"property float height\n", content("v.ply"))
        self.surface.save("w.ply", values={"height": height}, color="height", ascii=True)
        self.assertNotEqual(content("v.ply"), content("w.ply"))
        colours = self.surface.colors("height:-1:1", values={"height": height})
        self.assertTrue((colours[height > 1][:, 2] > colours[height > 1][:, 0]).all(), "blue above")
        for name in ("v.html", "v.png", "v.glb"):
            self.surface.save(name, values={"height": height}, color="height", **({"size": (64, 48)} if "png" in name
                                                                                  else {}))
        self.assertIn(b"_HEIGHT", content("v.glb"))
        for values, message in (({"height": height[1:]}, "shape"), ({"area": height}, "area"), ({"a b": height}, "name")):
            with self.assertRaisesRegex(ValueError, message):
                self.surface.save("x.ply", values=values)
        with self.assertRaisesRegex(ValueError, "there are height"):
            self.surface.colors("depth_", values={"height": height})
        self.assertFalse(os.path.exists("x.ply"))

    def test_maps_and_tables_give_values(self):
        pathlib.Path("x.dx").write_text(
            "object 1 class gridpositions counts 2 2 2\norigin -50 -50 -50\ndelta 100 0 0\ndelta 0 100 0\n"
            "delta 0 0 100\nobject 2 class gridconnections counts 2 2 2\n"
            "object 3 class array type double rank 0 items 8 data follows\n" + "-50 -50 -50 -50 50 50 50 50\n",
            encoding="ascii")
        x = self.surface.vertices[:, 0]
        self.assertTrue(np.allclose(self.surface.map_values("x.dx"), x, atol=1e-5))
        moved = self.surface.map_values("x.dx", offset=2.0, interpolation="cubic")
        self.assertTrue(np.allclose(moved, x + 2 * self.surface.normals[:, 0], atol=1e-4))
        with self.assertRaisesRegex(ValueError, "interpolation"):
            self.surface.map_values("x.dx", interpolation="best")
        pathlib.Path("t.csv").write_text("index,score\n0,1.5\n2,2.5\n", encoding="ascii")
        score = self.surface.table_values("t.csv")["score"]
        self.assertTrue((score[self.surface.atom == 2] == 2.5).all())
        self.assertTrue(np.isnan(score[self.surface.atom == 1]).all())
        points = self.surface.sample()
        points.save("p.ply", values=points.table_values("t.csv"), color="score", ascii=True)
        self.assertIn(b"property float score\n", content("p.ply"))

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

    def test_what_makes_no_sense_is_a_usage_error_and_leaves_nothing(self):
        count = len(self.surface.vertices)
        for path, options, message in (("x.gif", {}, "choose one of .ply"),
                                       ("x.ply", {"color": "rainbow"}, "color: unknown value 'rainbow'"),
                                       ("x.ply", {"color": "curvature:1"}, "SCHEME:MIN:MAX"),
                                       ("x.ply", {"color": "curvature:1:0"}, "range"),
                                       ("x.ply", {"color": "patch:0:1"}, "range"),
                                       ("x.dx", {"grid": (1, 2)}, "seven numbers"),
                                       ("x.dx", {"field": "charge"}, "field: unknown value"),
                                       ("x.dx", {"eps": (0, 1)}, "eps"),
                                       ("x.dx", {"maps": "apbs"}, "needs the grid"),
                                       ("x.mrc", {"maps": "apbs", "grid": (9, 9, 9, 1, 0, 0, 0)}, "reads its maps"),
                                       ("x.png", {"view": "behind"}, "view: unknown value"),
                                       ("x.png", {"view": (1, 2)}, "shape"),
                                       ("x.png", {"background": "mauve"}, "is not a colour"),
                                       ("x.dx", {"grid": (2.5, 9, 9, 1, 0, 0, 0)}, "must be whole"),
                                       ("x.dx", {"grid": (9, 9, 9, 1, 0, 0, np.nan)}, "finite"),
                                       ("x.dx", {"eps": (1,)}, "eps: two numbers"),
                                       ("x.png", {"size": (1, 2, 3)}, "size: two numbers"),
                                       ("x.png", {"size": (0, 10)}, "size|width|pixel"),
                                       ("x.ply", {"size": (8, 8, 8)}, "size: two numbers"),
                                       ("x.html", {"cut": "middle"}, "cut: unknown value"),
                                       ("x.glb", {"background": "mauve"}, "is not a colour"),
                                       ("x.ply", {"values": {"q": [1e300] * count}}, "beyond single precision"),
                                       ("x.ply", {"values": {"q": [1j] * count}}, "must be numbers")):
            with self.assertRaisesRegex(meniscus.UsageError, message):
                self.surface.save(path, **options)
        with self.assertRaises(FileNotFoundError):
            self.surface.save("x.dx", grid="none.dx")
        with self.assertRaises(FileNotFoundError):
            self.surface.map_values("none.dx")
        with self.assertRaises(FileNotFoundError):
            self.surface.table_values("none.csv")
        self.assertEqual(os.listdir(), [])

    def test_what_cannot_be_written_is_an_os_error_and_leaves_nothing(self):
        for suffix in ("ply", "npz", "png", "mls", "stl", "glb", "vtp", "html", "dx", "mrc"):
            with self.assertRaisesRegex(OSError, f"nosuch/x.{suffix}: there is no folder 'nosuch'; create it first"):
                self.surface.save(f"nosuch/x.{suffix}", size=(8, 8))
            os.mkdir(f"x.{suffix}")
            with self.assertRaises(OSError):
                self.surface.save(f"x.{suffix}", size=(8, 8))
            os.rmdir(f"x.{suffix}")
        with self.assertRaisesRegex(OSError, "nosuch/p.npz: there is no folder 'nosuch'; create it first"):
            self.surface.sample().save("nosuch/p.npz")
        self.assertEqual(os.listdir(), [])

    def test_values_without_a_name_are_a_type_error(self):
        for values in (self.surface.area, [1.0], "area"):
            with self.assertRaisesRegex(TypeError, "values: must be arrays by name, such as {'area': array}, not "):
                self.surface.save("x.ply", values=values)


if __name__ == "__main__":
    unittest.main()

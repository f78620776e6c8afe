#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the built program: what `surface` writes on disk, and what is in it.

usage: outputs_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import csv
import json
import random
import shutil
import subprocess
import sys
import unittest

import mesh_files
import schema
from program_case import PROGRAM, SHELL, SOURCE, UBIQUITIN, ProgramTest, glycine


class Outputs(ProgramTest):
    def test_without_o_the_mesh_goes_to_the_current_folder(self):
        (self.folder / "sub").mkdir()
        shutil.move(self.folder / "three.xyzr", self.folder / "sub" / "three.xyzr")
        self.surface("sub/three.xyzr")
        self.assertEqual(self.files(), ["sub/three.xyzr", "three.atoms.csv", "three.html", "three.ply"])

    def test_every_format_can_be_written(self):
        names = ["a.glb", "a.obj", "a.off", "a.ply", "a.stl", "a.vert", "a.vtp", "a.npz", "b.xyzr", "b.xyzrn"]
        self.surface("three.xyzr", *[word for name in names for word in ("-o", name)])
        self.assertEqual(self.files(), sorted([*names, "a.atoms.csv", "a.face", "three.xyzr"]))
        for name in [*names, "a.face"]:
            self.assertGreater((self.folder / name).stat().st_size, 0, name)

    def test_a_pair_of_msms_is_told_whole_and_nothing_else_goes_to_its_second_file(self):
        self.assertIn("written     a.vert, a.face, a.atoms.csv", self.surface("three.xyzr", "-o", "a.vert").stdout)
        error = self.surface("three.xyzr", "-o", "b.vert", "--report", "b.face", code=2).stderr
        self.assertIn("b.face: two outputs go to this file", error)

    def test_a_picture_alone(self):
        self.surface("three.xyzr", "-o", "a.png", "--size", "64x48")
        self.assertEqual(self.files(), ["a.png", "three.xyzr"])
        content = (self.folder / "a.png").read_bytes()
        self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual((int.from_bytes(content[16:20], "big"), int.from_bytes(content[20:24], "big")), (64, 48))

    def test_a_picture_cut_open_with_a_legend(self):
        (self.folder / "shell.xyzr").write_text(SHELL)
        report = self.report("shell.xyzr", "-o", "a.png", "--size", "320x240", "--cut", "auto", "--legend", "--color",
                             "component")
        self.assertEqual((report["options"]["cut"], report["options"]["legend"]), ("auto", True))
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        self.assertEqual(schema.problems(report, rules), [])
        content = (self.folder / "a.png").read_bytes()
        self.assertEqual((int.from_bytes(content[16:20], "big"), int.from_bytes(content[20:24], "big")), (320, 240))

    def ligand_beside_glycine(self):
        """Ethanal, glycerol (which crystals are grown from), a zinc ion and a water."""
        atom = "HETATM{:5}  {:<3} {:>3} A{:4}    {:8.3f}{:8.3f}{:8.3f}  1.00 10.00          {:>2}\n"
        rows = [("C1", "LIG", 2, 1.0, 0, 4.0, "C"), ("C2", "LIG", 2, 2.5, 0, 4.0, "C"), ("O1", "LIG", 2, 3.1, 1.0, 4.0, "O"),
                ("C1", "GOL", 3, 1.0, 0, -4.0, "C"), ("O1", "GOL", 3, 2.4, 0, -4.0, "O"), ("ZN", "ZN", 4, -4, 0, 0, "ZN"),
                ("O", "HOH", 5, 6.5, 0, 0, "O")]
        (self.folder / "gly.pdb").write_text(
            glycine() + "".join(atom.format(i + 10, *row) for i, row in enumerate(rows)), encoding="ascii")

    def test_ligands_are_drawn_beside_the_surface(self):
        self.ligand_beside_glycine()
        names = ("a.png", "a.glb", "a.html", "a.ply", "a.obj")
        content = {}
        for how in ("ligands", "none"):
            report = self.report("gly.pdb", "--size", "64x48", "--draw", how, *[w for n in names for w in ("-o", n)])
            self.assertEqual(report["drawn"], {"LIG": 1} if how == "ligands" else {})
            content[how] = [(self.folder / name).read_bytes() for name in names]
        for name, with_ligands, without in zip(names, *content.values()):
            self.assertEqual(with_ligands != without, name in ("a.png", "a.glb", "a.html"), name)
        glb = content["ligands"][1]
        nodes = json.loads(glb[20:20 + int.from_bytes(glb[12:16], "little")])["nodes"]
        self.assertEqual([node["name"] for node in nodes], ["surface", "ligands"])

    def test_ligands_of_the_surface_are_seen_in_pages_alone(self):
        self.ligand_beside_glycine()
        for output, drawn in (("a.png", {}), ("a.html", {"LIG": 1})):
            self.assertEqual(self.report("gly.pdb", "--hetero", "ligands", "-o", output)["drawn"], drawn)

    def test_draw_needs_something_to_draw_in(self):
        self.assertIn("--draw applies to pictures, pages and GLB", self.refused("three.xyzr", "-o", "a.ply", "--draw", "none"))

    def test_a_page_alone(self):
        report = self.report("three.xyzr", "-o", "a.html", "--view", "top", "--perspective", "--color", "patch")
        self.assertEqual(self.files(), ["a.html", "three.xyzr"])
        self.assertGreater(report["time_s"]["page"], 0)
        page = (self.folder / "a.html").read_text(encoding="utf-8")
        self.assertIn(f"{report['exact']['ses_area']:.1f} Å²", page)
        self.assertTrue(page.rstrip().endswith("</html>"))

    def test_a_page_of_a_surface_that_is_not_there(self):
        self.surface("three.xyzr", "-o", "a.html", "--components", "cavities")
        self.assertIn("</html>", (self.folder / "a.html").read_text(encoding="utf-8"))

    def test_colours_are_told_and_in_the_mesh(self):
        (self.folder / "gly.pdb").write_text(glycine())
        for scheme in ("patch element chain residue residue-patch hydrophobicity curvature component depth bfactor "
                       "plddt curvature:-1:1 depth:0:3 bfactor:0:50").split():
            report = self.report("gly.pdb", "-o", "a.ply", "-o", "a.png", "--size", "40x30", "--color", scheme)
            self.assertEqual(report["options"]["color"], scheme.split(":")[0])
            self.assertEqual(report["options"]["size"], [40, 30])
        header = (self.folder / "a.ply").read_bytes().split(b"end_header")[0].decode("ascii")
        self.assertRegex(header, r"uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n")

    def test_the_history_has_a_row_per_step(self):
        report = self.report("three.xyzr", "-o", "a.ply", "--history", "a.csv")
        with (self.folder / "a.csv").open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), report["flow"]["steps"] + 1)
        self.assertEqual([row["step"] for row in rows], [str(step) for step in range(len(rows))])
        self.assertEqual(report["flow"]["history"][-1]["mean_distance"], float(rows[-1]["mean_distance"]))
        self.surface("three.xyzr", "-o", "a.ply", "--history", "a.json")
        self.assertEqual(len(json.loads((self.folder / "a.json").read_text())), len(rows))

    def test_snapshots_lie_beside_the_final_mesh(self):
        report = self.report("three.xyzr", "-o", "a.ply", "--snapshots", "2", "--time-step", "1")
        steps = report["flow"]["steps"]
        expected = [f"a_step{step:03}.ply" for step in range(0, steps + 1, 2)]
        self.assertEqual(self.files(), sorted(["a.atoms.csv", "a.ply", "three.xyzr", *expected]))

    def test_a_flow_that_diverges_is_exit_6_with_its_reason_and_its_best_state(self):
        result = self.surface("three.xyzr", "-o", "a.ply", "--flow", "paper", "--report", "a.json", code=6)
        self.assertRegex(result.stderr, r"nearest to the exact surface after step \d+")
        report = json.loads((self.folder / "a.json").read_text())
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        self.assertEqual(schema.problems(report, rules), [])
        self.assertFalse(report["flow"]["converged"])
        best = min(step["mean_distance"] for step in report["flow"]["history"][1:] if step["mean_distance"] is not None)
        self.assertAlmostEqual(report["mesh"]["mean_distance"], best)

    def test_the_steady_state_in_one_solve(self):
        once = self.report("three.xyzr", "-o", "a.ply", "--max-steps", "1", "--time-step", "inf")
        steps = self.report("three.xyzr", "-o", "b.ply")
        self.assertEqual((once["flow"]["steps"], once["options"]["time_step"]), (1, "inf"))
        self.assertTrue(once["flow"]["converged"])
        self.assertAlmostEqual(once["mesh"]["volume"], steps["mesh"]["volume"], places=3)

    def test_components_are_chosen(self):
        everything = self.report("three.xyzr", "-o", "a.ply")
        outer = self.report("three.xyzr", "-o", "a.ply", "--components", "outer")
        self.assertEqual(outer["mesh"]["area"], everything["mesh"]["area"])
        none = self.report("three.xyzr", "-o", "a.ply", "--components", "cavities")
        self.assertEqual(none["mesh"]["vertices"], 0)

    def test_small_cavities_are_dropped_on_request(self):
        (self.folder / "shell.xyzr").write_text(SHELL)
        volume = [c["ses_volume"] for c in self.report("shell.xyzr")["components"] if c["kind"] == "cavity"]
        self.assertEqual(len(volume), 1)
        for options in ([], ["--edge", "1"], ["--method", "direct"]):
            for factor, pieces in ((0.8, 2), (1.2, 1)):
                report = self.report("shell.xyzr", "--min-cavity", factor * volume[0], *options)
                self.assertEqual(report["mesh"]["components"], pieces)
                self.assertEqual(report["mesh"]["dropped"], {"cavities": 2 - pieces, "islands": 0})
                self.assertEqual(report["options"]["min_cavity"], factor * volume[0])
                self.assertLess(abs(report["mesh"]["volume_deviation"]), 0.02)
        dropped = self.report("shell.xyzr", "--components", "cavities", "--min-cavity", 1.2 * volume[0])
        self.assertEqual(dropped["mesh"]["vertices"], 0)

    def test_meshes_that_pass_through_themselves_are_exit_6_on_request(self):
        # A grid far too coarse for the creases between atoms, and one of few clusters that cannot be untangled.
        place = random.Random(262).uniform
        (self.folder / "cluster.xyzr").write_text("".join(
            f"{place(0, 18):.3f} {place(0, 18):.3f} {place(0, 18):.3f} {place(0.8, 2.2):.2f}\n" for _ in range(300)))
        coarse = ("cluster.xyzr", "--method", "direct", "--probe", "0", "--spacing", "2.5", "--report", "a.json")
        self.surface(*coarse)
        self.assertIsNone(json.loads((self.folder / "a.json").read_text())["mesh"]["quality"]["self_intersections"])
        result = self.surface(*coarse, "--verify", code=6)
        self.assertIn("no_self_intersections", result.stderr)
        report = json.loads((self.folder / "a.json").read_text())
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        self.assertEqual(schema.problems(report, rules), [])
        failed = [check for check in report["checks"] if not check["passed"]]
        self.assertEqual([check["name"] for check in failed], ["no_self_intersections"])
        self.assertEqual(failed[0]["value"], report["mesh"]["quality"]["self_intersections"])
        self.assertGreater(failed[0]["value"], 0)

    def test_text_on_demand(self):
        self.surface("three.xyzr", "-o", "a.ply", "-o", "a.stl", "--ascii")
        self.assertIn("format ascii 1.0", (self.folder / "a.ply").read_text(encoding="ascii"))
        self.assertTrue((self.folder / "a.stl").read_text(encoding="ascii").startswith("solid"))

    def test_vertices_know_their_atom_and_residue(self):
        (self.folder / "gly.pdb").write_text(glycine())
        self.surface("gly.pdb", "-o", "a.ply")
        header = (self.folder / "a.ply").read_bytes().split(b"end_header")[0].decode("ascii")
        for name in ("x", "y", "z", "nx", "ny", "nz", "atom", "residue", "patch", "component"):
            self.assertRegex(header, rf"property \w+ {name}\n")

    def test_the_atom_table_has_one_row_per_kept_atom(self):
        self.surface("three.xyzr")
        with open(self.folder / "three.atoms.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([float(row["radius"]) for row in rows], [1.7, 1.52, 1.8])

    def test_outputs_that_cannot_be_written_are_exit_4(self):
        result = self.run_program("surface", "three.xyzr", "--quiet", "--report", "/dev/full")
        self.assertEqual(result.returncode, 4, result.stderr)

    def test_standard_output_that_cannot_be_written_is_exit_4(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            result = subprocess.run([PROGRAM, "surface", "three.xyzr"], cwd=self.folder, stdout=full,
                                    stderr=subprocess.PIPE, check=False)
        self.assertEqual(result.returncode, 4)

    def test_same_bits_for_any_number_of_threads(self):
        for threads in ("1", "2"):
            self.surface(UBIQUITIN, "--threads", threads, "--spacing", "1", "-o", f"t{threads}.ply", "--quiet")
        self.assertEqual((self.folder / "t1.ply").read_bytes(), (self.folder / "t2.ply").read_bytes())


class Rereading(ProgramTest):
    """What a file holds is the mesh that was made, whatever the format rounds."""

    def expect_same_surface(self, vertices, triangles, mesh, what):
        self.assertEqual(len(vertices), mesh["vertices"], what)
        self.assertEqual(len(triangles), mesh["triangles"], what)
        self.assertTrue(mesh_files.is_closed_and_oriented(triangles), what)
        self.assertTrue(mesh_files.has_single_fans(triangles), what)
        self.assertEqual(mesh_files.euler_characteristic(vertices, triangles), mesh["euler_characteristic"], what)
        self.assertEqual(mesh_files.piece_count(vertices, triangles), mesh["components"], what)

    def test_what_is_wrong_with_a_surface_is_found(self):
        solid = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
        self.assertTrue(mesh_files.is_closed_and_oriented(solid) and mesh_files.has_single_fans(solid))
        for wrong in (solid[1:], [(0, 1, 2), *solid[1:]], [*solid, solid[0]], [(0, 0, 1), *solid]):
            self.assertFalse(mesh_files.is_closed_and_oriented(wrong), wrong)
        touching = solid + [tuple(v and v + 3 for v in t) for t in solid]
        self.assertTrue(mesh_files.is_closed_and_oriented(touching))
        self.assertFalse(mesh_files.has_single_fans(touching))
        self.assertEqual(mesh_files.piece_count(range(8), solid + [tuple(v + 4 for v in t) for t in solid]), 2)

    def written(self, *options):
        """The report's mesh, and vertices and triangles by format."""
        outputs = [word for suffix in mesh_files.READERS for word in ("-o", f"a.{suffix}")]
        mesh = self.report(UBIQUITIN, *options, *outputs)["mesh"]
        return mesh, {suffix: read(self.folder / f"a.{suffix}") for suffix, read in mesh_files.READERS.items()}

    def test_every_format_of_the_mesh_of_the_grid(self):
        for options in ([], ["--method", "direct"]):
            mesh, files = self.written(*options)
            for suffix, (vertices, triangles) in files.items():
                self.expect_same_surface(vertices, triangles, mesh, (suffix, options))
                self.expect_same_surface(*mesh_files.merged(vertices, triangles), mesh, (suffix, options, "merged"))

    def test_every_format_of_even_triangles_and_three_decimals(self):
        for options in (["--edge", "1"], ["--edge", "0.6"], ["--edge", "2"], ["--edge", "2", "--simplify-topology"],
                        ["--edge", "1", "--method", "direct"]):
            mesh, files = self.written(*options)
            self.assertGreater(mesh["quality"]["edges"]["min"], 0.02)
            for suffix, (vertices, triangles) in files.items():
                self.expect_same_surface(vertices, triangles, mesh, (suffix, options))
                self.expect_same_surface(*mesh_files.merged(vertices, triangles, 3), mesh, (suffix, options, "rounded"))

if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

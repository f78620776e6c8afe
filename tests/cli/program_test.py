#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the built program: exit codes, messages, what lands on standard output and on disk.

usage: program_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import csv
import hashlib
import json
import math
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
import zipfile

import mesh_files
import schema

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
UBIQUITIN = SOURCE / "examples" / "1ubq.pdb"

# Two overlapping spheres and a third apart: quick, with two components.
SPHERES = "0 0 0 1.7\n1.2 0 0 1.52\n20 0 0 1.8\n"

# Ninety atoms on a sphere of 6.5 Å: an outer surface and a cavity.
SHELL = "".join(f"{6.5 * math.sqrt(1 - z * z) * math.cos(a):.4f} {6.5 * math.sqrt(1 - z * z) * math.sin(a):.4f} "
                f"{6.5 * z:.4f} 1.7\n"
                for z, a in ((1 - (2 * i + 1) / 90, 2.399963229728653 * i) for i in range(90)))

ATOM = "ATOM  {serial:5}  {name:<3} GLY A{residue:4}    {x:8.3f}{y:8.3f}{z:8.3f}  1.00 10.00           {element}\n"


def glycine(shift=0.0):
    """The heavy atoms of one glycine, as PDB lines."""
    atoms = [("N", 0.0, 0.0, 0.0, "N"), ("CA", 1.458, 0.0, 0.0, "C"), ("C", 2.009, 1.420, 0.0, "C"),
             ("O", 1.251, 2.390, 0.0, "O")]
    return "".join(ATOM.format(serial=i + 1, name=name, residue=1, x=x + shift, y=y, z=z, element=element)
                   for i, (name, x, y, z, element) in enumerate(atoms))


class ProgramTest(unittest.TestCase):
    """Every test runs in an empty folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "three.xyzr").write_text(SPHERES)

    def run_program(self, *arguments, text=None):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, input=text, capture_output=True,
                              encoding="utf-8", timeout=120, check=False)

    def surface(self, *arguments, code=0, text=None):
        """Runs `surface`, coarse unless --spacing is given, and expects an exit code."""
        if "--spacing" not in arguments:
            arguments += ("--spacing", "0.5")
        result = self.run_program("surface", *arguments, text=text)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def refused(self, *arguments, code=2, text=None):
        """Expects one line on standard error, nothing on standard output and no new file; returns the line."""
        before = self.files()
        result = self.surface(*arguments, code=code, text=text)
        self.assertEqual(result.stdout, "")
        remarks = ("meniscus: note: ", "meniscus: warning: ")
        errors = [line for line in result.stderr.splitlines() if not line.startswith(remarks)]
        self.assertEqual(len(errors), 1, result.stderr)
        self.assertTrue(errors[0].startswith("meniscus: error: "), errors[0])
        self.assertEqual(self.files(), before)
        return errors[0]

    def files(self):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*") if p.is_file())

    def report(self, *arguments, **keywords):
        return json.loads(self.surface(*arguments, "--report", "-", **keywords).stdout)


class Help(ProgramTest):
    def test_version_and_help_go_to_standard_output(self):
        for arguments in (["--version"], ["--help"], ["--help-all"], ["surface", "--help"], ["measure", "--help"]):
            result = self.run_program(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)
            self.assertTrue(result.stdout, arguments)
        self.assertRegex(self.run_program("--version").stdout, r"^meniscus \d+\.\d+\.\d+\n$")

    def test_help_fits_a_screen_and_ends_with_examples(self):
        for arguments in ([], ["surface"], ["measure"], ["compare"], ["batch", "surface"], ["batch", "measure"]):
            lines = self.run_program(*arguments, "--help").stdout.splitlines()
            self.assertLessEqual(len(lines), 50, arguments)
            self.assertEqual([line for line in lines if len(line) > 80], [], arguments)
            self.assertIn("Examples:", lines)
        for line in self.run_program("--help-all").stdout.splitlines():
            self.assertLessEqual(len(line), 80, line)

    def test_every_option_is_in_the_full_help(self):
        text = self.run_program("surface", "--help-all").stdout
        for option in ("--probe --radii --hydrogens --model --assembly --altloc --chains --select --hetero --waters "
                       "--strict-radii --report --threads --quiet --progress --method --flow --spacing --density "
                       "--curvature --anchor --reinitialise --solver --slope --time-step --half-width --max-steps "
                       "--tolerance --history --snapshots --components --min-cavity --edge --vertex-density --adaptive "
                       "--keep-ridges --corners --simplify-topology --verify -o --memory --ascii --color --view --size "
                       "--background --depth-cue --perspective --outline").split():
            self.assertIn(f"  {option} ", text)
        text = self.run_program("measure", "--help-all").stdout
        for option in ("--probe --radii --hydrogens --model --assembly --altloc --chains --select --hetero --waters "
                       "--strict-radii --report --threads --quiet --progress -o --between --per --value").split():
            self.assertIn(f"  {option} ", text)


class Usage(ProgramTest):
    def test_wrong_command_lines_are_refused_in_one_line(self):
        for arguments in ([], ["surfac"], ["surface"], ["surface", "--bogus", "three.xyzr"], ["--bogus"],
                          ["surface", "three.xyzr", "three.xyzr"], ["surface", "three.xyzr", "--threads"]):
            result = self.run_program(*arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
            self.assertRegex(result.stderr, r"\Ameniscus: error: [^\n]+\n\Z")

    def test_numbers_that_make_no_sense_are_refused(self):
        for option in ("--spacing", "--probe", "--density", "--time-step", "--max-steps", "--threads", "--memory",
                       "--model", "--min-cavity"):
            for value in ("abc", "", "nan", "inf", "-inf", "1e999", "1.4x"):
                if (option, value) != ("--time-step", "inf"):
                    self.assertIn(option, self.refused("three.xyzr", option, value))
        for option, value in (("--spacing", "0"), ("--spacing", "-1"), ("--probe", "-1"), ("--density", "0"),
                              ("--density", "1"), ("--time-step", "0"), ("--max-steps", "0"), ("--threads", "0"),
                              ("--threads", "1.5"), ("--memory", "0"), ("--model", "0"), ("--model", "-1"),
                              ("--min-cavity", "-1")):
            self.assertIn(option, self.refused("three.xyzr", option, value))

    def test_records_of_a_flow_need_a_flow(self):
        self.assertIn("--method flow", self.refused("three.xyzr", "--method", "direct", "--history", "a.csv"))
        self.assertIn("--history", self.refused("three.xyzr", "--history", "a.txt"))
        self.assertIn("--snapshots", self.refused("three.xyzr", "--snapshots", "1", "-o", "a.xyzr"))
        self.assertIn("time step", self.refused("three.xyzr", "--flow", "paper", "--time-step", "inf"))
        self.refused("three.xyzr", "--half-width", "100")

    def test_what_no_output_heeds_is_refused(self):
        self.assertIn("--show", self.refused("three.xyzr", "--show", "//A", "-o", "a.dx"))
        self.assertIn("--ascii", self.refused("three.xyzr", "--ascii", "-o", "a.glb"))
        self.assertEqual(self.run_program("surface", "three.xyzr", "--ascii", "-o", "a.glb", "-o", "a.stl").returncode, 0)

    def test_unknown_words_are_refused_with_those_that_exist(self):
        self.assertIn("flow, direct, gaussian", self.refused("three.xyzr", "--method", "fast"))
        self.assertIn("anchored", self.refused("three.xyzr", "--flow", "sideways"))
        self.assertIn("ligands", self.refused("three.xyzr", "--hetero", "haem"))
        self.assertIn("json", self.refused("three.xyzr", "--progress", "loud"))
        self.refused("three.xyzr", "--radii", "nosuchset")

    def test_pictures_that_make_no_sense_are_refused(self):
        for option, value in (("--color", "fancy"), ("--color", "residue:0:1"), ("--color", "depth:2:1"),
                              ("--size", "100"), ("--size", "0x9"), ("--view", "sideways"), ("--view", "0,0,0"),
                              ("--background", "#12"), ("--depth-cue", "2"), ("--cut", "middle")):
            self.assertIn(option, self.refused("three.xyzr", "-o", "a.png", option, value))
        for option in ("--outline", "--legend"):
            self.assertIn("-o FILE.png", self.refused("three.xyzr", option))
        self.assertIn("--legend", self.refused("three.xyzr", "-o", "a.png", "--legend", "--size", "64x48"))
        self.assertIn("cavity 1", self.refused("three.xyzr", "-o", "a.png", "--cut", "cavity:1"))
        self.assertIn("-o FILE.png", self.refused("three.xyzr", "-o", "a.html", "--size", "9x9"))
        self.assertIn("FILE.html", self.refused("three.xyzr", "-o", "a.ply", "--view", "top"))

    def test_outputs_are_checked_before_anything_is_read(self):
        missing = "missing.pdb"
        self.assertIn(".ply", self.refused(missing, "-o", "a.foo"))
        self.refused(missing, "-o", "noextension")
        self.refused(missing, "-o", "a.ply", "-o", "./a.ply")
        self.refused(missing, "-o", "a.ply", "--report", "a.ply")
        self.refused(missing, "-o", "nofolder/a.ply", code=4)
        self.refused(missing, "--report", "nofolder/a.json", code=4)
        (self.folder / "folder.ply").mkdir()
        self.refused(missing, "-o", "folder.ply", code=4)
        self.refused("three.xyzr", "-o", "three.xyzr")


class Input(ProgramTest):
    def test_files_that_cannot_be_read_are_exit_3(self):
        self.assertIn("missing.pdb", self.refused("missing.pdb", code=3))
        (self.folder / "empty.pdb").write_text("")
        self.refused("empty.pdb", code=3)
        (self.folder / "bad.pdb").write_text(glycine().replace("   1.458", "   1.4x8"))
        self.assertRegex(self.refused("bad.pdb", code=3), r"bad\.pdb:2:\d+: ")

    def test_standard_input_is_told_by_content(self):
        self.assertEqual(self.report("-", text=SPHERES)["input"]["atoms"], 3)
        self.assertEqual(self.report("-", text=glycine())["input"]["atoms"], 4)
        self.refused("-", text="", code=3)

    def test_all_models_are_structures_of_their_own(self):
        models = "".join(f"MODEL     {n:4}\n{glycine(shift=n)}ENDMDL\n" for n in (1, 2))
        (self.folder / "nmr.pdb").write_text(models + "END\n")
        reports = self.report("nmr.pdb", "--model", "all", "-o", "out.ply")
        self.assertEqual([r["input"]["model"] for r in reports], [1, 2])
        self.assertEqual(self.files(), ["nmr.pdb", "out_m01.atoms.csv", "out_m01.ply", "out_m02.atoms.csv",
                                        "out_m02.ply", "three.xyzr"])
        self.surface("nmr.pdb", "--model", "all")
        self.assertTrue({"nmr_m01.ply", "nmr_m01.html", "nmr_m02.ply", "nmr_m02.html", "nmr_m02.atoms.csv"} <= set(self.files()), self.files())
        self.assertEqual(self.report("nmr.pdb", "--model", "2")["input"]["model"], 2)
        self.refused("nmr.pdb", "--model", "3", code=3)


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


class Streams(ProgramTest):
    def test_the_summary_is_short_and_alone_on_standard_output(self):
        result = self.surface("three.xyzr")
        self.assertEqual(result.stderr, "")
        self.assertLess(len(result.stdout.splitlines()), 12)
        self.assertIn("Å²", result.stdout)

    def test_the_first_number_is_the_exact_one(self):
        printed = self.surface(UBIQUITIN, "--spacing", "1", "-o", "a.ply").stdout.splitlines()
        self.assertRegex(printed[1], r"^  area +3892\.2387 ± \d\.\de-\d+ Å² exact; mesh [0-9.]+ Å², flat triangles [0-9.]+ Å²$")
        self.assertRegex(printed[2], r"^  volume +10056\.3033 ± \d\.\de-\d+ Å³ exact; mesh [0-9.]+ Å³, flat triangles [0-9.]+ Å³$")
        measured = self.run_program("measure", UBIQUITIN).stdout
        for line, name in ((printed[1], "SES area"), (printed[2], "SES volume")):
            value = re.search(r"[0-9.]+ ± \S+", line).group()
            self.assertRegex(measured, rf"\n  {name} +{re.escape(value)} ")

    def test_without_exact_numbers_there_are_those_of_the_mesh(self):
        exact = self.report(UBIQUITIN, "--spacing", "1", "-o", "a.ply", "-o", "a.html")
        result = self.surface(UBIQUITIN, "--spacing", "1", "-o", "b.ply", "-o", "b.html", "--no-exact", "--report", "b.json")
        self.assertRegex(result.stdout, r"\n  area +[0-9.]+ Å² \(flat triangles [0-9.]+ Å²\)\n  volume +[0-9.]+ Å³ \(flat")
        self.assertNotIn("±", result.stdout)
        self.assertEqual((self.folder / "a.ply").read_bytes(), (self.folder / "b.ply").read_bytes())
        report = json.loads((self.folder / "b.json").read_text())
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        self.assertEqual(schema.problems(report, rules), [])
        self.assertEqual((report["exact"], report["components"]), (None, None))
        self.assertIsNone(report["mesh"]["area_deviation"])
        self.assertEqual((report["options"]["exact"], exact["options"]["exact"]), (False, True))
        self.assertEqual(report["mesh"]["area"], exact["mesh"]["area"])
        self.assertLess(report["expected"]["cpu_s"], exact["expected"]["cpu_s"])
        page = (self.folder / "b.html").read_text(encoding="utf-8")
        self.assertIn("surface, exact", (self.folder / "a.html").read_text(encoding="utf-8"))
        self.assertNotIn("surface, exact", page)
        self.assertTrue(page.rstrip().endswith("</html>"))

    def test_exact_numbers_cannot_be_checked_and_left_out(self):
        error = self.surface("three.xyzr", "--no-exact", "--verify", code=2).stderr
        self.assertEqual(error, "meniscus: error: --verify checks the exact numbers, which --no-exact leaves out; "
                                "give one of them\n")

    def test_numbers_of_pieces_that_differ_are_explained(self):
        antibody = SOURCE / "examples" / "1a0q.pdb"
        printed = self.surface(antibody, "-o", "a.ply").stdout
        self.assertRegex(printed, r"\n  components  8 \(1 outer, 7 cavities\) exact; mesh 8 \(2 outer, 6 cavities\)\n"
                                  r"              .*smaller than the spacing.*\n  left out ")
        outer = self.surface(antibody, "-o", "a.ply", "--components", "outer").stdout
        self.assertRegex(outer, r"\n  area +17411\.7340 ± \S+ +Å² exact, of all pieces; mesh of outer pieces ")
        self.assertRegex(outer, r"\n  components  8 \(1 outer, 7 cavities\) exact; mesh 2 \(2 outer, 0 cavities\)\n"
                                r"              .*smaller than the spacing.*\n")
        self.assertRegex(self.surface(antibody, "-o", "a.ply", "--no-exact").stdout,
                         r"\n  components  8 \(2 outer, 6 cavities\)\n  left out ")
        (self.folder / "shell.xyzr").write_text(SHELL)
        self.assertRegex(self.surface("shell.xyzr", "-o", "a.ply", "--components", "outer").stdout,
                         r"\n  components  2 \(1 outer, 1 cavity\) exact; mesh 1 \(1 outer, 0 cavities\)\n"
                         r"              the mesh leaves out .*\n")

    def test_every_chain_and_model_has_its_exact_numbers(self):
        for options in (["--per-chain"], ["--model", "all"]):
            printed = self.surface(SOURCE / "examples" / "1a0q.pdb", "--spacing", "1", *options, "-o", "a.ply").stdout
            numbers = re.findall(r"\n  area +([0-9.]+) ± ", printed)
            self.assertEqual(len(numbers), 2 if options == ["--per-chain"] else 1, printed)
            self.assertEqual(len(set(numbers)), len(numbers))

    def test_quiet_is_silent(self):
        result = self.surface("three.xyzr", "--quiet", "--report", "r.json")
        self.assertEqual((result.stdout, result.stderr), ("", ""))
        self.assertEqual(json.loads((self.folder / "r.json").read_text())["schema"], 1)

    def test_progress_is_silent_in_a_pipe_and_json_on_demand(self):
        self.assertEqual(self.surface("three.xyzr", "--progress", "off").stderr, "")
        lines = self.surface("three.xyzr", "--progress", "json").stderr.splitlines()
        updates = [json.loads(line) for line in lines]
        self.assertTrue(all(0.0 <= u["fraction"] <= 1.0 for u in updates))
        self.assertTrue({"read", "mesh", "write"} <= {u["stage"] for u in updates}, updates)
        self.assertIn("\033[K", self.surface("three.xyzr", "--progress", "on").stderr)

    def test_what_happens_with_every_file_is_a_note_that_quiet_silences(self):
        note = "58 waters left out (keep them with --waters)"
        self.assertEqual(self.surface(UBIQUITIN, "--spacing", "1", "--report", "r.json").stderr,
                         f"meniscus: note: {UBIQUITIN}: {note}\n")
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual((report["input"]["notes"], report["input"]["warnings"]), ([note], []))
        self.assertEqual(report["input"]["dropped"], {"waters": 58})
        self.assertEqual(self.surface(UBIQUITIN, "--spacing", "1", "--quiet").stderr, "")

    def test_what_may_make_a_number_wrong_is_a_warning_that_quiet_does_not_silence(self):
        (self.folder / "twice.xyzr").write_text("0 0 0 1.7\n0 0 0 1.7\n")
        for more in ([], ["--quiet"]):
            self.assertEqual(self.surface("twice.xyzr", *more).stderr,
                             "meniscus: warning: twice.xyzr: 1 atom at exactly the position of another atom\n")

    def test_notes_of_all_models_are_told_once(self):
        model = ("ATOM      1  CA  GLY A   1       0.000   0.000   0.000  1.00  0.00           C\n"
                 "HETATM    2  O   HOH A   2       9.000   0.000   0.000  1.00  0.00           O\n")
        (self.folder / "two.pdb").write_text(f"MODEL 1\n{model}ENDMDL\nMODEL 2\n{model}ENDMDL\n")
        self.assertEqual(self.surface("two.pdb", "--model", "all").stderr,
                         "meniscus: note: two.pdb: 1 water left out (keep it with --waters)\n")
        self.assertIn("meniscus: note: two.pdb: model 1 of 2 taken (choose another with --model N|all)\n",
                      self.surface("two.pdb").stderr)


class Report(ProgramTest):
    def test_reports_follow_the_schema(self):
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        for method in ("flow", "direct", "gaussian"):
            report = self.report("three.xyzr", "--method", method)
            self.assertEqual(schema.problems(report, rules), [], method)
        self.assertEqual(schema.problems(self.report("three.xyzr", "--model", "all"), rules), [])
        self.assertNotEqual(schema.problems({"schema": 1}, rules), [])

    def test_standard_output_by_its_path_has_the_report_alone(self):
        report = json.loads(self.surface("three.xyzr", "-o", "a.ply", "--report", "/dev/stdout").stdout)
        self.assertEqual(report["input"]["atoms"], 3)

    def test_numbers_of_a_mesh_with_two_components(self):
        report = self.report("three.xyzr", "--spacing", "0.25")
        mesh = report["mesh"]
        self.assertTrue(mesh["closed"] and mesh["manifold"])
        self.assertEqual(mesh["components"], 2)
        self.assertEqual(mesh["euler_characteristic"], 4)
        self.assertTrue(report["flow"]["converged"])
        self.assertAlmostEqual(mesh["corrected_area"], report["exact"]["ses_area"], delta=1.0)
        self.assertEqual([c["kind"] for c in report["components"]], ["outer", "outer"])
        # The sphere of 1.8 Å, and the closed form for the two that overlap.
        self.assertAlmostEqual(mesh["corrected_area"], 40.715 + 45.1, delta=1.0)

    def test_dropped_atoms_and_options_are_recorded(self):
        report = self.report(UBIQUITIN, "--spacing", "1", "--threads", "1", "--chains", "A")
        self.assertEqual(report["input"]["atoms"], 602)
        self.assertEqual(sum(report["input"]["dropped"].values()), 58)
        self.assertEqual(len(report["input"]["sha256"]), 64)
        self.assertEqual(report["options"]["threads"], 1)
        self.assertEqual(report["options"]["chains"], ["A"])

    def test_npz_knows_its_input_with_and_without_a_report(self):
        fingerprint = hashlib.sha256(UBIQUITIN.read_bytes()).hexdigest()
        for report in ([], ["--report", "r.json"]):
            self.surface(UBIQUITIN, "--spacing", "1", "-o", "a.npz", *report)
            with zipfile.ZipFile(self.folder / "a.npz") as archive:
                self.assertIn(fingerprint.encode("utf-32-le"), archive.read("options.npy"))
        self.assertEqual(json.loads((self.folder / "r.json").read_text())["input"]["sha256"], fingerprint)

    def test_peak_memory_is_not_that_of_the_caller(self):
        ours = bytearray(b"x") * (400 << 20)
        peak = self.report("three.xyzr")["peak_memory_mb"]
        self.assertEqual(ours[-1], ord("x"))
        self.assertGreater(peak, 1)
        self.assertLess(peak, 200)


class Limits(ProgramTest):
    def test_what_does_not_fit_is_refused_with_the_option_to_change(self):
        refusal = self.refused(UBIQUITIN, "--spacing", "0.05", "--memory", "50M", code=5)
        self.assertRegex(refusal, r"needs about [0-9.]+ [MG]B .* 50 MB are allowed; choose --spacing 0\.\d+ or more")

    def test_what_it_will_take_is_told_before_and_in_the_report(self):
        report = self.report(UBIQUITIN)
        self.assertAlmostEqual(report["expected"]["vertices"], report["mesh"]["vertices"],
                               delta=0.25 * report["mesh"]["vertices"])
        lines = self.surface(UBIQUITIN, "--progress", "json").stderr.splitlines()
        self.assertTrue(any("expected_s" in line for line in lines))

    def check_signal(self, number):
        """Sends a signal while the surface is computed."""
        with subprocess.Popen([PROGRAM, "surface", UBIQUITIN, "--spacing", "0.1", "--progress", "json"],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            for line in process.stderr:
                if b'"stage"' in line and b'"read"' not in line:
                    break
            process.send_signal(number)
            process.stdout.read(), process.stderr.read()
            self.assertEqual(process.wait(timeout=60), 128 + number)
        self.assertEqual(self.files(), ["three.xyzr"])

    def test_signals_end_the_program_and_leave_nothing(self):
        self.check_signal(signal.SIGINT)
        self.check_signal(signal.SIGTERM)

    def test_signals_end_a_program_that_waits_for_input(self):
        with subprocess.Popen([PROGRAM, "surface", "-", "--progress", "json"], cwd=self.folder, stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            process.stderr.readline()
            process.send_signal(signal.SIGTERM)
            self.assertEqual(process.wait(timeout=60), 143)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

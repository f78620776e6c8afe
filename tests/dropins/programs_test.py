#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""meniscus-msms, meniscus-nanoshaper and pdb_to_xyzr(n), called and read as their callers do.

usage: programs_test.py FOLDER-OF-PROGRAMS MENISCUS SOURCE [unittest arguments]
"""
import itertools
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import callers

PROGRAMS = pathlib.Path(sys.argv[1]).resolve()
MENISCUS = pathlib.Path(sys.argv[2]).resolve()
UBIQUITIN = pathlib.Path(sys.argv[3]).resolve() / "examples" / "1ubq.pdb"

# A hollow cube: an outer piece and a cavity. With names such as MaSIF's, which are to come back untouched.
CUBE = [(2.4 * x, 2.4 * y, 2.4 * z) for x, y, z in itertools.product(range(5), repeat=3)
        if {0, 4} & {x, y, z}]
NAMES = [f"A_{i}_x_ALA_CB_Green" for i in range(len(CUBE))]
LINING = CUBE.index((4.8, 4.8, 0.0))  # in the middle of a face
CORNER = CUBE.index((0.0, 0.0, 0.0))


class ProgramTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "cube.xyzr").write_text("".join(f"{x} {y} {z} 1.7\n" for x, y, z in CUBE))
        (self.folder / "cube.xyzrn").write_text(
            "".join(f"{x} {y} {z} 1.7 1 {name}\n" for (x, y, z), name in zip(CUBE, NAMES)))

    def run_program(self, name, *words, code=0, **options):
        done = subprocess.run([PROGRAMS / name, *map(str, words)], cwd=self.folder, text=True, capture_output=True,
                              check=False, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def msms(self, *words, **options):
        return self.run_program("meniscus-msms", *words, **options)

    def exact(self, *words):
        done = subprocess.run([MENISCUS, "measure", "cube.xyzr", "--probe", "1.5", "--report", "-", *words],
                              cwd=self.folder, text=True, capture_output=True, check=True)
        return json.loads(done.stdout)


class MsmsTest(ProgramTest):
    def test_masif_gets_names_normals_atoms_faces_and_areas(self):
        done = self.msms("-density", "3.0", "-hdensity", "3.0", "-probe", "1.5", "-all_components", "-if", "cube.xyzrn",
                         "-of", self.folder / "m", "-af", self.folder / "m")
        self.assertEqual(done.stderr, "")
        vertices = callers.read_vertices_by_place(self.folder / "m.vert")
        faces = callers.read_faces(self.folder / "m.face")
        self.assertTrue(callers.is_closed(faces))
        for place, normal, sphere, kind, name in vertices:
            self.assertAlmostEqual(math.hypot(*normal), 1.0, delta=0.002)
            self.assertEqual(name, NAMES[sphere - 1])
            self.assertIn(kind, (1, 2, 3))
            if kind == 3:
                self.assertAlmostEqual(math.dist(place, CUBE[sphere - 1]), 1.7, delta=0.002)
        areas = callers.read_areas_by_name(self.folder / "m.area")
        self.assertEqual(set(areas), set(NAMES))
        outer = self.exact()["components"][0]
        self.assertAlmostEqual(sum(areas.values()), outer["ses_area"], delta=0.001 * len(areas))

    def test_columns_are_those_that_the_manual_of_msms_gives(self):
        self.msms("-if", "cube.xyzrn", "-of", "m")
        by_place = callers.read_vertices_by_place(self.folder / "m.vert")
        by_column = callers.read_vertices_by_column(self.folder / "m.vert")
        self.assertEqual([(place + normal, sphere, kind, name) for place, normal, sphere, kind, name in by_place],
                         [(numbers, sphere, kind, name) for numbers, _, sphere, kind, name in by_column])

    def test_no_two_vertices_are_at_one_place_and_none_is_left_over(self):
        self.msms("-if", "cube.xyzr", "-of", "m", "-density", "4")
        vertices = callers.read_vertices_by_place(self.folder / "m.vert")
        faces = callers.read_faces(self.folder / "m.face")
        self.assertEqual(len({tuple(vertex[0]) for vertex in vertices}), len(vertices))
        self.assertEqual({corner for corners, _ in faces for corner in corners}, set(range(len(vertices))))

    def test_vmd_gets_files_without_headers(self):
        self.msms("-if", "cube.xyzr", "-of", "cube.xyzr", "-probe_radius", "1.400", "-density", "1.500", "-no_area",
                  "-no_header")
        vertices = callers.read_vertices_by_place(self.folder / "cube.xyzr.vert", header_lines=0)
        faces = callers.read_faces(self.folder / "cube.xyzr.face", header_lines=0)
        self.assertTrue(callers.is_closed(faces))
        self.assertTrue(all(0 < vertex[2] <= len(CUBE) for vertex in vertices))

    def test_tabi_pb_reads_counts_and_numbers_from_a_stream(self):
        self.msms("-if", "cube.xyzr", "-prob", "1.400000", "-dens", "2.000000", "-of", "molecule")
        for name, kinds in (("vert", [float] * 6 + [int] * 3), ("face", [int] * 5)):
            count, spheres, density, probe = callers.scan_stream(self.folder / f"molecule.{name}",
                                                                 [int, int, float, float], 1, 2)[0]
            self.assertEqual((spheres, density, probe), (len(CUBE), 2.0, 1.4))
            self.assertEqual(len(callers.scan_stream(self.folder / f"molecule.{name}", kinds, count, 3)), count)

    def test_openstructure_gets_every_component_from_output_and_files(self):
        printed = self.msms("-if", "cube.xyzr", "-of", "c", "-density", "1.0", "-probe_radius", "1.5", "-all", "-af",
                            "asa_atom").stdout
        self.assertEqual(callers.read_version(printed), "2.6.1")
        self.assertEqual(callers.count_components(printed), 1)
        exact = self.exact()["components"]
        for (ses, sas), component in zip(callers.read_analytical(printed), exact, strict=True):
            self.assertAlmostEqual(ses, component["ses_area"], delta=0.001)
            self.assertAlmostEqual(sas, component["sas_area"], delta=0.001)
        for stem in ("c", "c_1"):
            self.assertTrue(callers.is_closed(callers.read_faces(self.folder / f"{stem}.face")))
        rows = [line.split() for line in (self.folder / "asa_atom.area").read_text().splitlines()[1:]]
        for c, component in enumerate(exact):
            self.assertAlmostEqual(sum(float(row[1 + 2 * c]) for row in rows), component["ses_area"], delta=0.1)
            self.assertAlmostEqual(sum(float(row[2 + 2 * c]) for row in rows), component["sas_area"], delta=0.1)

    def test_only_areas_where_no_triangles_are_asked_for(self):
        printed = self.msms("-if", "cube.xyzr", "-of", "c", "-surface", "ases").stdout
        self.assertEqual(len(callers.read_analytical(printed)), 1)
        self.assertIsNone(callers.read_total_volume(printed))
        self.assertFalse((self.folder / "c.vert").exists())

    def test_the_outer_component_alone_unless_asked(self):
        printed = self.msms("-if", "cube.xyzr", "-of", "c", "-af", "c.area").stdout
        self.assertEqual(callers.count_components(printed), 0)
        self.assertFalse((self.folder / "c_1.vert").exists())
        exact = self.exact()["components"][0]
        rows = callers.read_areas(self.folder / "c.area")
        self.assertEqual(len(rows), len(CUBE))
        self.assertAlmostEqual(sum(ses for ses, _ in rows), exact["ses_area"], delta=0.1)
        self.assertAlmostEqual(callers.read_total_volume(printed), exact["ses_volume"], delta=0.03 * exact["ses_volume"])

    def test_one_cavity_is_the_one_that_the_atoms_line(self):
        printed = self.msms("-if", "cube.xyzr", "-of", "c", "-one_cavity", "1", LINING).stdout
        cavity = self.exact()["components"][1]
        self.assertEqual(cavity["kind"], "cavity")
        self.assertAlmostEqual(callers.read_analytical(printed)[0][0], cavity["ses_area"], delta=0.001)
        self.assertLess(callers.read_total_volume(printed), 0.0)
        vertices = callers.read_vertices_by_place(self.folder / "c.vert")
        self.assertTrue(all(1.0 < x < 8.6 for (x, _, _), *_ in vertices))
        outer = callers.read_analytical(self.msms("-if", "cube.xyzr", "-one_cavity", "1", CORNER).stdout)
        self.assertAlmostEqual(outer[0][0], self.exact()["components"][0]["ses_area"], delta=0.001)
        done = self.msms("-if", "cube.xyzr", "-one_cavity", "1", "5000", code=2)
        self.assertIn("there is no sphere 5000", done.stderr)

    def test_output_is_read_by_sections(self):
        printed = self.msms("-if", "cube.xyzr", "-all").stdout
        self.assertEqual(callers.read_parameters(printed), (1.5, 1.0, 3.0))
        numerical = callers.read_numerical(printed)
        self.assertEqual(len(numerical), 2)
        self.assertGreater(numerical[0][0], 0.0)
        self.assertLess(numerical[1][0], 0.0)

    def test_two_spheres_have_the_areas_that_msms_itself_prints(self):
        (self.folder / "two.xyzrn").write_text("-2.70 0 0 1.7 1 C\n2.75 0 0 1.7 1 C\n")
        printed = self.msms("-if", "two.xyzrn", "-of", "two", "-density", "5").stdout
        self.assertIn("      0       1.500       0.000     8.144    67.243    75.387   238.258\n", printed)

    def test_the_density_is_that_of_the_vertices_and_errors_fall_with_it(self):
        errors = []
        exact = self.exact()["components"][0]
        for density in (1, 2, 4):
            printed = self.msms("-if", "cube.xyzr", "-of", "c", "-density", density).stdout
            volume, area = callers.read_numerical(printed)[0]
            self.assertGreater(len(callers.read_vertices_by_place(self.folder / "c.vert")), 0.8 * density * area)
            self.assertLess(len(callers.read_vertices_by_place(self.folder / "c.vert")), 1.25 * density * area)
            errors.append(abs(volume - exact["ses_volume"]))
        self.assertEqual(errors, sorted(errors, reverse=True))

    def test_spheres_of_hydrogens_are_ignored_and_of_no_radius_have_no_area(self):
        (self.folder / "h.xyzr").write_text("0 0 0 1.5\n3 0 0 1.2\n0 3 0 0.0\n")
        self.msms("-if", "h.xyzr", "-af", "all", "-of", "all")
        self.msms("-if", "h.xyzr", "-af", "noh", "-of", "noh", "-noh")
        every = callers.read_areas(self.folder / "all.area")
        self.assertEqual(len(every), 3)
        self.assertEqual(every[2], (0.0, 0.0))
        self.assertGreater(every[1][0], 1.0)
        kept = callers.read_areas(self.folder / "noh.area")
        self.assertEqual(len(kept), 2)
        self.assertAlmostEqual(kept[0][0], 4 * math.pi * 1.5**2, delta=0.001)

    def test_help_and_version_without_an_input(self):
        self.assertIn("-probe_radius", self.msms("-h").stderr)
        done = self.msms(code=2)
        self.assertEqual(callers.read_version(done.stdout), "2.6.1")

    def test_what_goes_wrong_is_one_line_and_leaves_no_file(self):
        before = sorted(os.listdir(self.folder))
        for words, code in ((["-if", "none"], 3), (["-if", "cube.xyzr", "-of", "none/c"], 4), (["-foo"], 2)):
            done = self.msms(*words, code=code)
            self.assertRegex(done.stderr, r"\Ameniscus-msms: error: [^\n]+\n\Z")
            self.assertNotIn("terminated normally", done.stdout)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_results_do_not_depend_on_the_number_of_cores(self):
        files = []
        for cores in (1, 2):
            wanted = set(sorted(os.sched_getaffinity(0))[:cores])
            self.msms("-if", "cube.xyzr", "-of", "c", "-af", "c", "-all",
                      preexec_fn=lambda cpus=wanted: os.sched_setaffinity(0, cpus))
            files.append([(self.folder / name).read_bytes() for name in ("c.vert", "c.face", "c_1.vert", "c.area")])
        self.assertEqual(*files)


class NanoShaperTest(ProgramTest):
    TABI_PB = ("Grid_scale = {scale}\nGrid_perfil = 90\nXYZR_FileName = cube.xyzr\nBuild_epsilon_maps = false\n"
               "Build_status_map = false\nSave_Mesh_MSMS_Format = true\nCompute_Vertex_Normals = true\nSurface = ses\n"
               "Smooth_Mesh = true\nSkin_Surface_Parameter = 0.45\nCavity_Detection_Filling = {fill}\n"
               "Conditional_Volume_Filling_Value = {below}\nKeep_Water_Shaped_Cavities = false\nProbe_Radius = 1.5\n"
               "Accurate_Triangulation = true\nTriangulation = true\nCheck_duplicated_vertices = true\n"
               "Save_Status_map = false\nSave_PovRay = false\nMax_ses_patches_per_auxiliary_grid_2d_cell = 1600\n")

    def nanoshaper(self, text, *words, name="surfaceConfiguration.prm", **options):
        (self.folder / name).write_text(text)
        return self.run_program("meniscus-nanoshaper", *words, **options)

    def test_tabi_pb_reads_counts_alone_then_nine_and_five_numbers(self):
        for scale in (1, 2, 3):
            with self.subTest(scale=scale):
                done = self.nanoshaper(self.TABI_PB.format(scale=scale, fill="false", below=11.4))
                self.assertEqual(done.stderr, "")
                counts = {}
                for name, kinds in (("vert", [float] * 6 + [int] * 3), ("face", [int] * 5)):
                    path = self.folder / f"triangulatedSurf.{name}"
                    counts[name] = callers.scan_stream(path, [int], 1, 2)[0][0]
                    self.assertEqual(len(callers.scan_stream(path, kinds, counts[name], 3)), counts[name])
                    lines = path.read_text().splitlines()
                    self.assertEqual(len(lines), counts[name] + 3)
                    self.assertTrue(all(len(line.split()) == len(kinds) for line in lines[3:]))
                volume, area = callers.read_nanoshaper_output(done.stdout)
                whole = self.exact()["exact"]
                self.assertAlmostEqual(volume, whole["ses_volume"], delta=0.04 * whole["ses_volume"])
                self.assertAlmostEqual(counts["vert"], 1.5 * area * scale**2, delta=0.25 * counts["vert"])
                areas = [float(line) for line in (self.folder / "triangleAreas.txt").read_text().splitlines()]
                self.assertEqual(len(areas), counts["face"])
                self.assertAlmostEqual(sum(areas), area, delta=0.001 * area)

    def test_vmd_finds_its_files_under_the_root_it_gives_with_atoms(self):
        text = (f"Operative_Mode = normal\nPocket_Radius_Small = 1.4\nPocket_Radius_Big = 3.0\nSurface = ses\n"
                f"Grid_scale = 2.0\nXYZR_FileName = {self.folder}/cube.xyzr\nProbe_Radius = 1.4\n"
                f"Skin_Surface_Parameter = 0.45\nBlobbyness = -2.5\nCompute_Vertex_Normals = true\n"
                f"Save_Mesh_MSMS_Format = true\nVertex_Atom_Info = true\nGrid_perfil = 70.0\nBuild_epsilon_maps = false\n"
                f"Build_status_map = true\nSmooth_Mesh = true\nTriangulation = true\n"
                f"Max_Probes_Self_Intersections = 5000\nSelf_Intersections_Grid_Coefficient = 5.0\n"
                f"Accurate_Triangulation = true\nRoot_FileName = {self.folder}/vmdns.u0.7.\n"
                f"Max_skin_patches_per_auxiliary_grid_2d_cell = 2000\n")
        done = self.nanoshaper(text, self.folder / "vmdns.u0.7.prm", name="vmdns.u0.7.prm")
        self.assertEqual(done.stderr, "")
        faces = callers.read_faces(self.folder / "vmdns.u0.7.triangulatedSurf.face")
        self.assertTrue(callers.is_closed(faces))
        for place, _, sphere, kind, _ in callers.read_vertices_by_place(self.folder / "vmdns.u0.7.triangulatedSurf.vert"):
            if kind == 3:
                self.assertAlmostEqual(math.dist(place, CUBE[sphere - 1]), 1.7, delta=0.002)

    def test_off_has_four_lines_of_head_and_is_closed(self):
        for extra, head, fields in (("", "OFF", 3), ("Compute_Vertex_Normals = true\n", "OFF+N", 6),
                                    ("Compute_Vertex_Normals = true\nVertex_Atom_Info = true\n", "OFF+N+A", 7)):
            self.nanoshaper("Surface = ses\nXYZR_FileName = cube.xyzr\nTriangulation = true\n" + extra)
            lines = (self.folder / "triangulatedSurf.off").read_text().splitlines()
            self.assertEqual(lines[0], head)
            vertices, triangles, _ = map(int, lines[3].split())
            self.assertTrue(all(len(line.split()) == fields for line in lines[4:4 + vertices]))
            faces = [(tuple(map(int, line.split()[1:])), 0) for line in lines[4 + vertices:]]
            self.assertEqual(len(faces), triangles)
            self.assertTrue(callers.is_closed(faces))

    def test_cavities_below_the_value_are_filled_if_asked(self):
        cavity = self.exact()["components"][1]["ses_volume"]
        volumes = [callers.read_nanoshaper_output(self.nanoshaper(
            self.TABI_PB.format(scale=3, fill=fill, below=below)).stdout)[0]
            for fill, below in (("false", 2 * cavity), ("true", 0.5 * cavity), ("true", 2 * cavity))]
        self.assertAlmostEqual(volumes[0], volumes[1], delta=0.01)
        self.assertAlmostEqual(volumes[2] - volumes[0], cavity, delta=0.05 * cavity)

    def test_unknown_keys_are_warned_of_and_other_surfaces_refused(self):
        text = self.TABI_PB.format(scale=2, fill="false", below=11.4)
        done = self.nanoshaper(text + "Grid_perfill = 70\n")
        self.assertRegex(done.stderr, r"\Ameniscus-nanoshaper: warning: surfaceConfiguration.prm:\d+:1: Grid_perfill is "
                                      r"unknown[^\n]*\n\Z")
        for surface in ("skin", "blobby"):
            done = self.nanoshaper(text.replace("Surface = ses", f"Surface = {surface}"), code=3)
            self.assertIn(f"not {surface}", done.stderr)
        self.run_program("meniscus-nanoshaper", "none.prm", code=3)


class PdbToSpheresTest(ProgramTest):
    def test_every_record_is_a_line_from_a_file_or_a_stream(self):
        records = [line for line in UBIQUITIN.read_text().splitlines() if line.startswith(("ATOM", "HETATM"))]
        from_file = self.run_program("pdb_to_xyzr", UBIQUITIN).stdout
        with open(UBIQUITIN) as stream:
            self.assertEqual(self.run_program("pdb_to_xyzr", stdin=stream).stdout, from_file)
        lines = from_file.splitlines()
        self.assertEqual(len(lines), len(records))
        for line, record in zip(lines, records):
            x, y, z, radius = map(float, line.split())
            self.assertEqual([x, y, z], [float(record[i:i + 8]) for i in (30, 38, 46)])
            self.assertGreater(radius, 1.0)
        self.assertEqual(lines[0], "  27.340   24.430    2.614 1.70")

    def test_names_are_atom_residue_and_number(self):
        lines = self.run_program("pdb_to_xyzrn", UBIQUITIN).stdout.splitlines()
        self.assertEqual(lines[0], "27.340000 24.430000 2.614000 1.700000 1 N_MET_1")
        self.assertEqual(len(lines), 660)

    def test_radii_are_united_unless_hydrogens_are_explicit(self):
        united = self.run_program("pdb_to_xyzr", UBIQUITIN).stdout.splitlines()
        explicit = self.run_program("pdb_to_xyzr", "-h", UBIQUITIN).stdout.splitlines()
        self.assertEqual(united[1].split()[3], "2.00")
        self.assertEqual(explicit[1].split()[3], "1.70")

    def test_hydrogens_beside_united_radii_are_told(self):
        (self.folder / "h.pdb").write_text(
            "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00           N\n"
            "ATOM      2  H   GLY A   1       1.000   0.000   0.000  1.00  0.00           H\n")
        done = self.run_program("pdb_to_xyzr", "h.pdb")
        self.assertIn("1 hydrogens", done.stderr)
        self.assertEqual(done.stdout.splitlines()[1].split()[3], "1.20")

    def test_an_element_without_a_radius_is_told_with_its_file(self):
        (self.folder / "z.pdb").write_text(
            "ATOM      1  Q\x01  GLY A   1       0.000   0.000   0.000  1.00  0.00           Q\n")
        done = self.run_program("pdb_to_xyzr", "z.pdb", code=3)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"^pdb_to_xyzr: error: z.pdb: atom 0 \('Q\?' of 'GLY', element 'Q'\): .*\n$")

    def test_the_usual_course_from_pdb_to_surface(self):
        with open(self.folder / "u.xyzrn", "w") as file:
            file.write(self.run_program("pdb_to_xyzrn", UBIQUITIN).stdout)
        self.msms_done = self.run_program("meniscus-msms", "-if", "u.xyzrn", "-of", "u", "-af", "u")
        self.assertEqual(len(callers.read_areas_by_name(self.folder / "u.area")), 660)
        self.assertTrue(callers.is_closed(callers.read_faces(self.folder / "u.face")))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])

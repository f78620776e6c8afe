#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs `meniscus measure`: its numbers, tables, copies and interfaces, and FreeSASA beside it where that is installed.

usage: measure_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import schema

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
sys.path.append(str(SOURCE / "tools"))
import freesasa_area  # noqa: E402

UBIQUITIN = SOURCE / "examples" / "1ubq.pdb"
FREESASA_DATA = pathlib.Path("/usr/share/freesasa/test-data")

SPHERES = "0 0 0 1.7\n1.2 0 0 1.52\n20 0 0 1.8\n"

# Gly-Ala-Gly, extended (phi -139, psi 135 degrees), built from ideal bond lengths and angles.
EXTENDED = """\
ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00           N
ATOM      2  CA  GLY A   1       1.458   0.000   0.000  1.00  0.00           C
ATOM      3  C   GLY A   1       2.005  -1.074  -0.934  1.00  0.00           C
ATOM      4  O   GLY A   1       1.528  -2.210  -0.927  1.00  0.00           O
ATOM      5  N   ALA A   2       3.002  -0.715  -1.735  1.00  0.00           N
ATOM      6  CA  ALA A   2       3.608  -1.654  -2.672  1.00  0.00           C
ATOM      7  C   ALA A   2       5.124  -1.491  -2.704  1.00  0.00           C
ATOM      8  O   ALA A   2       5.632  -0.371  -2.757  1.00  0.00           O
ATOM      9  CB  ALA A   2       3.028  -1.460  -4.075  1.00  0.00           C
ATOM     10  N   GLY A   3       5.843  -2.609  -2.673  1.00  0.00           N
ATOM     11  CA  GLY A   3       7.301  -2.583  -2.699  1.00  0.00           C
ATOM     12  C   GLY A   3       7.850  -3.684  -3.600  1.00  0.00           C
ATOM     13  O   GLY A   3       7.395  -4.826  -3.541  1.00  0.00           O
"""


def two_chains(distance):
    """One carbon atom in each of two chains, and one of a third chain far away."""
    line = "ATOM  {0:5}  CA  GLY {1}   1    {2:8.3f}   0.000   0.000  1.00  0.00           C\n"
    return line.format(1, "A", 0.0) + line.format(2, "B", distance) + line.format(3, "C", 50.0)


def read_csv(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class MeasureTest(unittest.TestCase):
    """Every test runs in an empty folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.write("three.xyzr", SPHERES)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def run_program(self, *arguments, code=0):
        result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True,
                                encoding="utf-8", timeout=120, check=False)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def measure(self, *arguments, code=0):
        return self.run_program("measure", *arguments, code=code)

    def report(self, *arguments):
        return json.loads(self.measure(*arguments, "--report", "-").stdout)

    def files(self):
        return sorted(p.name for p in self.folder.iterdir())


class Numbers(MeasureTest):
    def test_a_sphere_has_the_closed_form(self):
        self.write("one.xyzr", "1 2 3 1.7\n")
        exact = self.report("one.xyzr")["exact"]
        for name, value in (("sas_area", 4 * math.pi * 3.1**2), ("sas_volume", 4 / 3 * math.pi * 3.1**3),
                            ("ses_area", 4 * math.pi * 1.7**2), ("ses_volume", 4 / 3 * math.pi * 1.7**3)):
            self.assertAlmostEqual(exact[name] / value, 1.0, delta=1e-9)
            self.assertLess(abs(exact[name] - value), exact["errors"][name] + 1e-12)

    def test_reports_follow_the_schema(self):
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        self.write("two.pdb", two_chains(4.0))
        for arguments in (["three.xyzr"], ["two.pdb", "--between", "all"], ["three.xyzr", "--model", "all"]):
            self.assertEqual(schema.problems(self.report(*arguments), rules), [], arguments)

    def test_components_sum_to_the_totals(self):
        report = self.report(UBIQUITIN, "--probe", "0.8")
        signs = [1 if c["kind"] == "outer" else -1 for c in report["components"]]
        self.assertIn(-1, signs)
        exact = report["exact"]
        for name in ("sas_area", "ses_area", "contact_area", "toroidal_area", "reentrant_area"):
            total = sum(c[name] for c in report["components"])
            self.assertAlmostEqual(total / exact[name], 1.0, delta=1e-11, msg=name)
        for name in ("sas_volume", "ses_volume"):
            total = sum(s * c[name] for s, c in zip(signs, report["components"]))
            self.assertAlmostEqual(total / exact[name], 1.0, delta=1e-11, msg=name)
        for component in report["components"]:
            for name, error in component["errors"].items():
                self.assertLess(error, 1e-5 + 1e-6 * component[name], name)
        self.assertEqual(report["exact"]["sas_components"], sum(c["sas_components"] for c in report["components"]))

    def test_surface_reports_the_same_exact_numbers(self):
        surface = json.loads(self.run_program("surface", UBIQUITIN, "-o", "u.ply", "--report", "-").stdout)
        measured = self.report(UBIQUITIN)
        self.assertEqual(surface["exact"], measured["exact"])
        self.assertEqual(surface["components"], measured["components"])
        mesh = surface["mesh"]
        for name, bound in (("area_deviation", 0.03), ("corrected_area_deviation", 0.02), ("volume_deviation", 0.01),
                            ("corrected_volume_deviation", 0.003)):
            self.assertLess(abs(mesh[name]), bound, name)
        self.assertAlmostEqual(mesh["area_deviation"], mesh["area"] / measured["exact"]["ses_area"] - 1, places=12)

    def test_threads_do_not_matter(self):
        one, two = (self.report(UBIQUITIN, "--threads", n) for n in ("1", "2"))
        self.assertEqual((one["exact"], one["components"]), (two["exact"], two["components"]))

    def test_the_summary_is_readable_and_quiet_is_silent(self):
        result = self.measure("three.xyzr")
        self.assertEqual(result.stderr, "")
        for text in ("SAS area", "SES volume", "reentrant", "±", "pieces"):
            self.assertIn(text, result.stdout)
        result = self.measure("three.xyzr", "--quiet")
        self.assertEqual((result.stdout, result.stderr), ("", ""))
        self.assertEqual(self.files(), ["three.xyzr"])


class Tables(MeasureTest):
    def test_tables_sum_to_the_totals(self):
        exact = self.report(UBIQUITIN, "-o", "a.csv", "--per", "atom", "-o", "r.csv", "--per", "residue", "-o",
                            "c.json", "--per", "chain")["exact"]
        tables = [read_csv(self.folder / "a.csv"), read_csv(self.folder / "r.csv"),
                  json.loads((self.folder / "c.json").read_text())]
        self.assertEqual([len(t) for t in tables], [602, 76, 1])
        for table in tables:
            for name in ("sas_area", "ses_area", "contact_area", "toroidal_area", "reentrant_area"):
                total = math.fsum(float(row[name]) for row in table)
                self.assertAlmostEqual(total / exact[name], 1.0, delta=1e-11, msg=name)

    def test_residues_are_the_default_and_buried_atoms_are_listed(self):
        self.measure(UBIQUITIN, "-o", "r.csv", "-o", "a.csv", "--per", "residue", "--per", "atom")
        rows = read_csv(self.folder / "r.csv")
        self.assertEqual(list(rows[0]), ["chain", "resnum", "icode", "resname", "atoms", "sas_area", "ses_area",
                                         "contact_area", "toroidal_area", "reentrant_area", "rsa", "mean_depth",
                                         "max_depth", "buried"])
        self.assertLess(max(float(row["rsa"]) for row in rows[:-1]), 1.0)
        atoms = read_csv(self.folder / "a.csv")
        buried = [row for row in atoms if row["buried"] == "true"]
        self.assertTrue(100 < len(buried) < 400, len(buried))
        self.assertTrue(all(float(row["sas_area"]) == 0.0 for row in buried))
        self.assertTrue(all(float(row["depth"]) > 0.0 for row in atoms))

    def test_an_extended_residue_is_almost_fully_accessible(self):
        self.write("gag.pdb", EXTENDED)
        self.measure("gag.pdb", "-o", "r.csv")
        rsa = float(read_csv(self.folder / "r.csv")[1]["rsa"])
        self.assertTrue(0.85 < rsa < 1.05, rsa)

    def test_cavities_have_a_row_each(self):
        report = self.report(UBIQUITIN, "--probe", "0.8", "-o", "c.csv", "--per", "cavity")
        cavities = [c for c in report["components"] if c["kind"] == "cavity"]
        rows = read_csv(self.folder / "c.csv")
        self.assertEqual([float(row["ses_volume"]) for row in rows], [c["ses_volume"] for c in cavities])
        self.assertTrue(all(row["residues"] for row in rows))
        self.assertTrue(all(float(row["inscribed_radius"]) > 0.8 for row in rows))

    def test_copies_carry_the_value(self):
        self.measure(UBIQUITIN, "-o", "a.csv", "--per", "atom", "-o", "s.pdb", "-o", "d.pdb", "--value", "sas",
                     "--value", "depth", "-o", "d.cif")
        atoms = read_csv(self.folder / "a.csv")
        for name, column in (("s.pdb", "sas_area"), ("d.pdb", "depth")):
            lines = [x for x in (self.folder / name).read_text().splitlines() if x.startswith("ATOM")]
            self.assertEqual(len(lines), len(atoms))
            for line, atom in zip(lines, atoms):
                self.assertEqual((line[12:16].strip(), line[17:20]), (atom["name"], atom["resname"]))
                self.assertAlmostEqual(float(line[60:66]), float(atom[column]), delta=0.00501)
        copy, original = (self.report(name)["exact"] for name in ("d.cif", UBIQUITIN))
        self.assertAlmostEqual(copy["ses_area"] / original["ses_area"], 1.0, delta=1e-12)

    def test_models_have_tables_of_their_own(self):
        model = "MODEL     {0:4}\n" + EXTENDED + "ENDMDL\n"
        self.write("nmr.pdb", model.format(1) + model.format(2))
        self.measure("nmr.pdb", "--model", "all", "-o", "t.csv", "--quiet")
        self.assertEqual(self.files(), ["nmr.pdb", "t_m01.csv", "t_m02.csv", "three.xyzr"])


class Rows(MeasureTest):
    def test_a_residue_with_a_segment_on_some_atoms_is_one_row(self):
        lines = EXTENDED.splitlines()
        marked = [line[:66].ljust(72) + "A".rjust(4) + line[76:] if i % 2 else line for i, line in enumerate(lines)]
        tables = []
        for name, text in (("plain", lines), ("mixed", marked)):
            self.write(name + ".pdb", "\n".join(text) + "\n")
            self.measure(name + ".pdb", "--per", "residue", "-o", "t.csv", "--quiet")
            tables.append(read_csv(self.folder / "t.csv"))
        self.assertEqual([row["resnum"] for row in tables[0]], ["1", "2", "3"])
        self.assertEqual(tables[1], tables[0])


class Interfaces(MeasureTest):
    def test_two_atoms_have_the_closed_form(self):
        self.write("two.pdb", two_chains(4.0))
        report = self.report("two.pdb", "--between", "A:B", "-o", "t.csv", "--radii", "bondi")
        (found,) = report["interfaces"]
        rho = 1.7 + 1.4
        self.assertAlmostEqual(found["buried_sas"], 2 * (2 * math.pi * rho * (rho - 2.0)), delta=1e-6)
        self.assertAlmostEqual(found["interface_area"], found["buried_sas"] / 2, delta=1e-12)
        self.assertAlmostEqual(found["buried_ses"], found["ses_a"] + found["ses_b"] - found["ses_ab"], delta=1e-12)
        rows = read_csv(self.folder / "t.csv")
        self.assertEqual([(r["interface"], r["side"], r["chain"]) for r in rows], [("A:B", "a", "A"), ("A:B", "b", "B")])
        self.assertAlmostEqual(sum(float(r["buried_sas"]) for r in rows), found["buried_sas"], delta=1e-9)

    def test_all_pairs_are_those_that_touch(self):
        for distance, count in ((4.0, 1), (7.0, 0)):
            self.write("two.pdb", two_chains(distance))
            report = self.report("two.pdb", "--between", "all", "--radii", "bondi")
            self.assertEqual([(i["a"], i["b"]) for i in report["interfaces"]], [("A", "B")][:count])
        self.assertIn("no chains touch", self.measure("two.pdb", "--between", "all").stdout)

    def test_copies_and_partners_in_several_models_have_an_interface(self):
        atom = "ATOM  {0:5}  CA  GLY {1}   1    {2:8.3f}   0.000   0.000  1.00  0.00           C\n".format
        self.write("unit.pdb1", f"MODEL 1\n{atom(1, 'A', 0)}ENDMDL\nMODEL 2\n{atom(1, 'A', 4)}ENDMDL\n")
        self.write("dock.pdb", f"{atom(1, 'A', 0)}END\n{atom(1, 'B', 4)}END\n")
        rules = json.loads((SOURCE / "docs" / "report.schema.json").read_text(encoding="utf-8"))
        for name, between in (("unit.pdb1", "A:A-2"), ("dock.pdb", "A:B")):
            report = self.report(name, "--model", "join", "--between", between, "--radii", "bondi")
            self.assertEqual(schema.problems(report, rules), [])
            self.assertEqual((report["input"]["model"], report["options"]["model"]), ("join", "join"))
            self.assertEqual(report["input"]["warnings"], [])
            self.assertAlmostEqual(report["interfaces"][0]["buried_sas"], 2 * (2 * math.pi * 3.1 * 1.1), delta=1e-6)
        self.assertEqual(self.measure("dock.pdb", "--quiet").stderr,
                         "meniscus: warning: dock.pdb: chain A taken, before END in line 2; chain B follows it (take all "
                         "with --model join)\n")

    def test_a_ligand_is_a_partner_by_its_name(self):
        ligand = "HETATM    4  C1  HEP A   2    {:8.3f}   0.000   0.000  1.00  0.00           C\n"
        atoms = two_chains(20.0) + ligand.format(4.0) + ligand.format(5.2).replace("    4  C1", "    5  C2")
        self.write("two.pdb", atoms)
        (found,) = self.report("two.pdb", "--between", "A:(HEP)", "--hetero", "ligands", "-o", "t.csv",
                               "--per", "atom")["interfaces"]
        self.assertEqual((found["a"], found["b"]), ("A", "(HEP)"))
        self.assertGreater(found["buried_sas"], 10)
        rows = read_csv(self.folder / "t.csv")
        self.assertEqual([(r["side"], r["name"]) for r in rows], [("a", "CA"), ("b", "C1"), ("b", "C2")])
        for partner, hint in (("(HEP)", "HEP was left out with the other ligands; keep them with --hetero ligands"),
                              ("(ZN)", "ions, too, with --hetero all"), ("HEP", "residues of that name are (HEP)")):
            result = self.measure("two.pdb", "--between", f"A:{partner}", code=2)
            self.assertIn(hint, result.stderr)

    def test_wrong_pairs_are_refused_in_one_line(self):
        self.write("two.pdb", two_chains(4.0))
        for arguments in (["--between", "A:X"], ["--between", "A"], ["--between", "A:A"], ["--between", ":"],
                          ["--between", "all", "--between", "A:B"],
                          ["--between", "A:B", "-o", "t.csv", "--per", "cavity"], ["--per", "atom"],
                          ["--value", "sas"], ["-o", "t.ply"], ["-o", "t.csv", "--per", "molecule"]):
            result = self.measure("two.pdb", *arguments, code=2)
            self.assertEqual(result.stdout, "")
            self.assertRegex(result.stderr, r"\Ameniscus: error: [^\n]+\n\Z")
        self.assertEqual(self.files(), ["three.xyzr", "two.pdb"])

    def test_what_pdb_cannot_hold_is_exit_4(self):
        self.write("big.xyzr", "0 0 0 1.7\n20000 0 0 1.7\n")
        result = self.measure("big.xyzr", "-o", "b.pdb", code=4)
        self.assertIn(".cif", result.stderr)
        self.measure("big.xyzr", "-o", "b.cif")


@unittest.skipUnless(shutil.which("freesasa") and FREESASA_DATA.is_dir(), "freesasa is not installed")
class FreeSasa(MeasureTest):
    """Lee and Richards' slices converge to the same area: 100 slices per atom are good to 2e-4, 1000 to 2e-6."""

    SLICES = 1000
    TOLERANCE = 5e-6  # relative

    def freesasa_area(self, structure):
        self.run_program("surface", structure, "--method", "gaussian", "--spacing", "2", "--quiet", "-o", "k.xyzr")
        spheres, _ = freesasa_area.read_spheres(self.folder / "k.xyzr")
        freesasa_area.write_pdb(self.folder / "k.pdb", spheres)
        result = subprocess.run(freesasa_area.command("k.pdb", self.SLICES), cwd=self.folder, capture_output=True,
                                encoding="utf-8", timeout=300, check=True)
        return freesasa_area.area_of(result.stdout)

    def test_areas_agree_within_the_slicing_error(self):
        for name in ("1a0q", "1d3z", "1ubq", "2jo4"):
            structure = FREESASA_DATA / f"{name}.pdb"
            area = self.report(structure)["exact"]["sas_area"]
            self.assertAlmostEqual(self.freesasa_area(structure) / area, 1.0, delta=self.TOLERANCE, msg=name)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

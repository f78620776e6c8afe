# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Python and the command line have the same results and options, under the same names."""
import dataclasses
import inspect
import json
import math
import subprocess
import unittest

import numpy
from support import PROGRAM, ROOT, InScratchFolder, read

import meniscus

COMPLEX = str(ROOT / "examples" / "1a0q.pdb")
# The first residues of both chains, which do not touch, in both clients.
SELECTION = "//*/1-20"

# Key -> why only one of the two has it.
ONLY_IN_REPORT = {
    "mesh": {"shown": "of --show; Surface.save(show=...) returns nothing"},
    "a": {key: "the caller has the file, mesh or structure that was compared"
          for key in ("file", "kind", "vertices", "triangles", "atoms", "radii", "probe", "notes", "warnings")},
    "report": {
        "meniscus": "meniscus.__version__", "schema": "of the report", "input": "attributes of Structure",
        "options": "Surface.options", "interfaces": "only of measure", "expected": "cost of the run",
        "drawn": "of what is saved; Structure.ligands",
        "time_s": "cost of the run", "peak_memory_mb": "cost of the run", "values": "arrays are the caller's own"},
}
ARRAYS_OF_ATOMS = "an array by atom, which the report has no room for; tables have it"
ONLY_IN_PYTHON = {
    "mesh": {"self_intersections": "quality.self_intersections of the report, there without quality=True, too"},
    "interfaces": {key: ARRAYS_OF_ATOMS
                   for key in ("atoms_a", "atoms_b", "atom_buried_sas_a", "atom_buried_sas_b", "atom_buried_ses_a",
                               "atom_buried_ses_b")},
}

# Option -> why not all clients have it.
ONLY_KEYWORDS = {"initial_area": "with --report", "quality": "with --report", "two_sided_distance": "with --report"}
NOT_REPORTED = {"history": "a path there", "vertex_density": "reported as edge", "memory": "reported as memory_mb", **ONLY_KEYWORDS}
NOT_IN_FILES = {"verify": "decides nothing about the mesh", "threads": "likewise", **NOT_REPORTED}


def flat(value, place=""):
    """(key, value) of everything below; of a list of dicts, of its first."""
    if isinstance(value, list) and value and isinstance(value[0], dict):
        value = value[0]
    if not isinstance(value, dict):
        yield place, value
        return
    for key, inner in value.items():
        yield from flat(inner, f"{place}.{key}" if place else key)


class Keys(InScratchFolder):
    def run_program(self, *words):
        subprocess.run([PROGRAM, *words, "--quiet", "--report", "report.json"], check=True)
        with open("report.json", encoding="utf-8") as file:
            return json.load(file)

    def compare_keys(self, block, report, python):
        with_report, with_python = dict(flat(report)), dict(flat(python))
        for only, allowed in ((with_report.keys() - with_python.keys(), ONLY_IN_REPORT),
                              (with_python.keys() - with_report.keys(), ONLY_IN_PYTHON)):
            where = "in the report" if allowed is ONLY_IN_REPORT else "in Python"
            self.assertEqual({key.split(".")[0] for key in only}, set(allowed.get(block, ())),
                             f"{block}: only {where}: {sorted(only)}")
        for key in with_report.keys() & with_python.keys():
            self.compare_values(f"{block}.{key}", with_report[key], with_python[key])

    def compare_values(self, key, expected, found):
        if isinstance(found, float) and not math.isfinite(found):
            found = None
        elif isinstance(found, float) and expected is not None:
            self.assertAlmostEqual(found, expected, delta=1e-9 * max(1.0, abs(expected)), msg=key)
            return
        elif hasattr(found, "tolist"):
            found = found.tolist()
        elif isinstance(found, tuple):
            found = ",".join(found) if isinstance(found[0], str) else list(found)
        self.assertEqual(found, expected, key)

    def test_of_surfaces(self):
        report = self.run_program("surface", COMPLEX, "--select", SELECTION, "--spacing", "1", "--verify",
                                  "--history", "history.csv", "-o", "mesh.ply")
        surface = meniscus.surface(read(COMPLEX, select=SELECTION), spacing=1.0, history=True, initial_area=True,
                                   quality=True, verify=True)
        self.compare_keys("mesh", report["mesh"], surface.mesh)
        self.compare_keys("flow", report["flow"], surface.flow)
        self.compare_keys("checks", report["checks"], surface.checks)
        self.assertEqual([check["name"] for check in report["checks"]], [check["name"] for check in surface.checks])
        self.compare_keys("two_sided_distance", *(
            found["two_sided_distance"] for found in (
                self.run_program("surface", COMPLEX, "--select", SELECTION, "--edge", "1", "-o", "even.ply")["mesh"],
                meniscus.surface(read(COMPLEX, select=SELECTION), edge=1.0, two_sided_distance=True).mesh)))
        here = {"exact": surface.measures, "components": surface.measures.components, "mesh": surface.mesh,
                "flow": surface.flow, "checks": surface.checks}
        self.assertEqual(set(report) | {"interfaces"}, set(here) | set(ONLY_IN_REPORT["report"]))

    def test_of_measures(self):
        report = self.run_program("measure", COMPLEX, "--between", "L:H")
        measures = meniscus.measure(read(COMPLEX), between=("L", "H"))
        self.compare_keys("exact", report["exact"], {name: getattr(measures, name) for name in report["exact"]})
        for block, pieces in (("components", measures.components), ("interfaces", measures.interfaces)):
            self.assertEqual(len(report[block]), len(pieces))
            for expected, piece in zip(report[block], pieces):
                fields = {field.name: getattr(piece, field.name) for field in dataclasses.fields(piece)}
                if fields.get("kind") == "outer":  # Python has a sphere of radius 0 there
                    expected.update(inscribed_centre=[0.0, 0.0, 0.0], inscribed_radius=0.0)
                self.compare_keys(block, expected, fields)

    def test_of_comparisons(self):
        meniscus.surface(read(COMPLEX, select=SELECTION), spacing=1.0).save("mesh.ply")
        report = self.run_program("compare", "mesh.ply", COMPLEX, "--select", SELECTION)
        found = meniscus.compare("mesh.ply", read(COMPLEX, select=SELECTION))
        self.compare_keys("a", report["a"], dataclasses.asdict(found.a))
        for block in ("a_to_b", "b_to_a"):
            self.compare_keys(block, report[block], dataclasses.asdict(getattr(found, block)))
        self.compare_values("hausdorff", report["hausdorff"], found.hausdorff)

    def test_of_options(self):
        described = json.loads(subprocess.run([PROGRAM, "--describe", "options"], capture_output=True, check=True).stdout)
        names = {option["name"] for group, options in described.items() for option in options if group != "Pockets"}
        self.assertLessEqual({"probe", "spacing", "edge", "flow", "verify", "threads"}, names)
        text = subprocess.run([PROGRAM, "surface", "--help-all"], capture_output=True, encoding="utf-8", check=True).stdout
        flags = {word.strip(",").removeprefix("--").replace("-", "_") for word in text.split() if word.startswith("--")}
        reported = set(self.run_program("surface", COMPLEX, "--select", SELECTION, "--spacing", "1", "-o", "a.npz")["options"])
        written = set(json.loads(str(numpy.load("a.npz")["options"]))["options"])
        for found, without in ((flags, ONLY_KEYWORDS), (reported, NOT_REPORTED), (written, NOT_IN_FILES),
                               (set(inspect.signature(meniscus.surface).parameters), {})):
            self.assertEqual(names - found, set(without))


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The npm package in Node: its files and numbers are those of the program, errors have their code, what is asked to stop
stops; and it is as small as it is said to be. Skipped where node or build/web is missing.

usage: package_test.py PROGRAM PROJECT PACKAGE
"""
import gzip
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, PROJECT, PACKAGE = (pathlib.Path(path).resolve() for path in sys.argv[1:4])
INPUT = PROJECT / "examples" / "1a0q.pdb"
MOST_PACKED = 1_000_000

SCRIPT = """
import {readFileSync, writeFileSync} from "node:fs";
import {Meniscus, measure} from "INDEX";
const input = readFileSync("1a0q.pdb.gz"), options = {name: "1a0q.pdb.gz", spacing: 0.8, exact: true, interfaces: true};
const result = {};
const failed = async promise => promise.then(() => "nothing", ({name, code, message}) => ({name, code, message}));
const engine = new Meniscus();
const stages = new Set();
const s = await engine.surface(input, {...options, progress: ({stage}) => stages.add(stage)});
for (const kind of ["ply", "stl", "residues.csv"]) writeFileSync("ours." + kind, await s.file(kind));
Object.assign(result, {report: s.report, vertices: s.positions.length / 3, names: s.atoms.name.length, stages: [...stages],
                       last: [s.atoms.chain.at(-1), s.atoms.number.at(-1)], page: (await s.page()).data.length});
result.spheres = (await measure({positions: [0, 0, 0], radii: [2]})).report.exact.ses_area;
result.usage = await failed(engine.surface(input, {...options, spacing: -1}));
result.input = await failed(measure("ATOM      1  N   MET A   1      27.340  24.430   2.x14  1.00  9.67           N\\n"));
const running = failed(engine.surface(input, {...options, spacing: 0.2, method: "flow"}));
setTimeout(() => engine.stop(), 50);
result.stopped = await running;
result.closed = await failed(s.file("ply"));
result.again = (await engine.surface(input, {name: "1a0q.pdb", method: "direct", spacing: 1})).positions.length > 0;
console.log(JSON.stringify(result));
process.exit(0);
"""


def program(*arguments, folder):
    subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, cwd=folder)


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        folder = cls.folder = pathlib.Path(cls.scratch.name)
        (folder / "1a0q.pdb.gz").write_bytes(gzip.compress(INPUT.read_bytes()))
        (folder / "try.mjs").write_text(SCRIPT.replace("INDEX", str(PACKAGE / "dist" / "index.js")))
        shown = subprocess.run(["node", "try.mjs"], check=True, capture_output=True, text=True, cwd=folder).stdout
        cls.ours = json.loads(shown)
        program("surface", "1a0q.pdb.gz", "--spacing", "0.8", "-o", "theirs.ply", "-o", "theirs.stl", "--report", "s.json",
                folder=folder)
        program("measure", "1a0q.pdb.gz", "--between", "all", "--report", "m.json", folder=folder)
        program("measure", "1a0q.pdb.gz", "-o", "theirs.residues.csv", folder=folder)

    def read(self, name):
        return (self.folder / name).read_bytes()

    def test_files_are_those_of_the_program(self):
        for kind in ("ply", "stl", "residues.csv"):
            self.assertEqual(self.read("ours." + kind), self.read("theirs." + kind), kind)

    def test_numbers_are_those_of_the_program(self):
        surface, measured = json.loads(self.read("s.json")), json.loads(self.read("m.json"))
        for key in ("exact", "components"):
            self.assertEqual(self.ours["report"][key], surface[key])
        self.assertEqual(self.ours["report"]["interfaces"], measured["interfaces"])
        self.assertEqual(self.ours["report"]["mesh"]["area"], surface["mesh"]["area"])
        self.assertEqual(self.ours["vertices"], surface["mesh"]["vertices"])
        self.assertEqual(self.ours["names"], surface["input"]["atoms"])
        self.assertEqual(len(self.ours["report"]["cavities"]), 7)
        self.assertEqual(self.ours["last"][0], "H")
        self.assertGreater(self.ours["page"], 10_000)
        self.assertAlmostEqual(self.ours["spheres"], 50.26548245743669, 6)

    def test_progress_errors_and_stopping(self):
        self.assertLessEqual({"geometry", "mesh"}, set(self.ours["stages"]))
        self.assertEqual(self.ours["usage"]["code"], 2)
        self.assertEqual(self.ours["input"]["code"], 3)
        self.assertIn(":1:47: ", self.ours["input"]["message"])
        for key in ("stopped", "closed"):
            self.assertEqual(self.ours[key]["name"], "AbortError")
        self.assertTrue(self.ours["again"])

    def test_is_small(self):
        packed = list(PACKAGE.parent.glob("meniscus-surface-*.tgz"))
        for path in packed:
            self.assertLess(path.stat().st_size, MOST_PACKED)
        self.assertTrue((PACKAGE / "dist" / "index.d.ts").is_file())


if __name__ == "__main__":
    if shutil.which("node") is None or not (PACKAGE / "dist" / "meniscus.wasm").is_file():
        print("skipped: node or build/web is missing (./run web makes it)")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The npm package in Node: its files and numbers are those of the program, errors have their code, what is asked to stop
stops and leaves nothing behind; and it is as small as it is said to be. Skipped where node or build/web is missing.

usage: package_test.py PROGRAM PROJECT PACKAGE
"""
import gzip
import json
import math
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
import {Meniscus, measure, pockets} from "INDEX";
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
result.pockets = (await pockets(input, {name: "1a0q.pdb.gz", count: 2})).pockets;
result.estimates = [await engine.estimate(input, options), await engine.estimate(input, {...options, interfaces: false})];
result.usage = await failed(engine.surface(input, {...options, spacing: -1}));
result.input = await failed(measure("ATOM      1  N   MET A   1      27.340  24.430   2.x14  1.00  9.67           N\\n"));
const running = failed(engine.surface(input, {...options, spacing: 0.2, method: "flow"}));
setTimeout(() => engine.stop(), 50);
result.stopped = await running;
result.closed = await failed(s.file("ply"));
result.again = (await engine.surface(input, {name: "1a0q.pdb", method: "direct", spacing: 1})).positions.length > 0;
console.log(JSON.stringify(result));
"""

# What may come at a wrong time. Every promise must end, and the program with them.
RACES = """
import {readFileSync} from "node:fs";
import {Meniscus, measure, surface} from "INDEX";
const input = readFileSync("1a0q.pdb"), quick = {method: "direct", spacing: 1}, long = {method: "flow", spacing: 0.1};
const said = promise => promise.then(({positions, report}) => positions ? "surface" : report ? "measures" : "more",
                                     ({name, code, message}) => name === "AbortError" ? name : [code, message]);
const all = (...promises) => Promise.all(promises.map(said));
const signalled = (options, f) => {
  const controller = new AbortController(), promise = engine.surface(input, {...options, signal: controller.signal});
  f(() => controller.abort());
  return promise;
};
const result = {};
const engine = new Meniscus();

const early = [engine.surface(input, quick), engine.measure(input)];
engine.stop();
engine.stop();
result.stoppedWhileLoading = await all(...early, engine.surface(input, quick));

const s = await engine.surface(input, quick), abort = [];
result.abortedWhileWaiting = await all(engine.surface(input, quick), signalled(quick, f => f()), engine.measure(input));
result.kept = await all(s.file("ply"), s.page());
const running = signalled(long, f => setTimeout(f, 200));
result.abortedWhileRunning = await all(running, engine.surface(input, quick), s.file("ply"));
s.close();
result.abortedBefore = await all(engine.surface(input, {...quick, signal: AbortSignal.abort()}));

const closed = await engine.surface(input, quick);
closed.close();
closed.close();
result.closed = await all(closed.page());

const one = new Float64Array([0, 0, 0]), measured = engine.measure({positions: one, radii: [2]});
one[0] = NaN;
result.copied = (await measured).report.exact.ses_area;
result.unsendable = await all(engine.surface(input, {probe: () => 1.4}), engine.measure(input));

result.tooFine = await all(engine.surface(input, {...quick, spacing: 0.01}), engine.surface(input, quick));
result.noMemory = await all(engine.surface(input, {spacing: 0.02, memory: 1000000}), engine.surface(input, quick));

const wrong = new Meniscus({wasm: new TextEncoder().encode("<!DOCTYPE html>")});
result.wrongModule = await all(wrong.surface(input), wrong.measure(input));
const failing = new Meniscus({worker: "throw new Error('oops')"});
result.failingWorker = await all(failing.surface(input), failing.measure(input));
const script = "let n = 0; require('worker_threads').parentPort.on('message', m => { if (n++) throw new Error('later');" +
               " require('worker_threads').parentPort.postMessage({}); })";
const dying = new Meniscus({worker: script});
result.dyingWorker = await all(dying.measure(input), dying.measure(input));
result.shared = await all(surface(input, quick), measure(input));
console.log(JSON.stringify(result));
"""

# What JavaScript lets callers give. Each must be refused in one line, and the engine answer the next.
WRONG = r"""
import {readFileSync} from "node:fs";
import {Meniscus, measure} from "INDEX";
const text = readFileSync("1ubq.pdb", "utf8"), ball = {positions: [0, 0, 0], radii: [2]}, engine = new Meniscus();
const said = async f => {
  try { await f(); return ["no error"]; } catch (error) { return [error.code ?? error.name, error.message]; }
};
const options = [
  ["name:", {name: 5}], ["name:", {name: ""}], ["signal:", {signal: {}}], ["progress:", {progress: "x"}],
  ["interfaces:", {interfaces: 5}], ["options:", null], ["options:", []], ["options:", "x"], ["options:", new Map()],
  ["options:", {__proto__: {spacing: 1}}], ["'__proto__'", JSON.parse('{"__proto__": 1}')], ["'constructor'", {constructor: 1}],
  ["'hasOwnProperty'", {hasOwnProperty: "1"}], ["probe:", {probe: () => 1.4}], ["probe:", {probe: {}}],
  ["spacing:", {spacing: NaN}], ["spacing:", {spacing: "fine"}], ["exact:", {exact: 2}], ["chains:", {chains: []}],
  ["select:", {select: Symbol("x")}],
];
const at = [0, 0, 0], inputs = [
  ["input:", undefined], ["input:", null], ["input:", 7], ["input:", {}], ["input:", [ball]], ["input:", new Int8Array(3)],
  ["input:", "1ubq.pdb"], ["positions:", {radii: [2]}], ["positions:", {positions: [0, 0], radii: [2]}],
  ["positions:", {positions: at, radii: [2, 3]}], ["positions:", {positions: [at], radii: [2]}],
  ["positions:", {positions: [0, NaN, 0], radii: [2]}], ["positions:", {positions: ["0", "0", "0"], radii: [2]}],
  ["positions:", {positions: 3, radii: [2]}], ["radii:", {positions: at}], ["radii:", {positions: at, radii: [NaN]}],
  ["radii:", {positions: at, radii: [-2]}], ["radii:", {positions: at, radii: [0]}], ["radii:", {positions: [], radii: []}],
  ["radii:", {positions: at, radii: [Infinity]}],
];
const closed = "this surface has been closed", kinds = ["pdb", "constructor.csv", "../x", undefined, 5];
const colours = [["colour:", {colour: 5}], ["colour:", {colour: "x"}], ["'color'", {color: "chain"}], ["options:", null]];
const result = {refused: []}, refused = async (begin, f) => result.refused.push([begin, ...await said(f)]);
for (const what of ["measure", "surface", "estimate"])
  for (const [begin, given] of options) await refused(begin, () => engine[what](text, given));
for (const what of ["measure", "surface"])
  await refused("interfaces:", () => engine[what](text, {interfaces: "AB", method: "direct", spacing: 1}));
for (const [begin, given] of inputs) await refused(begin, () => measure(given));
const s = await engine.surface(ball, {method: "direct"});
for (const kind of kinds) await refused("kind:", () => s.file(kind));
for (const [begin, given] of colours) await refused(begin, () => s.page(given));
s.close();
for (const kind of ["ply", "report.json"]) await refused(closed, () => s.file(kind));
await refused("the files of the engine:", () => new Meniscus(null));

const throwing = progress => said(() => engine.surface(text, {method: "direct", spacing: 1, progress}));
result.thrown = [await throwing(() => { throw new RangeError("mine"); }),
                 await throwing(async () => { throw new RangeError("later"); })];
result.after = (await engine.surface(text, {method: "direct", spacing: 1, name: null, signal: undefined})).positions.length > 0;

const bom = "\uFEFF", [pqr, cif] = ["one.pqr", "1ubq.cif"].map(name => readFileSync(name, "utf8"));
const formats = {pdb: text, bom: bom + text, pqr, cif: bom + cif, gro: readFileSync("1ubq.gro"), xyzr: bom + "0 0 0 2\n"};
result.formats = {};
for (const [format, input] of Object.entries(formats)) {
  const {report} = await measure(input);
  result.formats[format] = [report.input.file, report.input.atoms, report.exact.ses_area];
}
result.hints = [await said(() => measure(new Blob([text]))), await said(() => measure(Promise.resolve(text)))];
result.noFormat = await said(() => measure("a letter to a friend"));
result.wrongLine = await said(() => measure("ATOM      1  N   MET A   1      27.340  24.430   2.x14  1.00  9.67           N\n"));
console.log(JSON.stringify(result));
"""

# The engine in this thread, so that its memory can be filled: addresses beyond 2 GB, and mistakes of the module itself.
INSIDE = """
const {readFileSync} = require("fs"), {runInThisContext} = require("vm");
Object.assign(globalThis, {require, __filename: "WORKER", __dirname: "."});
runInThisContext(readFileSync("WORKER", "utf8").replace(/^serve\\(.*$/m, "Object.assign(globalThis, {Engine, messageOf})"));
(async () => {
  const engine = await Engine.load(await WebAssembly.compile(readFileSync("WASM")), () => {}), m = engine.module;
  const request = {input: new Uint8Array(readFileSync("1ubq.pdb")), name: "1ubq.pdb", options: {spacing: 1, between: "all"}};
  const countHandles = m => {
    const count = {made: 0, freed: 0};
    for (const name of ["options_new", "parse", "exact_new", "web_surface"].map(n => "_meniscus_" + n)) {
      const make = m[name];
      m[name] = (...given) => { const status = make(...given); count.made += name.includes("options") || status === 0; return status; };
    }
    for (const name of ["options", "structure", "exact", "surface"].map(n => `_meniscus_${n}_free`)) {
      const free = m[name];
      m[name] = handle => { count.freed += handle !== 0; free(handle); };
    }
    return count;
  };
  const digest = () => {
    const {number, report, ...arrays} = engine.surface(request), ply = engine.file({number, kind: "ply"});
    const page = engine.page({number}).data, {sas} = engine.measure(request);
    engine.close({number});
    return [arrays.positions, arrays.normals, arrays.indices, arrays.values.area, arrays.atoms.radii, sas].map(a => a.join())
      .join() + arrays.atoms.name.join() + arrays.atoms.chain.join() + report.input.atoms + ply.length + page.length;
  };
  const refused = options => { try { engine.surface({...request, options}); } catch (error) { return error; } };
  const before = digest(), open = countHandles(m);
  for (const options of [{probe: -1}, {nonsense: 1}, {select: "and"}, {spacing: 0.001}, {spacing: 1, between: "Q:R"}]) refused(options);
  digest();
  const made = {...open};
  for (const size of [1e8, 1e6, 1e4, 100]) while (m._malloc(size) >>> 0 < 2 ** 31) continue;   // nothing is left below
  console.log(JSON.stringify({
    same: digest() === before, made, open: made.made - made.freed, message: refused({method: "x"}).message, code: refused({method: "x"}).code,
    trap: messageOf(new WebAssembly.RuntimeError("unreachable")), usual: messageOf(refused({method: "x"})),
  }));
})();
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
        for name in ("1a0q.pdb", "1ubq.pdb"):
            shutil.copy(PROJECT / "examples" / name, folder)
        cls.write_other_formats(folder)
        cls.ours, cls.races, cls.wrong, cls.inside = (cls.node(*script) for script in (
            ("try.mjs", SCRIPT), ("races.mjs", RACES), ("wrong.mjs", WRONG), ("inside.cjs", INSIDE)))
        program("surface", "1a0q.pdb.gz", "--spacing", "0.8", "-o", "theirs.ply", "-o", "theirs.stl", "--report", "s.json",
                folder=folder)
        program("measure", "1a0q.pdb.gz", "--between", "all", "--report", "m.json", folder=folder)
        program("measure", "1a0q.pdb.gz", "-o", "theirs.residues.csv", folder=folder)
        program("pockets", "1a0q.pdb.gz", "--count", "2", "--report", "p.json", folder=folder)

    @staticmethod
    def write_other_formats(folder):
        """1ubq.cif, 1ubq.gro with fewer digits, and an atom of known radius as one.pqr."""
        program("measure", "1ubq.pdb", "-o", "1ubq.cif", folder=folder)
        lines = [line for line in (folder / "1ubq.pdb").read_text(encoding="ascii").splitlines() if line.startswith("ATOM")]
        rows = [f"{int(line[22:26]):5}{line[17:20]:5}{line[12:16].strip():>5}{int(line[6:11]):5}" +
                "".join(f"{float(line[k:k + 8]) / 10:8.3f}" for k in (30, 38, 46)) for line in lines]
        (folder / "1ubq.gro").write_text("\n".join(["Ubiquitin", str(len(rows)), *rows, "   1.0 1.0 1.0\n"]), encoding="ascii")
        atom = "ATOM      1  CA  ALA A   1       1.000   2.000   3.000  0.5000 1.9080\n"
        (folder / "one.pqr").write_text(atom, encoding="ascii")

    @classmethod
    def node(cls, name, script):
        """What a script prints; it must end by itself."""
        for word, file in (("INDEX", "index.js"), ("WORKER", "meniscus-worker.js"), ("WASM", "meniscus.wasm")):
            script = script.replace(word, str(PACKAGE / "dist" / file))
        (cls.folder / name).write_text(script, encoding="utf-8")
        done = subprocess.run(["node", name], check=False, capture_output=True, text=True, cwd=cls.folder, timeout=500)
        if done.returncode != 0:
            raise AssertionError(f"{name}: {done.returncode}\n{done.stdout[-2000:]}\n{done.stderr[-3000:]}")
        return json.loads(done.stdout)

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
        for ours, theirs in zip(self.ours["pockets"], json.loads(self.read("p.json"))["pockets"], strict=True):
            self.assertAlmostEqual(ours["volume"], theirs["volume"], 6)
            self.assertEqual(ours["residues"], theirs["residues"])

    def test_estimates_are_of_what_is_asked_for(self):
        estimate, without_interfaces = self.ours["estimates"]
        self.assertEqual(estimate["atoms"], self.ours["names"])
        self.assertLess(abs(estimate["vertices"] / self.ours["vertices"] - 1), 0.4)
        self.assertGreater(estimate["seconds"], without_interfaces["seconds"])
        self.assertEqual(estimate["megabytes"], without_interfaces["megabytes"])

    def test_progress_errors_and_stopping(self):
        self.assertLessEqual({"geometry", "mesh"}, set(self.ours["stages"]))
        self.assertEqual(self.ours["usage"]["code"], 2)
        self.assertEqual(self.ours["input"]["code"], 3)
        self.assertIn(":1:47: ", self.ours["input"]["message"])
        for key in ("stopped", "closed"):
            self.assertEqual(self.ours[key]["name"], "AbortError")
        self.assertTrue(self.ours["again"])

    def test_stopping_and_signals_reject_what_they_concern_and_nothing_else(self):
        aborted = "AbortError"
        self.assertEqual(self.races["stoppedWhileLoading"], [aborted, aborted, "surface"])
        self.assertEqual(self.races["abortedWhileWaiting"], ["surface", aborted, "measures"])
        self.assertEqual(self.races["kept"], ["more", "more"])
        self.assertEqual(self.races["abortedWhileRunning"], [aborted, "surface", aborted])
        self.assertEqual(self.races["abortedBefore"], [aborted])
        (code, message), = self.races["closed"]
        self.assertEqual(code, 2)
        self.assertIn("this surface has been closed; ", message)
        self.assertEqual(self.races["shared"], ["surface", "measures"])

    def test_input_may_change_after_the_call(self):
        self.assertAlmostEqual(self.races["copied"], 50.26548245743669, 6)

    def test_what_has_the_wrong_type_is_refused_in_a_line_that_names_it(self):
        for begin, code, *message in self.wrong["refused"]:
            with self.subTest(begin, message=message):
                self.assertEqual(code, 2)
                self.assertIn(begin, message[0])
                self.assertTrue(message[0].startswith(begin) or begin.startswith("'"))
                self.assertNotIn("\n", message[0])

    def test_bytes_that_are_still_to_come_are_told_how_to_get(self):
        hints = ("a Blob; await its arrayBuffer()", "a Promise; await it")
        for (_, message), hint in zip(self.wrong["hints"], hints, strict=True):
            self.assertTrue(message.endswith(hint), message)

    def test_what_progress_throws_rejects_the_call_alone(self):
        self.assertEqual(self.wrong["thrown"], [["RangeError", "mine"], ["RangeError", "later"]])
        self.assertTrue(self.wrong["after"])

    def test_content_tells_the_format_of_what_has_no_name(self):
        for key, (file, atoms, _) in self.wrong["formats"].items():
            self.assertEqual(file, "<data>", key)
            self.assertEqual(atoms, {"pqr": 1, "xyzr": 1}.get(key, 602), key)
        areas = {key: area for key, (_, _, area) in self.wrong["formats"].items()}
        self.assertAlmostEqual(areas["xyzr"], 50.26548245743669, 6)
        self.assertAlmostEqual(areas["pqr"], 4 * math.pi * 1.908 ** 2, 6)
        self.assertEqual(areas["pdb"], areas["bom"])
        self.assertAlmostEqual(areas["pdb"], areas["cif"], 6)
        for key, words in (("noFormat", "neither PDB nor mmCIF"), ("wrongLine", ":1:47: ")):
            code, message = self.wrong[key]
            self.assertEqual(code, 3)
            self.assertTrue(message.startswith("<data>"), message)
            self.assertIn(words, message)

    def test_after_an_error_the_engine_goes_on(self):
        self.assertEqual(self.races["unsendable"][1], "measures")
        for key, words in (("tooFine", "GB are free"), ("noMemory", "not enough memory")):
            (code, message), then = self.races[key]
            self.assertEqual(code, 5)
            self.assertIn(words, message)
            self.assertEqual(then, "surface")

    def test_an_engine_that_cannot_be_loaded_says_so_each_time(self):
        for key, words in (("wrongModule", "beside index.js"), ("failingWorker", "oops"), ("dyingWorker", "later")):
            self.assertEqual(len(self.races[key]), 2)
            for _, message in self.races[key]:
                self.assertIn(words, message)

    def test_memory_beyond_2_gb_is_as_good_as_any(self):
        self.assertTrue(self.inside["same"])
        self.assertEqual(self.inside["code"], 2)
        self.assertIn("method: unknown value 'x'", self.inside["message"])

    def test_errors_leave_no_memory_behind(self):
        self.assertGreater(self.inside["made"]["made"], 12)
        self.assertEqual(self.inside["open"], 0)

    def test_a_mistake_in_the_module_ends_its_worker(self):
        self.assertTrue(self.inside["trap"]["broken"])
        self.assertIn("please report it", self.inside["trap"]["error"]["message"])
        self.assertNotIn("broken", self.inside["usual"])

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

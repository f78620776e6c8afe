#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The package as npm installs it: applications that Vite, webpack and esbuild build compute in Chromium, and so does what
web/README.md shows; TypeScript accepts what index.d.ts declares and nothing else.

usage: bundlers_test.py MENISCUS ROOT PACKAGE BUNDLERS
PACKAGE is the folder of the built npm package, beside which its .tgz lies; BUNDLERS has node_modules with vite, webpack,
esbuild and typescript. Skipped (77) where one of these, npm, Chromium, its driver or Python's selenium is missing.
"""
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import unittest

import web_browser
from web_browser import browser_test

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "docs"))
import markdown  # noqa: E402

_, ROOT, PACKAGE, BUNDLERS = (pathlib.Path(word).resolve() for word in sys.argv[1:5])
TOOLS = BUNDLERS / "node_modules" / ".bin"
README = markdown.read(ROOT / "web" / "README.md")[0]

HEAD = '<!DOCTYPE html>\n<meta charset="utf-8">\n<link rel="icon" href="data:,">\n<body>\n'
PAGE = HEAD + '<script type="module" src="SCRIPT"></script>\n'
APPLICATION = """
import {measure, surface} from "meniscus-surface";
import {vertexColours} from "meniscus-surface/adapters/colours";

const ball = {positions: [0, 0, 0], radii: [2]}, {report} = await measure(ball);
const mesh = await surface(ball, {method: "direct"});
globalThis.found = [report.exact.ses_area, vertexColours(mesh).length - mesh.positions.length / 3];
"""
AREA = 50.26548245743669
TYPED = """
import {Meniscus, surface, type MeniscusError} from "meniscus-surface";
const engine: Meniscus = new Meniscus();
export const s = await surface("", {name: "1ubq.pdb", spacing: 0.4, time_step: "inf", chains: ["A"], memory: "4G",
                                    interfaces: "A:B", signal: null, progress: ({stage}) => { stage.length; }});
export const bytes: Uint8Array = await s.file("residues.csv");
engine.measure({positions: new Float32Array(3), radii: [2]}).catch((error: MeniscusError) => error.code);
"""
REFUSED = """surface("", {nonsense: 1});
surface("", {method: "fast"});
surface("", {name: 5});
surface("", {progress: "x"});
surface(5);
s.file("pdb");
s.page({color: "chain"});
"""


def missing():
    packed = list(PACKAGE.parent.glob("meniscus-surface-*.tgz"))
    if not packed:
        return f"the packed npm package ({PACKAGE.parent})"
    for name in ("vite", "webpack", "esbuild", "tsc"):
        if not (TOOLS / name).exists():
            return f"{name} ({BUNDLERS})"
    if shutil.which("npm") is None:
        return "npm"
    node = subprocess.run(["node", "-p", "parseInt(process.versions.node)"], capture_output=True, text=True, check=True)
    if int(node.stdout) < 20:  # which Vite needs
        return "Node 20"
    return browser_test.missing()


class Bundlers(unittest.TestCase):
    """One project for all tests, in which each builds into a folder of its own."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-bundlers-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        for name, text in (("package.json", '{"private": true, "type": "module"}'), ("app.js", APPLICATION),
                           ("index.html", PAGE.replace("SCRIPT", "./app.js"))):
            (cls.folder / name).write_text(text, encoding="utf-8")
        shutil.copy(ROOT / "examples" / "1ubq.pdb", cls.folder)
        cls.call(f"npm install --offline --silent --no-audit --no-fund {max(PACKAGE.parent.glob('meniscus-surface-*.tgz'))}")
        cls.browser = web_browser.Browser(ROOT, PACKAGE, BUNDLERS, cls.folder)
        cls.addClassCleanup(cls.browser.close)

    @classmethod
    def call(cls, command, wrong=False):
        """What a command prints that is to succeed, or to fail if `wrong`."""
        path = f"{TOOLS}{os.pathsep}{os.environ['PATH']}"
        done = subprocess.run(["bash", "-ec", command], cwd=cls.folder, env={**os.environ, "PATH": path}, capture_output=True,
                              text=True, timeout=300, check=False)
        if (done.returncode != 0) != wrong:
            raise AssertionError(f"{command}: {done.returncode}\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}")
        return done.stdout + done.stderr

    def expect_areas(self, path):
        self.browser.open(path)
        self.expect_found()

    def expect_found(self):
        area, difference = self.browser.wait("globalThis.found")
        self.assertAlmostEqual(area, AREA, 6)
        self.assertEqual(difference, 0)
        self.assertEqual(self.browser.errors(), [])

    def write_page(self, folder, script):
        (self.folder / folder / "index.html").write_text(PAGE.replace("SCRIPT", script), encoding="utf-8")

    def test_vite_builds_it(self):
        self.assertNotIn("warn", self.call("vite build --base=./ --outDir vite").lower())
        self.expect_areas("made/vite/index.html")

    def test_vite_serves_it(self):
        with socket.socket() as chosen:
            chosen.bind(("127.0.0.1", 0))
            port = chosen.getsockname()[1]
        server = subprocess.Popen([TOOLS / "vite", "--host", "127.0.0.1", "--port", str(port), "--strictPort"], cwd=self.folder,
                                  stdout=subprocess.PIPE, text=True)
        try:
            while "Local" not in (line := server.stdout.readline()):
                self.assertTrue(line, "vite has ended")
            self.browser.driver.get(f"http://127.0.0.1:{port}/")
            self.expect_found()
        finally:
            server.terminate()
            server.communicate()

    def test_webpack_builds_it(self):
        said = self.call("webpack --mode production --entry ./app.js --output-path webpack --no-performance")
        self.assertNotIn("WARNING", said)
        self.write_page("webpack", "./main.js")
        self.expect_areas("made/webpack/index.html")

    def test_esbuild_needs_what_the_readme_says(self):
        build, copy = next(block.lines for block in README if block.info == ["sh", "esbuild"])
        self.assertNotIn("warning", self.call(build.replace("npx ", "") + " --color=false"))
        self.write_page("site", "./app.js")
        self.call(copy)
        self.expect_areas("made/site/index.html")

    def test_a_bundle_for_node_runs(self):
        self.call("esbuild app.js --bundle --format=esm --platform=node --outfile=node/app.mjs;"
                  "cp node_modules/meniscus-surface/dist/meniscus{.wasm,-worker.js} node; echo 'console.log(found[0])' >>node/app.mjs")
        self.assertIn("50.2654824", self.call("node node/app.mjs"))

    def test_the_import_map_of_the_readme_works(self):
        page = next(block.text for block in README if block.kind == "html")
        (self.folder / "map.html").write_text(HEAD + page, encoding="utf-8")
        self.browser.open("made/map.html")
        text = self.browser.wait("document.body.innerText.includes('colours') && document.body.innerText")
        self.assertIn("SES area 36.32 Å²; colours: element", text)
        self.assertEqual(self.browser.errors(), [])

    def test_the_readme_runs_in_node(self):
        text = next(block.text for block in README if block.kind == "js")
        read = 'await (await import("node:fs/promises")).readFile("1ubq.pdb", "utf8");\n'
        text, count = re.subn(r"await \(await fetch\(.*?\n", read, text)
        self.assertEqual(count, 1)
        text += "console.log(s.report.mesh.area, bytes.length, m.sas.length);\n"
        (self.folder / "readme.mjs").write_text(text, encoding="utf-8")
        area, size, spheres = map(float, self.call("node readme.mjs").split())
        self.assertTrue(3800 < area < 4000 and size > 100000 and spheres == 2, (area, size, spheres))

    def test_types_accept_what_is_declared_and_nothing_else(self):
        check = "tsc --strict --noEmit --target es2022 --module nodenext --moduleResolution nodenext --lib es2022,dom"
        (self.folder / "typed.ts").write_text(TYPED, encoding="utf-8")
        self.call(f"{check} --ignoreConfig typed.ts")
        (self.folder / "refused.ts").write_text(TYPED + REFUSED, encoding="utf-8")
        said = self.call(f"{check} --ignoreConfig refused.ts", wrong=True)
        first = TYPED.count("\n") + 1
        lines = {int(line) - first for line in re.findall(r"^refused\.ts\((\d+),", said, re.MULTILINE)}
        self.assertEqual(lines, set(range(REFUSED.count("\n"))), said)


if __name__ == "__main__":
    if lacking := missing():
        print(f"SKIPPED: bundlers are not tested: {lacking} is missing (./test --full installs it from npm's registry)")
        sys.exit(browser_test.SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)

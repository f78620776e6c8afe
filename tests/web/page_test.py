#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""meniscus.html in Chromium, opened from file:// and driven as a user would; its numbers against those of the program.

usage: page_test.py MENISCUS ROOT    skipped (77) without Chromium, its driver, Python's selenium or build/web
MENISCUS_SCREENSHOTS=FOLDER keeps pictures of it, wide and narrow, light and dark.
"""
import csv
import gzip
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from web_browser import browser_test

EXACT = ("ses_area", "ses_volume", "sas_area", "sas_volume", "contact_area", "toroidal_area", "reentrant_area")


def missing():
    return browser_test.missing() or (None if PAGE.exists() else f"{PAGE.name} (./run web makes it)")


def start_browser(folder):
    browser = browser_test.start_browser(folder / "profile", "--window-size=1280,800")
    browser.set_script_timeout(300)
    browser.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(folder / "saved")})
    return browser


def program(*arguments, **more):
    return subprocess.run([MENISCUS, *map(str, arguments)], capture_output=True, text=True, check=False, **more)


SIZES = {"float": 4, "uint": 4, "int": 4, "uchar": 1}


def ply(content):
    """Positions and normals of the vertices, and the faces, as bytes."""
    head, _, body = content.partition(b"end_header\n")
    lines = head.decode("ascii").splitlines()
    count = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    row = sum(SIZES[line.split()[1]] for line in lines if line.startswith("property") and "list" not in line)
    return b"".join(body[i * row:i * row + 24] for i in range(count)), body[count * row:]


def glb(content):
    """How many numbers there are of each kind, and between which they lie."""
    size = int.from_bytes(content[12:16], "little")
    described = json.loads(content[20:20 + size])
    attributes = described["meshes"][0]["primitives"][0]["attributes"]
    return [described["accessors"][attributes[name]] | {"bufferView": 0} for name in ("POSITION", "NORMAL")]


class MeniscusHtml(unittest.TestCase):
    """One browser for all tests; each loads the page afresh."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-web-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.saved = cls.folder / "saved"
        cls.saved.mkdir()
        cls.ubiquitin = ROOT / "examples" / "1ubq.pdb"
        (cls.folder / "zipped.pdb.gz").write_bytes(gzip.compress(cls.ubiquitin.read_bytes()))
        (cls.folder / "broken.pdb").write_text(
            "ATOM      1  N   MET A   1      27.340  24.430   2.614  1.00  9.67           N\n"
            "ATOM      2  CA  MET A   1      26.266  2x.413   2.842  1.00 10.38           C\n", encoding="ascii")
        cls.browser = start_browser(cls.folder)
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        self.browser.get_log("browser")
        self.browser.get_log("performance")
        self.browser.get(PAGE.as_uri())
        self.wait("document.body.dataset.ready === 'true'")

    def js(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def wait(self, condition, seconds=240):
        end = time.monotonic() + seconds
        while not self.js(f"return Boolean({condition})"):
            if time.monotonic() > end:
                self.fail(f"never came true: {condition}; {self.browser.get_log('browser')}; "
                          + self.js("return document.body.innerText"))
            time.sleep(0.05)

    def click(self, selector):
        self.js("const e = document.querySelector(arguments[0]); e.scrollIntoView({block: 'center'})", selector)
        self.browser.find_element("css selector", selector).click()

    def drop(self, *files):
        """Drags files from the desktop onto the middle of the page."""
        x, y = self.js("return [innerWidth / 3, innerHeight / 2]")
        data = {"items": [], "files": [str(file) for file in files], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.browser.execute_cdp_cmd("Input.dispatchDragEvent", {"type": kind, "x": x, "y": y, "data": data})

    def shown(self, name):
        self.wait(f"document.body.dataset.shown === {json.dumps(name)} || !document.getElementById('failure').hidden")
        self.assertTrue(self.js("return document.getElementById('failure').hidden"), self.text("#failure"))

    def text(self, selector):
        return self.js("return document.querySelector(arguments[0]).innerText", selector)

    def numbers(self):
        """{(section, label): text of the value}"""
        return {(section, label): value for section, label, value in self.js("""
            return [...document.querySelectorAll("#tables table")].flatMap(table => [...table.rows].map(row =>
                [table.previousElementSibling.textContent, row.cells[0].textContent, row.cells[1].firstChild.data]))""")}

    def set(self, selector, value):
        self.js("const e = document.querySelector(arguments[0]); e.value = arguments[1];"
                "e.dispatchEvent(new Event('input', {bubbles: true}))", selector, value)

    def save(self, what, name):
        """The bytes that a button saves."""
        self.begin_to_save(what)
        return self.saved_file(name)

    def begin_to_save(self, *what):
        for old in self.saved.iterdir():
            old.unlink()
        for word in what:
            self.js("document.querySelector(arguments[0]).click()", f'[data-save="{word}"]')

    def saved_file(self, name):
        end = time.monotonic() + 120
        while not (self.saved / name).exists() or list(self.saved.glob("*.crdownload")):
            if time.monotonic() > end:
                self.fail(f"{name} is not saved: {list(self.saved.iterdir())}; {self.text('#failure')}")
            time.sleep(0.05)
        return (self.saved / name).read_bytes()

    def expect_exact(self, source, *options):
        """That report and table have the numbers of `meniscus measure`."""
        report = self.folder / "measure.json"
        done = program("measure", source, *options, "--report", report, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        expected = json.loads(report.read_text(encoding="utf-8"))["exact"]
        actual = self.js("return meniscus.shown.result.report.exact")
        for key in EXACT:
            self.assertTrue(math.isclose(actual[key], expected[key], rel_tol=1e-9), f"{key}: {actual[key]} {expected[key]}")
        numbers = self.numbers()
        self.assertEqual(numbers["Solvent-excluded surface, exact", "area"], f"{expected['ses_area']:,.1f} Å²")
        self.assertEqual(numbers["Solvent-excluded surface, exact", "volume"], f"{expected['ses_volume']:,.1f} Å³")
        self.assertEqual(numbers["Solvent-accessible surface, exact", "area"], f"{expected['sas_area']:,.1f} Å²")
        self.assertIn(f"{expected['ses_area']:,.1f} Å²", self.text("#key-numbers"), "as in the table")
        self.assertIn("±", self.text("#tables"))

    def test_the_example_is_one_click_away_and_has_the_numbers_of_the_program(self):
        self.click("#example")
        self.shown("1ubq.pdb")
        self.expect_exact(self.ubiquitin)
        self.assertIn("602 atoms", self.text("#subtitle"))
        self.assertEqual(self.js("return document.title"), "1ubq · Meniscus")
        severe = [entry for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]
        self.assertEqual(severe, [])
        self.assertEqual(self.js("return document.querySelector('#remark-list').textContent"),
                         "58 waters left out (keep them with “Waters: keep”)")

    def test_nothing_is_fetched(self):
        self.click("#example")
        self.shown("1ubq.pdb")
        requests = [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")]
        urls = [r["params"]["request"]["url"] for r in requests if r["method"] == "Network.requestWillBeSent"]
        self.assertEqual([url[:80] for url in urls if not url.startswith(("data:", "blob:", "chrome:"))], [PAGE.as_uri()])
        self.js("window.got = 'nothing'; fetch('https://example.org/').then(() => { got = 'it'; }, e => { got = 'refused'; })")
        self.wait("got !== 'nothing'")
        self.assertEqual(self.js("return got"), "refused", "by the page's policy")

    def test_files_dropped_are_listed_and_switched_between(self):
        self.drop(self.ubiquitin, self.folder / "zipped.pdb.gz", ROOT / "fuzz" / "seeds" / "bcif" / "small.bcif")
        self.shown("1ubq.pdb")
        self.assertEqual(self.js("return document.querySelectorAll('#file-list li').length"), 3)
        plain = self.js("return meniscus.shown.result.report.exact.ses_area")
        self.click("#file-list li:nth-child(2) button")
        self.shown("zipped.pdb.gz")
        self.assertEqual(self.js("return meniscus.shown.result.report.exact.ses_area"), plain)
        self.click("#file-list li:nth-child(3) button")
        self.shown("small.bcif")
        self.click("#file-list li:nth-child(1) button")
        self.shown("1ubq.pdb")
        self.assertEqual(self.js("return document.querySelector('[aria-current]').innerText.split('\\n')[0]"), "1ubq.pdb")

    def test_options_are_heeded(self):
        self.set("#probe", "1.2")
        self.set("#waters", "true")
        self.set("#radii", "bondi")
        self.set("#spacing", "0.8")
        self.drop(self.ubiquitin)
        self.shown("1ubq.pdb")
        self.expect_exact(self.ubiquitin, "--probe", "1.2", "--waters", "--radii", "bondi")
        self.assertEqual(self.js("return meniscus.shown.result.report.options.spacing"), 0.8)
        self.js("document.querySelector('#settings').open = true")
        self.assertTrue(self.js("return document.querySelector('#compute').disabled"))
        self.set("#probe", "1.4")
        self.click("#compute")
        self.wait("meniscus.shown.result.report.input.probe === 1.4 && !meniscus.run")

    def test_an_option_that_makes_no_sense_is_said(self):
        self.drop(self.ubiquitin)
        self.shown("1ubq.pdb")
        self.js("document.querySelector('#settings').open = document.querySelector('#more').open = true")
        self.set("#select", "chain A and and")
        self.js("document.querySelector('#options').requestSubmit()")
        self.wait("!document.getElementById('failure').hidden")
        self.assertIn("chain A and and", self.text("#failure"))

    def test_fields_take_the_numbers_that_the_engine_takes(self):
        for name, value in (("probe", "1.45"), ("probe", "0"), ("probe", "25"), ("spacing", "0.33"), ("spacing", "3.5")):
            self.set("#" + name, value)
            self.assertEqual(self.js("return [document.querySelector('#options').checkValidity(), Settings.read()[arguments[0]]]",
                                     name), [True, float(value)])

    def test_options_that_notes_name_are_fields(self):
        one = "MODEL {0:8d}\nATOM      1  CA  GLY A   1      {0:6.3f}   0.000   0.000  1.00 10.00           C\nENDMDL\n"
        (self.folder / "models.pdb").write_text("".join(one.format(i) for i in range(1, 4)), encoding="ascii")
        self.drop(self.folder / "models.pdb")
        self.shown("models.pdb")
        self.assertIn("choose another with “Model”", self.text("#remark-list"))
        self.js("document.querySelector('#settings').open = document.querySelector('#more').open = true")
        self.set("#model", "2")
        self.click("#compute")
        self.wait("meniscus.shown.result.report.input.notes.some(n => n.includes('model 2 of 3'))")
        self.js("document.querySelector('#settings').open = document.querySelector('#more').open = true")
        self.click("#join")
        self.click("#compute")
        self.wait("meniscus.shown.result.report.input.atoms === 3 && !meniscus.run")
        for said, shown in (
                ("take all with model = join", "take all with “Model: all together”"),
                ("choose one with altloc = ID)", "choose one with “Altloc”)"),
                ("leave them out with waters = false, or keep them without this warning with waters = true)",
                 "leave them out with “Waters: leave out always”, or keep them without this warning with “Waters: keep”)"),
                ("keep them with radii = bondi)", "keep them with “Radii: bondi (1964)”)"),
                ("leave them out with select = (!NA,CL))", "leave them out with “Select: (!NA,CL)”)"),
                ("select = chain A and resi 3: understood as //A/3", "“Select: chain A and resi 3”: understood as //A/3"),
                ("1 X; give others with radii = FILE", "1 X")):
            self.assertEqual(self.js("return Settings.inFields(arguments[0])", said), shown)

    def test_every_option_that_the_library_names_is_a_field(self):
        named = {name for path in (ROOT / "src" / "structure").rglob("*.cpp")
                 for name in re.findall(r'spelling\("(\w+)"', path.read_text(encoding="utf-8"))}
        self.assertIn("altloc", named)
        fields = set(self.js("return [...document.querySelectorAll('#options [id]')].map(e => e.id)")) | {"keep_waters"}
        self.assertEqual(named - fields - {"strict_radii"}, set(), "strict radii are never asked for here")

    def test_a_folder_is_refused_and_files_beside_it_are_taken(self):
        folder = self.folder / "structures"
        folder.mkdir(exist_ok=True)
        self.drop(folder)
        self.wait("!document.getElementById('failure').hidden")
        self.assertIn("drop the files in it", self.text("#failure"))
        self.assertEqual(self.js("return meniscus.items.length"), 0)
        self.drop(folder, self.ubiquitin)
        self.wait("document.body.dataset.shown === '1ubq.pdb'")
        self.assertIn("structures", self.text("#failure"))
        self.assertEqual(self.js("return meniscus.items.length"), 1)

    def test_scales_have_digits_that_are_read(self):
        for low, high, expected in ((2.0713, 36.1378, ["2.1", "19.1", "36.1"]), (2, 72.06, ["2.0", "37.0", "72.1"]),
                                    (-5, 5, ["−5", "0", "5"]),
                                    (0, 0.123456, ["0.000", "0.062", "0.123"]), (10, 10, ["10", "10", "10"])):
            self.js("Panel.showLegend({title: '', ramp: ['#000000', '#ffffff'], min: arguments[0], max: arguments[1],"
                    " entries: []})", low, high)
            self.assertEqual(self.js("return [...document.querySelectorAll('#legend .ends span')].map(e => e.textContent)"),
                             expected)

    def test_the_start_names_every_format(self):
        for name in ("PDB", "mmCIF", "BinaryCIF", "PDBQT", "PQR", "GROMACS", "xyzr", "xyzrn"):
            self.assertIn(name, self.text("#drop").replace(",", " ").split(), name)

    def test_a_broken_file_gets_the_program_s_message(self):
        self.drop(self.folder / "broken.pdb")
        self.wait("!document.getElementById('failure').hidden")
        said = program("measure", "broken.pdb", cwd=self.folder).stderr.strip().removeprefix("meniscus: error: ")
        self.assertEqual(self.js("return document.getElementById('failure-text').textContent"), said)
        self.assertIn("broken.pdb:2:39", said)
        self.assertEqual(self.text("#file-list li span:last-child"), "failed")
        self.click("#failure-close")
        self.assertEqual(self.js("return document.getElementById('failure').hidden"), True)

    def test_what_runs_can_be_stopped_and_begun_again(self):
        self.set("#spacing", "0.2")
        self.drop(self.ubiquitin)
        self.wait("meniscus.run && !document.getElementById('busy').hidden")
        self.click("#stop")
        self.wait("!meniscus.run && document.getElementById('busy').hidden")
        self.assertEqual(self.text("#file-list li span:last-child"), "stopped")
        self.set("#spacing", "0.8")
        self.click("#compute")
        self.shown("1ubq.pdb")

    def test_after_a_stop_the_result_that_was_there_is_whole(self):
        self.drop(self.ubiquitin)
        self.shown("1ubq.pdb")
        before = self.text("#panel header") + self.text("#tables") + self.text("#file-list")
        self.slow_computation()
        self.assertIn("…", self.text("#file-list"))
        self.click("#stop")
        self.wait("document.getElementById('busy').hidden")
        self.assertEqual(self.text("#panel header") + self.text("#tables") + self.text("#file-list"), before)
        self.assertFalse(self.js("return document.getElementById('compute').disabled"), "the options are others still")

    def slow_computation(self):
        self.js("document.querySelector('#settings').open = true")
        self.set("#spacing", "0.12")
        self.click("#compute")
        self.wait("meniscus.run && document.getElementById('progress').value > 0")

    def test_what_is_shown_is_saved_whatever_else_is_computed_and_stopped(self):
        self.drop(self.ubiquitin, self.folder / "zipped.pdb.gz")
        self.shown("1ubq.pdb")
        expected = self.save("stl", "1ubq.stl")
        self.begin_to_save("stl", "obj")  # quickly, one after the other
        self.assertEqual(self.saved_file("1ubq.stl"), expected)
        self.assertGreater(len(self.saved_file("1ubq.obj")), 1000)
        self.js("document.querySelector('#settings').open = true")
        self.set("#spacing", "0.12")
        self.click("#file-list li:nth-child(2) button")
        self.wait("meniscus.run && document.getElementById('progress').value > 0")
        self.assertIn("zipped.pdb.gz: ", self.text("#busy-text"))
        self.assertEqual(self.save("stl", "1ubq.stl"), expected)
        self.assertTrue(self.js("return Boolean(meniscus.run)"), "the other one is still being computed")
        self.begin_to_save("stl", "atoms.csv")
        self.click("#stop")
        self.wait("document.getElementById('busy').hidden")
        self.assertEqual(self.saved_file("1ubq.stl"), expected)
        self.saved_file("1ubq.atoms.csv")
        self.assertEqual(self.save("stl", "1ubq.stl"), expected)
        self.assertTrue(self.js("return document.getElementById('failure').hidden"))
        self.assertEqual(self.text("#compute"), "Compute zipped.pdb.gz")

    def test_what_is_shown_is_saved_where_its_engine_has_made_room(self):
        self.drop(self.ubiquitin)
        self.shown("1ubq.pdb")
        expected = self.save("stl", "1ubq.stl")
        self.js("meniscus.release(meniscus.shown.result)")
        self.begin_to_save("stl", "obj")
        self.wait("!document.getElementById('busy').hidden")
        self.assertIn("1ubq.pdb", self.text("#busy-text"))
        self.assertEqual(self.saved_file("1ubq.stl"), expected)
        self.saved_file("1ubq.obj")
        self.wait("!meniscus.runs.length && document.getElementById('busy').hidden")
        self.assertEqual(self.js("return meniscus.held.length"), 1, "computed once")

    def test_what_is_stopped_while_its_file_is_read_is_not_begun(self):
        self.js("""
            const bytes = await (await meniscus.example()).arrayBuffer();
            let reads = 0;
            meniscus.open([{name: "1ubq.pdb", arrayBuffer: async () => {
              if (++reads === 2) meniscus.stop(meniscus.run);   // the first time is for the estimate
              return bytes;
            }}]);
            while (reads < 2) await new Promise(resolve => setTimeout(resolve, 20));
            await meniscus.newEngine().measure(bytes);   // takes as long as what must not have been begun""")
        self.assertEqual(self.text("#file-list li span:last-child"), "stopped")
        self.assertFalse(self.js("return Boolean(meniscus.items[0].result)"))
        self.assertTrue(self.js("return document.getElementById('busy').hidden"))

    def test_an_option_that_makes_no_sense_is_said_where_files_are_switched(self):
        self.drop(self.ubiquitin)
        self.shown("1ubq.pdb")
        self.js("document.querySelector('#settings').open = true")
        self.set("#spacing", "")
        self.click("#file-list li:nth-child(1) button")
        self.wait("!document.getElementById('failure').hidden")
        self.assertIn("Spacing", self.text("#failure"))

    def test_meshes_and_tables_that_are_saved_are_those_of_the_program(self):
        self.drop(self.ubiquitin)
        self.shown("1ubq.pdb")
        done = program("surface", self.ubiquitin, "-o", self.folder / "1ubq.ply", "-o", self.folder / "1ubq.glb", "-o",
                       self.folder / "1ubq.stl", "-o", self.folder / "1ubq.obj", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        for suffix in ("ply", "glb", "stl", "obj"):
            self.expect_mesh(self.save(suffix, f"1ubq.{suffix}"), (self.folder / f"1ubq.{suffix}").read_bytes(), suffix)
        for table in ("atom", "residue", "chain"):
            program("measure", self.ubiquitin, "--per", table, "-o", self.folder / "table.csv", "--quiet")
            expected = list(csv.reader((self.folder / "table.csv").read_text(encoding="utf-8").splitlines()))
            actual = list(csv.reader(self.save(f"{table}s.csv", f"1ubq.{table}s.csv").decode().splitlines()))
            self.assertEqual(actual[0], expected[0])
            self.assertEqual(len(actual), len(expected))
        report = json.loads(self.save("report.json", "1ubq.json"))
        self.assertEqual(report["input"]["atoms"], 602)

    def expect_mesh(self, actual, expected, suffix):
        """The same bytes, or the same triangles where formats have colours, which only the program writes."""
        if suffix in ("stl", "obj"):
            self.assertEqual(actual, expected, suffix)
        elif suffix == "ply":
            self.assertEqual(ply(actual), ply(expected))
        else:
            self.assertEqual(glb(actual), glb(expected))

    def test_a_picture_and_a_page_are_saved(self):
        self.drop(self.ubiquitin)
        self.shown("1ubq.pdb")
        self.assertEqual(self.save("png", "1ubq.png")[:8], b"\x89PNG\r\n\x1a\n")
        (self.folder / "page.html").write_bytes(self.save("html", "1ubq.html"))
        report = self.js("return meniscus.shown.result.report")
        self.browser.get((self.folder / "page.html").as_uri())
        self.wait("document.body.dataset.ready === 'true'")
        self.assertEqual(self.js("return meniscus.data.mesh.corners.length / 3"), report["mesh"]["triangles"])
        self.assertIn(f"{report['exact']['ses_area']:,.1f} Å²", self.text("#numbers"))
        severe = [entry for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]
        self.assertEqual(severe, [], "the policy of the page knows its scripts")

    def test_two_chains_have_an_interface(self):
        data = os.environ.get("MENISCUS_TEST_DATA")
        source = ROOT / "examples" / "1a0q.pdb" if data is None else pathlib.Path(data) / "structures" / "1a0q.pdb"
        if not source.exists():
            self.skipTest("1a0q.pdb is not there")
        self.drop(source)
        self.shown("1a0q.pdb")
        self.expect_exact(source)
        report = self.folder / "interfaces.json"
        program("measure", source, "--between", "all", "--report", report, "--quiet")
        expected = json.loads(report.read_text(encoding="utf-8"))["interfaces"]
        self.assertIn(f"{expected[0]['interface_area']:,.1f}", self.text("#interface-list"))
        cavities = [c for c in self.js("return meniscus.shown.result.report.components") if c["kind"] == "cavity"]
        self.assertEqual(self.js("return document.querySelectorAll('#cavity-list tr').length"), len(cavities))
        if "MENISCUS_SCREENSHOTS" in os.environ:
            self.photograph(pathlib.Path(os.environ["MENISCUS_SCREENSHOTS"]))

    def photograph(self, folder):
        """Pictures to look at, of docs/images, too (there in 128 colours, as docs/make_pictures makes them)."""
        for theme in ("light", "dark"):
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
                "features": [{"name": "prefers-color-scheme", "value": theme}]})
            for name, width, height in (("wide", 1100, 680), ("phone", 390, 760)):
                self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                    "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 720})
                time.sleep(1)  # until the view has been fitted and drawn
                self.browser.save_screenshot(str(folder / f"browser-{name}-{theme}.png"))
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def test_what_would_take_long_is_asked_about_first(self):
        rows = []
        for i in range(64000):  # a block of atoms, 3.2 Å apart
            x, y, z = (3.2 * (i // 40 ** k % 40) - 64 for k in range(3))
            rows.append(f"{x:.2f} {y:.2f} {z:.2f} 1.7")
        (self.folder / "block.xyzr").write_text("\n".join(rows) + "\n", encoding="ascii")
        self.set("#spacing", "0.2")
        self.drop(self.folder / "block.xyzr")
        self.wait("!document.getElementById('question').hidden")
        self.assertRegex(self.text("#question-text"), r"64,000 atoms.*\d+ (s|minutes).*\d GB")
        self.click("#question-no")
        self.wait("!meniscus.run && document.getElementById('question').hidden")
        self.set("#spacing", "0.07")
        self.click("#compute")
        self.wait("!document.getElementById('question').hidden")
        self.assertIn("Too large", self.text("#question"))
        offered = self.text("#question-coarse").split()[1]
        self.click("#question-coarse")
        self.wait("document.getElementById('progress').value > 0 || !document.getElementById('failure').hidden")
        self.assertTrue(self.js("return document.getElementById('failure').hidden && document.getElementById('question').hidden"),
                        self.text("#failure"))
        self.assertEqual(self.js("return document.querySelector('#spacing').value"), offered)
        self.assertTrue(self.js("return document.querySelector('#options').checkValidity()"))
        self.click("#stop")
        self.wait("!meniscus.run")

    def test_everything_has_a_name_and_is_reached_by_keys(self):
        unnamed = """return [...document.querySelectorAll("input, select, button, progress, [role=img], canvas")].filter(e =>
            !(e.labels && e.labels.length) && !e.getAttribute("aria-label") && !e.textContent.trim() && !e.title && e.type !== "file")
            .map(e => e.outerHTML.slice(0, 80))"""
        self.assertEqual(self.js(unnamed), [])
        self.js("document.activeElement.blur()")
        reached = set()
        for _ in range(40):
            browser_test.webdriver.ActionChains(self.browser).send_keys("\ue004").perform()  # tabulator
            reached.add(self.js("return document.activeElement.id"))
        self.assertLessEqual({"choose", "example", "theme", "probe", "spacing", "radii", "method", "waters"}, reached)
        self.js("document.getElementById('example').focus()")
        browser_test.webdriver.ActionChains(self.browser).send_keys("\ue007").perform()  # enter
        self.shown("1ubq.pdb")
        self.assertIn("role=\"status\"", self.js("return document.getElementById('busy').innerHTML"))

    def test_light_and_dark_wide_and_narrow(self):
        for theme, dark in (("light", False), ("dark", True)):
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
                "features": [{"name": "prefers-color-scheme", "value": theme}]})
            self.wait(f"document.documentElement.dataset.theme === '{theme}'")
            paper = self.js("return getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)")
            self.assertEqual(sum(paper) < 300, dark)
        for width, height in ((1280, 800), (390, 800), (320, 480)):
            self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 720})
            self.assertLessEqual(self.js("return document.documentElement.scrollWidth"), width)
            self.js("document.getElementById('example').scrollIntoView()")
            box = self.js("const b = document.getElementById('example').getBoundingClientRect(); return [b.left, b.right]")
            self.assertGreaterEqual(box[0], 0)
            self.assertLessEqual(box[1], width)
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def test_large_text_in_a_narrow_window_is_not_cut_off(self):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": 320, "height": 640, "deviceScaleFactor": 1, "mobile": True})
        self.addCleanup(self.browser.execute_cdp_cmd, "Emulation.clearDeviceMetricsOverride", {})
        self.js("document.documentElement.style.fontSize = '200%'")
        self.expect_all_within("#welcome, #tools")
        self.drop(self.ubiquitin, self.folder / "zipped.pdb.gz")
        self.shown("1ubq.pdb")
        self.js("document.body.classList.remove('folded');"
                "document.querySelector('#settings').open = document.querySelector('#more').open = true")
        self.js("""
            Tables.interfaces([{a: "A", b: "B", interface_area: 12345.6, buried_ses: 12345.6}]);
            Panel.fillCavities([{volume: 1234.5, area: 1234.5}], "", () => {})""")
        self.expect_all_within("#panel, #tools")
        self.slow_computation()
        self.expect_all_within("#busy, #panel")

    def expect_all_within(self, selector):
        self.assertEqual(self.js("""
            return [...document.querySelectorAll(arguments[0])].flatMap(box => [...box.querySelectorAll("*")])
                .filter(e => e.getClientRects().length && getComputedStyle(e).position !== "absolute")
                .filter(e => e.getBoundingClientRect().right > innerWidth || e.getBoundingClientRect().left < 0
                             || (e.id.endsWith("-box") && e.scrollWidth > e.clientWidth))
                .map(e => e.outerHTML.slice(0, 80))""", selector), [])


if __name__ == "__main__":
    MENISCUS, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    PAGE = ROOT / "build" / "web" / "meniscus.html"
    LACKING = missing()
    if LACKING:
        print(f"SKIPPED: meniscus.html is not tested in a browser: {LACKING} is missing (./test --full brings it)")
        sys.exit(browser_test.SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)

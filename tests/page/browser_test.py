#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Pages in Chromium, opened from file:// and driven as a reader would.

usage: browser_test.py MENISCUS ROOT    skipped (77) without Chromium, its driver or Python's selenium
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import hostile

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
except ImportError:
    webdriver = None

SKIPPED = 77
FLAGS = ("--headless=new --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --disable-quic "
         "--no-first-run --disable-background-networking --disable-component-update --disable-sync").split()


def missing():
    if webdriver is None:
        return "Python's selenium (python3-selenium)"
    for program in ("chromium", "chromedriver"):
        if shutil.which(program) is None:
            return program
    return None


def start_browser(profile, *flags):
    options = Options()
    options.binary_location = shutil.which("chromium")
    for flag in (*FLAGS, "--window-size=1200,800", f"--user-data-dir={profile}", *flags):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


def shell_of_atoms():
    """mmCIF: atoms on a sphere of 6 Å, so dense that no probe gets in; names as hostile as mmCIF allows."""
    rows = ["data_shell", "loop_", *("_atom_site." + tag for tag in (
        "group_PDB id type_symbol label_atom_id label_alt_id label_comp_id label_asym_id label_entity_id label_seq_id "
        "pdbx_PDB_ins_code Cartn_x Cartn_y Cartn_z occupancy B_iso_or_equiv auth_seq_id auth_asym_id "
        "pdbx_PDB_model_num").split())]
    count, golden = 150, 2.399963
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        r = (1 - z * z) ** 0.5
        x, y, z = 6 * r * math.cos(golden * i), 6 * r * math.sin(golden * i), 6 * z
        rows.append(f"ATOM {i + 1} C '<b>x</b>' . '</script>' X 1 {i + 1} ? {x:.3f} {y:.3f} {z:.3f} 1.0 "
                    f"{10 + i / 10:.2f} {i + 1} '<img/src=x/onerror=document.title=1>' 1")
    return "\n".join(rows) + "\n"


def ligand_behind_shell():
    """mmCIF: two atoms of a ligand that the shell hides in front view, its cavity does not."""
    rows = (f"HETATM {151 + i} C C{i} . LIG Z 2 . ? 5.5 {1.5 * i:.3f} -8 1.0 10 901 Z 1" for i in range(2))
    return shell_of_atoms() + "\n".join(rows) + "\n"


def ligand_in_shell():
    """mmCIF: two atoms of a ligand in the middle of that shell."""
    rows = (f"HETATM {151 + i} C C{i} . LIG Z 2 . ? {1.5 * i:.3f} 0 0 1.0 10 901 Z 1" for i in range(2))
    return shell_of_atoms() + "\n".join(rows) + "\n"


class PageTest(unittest.TestCase):
    """One browser for all tests; each loads the page afresh."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-page-"))
        (cls.folder / "shell.cif").write_text(shell_of_atoms(), encoding="utf-8")
        (cls.folder / "ligand.cif").write_text(ligand_in_shell(), encoding="utf-8")
        (cls.folder / "behind.cif").write_text(ligand_behind_shell(), encoding="utf-8")
        (cls.folder / "score.csv").write_text("serial,score\n" + "".join(f"{i + 1},{-1 if i < 50 else 1}\n"
                                                                        for i in range(100)), encoding="ascii")
        (cls.folder / hostile.FILE_NAME).write_text(hostile.mmcif(), encoding="utf-8")
        cls.report = {}
        for name, source, *more in (("1ubq", ROOT / "examples" / "1ubq.pdb"), ("shell", cls.folder / "shell.cif"),
                                    ("ligand", cls.folder / "ligand.cif"),
                                    ("behind", cls.folder / "behind.cif", "--view", "front"),
                                    ("scored", cls.folder / "shell.cif", "--values", cls.folder / "score.csv"),
                                    ("hostile", cls.folder / hostile.FILE_NAME)):
            subprocess.run([MENISCUS, "surface", source, *more, "-o", cls.folder / f"{name}.html", "--report",
                            cls.folder / f"{name}.json", "--quiet", "--spacing", "0.8"], check=True, stderr=subprocess.DEVNULL)
            cls.report[name] = json.loads((cls.folder / f"{name}.json").read_text(encoding="utf-8"))
        subprocess.run([MENISCUS, "pockets", ROOT / "examples" / "1ubq.pdb", "-o", cls.folder / "pockets.html", "--report",
                        cls.folder / "pockets.json", "--quiet", "--count", "3", "--tunnels", "--pore", "z"], check=True, stderr=subprocess.DEVNULL)
        cls.report["pockets"] = json.loads((cls.folder / "pockets.json").read_text(encoding="utf-8"))
        cls.browser = start_browser(cls.folder / "profile")

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        shutil.rmtree(cls.folder, ignore_errors=True)

    def load(self, name):
        self.browser.get_log("browser")
        self.browser.get_log("performance")
        self.browser.get((self.folder / f"{name}.html").as_uri())
        self.wait("document.body.dataset.ready === 'true'")

    def js(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def wait(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while not self.js(f"return Boolean({condition})"):
            if time.monotonic() > end:
                self.fail(f"never came true: {condition}; {self.browser.get_log('browser')}")
            time.sleep(0.05)

    def click(self, selector):
        self.browser.find_element("css selector", selector).click()

    def choose(self, selector, value, event):
        self.js("const e = document.querySelector(arguments[0]); e.value = arguments[1];"
                "e.dispatchEvent(new Event(arguments[2]))", selector, value, event)

    def pixels(self):
        """Mean colour of the middle of the canvas."""
        return self.js("""meniscus.drawNow();
            const g = meniscus.renderer.getContext(), w = g.drawingBufferWidth, h = g.drawingBufferHeight, n = 40;
            const bytes = new Uint8Array(4 * n * n), sum = [0, 0, 0];
            g.readPixels((w - n) / 2, (h - n) / 2, n, n, g.RGBA, g.UNSIGNED_BYTE, bytes);
            for (let i = 0; i < bytes.length; ++i) if (i % 4 < 3) sum[i % 4] += bytes[i] / (n * n);
            return sum""")

    def click_canvas(self, x=0, y=0):
        """x, y: from the middle of the canvas, pixels."""
        canvas = self.browser.find_element("id", "view")
        webdriver.ActionChains(self.browser).move_to_element_with_offset(canvas, x, y).click().perform()

    def click_ligand(self):
        """On its first atom, whatever is before it."""
        self.click_canvas(*self.js("""meniscus.drawNow();
            const p = new THREE.Vector3(...meniscus.data.ligands.atoms.points.slice(0, 3)).project(meniscus.controls.camera);
            return [p.x * meniscus.canvas.clientWidth / 2, -p.y * meniscus.canvas.clientHeight / 2]"""))

    def test_nothing_is_wrong_and_nothing_is_fetched(self):
        self.load("1ubq")
        self.js("meniscus.setAtoms('sticks'); meniscus.setAtoms('spheres'); meniscus.setCut(0.5); meniscus.drawNow()")
        errors = [entry for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]
        self.assertEqual(errors, [])
        requests = [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")]
        urls = [r["params"]["request"]["url"] for r in requests if r["method"] == "Network.requestWillBeSent"]
        self.assertEqual([url for url in urls if not url.startswith(("file:", "data:", "blob:"))], [])
        self.assertEqual(len([url for url in urls if url.startswith("file:")]), 1)

    def test_all_of_the_mesh_arrives(self):
        self.load("1ubq")
        mesh = self.report["1ubq"]["mesh"]
        self.assertEqual(self.js("return meniscus.data.mesh.corners.length / 3"), mesh["triangles"])
        self.assertEqual(self.js("return meniscus.data.mesh.points.length / 3"), mesh["vertices"])
        volume = self.js("""const {points: p, corners: c} = meniscus.data.mesh; let sum = 0;
            for (let t = 0; t < c.length; t += 3) {
              const [a, b, d] = [0, 1, 2].map(k => [0, 1, 2].map(i => p[3 * c[t + k] + i]));
              sum += a[0] * (b[1] * d[2] - b[2] * d[1]) + a[1] * (b[2] * d[0] - b[0] * d[2])
                   + a[2] * (b[0] * d[1] - b[1] * d[0]);
            } return sum / 6""")
        self.assertAlmostEqual(volume / mesh["volume"], 1, places=4)

    def test_the_surface_is_drawn_and_takes_on_other_colours(self):
        self.load("1ubq")
        before = self.pixels()
        self.assertLess(before[0], before[2] - 20, "one colour: blue")
        self.choose("#scheme", "hydrophobicity", "change")
        after = self.pixels()
        self.assertGreater(sum(abs(a - b) for a, b in zip(before, after)), 20)
        self.assertEqual(self.js("return document.querySelector('#legend').hidden"), False)

    def test_values_have_their_colours_and_grey_where_there_is_none(self):
        self.load("scored")
        self.choose("#scheme", "score", "change")
        self.js("meniscus.drawNow()")
        steps = self.js("return [...meniscus.data.mesh.values[0]]")
        self.assertEqual(set(steps), {0, 32000, -1})
        self.assertEqual(self.js("return meniscus.surface.uniforms.value.value"), 2)
        self.assertIn("no value", self.js("return document.querySelector('#legend').textContent"))

    def test_a_click_tells_what_is_there(self):
        self.load("1ubq")
        self.click_canvas()
        self.wait("!document.getElementById('picked').hidden")
        facts = self.js("return document.getElementById('picked').innerText")
        for word in ("atom", "residue", "patch", "curvature", "chain"):
            self.assertIn(word, facts)
        self.assertRegex(facts, r"[A-Z]{3} \d+")
        width, height = self.js("return [meniscus.canvas.clientWidth, meniscus.canvas.clientHeight]")
        self.click_canvas(20 - width // 2, height // 2 - 20)
        self.wait("document.getElementById('picked').hidden")

    def test_dragging_turns_and_the_wheel_zooms(self):
        self.load("1ubq")
        before = self.js("return meniscus.controls.view.turn.toArray()")
        canvas = self.browser.find_element("id", "view")
        webdriver.ActionChains(self.browser).move_to_element(canvas).click_and_hold().move_by_offset(
            60, 30).release().perform()
        self.assertNotEqual(self.js("return meniscus.controls.view.turn.toArray()"), before)
        half = self.js("return meniscus.controls.view.half")
        webdriver.ActionChains(self.browser).scroll_from_origin(
            webdriver.common.actions.wheel_input.ScrollOrigin.from_element(canvas), 0, -300).perform()
        self.assertLess(self.js("return meniscus.controls.view.half"), half)
        self.click("#reset")
        self.wait(f"Math.abs(meniscus.controls.view.half - {half}) < 1e-6")

    def test_two_fingers_zoom(self):
        self.load("1ubq")
        half = self.js("return meniscus.controls.view.half")
        for kind, spread in (("touchStart", 20), ("touchMove", 60), ("touchMove", 100), ("touchEnd", None)):
            points = [] if spread is None else [{"x": 400 + s * spread, "y": 400, "id": 1 + (s > 0)} for s in (-1, 1)]
            self.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        self.assertAlmostEqual(self.js("return meniscus.controls.view.half"), half / 5, delta=0.1 * half)
        self.assertTrue(self.js("return document.getElementById('picked').hidden"), "that was no click")

    def test_keys_do_what_the_mouse_does(self):
        self.load("1ubq")
        turn, half = self.js("return [meniscus.controls.view.turn.toArray(), meniscus.controls.view.half]")
        canvas = self.browser.find_element("id", "view")
        canvas.send_keys("\ue012+")   # arrow to the left
        self.assertNotEqual(self.js("return meniscus.controls.view.turn.toArray()"), turn)
        self.assertLess(self.js("return meniscus.controls.view.half"), half)
        canvas.send_keys("p")
        self.assertTrue(self.js("return document.body.classList.contains('folded')"))
        canvas.send_keys("r")
        self.wait("!meniscus.controls.flying && meniscus.controls.atFirst")

    def test_a_cut_shows_the_inside(self):
        self.load("1ubq")
        self.choose("#clip", "500", "input")
        self.assertEqual(self.js("meniscus.setTheme('light'); return meniscus.surface.uniforms.cut.value"), True)
        red, green, blue = self.pixels()
        self.assertGreater(red, blue, "the inside is sand-coloured, not blue")

    def test_atoms_lie_beneath_a_surface_that_lets_one_see_them(self):
        self.load("1ubq")
        self.js("document.getElementById('atoms-sticks').click()")
        self.assertLess(self.js("return meniscus.surface.opacity"), 1)
        bonds = self.js("return meniscus.atoms.sticks.geometry.maxInstancedCount / 2")
        self.assertGreater(bonds, 600)
        self.assertLess(bonds, 640)   # 602 atoms, few rings
        self.choose("#opacity", "0", "input")
        self.pixels()

    def test_a_cavity_is_listed_and_flown_to(self):
        self.load("shell")
        cavities = [c for c in self.report["shell"]["components"] if c["kind"] == "cavity"]
        self.assertEqual(len(cavities), 1)
        row = self.js("return document.querySelector('#cavity-list tr').innerText")
        self.assertIn(f"{cavities[0]['ses_volume']:.1f}", row)
        self.assertIn(f"{cavities[0]['ses_area']:.1f}", row)
        half = self.js("return meniscus.controls.view.half")
        self.click("#cavity-list button")
        self.wait(f"meniscus.controls.view.half !== {half} && !meniscus.controls.flying")
        centre = self.js("return meniscus.controls.view.centre.toArray().map((c, k) => c + meniscus.info.low[k])")
        for a, b in zip(centre, cavities[0]["centre"]):
            self.assertAlmostEqual(a, b, places=3)
        self.assertLess(self.js("return meniscus.surface.opacity"), 1)

    def test_pockets_are_bodies_listed_and_flown_to(self):
        self.load("pockets")
        pockets = self.report["pockets"]["pockets"]
        rows = self.js("return [...document.getElementById('pocket-list').rows].map(row => row.innerText)")
        self.assertEqual(len(rows), len(pockets))
        self.assertIn(f"{pockets[0]['score']:.2f}", rows[0])
        self.assertLess(self.js("return meniscus.surface.opacity"), 1)
        with_bodies = self.pixels()
        self.click("#bodies")
        self.assertNotEqual(self.pixels(), with_bodies)
        self.click("#bodies")
        self.assertEqual(self.pixels(), with_bodies)
        half = self.js("return meniscus.controls.view.half")
        self.click("#pocket-list tr:nth-child(2) button")
        self.wait(f"meniscus.controls.view.half !== {half} && !meniscus.controls.flying")
        centre = self.js("return meniscus.controls.view.centre.toArray().map((c, k) => c + meniscus.info.low[k])")
        for a, b in zip(centre, pockets[1]["centre"]):
            self.assertAlmostEqual(a, b, places=3)
        self.assertEqual(self.js("return document.getElementById('picked-name').innerText"), "Pocket 2")

    def test_tunnels_are_tubes_listed_plotted_and_flown_to(self):
        self.load("pockets")
        report = self.report["pockets"]
        ways = [*report["tunnels"], report["pore"]]
        rows = self.js("return [...document.getElementById('way-list').rows].map(row => row.innerText)")
        self.assertEqual(len(rows), len(ways))
        for row, way in zip(rows, ways):
            self.assertIn(f"{way['bottleneck_radius']:.2f}", row)
        self.assertTrue(rows[-1].startswith("pore"))
        plot = "document.getElementById('profile')"
        first = self.js(f"return {plot}.querySelector('.curve').getAttribute('d')")
        half = self.js("return meniscus.controls.view.half")
        self.click("#way-list tr:last-child button")
        self.wait(f"meniscus.controls.view.half !== {half} && !meniscus.controls.flying")
        centre = self.js("return meniscus.controls.view.centre.toArray().map((c, k) => c + meniscus.info.low[k])")
        for a, b in zip(centre, report["pore"]["bottleneck"]):
            self.assertAlmostEqual(a, b, places=3)
        self.assertEqual(self.js("return document.getElementById('picked-name').innerText"), "Pore")
        along = [b - a for a, b in zip(*(report["pore"]["profile"][i]["position"] for i in (0, -1)))]
        towards = self.js("return meniscus.controls.view.axis(0, 0, 1).toArray()")   # seen from the side
        self.assertAlmostEqual(sum(a * b for a, b in zip(along, towards)) / math.hypot(*along), 0, places=4)
        curve = self.js(f"return {plot}.querySelector('.curve').getAttribute('d')")
        self.assertNotEqual(curve, first)
        # The curve comes nearest to the axis where the bottleneck is marked.
        lowest = max((tuple(map(float, pair.split())) for pair in curve[1:].split("L")), key=lambda place: place[1])
        mark = self.js(f"const c = {plot}.querySelector('circle'); return ['cx', 'cy'].map(a => +c.getAttribute(a))")
        self.assertAlmostEqual(mark[0], lowest[0], delta=2)
        self.assertAlmostEqual(mark[1], lowest[1], delta=0.5)
        self.assertEqual(self.js(f"return {plot}.querySelector('.of-bottleneck').textContent"),
                         f"{report['pore']['bottleneck_radius']:.2f} Å")
        with_tubes = self.pixels()
        self.click("#tubes")
        self.assertNotEqual(self.pixels(), with_tubes)
        self.click("#tubes")
        self.assertEqual(self.pixels(), with_tubes)

    def test_the_list_of_cavities_names_the_ligands_left_out(self):
        for page, shown in (("shell", None), ("ligand", "Ligands that may fill them were left out: 1 LIG")):
            self.load(page)
            self.assertEqual(self.js("const p = document.getElementById('left-out'); return p.hidden ? null : p.innerText"),
                             shown)

    def test_ligands_are_seen_and_clicked_through_a_translucent_surface(self):
        self.load("shell")
        self.assertTrue(self.js("return document.getElementById('ligand-row').hidden"))
        self.load("behind")
        self.assertEqual(self.js("return document.getElementById('ligand-names').textContent"), "1 LIG")
        self.assertEqual(self.js("const {atoms, bonds} = meniscus.data.ligands; return [atoms.count, bonds.length / 2]"), [2, 1])
        name = "return document.getElementById('picked-name').textContent"
        self.click_ligand()
        self.assertNotIn("LIG", self.js(name))
        self.choose("#opacity", "40", "input")
        self.click_ligand()
        self.assertIn("LIG", self.js(name))
        self.assertIn("beside the surface", self.js("return document.getElementById('picked').textContent"))
        self.click("#ligands")
        self.click_ligand()
        self.assertNotIn("LIG", self.js(name))
        self.load("ligand")  # in a cavity
        self.choose("#opacity", "40", "input")
        self.click_ligand()
        self.assertIn("LIG", self.js(name))

    def test_names_of_the_input_stay_text(self):
        self.load("shell")
        self.click_canvas()
        self.wait("!document.getElementById('picked').hidden")
        self.assertIn("</SCRIPT>", self.js("return document.getElementById('picked-name').textContent"))
        self.assertIn("<img/src=x", self.js("return document.getElementById('picked').textContent"))
        self.choose("#scheme", "bfactor", "change")
        self.assertEqual(self.js("return document.images.length"), 1, "the picture alone")
        self.assertNotEqual(self.js("return document.title"), "1")
        self.assertEqual(self.js("return document.querySelectorAll('#stage b, #panel b').length"), 0)

    def test_names_that_are_scripts_never_run(self):
        self.load("hostile")
        self.assertIn(hostile.FILE_NAME.removesuffix(".cif"), self.js("return document.querySelector('h1').textContent"))
        for scheme in self.js("return [...document.querySelectorAll('#scheme option')].map(o => o.value)"):
            self.choose("#scheme", scheme, "change")  # each has a legend of its own
        shown = set()
        width = self.js("return meniscus.canvas.clientWidth")
        for x in range(-width // 2 + 10, width // 2, 12):  # along the row of atoms, past the panel
            self.js("document.getElementById('unpick').click()")
            self.click_canvas(x)
            shown.add(self.js("return document.getElementById('picked').textContent"))
        facts = "".join(shown)
        for payload in hostile.PAYLOADS:
            self.assertIn(payload.split("\n")[0], facts)
        self.assertIsNone(self.js("return window.intruder ?? null"))
        self.assertEqual(self.js("return document.images.length"), 1, "the picture alone")
        self.assertEqual(self.js("return document.querySelectorAll('[onerror], [onload], [onfocus], [autofocus]').length"), 0)
        errors = [entry for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]
        self.assertEqual(errors, [], "the policy had nothing to refuse either")

    def test_nothing_but_the_page_s_own_scripts_can_run(self):
        self.load("1ubq")
        self.js("""const s = document.createElement('script'); s.textContent = 'window.intruder = 1';
            document.body.append(s); document.body.insertAdjacentHTML('beforeend', '<img src=x: onerror="intruder = 2">')""")
        time.sleep(0.2)
        self.assertIsNone(self.js("return window.intruder || null"))

    def test_light_and_dark(self):
        self.load("1ubq")
        for theme, dark in (("light", False), ("dark", True)):
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
                "features": [{"name": "prefers-color-scheme", "value": theme}]})
            self.wait(f"document.documentElement.dataset.theme === '{theme}'")
            paper = self.js("return meniscus.renderer.getClearColor().r")
            self.assertEqual(paper < 0.5, dark)


class WithoutWebGl(unittest.TestCase):
    """What is left where nothing can be drawn."""

    def test_there_is_a_picture_and_the_numbers(self):
        with tempfile.TemporaryDirectory(prefix="meniscus-page-") as folder:
            page = pathlib.Path(folder) / "1ubq.html"
            subprocess.run([MENISCUS, "surface", ROOT / "examples" / "1ubq.pdb", "-o", page, "--quiet"], check=True,
                           stderr=subprocess.DEVNULL)
            browser = start_browser(pathlib.Path(folder) / "profile", "--disable-3d-apis")
            try:
                browser.get(page.as_uri())
                time.sleep(1)
                width, notice, numbers = browser.execute_script(
                    "const p = document.getElementById('picture');"
                    "return [p.offsetWidth && p.naturalWidth, document.getElementById('notice').textContent,"
                    "        document.getElementById('numbers').innerText]")
            finally:
                browser.quit()
            self.assertEqual(width, 640)
            self.assertIn("WebGL", notice)
            self.assertIn("Å²", numbers)


if __name__ == "__main__":
    MENISCUS, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    LACKING = missing()
    if LACKING:
        print(f"SKIPPED: pages are not tested in a browser: {LACKING} is missing (./test --full installs it)")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The surface in Mol*, 3Dmol.js and NGL: the example pages in Chromium, driven as a reader would.

usage: adapters_test.py MENISCUS ROOT PACKAGE VIEWERS [PICTURES]
PACKAGE is the folder of the built npm package; VIEWERS has node_modules with molstar, 3dmol and ngl; PICTURES is a folder
for screenshots. Skipped (77) where one of these, Chromium, its driver or Python's selenium is missing.
"""
import base64
import functools
import http.server
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "page"))
import browser_test  # noqa: E402  its flags, and how it starts a browser

try:
    from PIL import Image
    from selenium import webdriver
except ImportError:
    Image = webdriver = None

VIEWERS = {"molstar": "build/viewer/molstar.js", "3dmol": "build/3Dmol-min.js", "ngl": "dist/ngl.js"}
SCHEMES = ("element", "chain", "residue", "hydrophobicity", "patch", "component")

# Of each viewer, in its own words: what it draws, whether the surface is there, where a point is in the window, and
# the direction in which its camera lies.
PROBES = {
    "molstar": """
        const canvas = shown.plugin.canvas3d, cell = shown.plugin.state.data.cells.get(shown.representation);
        const values = cell?.obj?.data.repr.renderObjects[0].values;
        return {
          there: cell !== undefined, vertices: values?.uVertexCount.ref.value, corners: values?.drawCount.ref.value,
          place: p => { const [x, y] = canvas.camera.project([0, 0, 0, 0], p), box = canvas.webgl.gl.canvas.getBoundingClientRect();
                        const ratio = canvas.webgl.gl.drawingBufferWidth / box.width;
                        return [box.left + x / ratio, box.bottom - y / ratio]; },
          towards: [0, 1, 2].map(k => canvas.camera.state.position[k] - canvas.camera.state.target[k]),
        };""",
    "3dmol": """
        const {viewer, shapes} = shown, groups = shapes.flatMap(shape => shape.geo.geometryGroups);
        const sum = key => groups.reduce((total, group) => total + group[key], 0), [, , , , x, y, z, w] = viewer.getView();
        return {
          there: shapes.every(shape => viewer.shapes.includes(shape)), vertices: sum("vertices"), corners: sum("faceidx"),
          place: p => { const at = viewer.modelToScreen({x: p[0], y: p[1], z: p[2]}); return [at.x, at.y]; },
          towards: [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        };""",
    "ngl": """
        const {stage, component, buffer} = shown, box = stage.viewer.renderer.domElement.getBoundingClientRect();
        const inverse = stage.viewer.rotationGroup.matrix.clone().invert(), vector = component.getCenter().clone();
        return {
          there: stage.compList.includes(component), vertices: buffer.geometry.attributes.position.count,
          corners: buffer.geometry.index.count,
          place: p => { const at = stage.viewerControls.getPositionOnCanvas(vector.clone().fromArray(p));
                        return [box.left + at.x, box.bottom - at.y]; },
          towards: vector.clone().set(0, 0, -stage.viewer.camera.position.z < 0 ? 1 : -1).transformDirection(inverse).toArray(),
        };""",
}

# Vertices that stick out towards the reader: what is farthest in a direction hides nothing and is not hidden.
OUTERMOST = """
    const {positions, atom} = shown.surface, {place, towards} = (() => { PROBE })(), length = Math.hypot(...towards);
    const ways = [[0, 0, 0], [.5, 0, 0], [0, .5, 0], [-.3, .3, .3], [0, -.4, -.4]];
    return ways.map(way => way.map((x, k) => x + towards[k] / length)).map(way => {
      let best = 0, height = -Infinity;
      for (let v = 0; v < atom.length; ++v) {
        const h = positions[3 * v] * way[0] + positions[3 * v + 1] * way[1] + positions[3 * v + 2] * way[2];
        if (h > height) [best, height] = [v, h];
      }
      return {atom: atom[best], serial: shown.surface.atoms.serial[atom[best]],
              place: place(Array.from(positions.subarray(3 * best, 3 * best + 3)))};
    });"""


# The arrays that a test has laid out, as s.
READ = """
    const s = await (await fetch("/made/surface.json")).json();
    for (const [key, Type] of Object.entries({positions: Float32Array, normals: Float32Array, indices: Uint32Array,
                                              atom: Uint32Array, patch: Uint8Array, component: Uint32Array}))
      if (s[key]) s[key] = Type.from(s[key]);
"""


class Server(http.server.SimpleHTTPRequestHandler):
    """The repository, with the built package as web/ and the viewers where npm would put them."""

    def __init__(self, *arguments, places, **more):
        self.places = places
        super().__init__(*arguments, **more)

    def translate_path(self, path):
        path = path.split("?")[0].split("#")[0]
        start, folder = next((s, f) for s, f in self.places if path.startswith(s))
        return str(folder / path[len(start):])

    def end_headers(self):
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def log_message(self, *_):
        pass


def serve(places):
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Server, places=places))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server


class BrowserTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-web-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.server = serve((("/web/node_modules/", VIEWER_FOLDER), ("/web/", PACKAGE), ("/made/", cls.folder), ("/", ROOT)))
        cls.addClassCleanup(cls.server.server_close)
        cls.addClassCleanup(cls.server.shutdown)
        cls.browser = browser_test.start_browser(cls.folder / "profile", "--window-size=800,600")
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.set_script_timeout(120)

    def open(self, path):
        self.browser.get_log("browser")
        self.browser.get(f"http://127.0.0.1:{self.server.server_port}/{path}")

    def js(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def wait(self, condition, seconds=90):
        end = time.monotonic() + seconds
        while not (value := condition() if callable(condition) else self.js(f"return {condition}")):
            if time.monotonic() > end:
                self.fail(f"never came true: {condition}; {self.js('return document.body.innerText')}; {self.browser.get_log('browser')}")
            time.sleep(0.1)
        return value

    def assert_no_errors(self):
        self.assertEqual([entry for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"], [])


class Examples:
    """What holds of each page."""

    NAME = ""

    def setUp(self):
        self.load()

    def load(self):
        self.open(f"web/examples/{self.NAME}.html")
        self.wait("document.body.dataset.ready === '1ubq.pdb'")

    def probe(self, member):
        return self.js(f"return (() => {{ {PROBES[self.NAME]} }})().{member}")

    def picture(self):
        return Image.open(io.BytesIO(base64.b64decode(self.browser.get_screenshot_as_base64()))).convert("RGB")

    def box(self):
        """The viewer's left, top, right and bottom in the window."""
        return self.js("const b = document.getElementById('view').getBoundingClientRect();"
                       "return [b.left, b.top, b.right, b.bottom]")

    def share(self, like):
        """The share of the viewer's pixels that are `like` what is asked for."""
        pixels = numpy.asarray(self.picture().crop([int(x) for x in self.box()])).astype(int)
        return like(pixels[..., 0], pixels[..., 1], pixels[..., 2]).mean()

    def update(self, options):
        self.js("const done = arguments[1]; return shown.update(arguments[0])", options)

    def keep(self, name):
        if PICTURES:
            self.picture().save(PICTURES / f"{self.NAME}-{name}.png")

    def test_all_of_the_mesh_is_drawn(self):
        vertices, corners = self.js("return [shown.surface.positions.length / 3, shown.surface.indices.length]")
        self.assertGreater(vertices, 10000)
        self.assertEqual(self.probe("corners"), corners)
        self.assertGreaterEqual(self.probe("vertices"), vertices)
        self.assertIn(f"{vertices} vertices", self.js("return document.getElementById('status').textContent"))
        self.assert_no_errors()

    def test_colours_arrive_on_the_screen_and_remove_removes(self):
        self.assertTrue(self.wait(lambda: self.share(lambda r, g, b: r + g + b < 720) > 0.08), "something is drawn")
        self.keep("element")
        magenta = lambda r, g, b: (r > 2 * g + 20) & (b > 2 * g + 20)
        self.assertLess(self.share(magenta), 0.001)
        self.update({"colour": "#ff00ff", "opacity": 1})
        self.wait(lambda: self.share(magenta) > 0.08)
        self.update({"colour": "patch", "opacity": 0.6})
        self.wait(lambda: self.share(magenta) < 0.001)
        self.keep("patch")
        self.assertTrue(self.probe("there"))
        self.update({"colour": "rebeccapurple", "opacity": 1})
        purple = lambda r, g, b: (b > r + 15) & (r > g + 10)
        self.wait(lambda: self.share(purple) > 0.08)
        self.js("return shown.remove()")
        self.wait(lambda: self.share(purple) < 0.005)
        self.assertFalse(self.probe("there"))
        self.assert_no_errors()

    def outermost(self):
        """Vertices in front, once the camera has come to rest."""
        left, top, right, bottom = self.box()
        looks = []

        def at_rest():
            looks.append(self.js(OUTERMOST.replace("PROBE", PROBES[self.NAME])))
            time.sleep(0.5)
            inside = all(left < f["place"][0] < right and top < f["place"][1] < bottom for f in looks[-1])
            return inside and looks[-1] == looks[-2:][0] and len(looks) > 1

        self.wait(at_rest)
        return looks[-1]

    def point(self, place):
        """Moves the pointer there, from a little beside it, as a hand would."""
        mouse = webdriver.common.actions.action_builder.ActionBuilder(self.browser)
        for x, y in ((place[0] + 3, place[1] + 3), place):
            mouse.pointer_action.move_to_location(int(round(x)), int(round(y)))
        mouse.perform()

    def beside(self):
        """A place in the viewer where nothing is drawn."""
        left, top, _, bottom = self.box()
        return [left + 60, (top + bottom) / 2]

    def named(self, place):
        self.point(place)
        time.sleep(1.0)  # viewers wait until the pointer rests
        return self.js("return document.getElementById('atom').textContent")

    def test_the_atom_under_the_pointer_is_named(self):
        found = self.outermost()
        self.assertGreater(len({f["atom"] for f in found}), 2)
        names = self.js("const {atomName} = await import('/web/adapters/names.js');"
                        "return arguments[0].map(f => atomName(shown.surface, f.atom))", found)
        self.wait(lambda: self.named(found[0]["place"]) == names[0], 60)
        self.assertEqual([self.named(f["place"]) for f in found], names)
        self.assertEqual(self.named(self.beside()), "")
        self.assert_no_errors()

    def test_names_of_atoms_stay_text(self):
        found = self.outermost()[0]
        self.wait(lambda: self.named(found["place"]) != "", 60)
        images = self.js("return document.images.length")
        self.js("shown.surface.atoms.name[arguments[0]] = '<img src=x onerror=\"intruder = 1\">'", found["atom"])
        self.named(self.beside())
        self.assertIn("<img", self.named(found["place"]))
        self.assertEqual(self.js("return [window.intruder ?? null, document.images.length]"), [None, images])

    def test_another_file_takes_its_place(self):
        self.browser.find_element("id", "file").send_keys(str(ROOT / "examples" / "1a0q.pdb"))
        self.wait("document.body.dataset.ready === '1a0q.pdb'", 180)
        vertices, corners = self.js("return [shown.surface.positions.length / 3, shown.surface.indices.length]")
        self.assertGreater(vertices, 65536, "more than 16 bits can number")
        self.assertEqual(self.probe("corners"), corners)
        self.browser.find_element("css selector", "#colour option:nth-child(2)").click()
        orange = lambda r, g, b: (r > b + 40) & (r > g + 15)
        self.wait(lambda: self.share(orange) > 0.02, 120)
        self.keep("chains")
        self.assert_no_errors()

    def test_what_is_no_structure_gets_a_message(self):
        (self.folder / "no.pdb").write_text("Dear all,\n", encoding="ascii")
        self.browser.find_element("id", "file").send_keys(str(self.folder / "no.pdb"))
        self.assertTrue(self.wait("document.querySelector('#status.wrong')?.textContent"))
        self.assertTrue(self.probe("there"), "what was shown is still shown")

    def test_what_is_no_colour_is_refused(self):
        for wrong in ("no-such", -1, "inherit", ""):
            message = self.js("try { await shown.update({colour: arguments[0]}); } catch (error) { return error.message; }", wrong)
            self.assertIn("is no colour", message or "no error")


class Molstar(Examples, BrowserTest):
    NAME = "molstar"

    def load(self):
        super().load()
        # Without a graphics card each frame would take seconds.
        self.js("shown.plugin.canvas3d.setProps({multiSample: {mode: 'off'}, postprocessing: {enabled: false}})")

    def test_the_state_tree_shows_and_hides_it(self):
        self.assertEqual(self.js("return shown.plugin.state.data.cells.get(shown.ref).obj.label"), "1ubq.pdb")
        self.update({"colour": "#ff00ff", "opacity": 1})
        magenta = lambda r, g, b: (r > 2 * g + 20) & (b > 2 * g + 20)
        self.wait(lambda: self.share(magenta) > 0.08)
        self.js("shown.plugin.state.data.updateCellState(shown.representation, {isHidden: true});"
                "shown.plugin.state.data.cells.get(shown.representation).obj.data.repr.setState({visible: false});"
                "shown.plugin.canvas3d.requestDraw()")
        self.wait(lambda: self.share(magenta) < 0.001)


class ThreeDmol(Examples, BrowserTest):
    NAME = "3dmol"


class Ngl(Examples, BrowserTest):
    NAME = "ngl"


def ply_vertices(path):
    """The vertices of one of our binary PLY files, as a structured array, and its triangles."""
    header, body = path.read_bytes().split(b"end_header\n", 1)
    types = {"float": "<f4", "uint": "<u4", "int": "<i4", "uchar": "u1"}
    lines = header.decode("ascii").splitlines()
    faces_at = next(i for i, line in enumerate(lines) if line.startswith("element face"))
    vertices = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    layout = [(line.split()[2], types[line.split()[1]]) for line in lines[:faces_at] if line.startswith("property")]
    values = numpy.frombuffer(body, layout, vertices)
    faces = numpy.frombuffer(body[values.nbytes:], [("n", "u1"), ("corners", "<u4", 3)])
    return values, faces["corners"]


class Colours(BrowserTest):
    """The schemes against the program's, on the program's own meshes."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for scheme in SCHEMES:
            cls.meniscus("surface", ROOT / "examples" / "1a0q.pdb", "--spacing", "1", "--color", scheme, "-o",
                         cls.folder / f"{scheme}.ply")

    @classmethod
    def meniscus(cls, *words):
        subprocess.run([MENISCUS, *words, "--quiet"], check=True, stderr=subprocess.DEVNULL)

    def give(self, **arrays):
        """Lays arrays out for the page, which READ reads."""
        (self.folder / "surface.json").write_text(json.dumps(arrays), encoding="utf-8")

    def mesh_of(self, path):
        values, corners = ply_vertices(path)
        return values, {"positions": numpy.stack([values[k] for k in ("x", "y", "z")], 1).ravel().tolist(),
                        "normals": numpy.stack([values[k] for k in ("nx", "ny", "nz")], 1).ravel().tolist(),
                        "indices": corners.ravel().tolist()}

    def vertex_colours(self, scheme):
        """The program's mesh, and colours of the module on it, with the atoms as the program's table names them."""
        values, mesh = self.mesh_of(self.folder / f"{scheme}.ply")
        rows = [line.split(",") for line in (self.folder / f"{scheme}.atoms.csv").read_text(encoding="utf-8").splitlines()]
        columns = {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}
        self.give(**mesh, **{key: values[key].tolist() for key in ("atom", "patch", "component")}, columns=columns,
                  cavities=[{"component": c} for c in range(1, int(values["component"].max()) + 1)])
        return values, numpy.array(self.js(READ + """
            const {vertexColours} = await import("/web/adapters/colours.js"), {element, chain, resname: residue} = s.columns;
            return Array.from(vertexColours({...s, atoms: {count: element.length, element, chain, residue}}, arguments[0]))""",
                                           scheme))

    def test_every_scheme_has_the_program_s_colours(self):
        self.open("web/examples/example.css")
        for scheme in SCHEMES:
            with self.subTest(scheme):
                values, mine = self.vertex_colours(scheme)
                theirs = values["red"].astype(int) << 16 | values["green"].astype(int) << 8 | values["blue"]
                self.assertGreater(len(set(theirs)), 1)
                self.assertEqual((mine != theirs).sum(), 0)

    def test_many_chains_have_the_program_s_colours(self):
        rows = ["data_chains", "loop_", *("_atom_site." + tag for tag in (
            "group_PDB id type_symbol label_atom_id label_alt_id label_comp_id label_asym_id label_entity_id label_seq_id "
            "Cartn_x Cartn_y Cartn_z auth_seq_id auth_asym_id pdbx_PDB_model_num").split())]
        rows += [f"ATOM {i + 1} C CA . ALA C{i} 1 1 {9 * i} 0 0 1 C{i} 1" for i in range(96)]
        (self.folder / "chains.cif").write_text("\n".join(rows) + "\n", encoding="ascii")
        self.meniscus("surface", self.folder / "chains.cif", "--color", "chain", "--spacing", "1", "-o", self.folder / "chains.ply")
        values, _ = ply_vertices(self.folder / "chains.ply")
        first = [values[values["atom"] == atom][0] for atom in range(96)]
        self.open("web/examples/example.css")
        distinct = self.js("return (await import('/web/adapters/palettes.js')).DISTINCT")
        self.assertEqual(distinct, [int(v["red"]) << 16 | int(v["green"]) << 8 | int(v["blue"]) for v in first])

    def curvatures(self, path):
        """The module's and the program's, at the vertices of the program's mesh."""
        self.meniscus("surface", path, "-o", self.folder / "curved.ply")
        values, mesh = self.mesh_of(self.folder / "curved.ply")
        self.give(**mesh)
        self.open("web/examples/example.css")
        return numpy.array(self.js(READ + "return Array.from((await import('/web/adapters/colours.js')).meanCurvatures(s))")), \
            values["mean_curvature"]

    def test_curvatures_are_near_to_the_program_s(self):
        (self.folder / "ball.xyzr").write_text("0 0 0 2\n", encoding="ascii")
        mine, _ = self.curvatures(self.folder / "ball.xyzr")
        self.assertLess(numpy.abs(mine - 0.5).max(), 0.02)
        mine, theirs = self.curvatures(ROOT / "examples" / "1ubq.pdb")
        self.assertLess(abs(numpy.median(mine - theirs)), 0.01)
        self.assertGreater(numpy.corrcoef(mine, numpy.clip(theirs, -0.7, 0.7))[0, 1], 0.85)


def missing():
    if not (PACKAGE / "src" / "index.js").is_file():
        return f"the built package ({PACKAGE})"
    for name, script in VIEWERS.items():
        if not (VIEWER_FOLDER / name / script).is_file():
            return f"the npm package {name}"
    return browser_test.missing() or (None if Image else "Python's PIL (python3-pil)")


if __name__ == "__main__":
    MENISCUS, ROOT, PACKAGE, VIEWER_FOLDER = (pathlib.Path(word).resolve() for word in sys.argv[1:5])
    VIEWER_FOLDER /= "node_modules"
    PICTURES = pathlib.Path(sys.argv[5]) if len(sys.argv) > 5 else None
    LACKING = missing()
    if LACKING:
        print(f"SKIPPED: the viewers are not tested in a browser: {LACKING} is missing (./test --full installs it)")
        sys.exit(browser_test.SKIPPED)
    if PICTURES:
        PICTURES.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1], verbosity=2)

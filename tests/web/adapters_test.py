#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The surface in Mol*, 3Dmol.js and NGL: the example pages in Chromium, driven as a reader would.

usage: adapters_test.py MENISCUS ROOT PACKAGE VIEWERS [PICTURES]
PACKAGE is the folder of the built npm package; VIEWERS has node_modules with molstar, 3dmol and ngl; PICTURES is a folder
for screenshots. Skipped (77) where one of these, Chromium, its driver or Python's selenium is missing.
"""
import base64
import gzip
import io
import pathlib
import sys
import time

import numpy

import web_browser

try:
    from PIL import Image
    from selenium.webdriver.common.actions.action_builder import ActionBuilder
except ImportError:
    Image = ActionBuilder = None

PICTURES = pathlib.Path(sys.argv[5]) if len(sys.argv) > 5 else None

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
          molecules: shown.plugin.managers.structure.hierarchy.current.structures.length,
          towards: [0, 1, 2].map(k => canvas.camera.state.position[k] - canvas.camera.state.target[k]),
        };""",
    "3dmol": """
        const {viewer, shapes} = shown, groups = shapes.flatMap(shape => shape.geo.geometryGroups);
        const sum = key => groups.reduce((total, group) => total + group[key], 0), [, , , , x, y, z, w] = viewer.getView();
        return {
          there: shapes.every(shape => viewer.shapes.includes(shape)), vertices: sum("vertices"), corners: sum("faceidx"),
          place: p => { const at = viewer.modelToScreen({x: p[0], y: p[1], z: p[2]}); return [at.x, at.y]; },
          molecules: viewer.models.length,
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
          molecules: stage.compList.filter(each => each.type === "structure").length,
          towards: vector.clone().set(0, 0, -stage.viewer.camera.position.z < 0 ? 1 : -1).transformDirection(inverse).toArray(),
        };""",
}

# Vertices that stick out towards the reader: what is farthest in a direction hides nothing and is not hidden.
OUTERMOST = """
    const {atomName} = await import("/node_modules/meniscus-surface/adapters/names.js");
    const {positions, atom} = shown.surface, {place, towards} = (() => { PROBE })(), length = Math.hypot(...towards);
    const ways = [[0, 0, 0], [.5, 0, 0], [0, .5, 0], [-.3, .3, .3], [0, -.4, -.4]];
    return ways.map(way => way.map((x, k) => x + towards[k] / length)).map(way => {
      let best = 0, height = -Infinity;
      for (let v = 0; v < atom.length; ++v) {
        const h = positions[3 * v] * way[0] + positions[3 * v + 1] * way[1] + positions[3 * v + 2] * way[2];
        if (h > height) [best, height] = [v, h];
      }
      return {atom: atom[best], name: atomName(shown.surface, atom[best]),
              place: place(Array.from(positions.subarray(3 * best, 3 * best + 3)))};
    });"""


class Examples:
    """What holds of each page."""

    NAME = ""

    def setUp(self):
        self.load()

    def load(self):
        self.open(f"node_modules/meniscus-surface/examples/{self.NAME}.html")
        self.wait("document.body.dataset.ready === '1ubq.pdb'")

    def probe(self, member):
        return self.js(f"return (() => {{ {PROBES[self.NAME]} }})().{member}")

    def picture(self):
        return Image.open(io.BytesIO(base64.b64decode(self.browser.driver.get_screenshot_as_base64()))).convert("RGB")

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
        self.assertEqual(self.browser.errors(), [])

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
        self.assertEqual(self.browser.errors(), [])

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
        mouse = ActionBuilder(self.browser.driver)
        for x, y in ((place[0] + 3, place[1] + 3), place):
            mouse.pointer_action.move_to_location(int(round(x)), int(round(y)))
        mouse.perform()

    def beside(self):
        """A place in the viewer where nothing is drawn."""
        left, top, _, bottom = self.box()
        return [left + 60, (top + bottom) / 2]

    def named(self, found):
        """Points at a vertex; the name on the page, as soon as it is the right one or when it is too late for that."""
        self.point(found["place"])
        end = time.monotonic() + 10  # viewers wait until the pointer rests, and are slow where nothing else draws
        while (name := self.js("return document.getElementById('atom').textContent")) != found["name"] and time.monotonic() < end:
            time.sleep(0.1)
        return name

    def look(self):
        """Vertices in front, once the camera is at rest and the viewer names what is under the pointer."""
        looks = []

        def first_is_named():
            looks.append(self.outermost())
            return self.named(looks[-1][0]) == looks[-1][0]["name"]

        self.wait(first_is_named)
        return looks[-1]

    def test_the_atom_under_the_pointer_is_named(self):
        found = self.look()
        self.assertGreater(len({f["name"] for f in found}), 2)
        self.assertEqual([self.named(f) for f in found], [f["name"] for f in found])
        self.assertEqual(self.named({"place": self.beside(), "name": ""}), "")
        self.assertEqual(self.browser.errors(), [])

    def test_names_of_atoms_stay_text(self):
        found = self.look()[0]
        images = self.js("return document.images.length")
        self.named({"place": self.beside(), "name": ""})
        self.js("shown.surface.atoms.name[arguments[0]] = '<img src=x onerror=\"intruder = 1\">'", found["atom"])
        found = self.outermost()[0]
        self.assertIn("<img", found["name"])
        self.assertEqual(self.named(found), found["name"])
        self.assertEqual(self.js("return [window.intruder ?? null, document.images.length]"), [None, images])

    def test_another_file_takes_its_place(self):
        self.browser.driver.find_element("id", "file").send_keys(str(self.root / "examples" / "1a0q.pdb"))
        self.wait("document.body.dataset.ready === '1a0q.pdb'", 180)
        vertices, corners = self.js("return [shown.surface.positions.length / 3, shown.surface.indices.length]")
        self.assertGreater(vertices, 65536, "more than 16 bits can number")
        self.assertEqual(self.probe("corners"), corners)
        self.browser.driver.find_element("css selector", "#colour option:nth-child(2)").click()
        orange = lambda r, g, b: (r > b + 40) & (r > g + 15)
        self.wait(lambda: self.share(orange) > 0.02, 120)
        self.keep("chains")
        self.assertEqual(self.browser.errors(), [])

    def test_a_dropped_file_takes_its_place(self):
        zipped = gzip.compress((self.root / "examples" / "1ubq.pdb").read_bytes())
        self.js("""
            const bytes = Uint8Array.from(atob(arguments[0]), c => c.charCodeAt(0)), dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File([bytes], "dropped.pdb.gz"));
            const canvas = document.querySelector("#view canvas");
            for (const type of ["dragenter", "dragover", "drop"])
              canvas.dispatchEvent(new DragEvent(type, {dataTransfer, bubbles: true, cancelable: true}))""",
                base64.b64encode(zipped).decode("ascii"))
        self.wait("document.body.dataset.ready === 'dropped.pdb.gz'")
        self.assertEqual(self.probe("molecules"), 1)
        self.assertFalse(self.js("return document.body.classList.contains('over')"))
        self.assertEqual(self.browser.errors(), [])

    def test_what_is_no_structure_gets_a_message(self):
        (self.folder / "no.pdb").write_text("Dear all,\n", encoding="ascii")
        self.browser.driver.find_element("id", "file").send_keys(str(self.folder / "no.pdb"))
        self.assertTrue(self.wait("document.querySelector('#status.wrong')?.textContent"))
        self.assertTrue(self.probe("there"), "what was shown is still shown")

    def test_what_is_no_colour_is_refused(self):
        for wrong in ("no-such", -1, "inherit", ""):
            message = self.js("try { await shown.update({colour: arguments[0]}); } catch (error) { return error.message; }", wrong)
            self.assertIn("is no colour", message or "no error")


class Molstar(Examples, web_browser.BrowserTest):
    NAME = "molstar"

    def load(self):
        super().load()
        # Without a graphics card each frame would take seconds, and Mol* gives up on what is picked after five of them.
        self.js("""
            shown.plugin.canvas3d.setProps({multiSample: {mode: 'off'}, postprocessing: {enabled: false}});
            WebGL2RenderingContext.prototype.clientWaitSync = function() { this.finish(); return this.ALREADY_SIGNALED; }""")

    def test_the_state_tree_shows_and_hides_it(self):
        self.assertEqual(self.js("return shown.plugin.state.data.cells.get(shown.ref).obj.label"), "1ubq.pdb")
        self.update({"colour": "#ff00ff", "opacity": 1})
        magenta = lambda r, g, b: (r > 2 * g + 20) & (b > 2 * g + 20)
        self.wait(lambda: self.share(magenta) > 0.08)
        self.js("shown.plugin.state.data.updateCellState(shown.representation, {isHidden: true});"
                "shown.plugin.state.data.cells.get(shown.representation).obj.data.repr.setState({visible: false});"
                "shown.plugin.canvas3d.requestDraw()")
        self.wait(lambda: self.share(magenta) < 0.001)


class ThreeDmol(Examples, web_browser.BrowserTest):
    NAME = "3dmol"


class Ngl(Examples, web_browser.BrowserTest):
    NAME = "ngl"

    def test_each_triangle_is_picked_as_one_of_its_atoms(self):
        """NGL interpolates between the identifiers of corners, which would name any atom between two."""
        mixed, foreign = self.js("""
            const {geometry} = shown.buffer, ids = geometry.attributes.primitiveId.array, drawn = geometry.index.array;
            const {indices, atom} = shown.surface;
            let mixed = 0, foreign = 0;
            for (let t = 0; t < drawn.length; t += 3) {
              const [a, b, c] = [0, 1, 2].map(k => ids[drawn[t + k]]);
              if (a !== b || b !== c) ++mixed;
              if (![0, 1, 2].some(k => atom[indices[t + k]] === a)) ++foreign;
            }
            return [mixed, foreign];""")
        self.assertEqual((mixed, foreign), (0, 0))


if __name__ == "__main__":
    if PICTURES:
        PICTURES.mkdir(parents=True, exist_ok=True)
    web_browser.main(None if Image else "Python's PIL (python3-pil)")

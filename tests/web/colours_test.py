#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The colours of the npm package's adapters against the program's, on the program's own meshes.

usage: colours_test.py MENISCUS ROOT PACKAGE VIEWERS    as adapters_test.py
"""
import json
import subprocess

import numpy

import web_browser

SCHEMES = ("element", "chain", "residue", "hydrophobicity", "patch", "component")

# The arrays that a test has laid out, as s.
READ = """
    const s = await (await fetch("/made/surface.json")).json();
    for (const [key, Type] of Object.entries({positions: Float32Array, normals: Float32Array, indices: Uint32Array,
                                              atom: Uint32Array, patch: Uint8Array, component: Uint32Array}))
      if (s[key]) s[key] = Type.from(s[key]);
"""


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


class Colours(web_browser.BrowserTest):
    """The schemes against the program's, on the program's own meshes."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for scheme in SCHEMES:
            cls.meniscus("surface", cls.root / "examples" / "1a0q.pdb", "--spacing", "1", "--color", scheme, "-o",
                         cls.folder / f"{scheme}.ply")

    @classmethod
    def meniscus(cls, *words):
        subprocess.run([cls.program, *words, "--quiet"], check=True, stderr=subprocess.DEVNULL)

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
        mine, theirs = self.curvatures(self.root / "examples" / "1ubq.pdb")
        self.assertLess(abs(numpy.median(mine - theirs)), 0.01)
        self.assertGreater(numpy.corrcoef(mine, numpy.clip(theirs, -0.7, 0.7))[0, 1], 0.85)


if __name__ == "__main__":
    web_browser.main()

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

SCHEMES = ("element", "chain", "residue", "hydrophobicity", "patch", "component", "curvature")

def ply_vertices(path):
    """The vertices of one of our binary PLY files, as a structured array."""
    header, body = path.read_bytes().split(b"end_header\n", 1)
    types = {"float": "<f4", "uint": "<u4", "int": "<i4", "uchar": "u1"}
    lines = header.decode("ascii").splitlines()
    faces_at = next(i for i, line in enumerate(lines) if line.startswith("element face"))
    vertices = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    layout = [(line.split()[2], types[line.split()[1]]) for line in lines[:faces_at] if line.startswith("property")]
    return numpy.frombuffer(body, layout, vertices)


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

    def vertex_colours(self, scheme):
        """The program's vertices, and colours of the module for them, with the atoms as the program's table names them."""
        values = ply_vertices(self.folder / f"{scheme}.ply")
        rows = [line.split(",") for line in (self.folder / f"{scheme}.atoms.csv").read_text(encoding="utf-8").splitlines()]
        columns = {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}
        arrays = {key: values[key].tolist() for key in ("atom", "patch", "component", "mean_curvature")}
        (self.folder / "surface.json").write_text(json.dumps({**arrays, "columns": columns}), encoding="utf-8")
        return values, numpy.array(self.js("""
            const {vertexColours} = await import("/node_modules/meniscus-surface/adapters/colours.js");
            const {columns, mean_curvature, ...arrays} = await (await fetch("/made/surface.json")).json();
            const {element, chain, resname: residue} = columns, last = arrays.component.reduce((a, b) => Math.max(a, b), 0);
            const cavities = Array.from({length: last}, (_, i) => ({component: i + 1}));
            return Array.from(vertexColours({...arrays, cavities, values: {mean_curvature},
                                             atoms: {count: element.length, element, chain, residue}}, arguments[0]))""", scheme))

    def test_every_scheme_has_the_program_s_colours(self):
        self.open("node_modules/meniscus-surface/examples/example.css")
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
        values = ply_vertices(self.folder / "chains.ply")
        first = [values[values["atom"] == atom][0] for atom in range(96)]
        self.open("node_modules/meniscus-surface/examples/example.css")
        distinct = self.js("return (await import('/node_modules/meniscus-surface/adapters/palettes.js')).DISTINCT")
        self.assertEqual(distinct, [int(v["red"]) << 16 | int(v["green"]) << 8 | int(v["blue"]) for v in first])


if __name__ == "__main__":
    web_browser.main()

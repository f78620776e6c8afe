#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the built program for pockets that are seen: bodies in PLY and GLB, pictures, pages, and colours of surfaces.

usage: pockets_drawn_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""
import base64
import csv
import json
import re
import struct
import sys
import unittest
import zlib

from program_case import SHELL, UBIQUITIN, ProgramTest


def volume_of(vertices, triangles):
    """By the divergence theorem."""
    total = 0.0
    for triangle in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (vertices[i] for i in triangle)
        total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return total / 6


def read_ply(path):
    """The properties of vertices by name, and triangles."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    sizes = {"float": "f", "double": "d", "int": "i", "uint": "I", "uchar": "B"}
    counts, names, record = {}, [], "<"
    for line in header.decode("ascii").splitlines():
        words = line.split()
        if words[0] == "element":
            counts[words[1]] = int(words[2])
        if words[0] == "property" and "face" not in counts:
            record += sizes[words[1]]
            names.append(words[2])
    end = counts["vertex"] * struct.calcsize(record)
    columns = dict(zip(names, zip(*struct.iter_unpack(record, body[:end]))))
    return columns, [row[1:] for row in struct.iter_unpack("<BIII", body[end:])]


def page_info(path):
    """What a page knows, as JSON."""
    data = re.search(r'id="data">([^<]*)<', path.read_text(encoding="utf-8")).group(1)
    content = zlib.decompress(base64.b64decode(data))
    size = struct.unpack_from("<I", content)[0]
    return json.loads(content[4:4 + size])


def glb_json(path):
    content = path.read_bytes()
    return json.loads(content[20:20 + struct.unpack_from("<I", content, 12)[0]])


class DrawnPocketsTest(ProgramTest):
    def pockets(self, *arguments, code=0):
        result = self.run_program("pockets", *arguments)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def rows(self, name):
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_bodies_have_the_volumes_of_the_table(self):
        self.pockets(UBIQUITIN, "-o", "p.ply", "-o", "p.csv", "--count", 3)
        columns, triangles = read_ply(self.folder / "p.ply")
        vertices = list(zip(columns["x"], columns["y"], columns["z"]))
        of = columns["pocket"]
        rows = self.rows("p.csv")
        self.assertEqual(sorted({int(rank) for rank in of}), [int(row["rank"]) for row in rows])
        for row in rows:
            own = [t for t in triangles if of[t[0]] == int(row["rank"])]
            self.assertTrue(all(of[v] == int(row["rank"]) for t in own for v in t))
            volume = float(row["volume"])
            self.assertAlmostEqual(volume_of(vertices, own), volume, delta=max(0.05 * volume, 2.0))

    def test_a_node_for_each_pocket(self):
        self.pockets(UBIQUITIN, "-o", "p.glb", "-o", "p.csv", "--count", 2)
        names = [node["name"] for node in glb_json(self.folder / "p.glb")["nodes"]]
        self.assertEqual(names, ["surface"] + [f"pocket {row['rank']}" for row in self.rows("p.csv")])

    def test_tunnels_and_pores_are_nodes_in_colours(self):
        self.pockets(UBIQUITIN, "-o", "p.glb", "--report", "p.json", "--count", 2, "--tunnels", "--pore", "z", "--tunnel-count", 2)
        gltf = glb_json(self.folder / "p.glb")
        report = json.loads((self.folder / "p.json").read_text())
        ways = {f"tunnel {t['pocket']}.{t['rank']}": t for t in report["tunnels"]} | {"pore": report["pore"]}
        self.assertGreater(len(ways), 1)
        names = [node["name"] for node in gltf["nodes"]]
        self.assertEqual(names[-len(ways):], list(ways))
        for node in gltf["nodes"][-len(ways):]:
            primitive = gltf["meshes"][node["mesh"]]["primitives"][0]
            places, colours = (gltf["accessors"][primitive["attributes"][name]] for name in ("POSITION", "COLOR_0"))
            self.assertEqual(places["count"], colours["count"])
            self.assertNotIn("alphaMode", gltf["materials"][primitive["material"]])
            way = ways[node["name"]]
            for end in (way["profile"][0], way["profile"][-1]):   # as wide as its balls, ends included
                for k in range(3):
                    self.assertGreater(end["position"][k] - end["radius"], places["min"][k] - 0.5)
                    self.assertLess(end["position"][k] + end["radius"], places["max"][k] + 0.5)
            box = [high - low for low, high in zip(places["min"], places["max"])]
            self.assertLess(max(box), way["length"] + 2 * max(p["radius"] for p in way["profile"]) + 0.1)

    def test_pages_have_the_tunnels_of_the_report(self):
        self.pockets(UBIQUITIN, "-o", "p.html", "--report", "p.json", "--count", 1, "--tunnels", "--pore", "z",
                     "--tunnels-from", "//A/1")
        info, report = page_info(self.folder / "p.html"), json.loads((self.folder / "p.json").read_text())
        ways, found = info["ways"]["list"], [*report["tunnels"], report["pore"]]
        self.assertEqual(len(ways), len(found))
        self.assertEqual([w["from"] for w in ways][-1], "pore")
        for i, (shown, way) in enumerate(zip(ways, found)):
            if "rank" in way:
                self.assertEqual(shown["name"], f"tunnel {way['pocket']}.{way['rank']}" if way["pocket"] else f"tunnel {i + 1}")
                self.assertEqual(shown["rank"], way["rank"])
            self.assertAlmostEqual(shown["radius"], way["bottleneck_radius"], delta=0.0006)
            self.assertEqual(shown["bottleneck"], way["bottleneck"])
            self.assertEqual(len(shown["profile"]), len(way["profile"]))
            self.assertAlmostEqual(min(radius for _, radius in shown["profile"]), shown["radius"], delta=0.01)
            distance, _ = min(shown["profile"], key=lambda place: place[1])
            self.assertAlmostEqual(shown["distance"], distance, delta=0.3)
        self.assertEqual(info["ways"]["scale"][0][0], 1.0)
        self.assertGreater(info["tubes"]["triangles"], 100)

    def test_pages_without_tunnels_have_no_tubes(self):
        self.pockets(UBIQUITIN, "-o", "p.html", "--count", 1, "--tunnels", "--tunnel-radius", 9)
        info = page_info(self.folder / "p.html")
        self.assertNotIn("ways", info)
        self.assertNotIn("tubes", info)

    def test_tunnels_are_in_pictures(self):
        for name, options in (("with.png", ["--pore", "z"]), ("without.png", [])):
            self.pockets(UBIQUITIN, "-o", name, "--size", "64x48", "--count", 1, *options)
        self.assertNotEqual(*((self.folder / name).read_bytes() for name in ("with.png", "without.png")))

    def test_pages_list_what_the_table_has(self):
        self.pockets(UBIQUITIN, "-o", "p.html", "-o", "p.csv", "--count", 2)
        info, rows = page_info(self.folder / "p.html"), self.rows("p.csv")
        self.assertEqual(info["scheme"], "pocket")
        self.assertEqual([p["name"] for p in info["pockets"]], [row["rank"] for row in rows])
        for pocket, row in zip(info["pockets"], rows):
            self.assertAlmostEqual(pocket["volume"], float(row["volume"]), delta=0.006)
        self.assertEqual(len({p["colour"] for p in info["pockets"]}), len(rows))
        self.assertGreater(info["bodies"]["triangles"], 100)

    def test_pictures_take_the_options_of_pictures(self):
        self.pockets(UBIQUITIN, "-o", "p.png", "--size", "64x48", "--count", 1)
        self.assertEqual(struct.unpack(">II", (self.folder / "p.png").read_bytes()[16:24]), (64, 48))
        for options, name in ((["--size", "64x48"], "p.html"), (["--view", "top"], "p.ply"), (["--draw", "none"], "p.csv")):
            result = self.pockets(UBIQUITIN, "-o", name, *options, code=2)
            self.assertIn(options[0], result.stderr)

    def test_surfaces_in_the_colours_of_pockets(self):
        result = self.surface(UBIQUITIN, "--color", "pocket", "-o", "s.ply", "-o", "s.html", "--radii", "bondi")
        self.assertNotIn("the ranking was fitted to", result.stderr)  # pockets are found among united atoms all the same
        piped = self.run_program("surface", "-", "--color", "pocket", "-o", "t.ply", "--radii", "bondi", "--spacing", "1",
                                 text=UBIQUITIN.read_text(encoding="ascii"))
        self.assertIn("the ranking was fitted to", piped.stderr)
        columns, _ = read_ply(self.folder / "s.ply")
        colours = {}
        for rank, *colour in zip(columns["pocket"], columns["red"], columns["green"], columns["blue"]):
            colours.setdefault(None if rank != rank else int(rank), set()).add(tuple(colour))
        self.assertEqual(colours[None], {(204, 204, 204)})
        self.assertIn(1, colours)
        self.assertTrue(all(len(of_rank) == 1 for of_rank in colours.values()))
        info = page_info(self.folder / "s.html")
        self.assertEqual(info["pockets"][0]["name"], "1")
        self.assertNotIn("bodies", info)

    def test_a_cavity_alone(self):
        (self.folder / "shell.xyzr").write_text(SHELL)
        self.pockets("shell.xyzr", "--radii", "auto", "--spacing", "0.5", "-o", "p.ply", "-o", "p.html", "-o", "p.glb", "-o", "p.png", "--size", "40x30")
        self.assertTrue(any(p["cavity"] for p in page_info(self.folder / "p.html")["pockets"]))

    def test_nothing_to_draw(self):
        (self.folder / "one.xyzr").write_text("0 0 0 1.7\n")
        self.pockets("one.xyzr", "--radii", "auto", "-o", "p.ply", "-o", "p.html", "-o", "p.glb", "-o", "p.png", "--size", "40x30")
        self.assertEqual(read_ply(self.folder / "p.ply")[1], [])
        self.assertNotIn("pockets", page_info(self.folder / "p.html"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])

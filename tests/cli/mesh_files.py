# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Reads mesh files back as other programs would, and tells what the triangles are as a surface."""
import collections
import struct

SIZES = {"float": "f", "double": "d", "int": "i", "uint": "I", "uchar": "B"}


def read_ply(path):
    """Vertices and triangles of a binary PLY file."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    counts, record = {}, "<"
    for line in header.decode("ascii").splitlines():
        words = line.split()
        if words[0] == "element":
            counts[words[1]] = int(words[2])
        if words[0] == "property" and "face" not in counts:
            record += SIZES[words[1]]
    vertices = [row[:3] for row in struct.iter_unpack(record, body[:counts["vertex"] * struct.calcsize(record)])]
    triangles = [row[1:] for row in struct.iter_unpack("<BIII", body[counts["vertex"] * struct.calcsize(record):])]
    assert len(triangles) == counts["face"]
    return vertices, triangles


def read_stl(path):
    """Of a binary STL file; corners at the same place are one vertex, which is all that the format tells."""
    content = path.read_bytes()
    corners = [row[3 * k:3 * k + 3] for row in struct.iter_unpack("<12fH", content[84:]) for k in (1, 2, 3)]
    assert len(corners) == 3 * struct.unpack_from("<I", content, 80)[0]
    return merged(corners, [(i, i + 1, i + 2) for i in range(0, len(corners), 3)])


def read_obj(path):
    rows = [line.split() for line in path.read_text(encoding="ascii").splitlines()]
    return ([tuple(map(float, row[1:4])) for row in rows if row[0] == "v"],
            [tuple(int(corner.split("/")[0]) - 1 for corner in row[1:]) for row in rows if row[0] == "f"])


def read_off(path):
    rows = [line.split() for line in path.read_text(encoding="ascii").splitlines() if not line.startswith("#")]
    count = int(rows[1][0])
    return ([tuple(map(float, row)) for row in rows[2:2 + count]],
            [tuple(map(int, row[1:])) for row in rows[2 + count:]])


READERS = {"ply": read_ply, "stl": read_stl, "obj": read_obj, "off": read_off}


def merged(vertices, triangles, digits=None):
    """Vertices at the same place become one; with `digits`, after rounding to so many decimals."""
    number = {}
    place = (lambda v: tuple(v)) if digits is None else (lambda v: tuple(f"{x:.{digits}f}" for x in v))
    of = [number.setdefault(place(vertex), len(number)) for vertex in vertices]
    return list(number), [tuple(of[corner] for corner in triangle) for triangle in triangles]


def is_closed_and_oriented(triangles):
    """Whether every edge has two triangles, which run along it in opposite directions."""
    count = collections.Counter((t[k], t[(k + 1) % 3]) for t in triangles for k in range(3))
    return all(a != b and n == 1 and count.get((b, a)) == 1 for (a, b), n in count.items())


def has_single_fans(triangles):
    """Whether the triangles round every vertex of a closed surface form one ring."""
    after = collections.defaultdict(dict)
    for t in triangles:
        for k in range(3):
            after[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3]
    for ring in after.values():
        start = at = next(iter(ring))
        for steps in range(1, len(ring) + 1):
            at = ring[at]
            if at == start:
                break
        if at != start or steps != len(ring):
            return False
    return True


def euler_characteristic(vertices, triangles):
    """Of all vertices, used or not."""
    edges = {frozenset((t[k], t[(k + 1) % 3])) for t in triangles for k in range(3)}
    return len(vertices) - len(edges) + len(triangles)


def piece_count(vertices, triangles):
    above = list(range(len(vertices)))

    def root(v):
        while above[v] != v:
            above[v] = v = above[above[v]]
        return v

    for a, b, c in triangles:
        above[root(b)] = root(a)
        above[root(c)] = root(a)
    return sum(root(v) == v for v in range(len(vertices)))

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What callers of MSMS and NanoShaper read of their files and output, field by field, each in its way."""
import re


def read_vertices_by_place(path, header_lines=3):
    """As MaSIF: the count of the third line, fields by their number, the tenth the name of the atom."""
    lines = path.read_text().rstrip().split("\n")
    count = int(lines[2].split()[0]) if header_lines else len(lines)
    vertices = []
    for line in lines[header_lines:]:
        fields = line.split()
        vertices.append(([float(word) for word in fields[:3]], [float(word) for word in fields[3:6]], int(fields[7]),
                         int(fields[8]), fields[9] if len(fields) > 9 else None))
    assert len(vertices) == count, (len(vertices), count)
    return vertices


def read_vertices_by_column(path):
    """As readers of fixed columns do: '%9.3f %9.3f %9.3f %9.3f %9.3f %9.3f %7d %7d %2d %s'."""
    vertices = []
    for line in path.read_text().splitlines()[3:]:
        numbers = [float(line[start:start + 9]) for start in range(0, 60, 10)]
        vertices.append((numbers, int(line[60:67]), int(line[68:75]), int(line[76:78]), line[79:]))
    return vertices


def read_faces(path, header_lines=3):
    """Corners from 0 on, and the kind; as MaSIF, PyVOL and VMD."""
    lines = path.read_text().rstrip().split("\n")
    faces = []
    for line in lines[header_lines:]:
        numbers = [int(word) for word in line.split()]
        assert len(numbers) == 5, line
        faces.append((tuple(number - 1 for number in numbers[:3]), numbers[3]))
    assert not header_lines or len(faces) == int(lines[2].split()[0])
    return faces


def scan_stream(path, kinds, count, skip_lines):
    """As C programs with fscanf: after the lines passed over, numbers whatever the lines; records of `kinds`."""
    words = path.read_text().split("\n", skip_lines)[skip_lines].split()
    width = len(kinds)
    return [[kind(word) for kind, word in zip(kinds, words[width * i:width * (i + 1)])] for i in range(count)]


def read_areas_by_name(path):
    """As MaSIF: the fourth field is the name, the second the SES area."""
    lines = path.read_text().splitlines()[1:]
    return {fields[3]: float(fields[1]) for fields in map(str.split, lines)}


def read_areas(path):
    """As OpenStructure, with spheres without names: number from 0 on, SES, SAS."""
    rows = []
    for line in path.read_text().splitlines()[1:]:
        number, ses, sas = line.split()
        assert int(number) == len(rows)
        rows.append((float(ses), float(sas)))
    return rows


def read_analytical(printed):
    """As OpenStructure: pairs of areas between a head of exactly these words and the end."""
    pairs = []
    inside = False
    for line in printed.splitlines():
        if re.match("TRIANGULATION|MSMS terminated normally", line):
            inside = False
        if inside:
            pairs.append(tuple(float(word) for word in line.split()[5:7]))
        if re.match("    Comp. probe_radius,   reent,    toric,   contact    SES       SAS", line):
            inside = True
    return pairs


def read_total_volume(printed):
    """As OpenStructure."""
    for line in printed.splitlines():
        if re.match("    Total ses_volume:", line):
            return float(line.split(":")[1])
    return None


def read_numerical(printed):
    """As empiricalSES: sections by their first words, volume and area of every component."""
    lines = printed.split("\n")
    place = {flag: max(i for i, line in enumerate(lines) if line.startswith(flag))
             for flag in ("ANALYTICAL SURFACE AREA", "TRIANGULATION", "NUMERICAL VOLUMES AND AREA", "MSMS terminated")}
    for line in lines[place["ANALYTICAL SURFACE AREA"] + 2:place["TRIANGULATION"]]:
        float(line.split()[5]), float(line.split()[6])
    rows = lines[place["NUMERICAL VOLUMES AND AREA"] + 2:place["MSMS terminated"] - 1]
    return [(float(row.split()[2]), float(row.split()[3])) for row in rows]


def read_parameters(printed):
    """As msms_wrapper: probe radius, density, high density."""
    for line in printed.splitlines():
        if line.startswith("PARAM"):
            words = line.split()
            return float(words[2]), float(words[4]), float(words[6])
    return None


def read_version(printed):
    """As OpenStructure: the second word of the line that begins with MSMS."""
    return next(line.split(" ")[1] for line in printed.splitlines() if line[:4] == "MSMS")


def count_components(printed):
    """As OpenStructure: the number of the last component, from which it knows which files to read."""
    return max(int(line.split()[2]) for line in printed.splitlines() if re.search("RS component [0-9]+ identified", line))


def read_nanoshaper_output(printed):
    """As pickPocket: volume and area."""
    volume = re.search(r"(<<INFO>> Estimated volume )(\d*\.?\d+)", printed)
    area = re.search(r"(<<INFO>> Total, grid conformant, surface area is )(\d*\.?\d+)", printed)
    return float(volume[2]), float(area[2])


def is_closed(faces):
    """Every edge is run along once each way."""
    edges = [(a, b) for corners, _ in faces for a, b in zip(corners, corners[1:] + corners[:1])]
    directed = set(edges)
    return len(directed) == len(edges) and all((b, a) in directed for a, b in directed)

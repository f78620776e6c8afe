# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The C interface as other languages use it, through ctypes: its numbers and files are those of the program, it shows no
other symbols, and the example in C runs.

usage: ctypes_test.py LIBRARY PROGRAM EXAMPLE PROJECT
"""
import ctypes as c
import json
import pathlib
import subprocess
import sys
import tempfile

LIBRARY, PROGRAM, EXAMPLE, PROJECT = sys.argv[1:5]
INPUT = str(pathlib.Path(PROJECT) / "examples" / "1a0q.pdb")
lib = c.CDLL(LIBRARY)
lib.meniscus_last_error.restype = c.c_char_p
lib.meniscus_options_new.restype = c.c_void_p
for name in ("atom", "vertex", "triangle"):
    getattr(lib, f"meniscus_{name}_count").restype = c.c_size_t


def check(status):
    if status != 0:
        raise RuntimeError(f"{status}: {lib.meniscus_last_error().decode()}")


def made(function, *arguments):
    handle = c.c_void_p()
    check(function(*arguments, c.byref(handle)))
    return handle


def text_of(function, *arguments):
    text = c.c_char_p()
    check(function(*arguments, c.byref(text)))
    return json.loads(text.value)


def program(*arguments):
    subprocess.run([PROGRAM, *arguments], check=True, capture_output=True)


def compare_reports(ours, theirs, keys):
    for key in keys:
        assert ours[key] == theirs[key], f"{key}: {ours[key]} and {theirs[key]} differ"


def same_measures(folder, structure, options):
    exact = made(lib.meniscus_exact_new, structure, options)
    program("measure", INPUT, "--between", "all", "--report", f"{folder}/m.json")
    with open(f"{folder}/m.json", encoding="utf-8") as file:
        expected = json.load(file)
    lib.meniscus_options_set(options, b"between", b"all")
    report = text_of(lib.meniscus_measure_report, exact, options)
    compare_reports(report, expected, ("exact", "components", "interfaces"))
    compare_reports(report["input"], expected["input"], set(report["input"]) - {"notes"})
    assert "92 waters left out (keep them with waters = true)" in report["input"]["notes"]
    assert [cavity["volume"] for cavity in report["cavities"]] == sorted(
        (piece["ses_volume"] for piece in expected["components"] if piece["kind"] == "cavity"), reverse=True)
    check(lib.meniscus_write_table(exact, b"residue", f"{folder}/ours.csv".encode()))
    program("measure", INPUT, "--per", "residue", "-o", f"{folder}/theirs.csv")
    assert pathlib.Path(folder, "ours.csv").read_bytes() == pathlib.Path(folder, "theirs.csv").read_bytes()
    return exact


def same_mesh(folder, exact, options):
    for name, value in ((b"spacing", b"0.8"), (b"exact", b"true"), (b"quality", b"true"), (b"initial_area", b"true")):
        check(lib.meniscus_options_set(options, name, value))
    surface = made(lib.meniscus_surface_new, exact, options, None, None)
    check(lib.meniscus_write_mesh(surface, f"{folder}/ours.stl".encode()))
    program("surface", INPUT, "--spacing", "0.8", "-o", f"{folder}/theirs.stl", "--report", f"{folder}/s.json")
    assert pathlib.Path(folder, "ours.stl").read_bytes() == pathlib.Path(folder, "theirs.stl").read_bytes()
    report = text_of(lib.meniscus_surface_report, surface)
    with open(f"{folder}/s.json", encoding="utf-8") as file:
        expected = json.load(file)
    compare_reports(report, expected, ("exact", "components", "flow", "expected"))
    compare_reports(report["mesh"], expected["mesh"], report["mesh"])
    assert lib.meniscus_vertex_count(surface) == report["mesh"]["vertices"]
    lib.meniscus_surface_free(surface)


def same_pockets(folder):
    options = c.c_void_p(lib.meniscus_options_new())
    for name, value in ((b"radii", b"united"), (b"hetero", b"none"), (b"count", b"2"), (b"rank", b"volume")):
        check(lib.meniscus_options_set(options, name, value))
    structure = made(lib.meniscus_read, INPUT.encode(), options)
    exact = made(lib.meniscus_exact_new, structure, options)
    report = text_of(lib.meniscus_pockets_report, exact, options)
    program("pockets", INPUT, "--count", "2", "--rank", "volume", "--report", f"{folder}/p.json")
    with open(f"{folder}/p.json", encoding="utf-8") as file:
        compare_reports(report, json.load(file), ("total", "pockets", "checks"))
    check(lib.meniscus_options_set(options, b"count", b"0"))
    assert lib.meniscus_pockets_report(exact, options, c.byref(c.c_char_p())) == 2
    lib.meniscus_exact_free(exact)
    lib.meniscus_structure_free(structure)
    lib.meniscus_options_free(options)


def only_its_own_symbols():
    symbols = subprocess.run(["nm", "-D", "--defined-only", LIBRARY], check=True, capture_output=True, text=True).stdout
    foreign = [line for line in symbols.splitlines() if " T " in line and " meniscus_" not in line]
    assert not foreign, foreign[:10]


def the_example_runs(folder):
    shown = subprocess.run([EXAMPLE, INPUT, f"{folder}/c.ply"], check=True, capture_output=True, text=True).stdout
    assert "SES area" in shown and pathlib.Path(folder, "c.ply").stat().st_size > 10_000, shown


with tempfile.TemporaryDirectory() as scratch:
    options = c.c_void_p(lib.meniscus_options_new())
    structure = made(lib.meniscus_read, INPUT.encode(), options)
    exact = same_measures(scratch, structure, options)
    same_mesh(scratch, exact, options)
    same_pockets(scratch)
    only_its_own_symbols()
    the_example_runs(scratch)
    lib.meniscus_exact_free(exact)
    lib.meniscus_structure_free(structure)
    lib.meniscus_options_free(options)

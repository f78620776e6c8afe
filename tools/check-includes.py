#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Includes point one way: clients -> public headers -> rooms -> core (ARCHITECTURE.md), and some stay at home."""
import sys

from sources import ROOT, includes, sources

# What a room may include beside itself and core, be it a header of the room or a public one that belongs to it.
ROOMS = {
    "core": (),
    "simd": (),
    "platform": (),
    "space": ("simd",),
    "geometry": ("space", "simd", "platform"),
    "nearest": ("geometry", "space", "simd"),
    "exact": ("nearest", "geometry", "space", "simd"),
    "grid": ("simd", "platform"),
    "band": ("nearest", "geometry", "grid", "simd", "platform"),
    "flow": ("band", "nearest", "geometry", "grid", "simd", "platform"),
    "mesh": ("grid", "simd", "platform"),
    "measure": ("mesh", "exact", "nearest", "geometry", "space", "simd", "platform"),
    "remesh": ("measure", "mesh", "nearest", "space", "simd", "platform"),
    "project": ("remesh", "measure", "nearest", "geometry", "grid", "simd", "platform"),
    "cavities": ("project", "remesh", "mesh", "space", "platform"),
    "pipeline": ("cavities", "project", "remesh", "measure", "mesh", "flow", "band", "grid", "exact", "nearest", "geometry",
                 "space", "platform"),
    "pockets": ("pipeline", "mesh", "band", "grid", "exact", "nearest", "geometry", "space", "platform"),
    "tunnels": ("pipeline", "exact", "space"),
    "reading": ("platform",),
    "radii": ("reading",),
    "structure": ("reading", "radii", "platform"),
    "tables": ("structure", "radii", "flow", "exact", "measure", "pockets", "tunnels", "pipeline", "describe_results", "describe_pockets",
               "describe_tunnels"),
    "mesh_io": ("reading", "mesh"),
    "volume": ("reading", "io", "platform"),
    "values": ("reading", "structure"),
    "describe_pockets": ("describe_results", "pockets", "tables", "structure", "pipeline", "exact"),
    "describe_tunnels": ("describe_results", "tunnels", "tables", "structure", "pipeline"),
    "describe_results": ("exact", "flow", "measure", "pipeline"),
    "file_words": ("colours", "pipeline", "structure", "tables"),
    "io": ("reading", "structure", "tables", "render", "pipeline", "pockets", "tunnels", "describe_results", "grid",
           "platform"),
    "colours": ("reading", "structure", "radii", "tables", "values", "exact", "grid", "platform"),
    "render": ("colours", "platform"),
    "sticks": ("colours", "render", "structure"),
    "page": ("colours", "values", "render", "sticks", "io", "tables", "pockets", "describe_pockets", "structure", "exact", "pipeline", "platform"),
    "draw": ("page", "io", "mesh", "describe_pockets", "describe_tunnels", "pockets", "colours", "render", "sticks", "structure",
             "pipeline"),
}
# Whose a public header is. The others hold the library's vocabulary (vectors, atoms, meshes, values on grids, errors), which
# everybody may use.
PUBLIC = {
    "cavities": "cavities", "colours": "colours", "compare": "pipeline", "cost": "pipeline",
    "describe_options": "pipeline", "describe_pockets": "describe_pockets", "describe_results": "describe_results",
    "describe_tunnels": "describe_tunnels", "draw_pockets": "draw", "draw_surface": "draw",
    "exact_surface": "exact", "field": "pipeline", "file_words": "file_words", "flow": "flow",
    "interfaces": "exact", "legend": "colours", "ligand_bodies": "sticks",
    "level_set": "grid", "level_set_file": "io", "measures": "exact", "mesh_part": "mesh", "mesh_quality": "measure",
    "named_atoms": "structure", "page": "page", "pockets": "pockets", "pocket_chemistry": "tables", "pocket_places": "tables", "pocket_tracks": "pockets", "picture": "render", "radii": "radii", "read_mesh": "mesh_io", "remesh": "remesh",
    "sample": "pipeline", "structure": "structure", "surface": "pipeline", "tables": "tables", "tunnels": "tunnels", "vertex_values": "values",
    "volume_file": "volume", "words": "pipeline", "write": "io",
}
# What clients may use beside the public headers: how to write a file of their own whole or not at all, how foreign
# words stand in messages, how options are read from text, how to load a library, processes and their files, options and results as JSON.
FOR_CLIENTS = ("src/io/options_json.h", "src/io/json_visitor.h", "src/io/describe_structure.h",
               "src/platform/files/atomic_file.h", "src/reading/text.h", "src/reading/option_numbers.h",
               "src/platform/files/loaded_library.h", "src/platform/files/own_file.h", "src/platform/files/child_process.h")
# Words that only some folders may include.
ONLY_IN = {
    "<tbb/": ("src/core/threads/tbb.cpp", "src/render/ray_scene.cpp"),
    "<gemmi/": ("src/structure/", "src/radii/", "src/io/gemmi/"),
    "<embree3/": ("src/render/",),
    "<ft2build.h>": ("src/render/font.cpp",),
    "<openvdb/": ("src/volume/vdb_module.cpp",),
    "<png.h>": ("src/io/", "tests/io/"),
    "<CLI/": ("cli/", "tests/cli/"),
    "<pybind11/": ("python/",),
    # What not every system has is called in platform/; the two others leave it out where it is missing.
    "<dlfcn.h>": ("src/platform/",),
    "<sys/prctl.h>": ("src/platform/",),
    "<sys/syscall.h>": ("src/platform/",),
    "<sys/auxv.h>": ("src/platform/",),
    "<sched.h>": ("src/core/threads/tbb.cpp", "tests/"),
    "<malloc.h>": ("cli/heap.cpp", "src/platform/memory.cpp"),
    "<iostream>": ("cli/", "src/structure/", "src/io/", "tests/", "bench/", "fuzz/"),
    "<fstream>": ("cli/", "src/platform/", "src/structure/", "src/radii/", "src/io/", "tests/", "bench/", "fuzz/"),
}


def room_of(path):
    if path.parts[0] == "include":
        return PUBLIC.get(path.stem, "core")
    return path.parts[1] if path.parts[0] == "src" else None


def wrong_includes(path):
    room = room_of(path)
    for target in includes(path):
        other = room_of(target)
        if room is None:
            if path.parts[0] in ("cli", "python", "c", "web") and target.parts[0] == "src" and str(target) not in FOR_CLIENTS:
                yield f"{target}: only the public headers may be used here"
        elif path.parts[0] == "include" and target.parts[0] == "src":
            yield f"{target}: only the public headers may be used here"
        elif target.parts[0] not in ("src", "include"):
            yield f"{target}: a room may not use a client"
        elif other not in (room, "core", *ROOMS[room]):
            yield f"{target}: {room} may not use {other}"


def misplaced(path):
    text = (ROOT / path).read_text()
    for word, homes in ONLY_IN.items():
        if f"#include {word}" in text and not str(path).startswith(homes):
            yield f"{word} may only be included in {', '.join(homes)}"


def main():
    problems = [f"{path}: {problem}" for path in sources(".h", ".cpp")
                for problem in (*wrong_includes(path), *misplaced(path))]
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


sys.exit(main())

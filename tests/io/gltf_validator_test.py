#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The glTF validator of Khronos finds nothing wrong in the program's GLB files; skipped (77) where there is none.

usage: gltf_validator_test.py PROGRAM SOURCE_DIR

The validator is that of the npm package gltf-validator in build/npm (`./test --full` puts it there), or in the folder
that GLTF_VALIDATOR names.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
MODULES = pathlib.Path(os.environ.get("GLTF_VALIDATOR", SOURCE / "build" / "npm")) / "node_modules"

RUNS = (("plain.glb", ()), ("residue.glb", ("--color", "residue", "--method", "direct", "--spacing", "0.7")),
        ("curvature.glb", ("--color", "curvature", "--edge", "0.8")))
NOTHING = ("nothing.glb", ("--components", "cavities", "--min-cavity", "100000"))


def findings(files):
    """One report per file."""
    result = subprocess.run(["node", pathlib.Path(__file__).with_name("validate_glb.js"), *files], check=True,
                            capture_output=True, encoding="utf-8", env={**os.environ, "NODE_PATH": str(MODULES)})
    return [json.loads(line) for line in result.stdout.splitlines()]


def main():
    if shutil.which("node") is None or not (MODULES / "gltf-validator").is_dir():
        print(f"skipped: needs node and the npm package gltf-validator in {MODULES.parent}")
        return 77
    with tempfile.TemporaryDirectory(prefix="meniscus-") as folder:
        files = []
        for name, options in (*RUNS, NOTHING):
            files.append(pathlib.Path(folder) / name)
            subprocess.run([PROGRAM, "surface", SOURCE / "examples" / "1ubq.pdb", "--quiet", *options,
                            "-o", files[-1]], check=True, stderr=subprocess.DEVNULL)
        bad = 0
        for file, report in zip(files, findings(files), strict=True):
            issues = report["issues"]
            print(file.name, {key: value for key, value in issues.items() if key.startswith("num")})
            bad += issues["numErrors"] + issues["numWarnings"]
            for message in issues["messages"]:
                print("  ", message)
            triangles = report["info"]["totalTriangleCount"]
            bad += (triangles == 0) != (file.name == NOTHING[0])
    return 1 if bad else 0


sys.exit(main())

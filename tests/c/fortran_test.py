# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The example in Fortran, compiled and run: the area of two spheres is that of a closed form.

usage: fortran_test.py LIBRARY PROJECT
"""
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

library, project = map(pathlib.Path, sys.argv[1:3])
if shutil.which("gfortran") is None:
    print("skipped: gfortran is missing")
    sys.exit(77)


def expected_area(d, a, b, p):
    """Of two spheres of radii a and b at a distance d, with a probe of radius p that spans both."""
    x = (d * d + (a + p) ** 2 - (b + p) ** 2) / (2 * d)
    h = math.sqrt((a + p) ** 2 - x * x)
    caps = 2 * math.pi * (a * a * (1 + x / (a + p)) + b * b * (1 + (d - x) / (b + p)))
    first, second = math.asin(x / (a + p)), math.asin((d - x) / (b + p))
    return caps + 2 * math.pi * p * (h * (first + second) - p * (math.sin(first) + math.sin(second)))


with tempfile.TemporaryDirectory() as folder:
    program = pathlib.Path(folder) / "areas"
    subprocess.run(["gfortran", "-std=f2008", "-J", folder, str(project / "examples" / "fortran" / "areas.f90"), "-o",
                    str(program), str(library), f"-Wl,-rpath,{library.parent}"], check=True, env={**os.environ})
    shown = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout
    area = float(re.search(r"SES area\s+([0-9.]+)", shown)[1])
    assert abs(area - expected_area(3.0, 1.7, 1.52, 1.4)) < 2e-6, shown

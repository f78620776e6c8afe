#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Time and memory of `meniscus surface` over structures of growing size, and the exponent of the growth.

Seconds are processor time (user + system) of the whole process with one thread, the least of several runs.

usage: scaling.py [--program FILE] [--repeat N] [--spacing H] [--method M] [INPUT ...]
Without INPUT: reference structures under $MENISCUS_TEST_DATA, or the example if that is not set.
"""
import argparse
import json
import math
import os
import pathlib
import resource
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
REFERENCE = ("1crn", "1ubq", "1hga", "2isk", "6xm4")


def default_inputs():
    data = os.environ.get("MENISCUS_TEST_DATA")
    if not data:
        return [ROOT / "examples" / "1ubq.pdb"]
    return [pathlib.Path(data) / "reference" / "xyzr" / f"{name}.xyzr" for name in REFERENCE]


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def measure(arguments, path, folder):
    """Least processor time of the runs, and the last run's report."""
    command = [arguments.program, "surface", path.resolve(), "-o", "out.ply", "--quiet", "--report", "-", "--threads",
               "1", "--spacing", arguments.spacing, "--method", arguments.method]
    best = math.inf
    for _ in range(arguments.repeat):
        before = processor_seconds()
        result = subprocess.run(list(map(str, command)), cwd=folder, capture_output=True, text=True, check=False)
        best = min(best, processor_seconds() - before)
        if result.returncode not in (0, 6):
            raise SystemExit(f"{path}: exit {result.returncode}: {result.stderr}")
    return best, json.loads(result.stdout)


def exponent(points):
    """Slope of log(seconds) over log(atoms), by least squares."""
    x = [math.log(atoms) for atoms, _ in points]
    y = [math.log(seconds) for _, seconds in points]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "cli" / "meniscus")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--spacing", default="0.5")
    parser.add_argument("--method", default="flow")
    parser.add_argument("inputs", nargs="*", type=pathlib.Path, metavar="INPUT")
    arguments = parser.parse_args()
    arguments.program = arguments.program.resolve()
    stages = ("read", "geometry", "band", "flow", "mesh", "write")
    print(f"{'input':<16} {'atoms':>8} {'cpu s':>8} {'us/atom':>8} {'MB':>7}  " +
          " ".join(f"{stage:>8}" for stage in stages))
    points = []
    with tempfile.TemporaryDirectory() as folder:
        for path in arguments.inputs or default_inputs():
            seconds, report = measure(arguments, path, folder)
            atoms = report["input"]["atoms"]
            points.append((atoms, seconds))
            print(f"{path.name:<16} {atoms:8} {seconds:8.3f} {1e6 * seconds / atoms:8.1f} "
                  f"{report['peak_memory_mb']:7.1f}  " +
                  " ".join(f"{report['time_s'][stage]:8.3f}" for stage in stages))
    if len({atoms for atoms, _ in points}) > 1:
        print(f"time grows as atoms^{exponent(points):.2f}")


if __name__ == "__main__":
    main()

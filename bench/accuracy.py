#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the program over the reference structures and holds every result against the exact values.

For each input: the flow at 0.25 Å from six initial densities (closed, manifold, converged, distances, steps, solver
iterations, the sign at the deepest point of every exact piece, the same number of pieces), and the mesh volume at 0.25 and 0.5 Å where an exact volume is known. Ends with exit code 1 if any
bound is broken.

usage: accuracy.py [--program FILE] [--data FOLDER] [NAME ...]
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOO_LARGE = ("1aon", "2btv", "3jc8", "6xm4", "7cgo", "7o0u")  # more than 14,000 atoms
SUFFIXES = (".pdb", ".ent", ".cif", ".pqr", ".xyzr", ".gz")
DENSITIES = (-0.2, -0.3, -0.5, -0.8, -1.4, -4.0)
# At 0.25 Å, for proteins and nucleic acids.
BOUNDS = {"mean_distance": 0.0032, "p99_distance": 0.04, "steps": 10, "solver_iterations": 90}


def exact_volumes(data):
    rows = [line.split("\t") for line in (data / "reference" / "exact.tsv").read_text().splitlines()[1:]]
    return {row[0]: float(row[6]) for row in rows if row[2] == "1.4"}


def run(program, path, folder, **options):
    command = [program, "surface", path, "-o", folder / "out.ply", "--quiet", "--report", "-"]
    for name, value in options.items():
        command += [f"--{name}", value]
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    if result.returncode != 0:
        return None, [f"exit {result.returncode}: {result.stderr.strip()}"]
    report = json.loads(result.stdout)
    return report, [check["name"] for check in report["checks"] if not check["passed"]]


def volume_bounds(name, atoms):
    """Relative errors allowed at 0.25 and 0.5 Å."""
    if name.startswith("spheres/"):
        return 0.02, math.inf
    return (0.003, 0.012) if atoms < 200 else (0.002, 0.008)


def examine(program, path, name, exact, folder):
    faults = []
    reports = []
    for density in DENSITIES:
        report, failed = run(program, path, folder, spacing=0.25, density=density)
        faults += failed
        if report is None:
            return name, None, faults
        if not name.startswith("spheres/"):
            found = report["mesh"] | report["flow"]
            faults += [f"{key} {found[key]} from C = {density}" for key, bound in BOUNDS.items() if found[key] > bound]
        reports.append(report)
    pieces = [report["mesh"]["components"] for report in reports]
    if len(set(pieces)) > 1:
        faults.append(f"pieces {pieces}")
    row = {"atoms": reports[1]["input"]["atoms"], "mean": reports[1]["mesh"]["mean_distance"],
           "p99": reports[1]["mesh"]["p99_distance"], "pieces": pieces[1],
           "steps": max(report["flow"]["steps"] for report in reports),
           "iterations": max(report["flow"]["solver_iterations"] for report in reports), "seconds": reports[1]["time_s"]["total"]}
    if exact is not None:
        coarse, failed = run(program, path, folder, spacing=0.5)
        faults += failed
        fine_error = max(abs(report["mesh"]["volume"] / exact - 1) for report in reports)
        coarse_error = abs(coarse["mesh"]["volume"] / exact - 1)
        row.update(fine=fine_error, coarse=coarse_error)
        for error, bound, spacing in zip((fine_error, coarse_error), volume_bounds(name, row["atoms"]), (0.25, 0.5)):
            if error > bound:
                faults.append(f"volume off by {error:.2%} at {spacing}")
        if name.startswith("spheres/") and math.log2(coarse_error / fine_error) < 1.8:
            faults.append(f"volume order {math.log2(coarse_error / fine_error):.2f}")
    return name, row, faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "cli" / "meniscus")
    parser.add_argument("--data", type=pathlib.Path, default=os.environ.get("MENISCUS_TEST_DATA"))
    parser.add_argument("names", nargs="*", metavar="NAME", help="only inputs whose name contains one of these")
    arguments = parser.parse_args()
    if arguments.data is None:
        parser.error("name the folder of reference data with --data or MENISCUS_TEST_DATA")
    exact = exact_volumes(arguments.data)
    inputs = [(name, arguments.data / "reference" / name) for name in exact]
    inputs += [(path.name, path) for path in sorted((arguments.data / "structures").iterdir())
               if path.suffix in SUFFIXES and not path.name.startswith(TOO_LARGE)]
    if arguments.names:
        inputs = [pair for pair in inputs if any(part in pair[0] for part in arguments.names)]
    broken = 0
    print(f"{'input':<32} {'atoms':>6} {'pieces':>6} {'mean Å':>8} {'p99 Å':>8} {'steps':>5} {'iter.':>5} {'V 0.25':>8} {'V 0.5':>8} {'s':>6}")
    with tempfile.TemporaryDirectory() as folder:
        for name, path in inputs:
            name, row, faults = examine(arguments.program.resolve(), path, name, exact.get(name), pathlib.Path(folder))
            if row is not None:
                volume = "".join(f" {row[key]:8.3%}" if key in row else f" {'':8}" for key in ("fine", "coarse"))
                print(f"{name:<32} {row['atoms']:6} {row['pieces']:6} {row['mean']:8.4f} {row['p99']:8.4f} "
                      f"{row['steps']:5} {row['iterations']:5}{volume} "
                      f"{row['seconds']:6.2f}", flush=True)
            for fault in faults:
                print(f"{name}: {fault}", flush=True)
            broken += len(faults)
    print(f"{len(inputs)} inputs, {broken} faults")
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()

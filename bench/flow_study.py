#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Makes the numbers and plots of docs/design/flow.md: the three flows over time, and what their pieces cost and bring.

usage: flow_study.py [--program FILE] [--structure FILE] [--figures FOLDER]

Plots need gnuplot; without --figures only the tables are printed.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SPHERES = ROOT / "docs" / "paper" / "two_spheres.xyzr"
SPACING = 0.25
FLOWS = {"paper": ("--flow", "paper"), "paper, closest point": ("--flow", "paper", "--reinitialise", "closest-point"),
         "parallel": ("--flow", "parallel"),
         "anchored": ("--anchor", 4, "--time-step", 0.25, "--max-steps", 60)}
DENSITIES = (-0.3, -0.5, -1.4)

PLOT = """set terminal svg size 720,560 font 'sans-serif,12' background '#ffffff'
set output '{output}'
set datafile separator ','
set logscale y
set format y '%g'
set xlabel 'time / Å²'
set ylabel 'mean distance to the exact surface / Å'
set key below maxrows 3 samplen 2
set grid ytics lc rgb '#dddddd'
plot {curves}
"""
COLOURS = {"paper": "#d55e00", "paper, closest point": "#cc79a7", "parallel": "#0072b2", "anchored": "#009e73"}
DASHES = {-0.3: 1, -0.5: 2, -1.4: 3}


class Study:
    def __init__(self, program, folder):
        self.program = program
        self.folder = pathlib.Path(folder)

    def run(self, structure, *options):
        """The report of a flow, and its history as rows."""
        history = self.folder / "history.csv"
        command = [self.program, "surface", structure, "--spacing", SPACING, "--quiet", "-o", self.folder / "mesh.ply",
                   "--history", history, "--report", "-", *options]
        result = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
        if result.returncode not in (0, 6):
            sys.exit(f"flow_study: {result.stderr.strip()}")
        with history.open() as rows:
            return json.loads(result.stdout), list(csv.DictReader(rows))


def table(title, columns, rows):
    print(f"\n{title}\n\n| " + " | ".join(columns) + " |\n|" + "---|" * len(columns))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |", flush=True)


def courses(study, structure, title, figure):
    """The flows from several starts: best and last state; their course as a plot."""
    rows = []
    curves = []
    for flow, options in FLOWS.items():
        for density in DENSITIES:
            report, history = study.run(structure, "--density", density, *options)
            steps = [step for step in history[1:] if step["mean_distance"]]
            best = min(steps, key=lambda step: float(step["mean_distance"]))
            last = steps[-1]
            rows.append((flow, density, *(f"{float(step['mean_distance']):.4f} at t = {float(step['time']):.2f}"
                                          for step in (best, last)),
                         f"{float(last['volume']) / abs(report['exact']['ses_volume']) - 1:+.1%}", report["flow"]["end"]))
            data = study.folder / f"{title}_{len(rows)}.csv"
            data.write_text("".join(f"{step['time']},{step['mean_distance']}\n" for step in history
                                    if step["mean_distance"]))
            curves.append(f"'{data}' with lines lw 1.5 lc rgb '{COLOURS[flow]}' dt {DASHES[density]} "
                          f"title '{flow}, C = {density}'")
    table(f"Mean distance over time, {title}", ("flow", "C", "best / Å", "last / Å", "last volume", "end"), rows)
    if figure is not None:
        script = PLOT.format(output=figure / f"course_{title}.svg", curves=", ".join(curves))
        subprocess.run(["gnuplot"], input=script, text=True, check=True)


def pieces(study, structure, title):
    """What λ, τ, k, the solver and the curvature field cost and bring."""
    rows = []
    for options in ((), ("--time-step", 1), ("--time-step", 16), ("--anchor", 4), ("--anchor", 4, "--time-step", 4),
                    ("--anchor", 64), ("--half-width", 2), ("--half-width", 4), ("--solver", "gmres"),
                    ("--curvature", "sharp"), ("--curvature", "sharp", "--anchor", 4)):
        report, _ = study.run(structure, *options)
        mesh = report["mesh"]
        flow = report["flow"]
        rows.append((" ".join(map(str, options)) or "default", flow["steps"], flow["solver_iterations"],
                     *(f"{mesh[key]:.4f}" for key in ("mean_distance", "p99_distance", "max_distance")),
                     f"{mesh['corrected_area_deviation']:+.3%}", f"{mesh['volume_deviation']:+.3%}"))
    table(f"Pieces of the anchored flow, {title}", ("options", "steps", "iterations", "mean / Å", "p99 / Å", "max / Å",
                                                    "corrected area", "volume"), rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "cli" / "meniscus")
    parser.add_argument("--structure", type=pathlib.Path,
                        default=ROOT.parent / "shared" / "structures" / "1crn.pdb")
    parser.add_argument("--figures", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        study = Study(options.program, folder)
        for structure, title in ((SPHERES, "two_spheres"), (options.structure, options.structure.stem)):
            pieces(study, structure, title)
            courses(study, structure, title, options.figures)


if __name__ == "__main__":
    main()

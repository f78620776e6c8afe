#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Makes the numbers and plots of docs/design/flow.md: the three flows over time, and what their pieces cost and bring.

usage: flow_study.py [--program FILE] [--data FOLDER] [--figures FOLDER] [TABLE ...]

TABLE: pieces, courses, choices, order, solvers, waves, rim, reach, curvature; without any, all of them. Plots need gnuplot; without
--figures only the tables are printed. FOLDER of --data holds structures/ and reference/.
"""
import argparse
import csv
import itertools
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SPHERES = ROOT / "docs" / "paper"
SPACING = 0.25
TABLES = ("pieces", "courses", "choices", "order", "solvers", "waves", "rim", "reach", "curvature")
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

    def run(self, structure, *options, spacing=SPACING, history=None):
        """The report of a flow, and its history as rows if there is one."""
        command = [self.program, "surface", structure, "--spacing", spacing, "--quiet", "-o", self.folder / "mesh.ply",
                   "--report", "-", *options, *(() if history is None else ("--history", history))]
        result = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
        if result.returncode not in (0, 6):
            sys.exit(f"flow_study: {result.stderr.strip()}")
        if history is None:
            return json.loads(result.stdout), []
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
            report, history = study.run(structure, "--density", density, *options, history=study.folder / "history.csv")
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


def percent(value):
    return f"{value:+.3%}"


def choices(study, data):
    """λ and τ against distance and area; one solve is τ = inf."""
    rows = []
    for anchor, step in ((4, 4), (4, 64), (8, 64), (16, 64), (32, 64), (16, "inf")):
        row = [anchor, step]
        for name, spacing in (("1ubq", 0.25), ("1hga", 0.5)):
            report, _ = study.run(data / "structures" / f"{name}.pdb", "--anchor", anchor, "--time-step", step, spacing=spacing)
            mesh, flow = report["mesh"], report["flow"]
            row += [f"{mesh['mean_distance']:.4f}", f"{mesh['p99_distance']:.4f}", percent(mesh["corrected_area_deviation"]),
                    flow["steps"], flow["solver_iterations"]]
        rows.append(row)
    columns = ("mean / Å", "p99 / Å", "corrected area", "steps", "iterations")
    table("Choice of λ and τ: 1UBQ at 0.25 Å, 1HGA at 0.5 Å", ("λ h²", "τ/h²", *columns, *columns), rows)


def order(study, data):
    """Volume of two overlapping spheres at two spacings, and of the fullerene where a start shows."""
    rows = []
    for anchor in (4, 16):
        errors = [study.run(data / "reference" / "spheres" / "two_overlapping.xyzr", "--anchor", anchor,
                            spacing=spacing)[0]["mesh"]["volume_deviation"] for spacing in (0.5, 0.25)]
        rows.append((anchor, *map(percent, errors), f"{math.log2(errors[0] / errors[1]):.2f}"))
    table("Volume of two overlapping spheres", ("λ h²", "h = 0.5 Å", "h = 0.25 Å", "order"), rows)
    rows = []
    for tolerance in ("1e-3", "1e-4"):
        volumes = [study.run(data / "reference" / "spheres" / "fullerene.xyzr", "--anchor", 4, "--time-step", 1, "--tolerance",
                             tolerance, "--density", density)[0]["mesh"]["volume_deviation"] for density in (-0.5, -4)]
        rows.append((tolerance, *map(percent, volumes)))
    table("Volume of the fullerene, --anchor 4 --time-step 1", ("tolerance", "C = -0.5", "C = -4"), rows)


def solvers(study, data):
    rows = []
    for name, spacing in (("1crn", 0.25), ("1hga", 0.5), ("1hga", 0.25)):
        for solver in ("richardson", "cg", "gmres"):
            report, _ = study.run(data / "structures" / f"{name}.pdb", "--solver", solver, spacing=spacing)
            rows.append((name, spacing, solver, report["flow"]["solver_iterations"], f"{report['mesh']['mean_distance']:.6f}",
                         f"{report['time_s']['flow']:.2f}", f"{report['peak_memory_mb']:.0f}"))
    table("Solvers", ("input", "h / Å", "solver", "iterations", "mean / Å", "flow / s", "memory / MB"), rows)


def wave_factor(anchor, cosines):
    """h²A = h²(λB − L) on the wave with these three cosines: linear in each of them."""
    return anchor * math.prod((2 + c) / 3 for c in cosines) + sum(
        2 * (1 - c) * math.prod((2 + other) / 3 for j, other in enumerate(cosines) if j != i) for i, c in enumerate(cosines))


def waves(_study, _data):
    """A on waves: its range, that of its product with the approximate inverse, and how fast what enters at the rim decays."""
    rows = []
    node = math.sqrt(0.5)  # the inverse interpolates 1/A at cosines of ±node
    grid = [i / 20 for i in range(-20, 21)]
    for anchor in (4, 16, 64):
        corners = [wave_factor(anchor, c) for c in itertools.product((-1, 1), repeat=3)]
        inverses = {signs: 1 / wave_factor(anchor, [node * sign for sign in signs])
                    for signs in itertools.product((-1, 1), repeat=3)}

        def inverse(cosines, inverses=inverses):
            return sum(value * math.prod((1 + sign * c / node) / 2 for sign, c in zip(signs, cosines))
                       for signs, value in inverses.items())

        products = [wave_factor(anchor, c) * inverse(c) for c in itertools.combinations_with_replacement(grid, 3)]
        # along one axis A is middle + 2 beside cos θ, under waves across it; decay is its root beyond 1
        decays = []
        for across in ((1, 1), (1, -1), (-1, -1)):
            least, greatest = (wave_factor(anchor, (c, *across)) for c in (-1, 1))
            ratio = abs((greatest + least) / (greatest - least))
            decays.append(ratio + math.sqrt(ratio * ratio - 1))
        rows.append((anchor, *(f"{value:.2f}" for value in (min(corners), max(corners), min(products), max(products))),
                     f"{min(decays):.1f}", f"{decays[0]:.1f}"))
    table("A = λB − L on waves, F its approximate inverse", ("λ h²", "least h²A", "greatest h²A", "least A F", "greatest A F",
                                                            "least decay per node", "of flat fronts"), rows)


def vertices(study):
    """The vertices of the mesh that a run left as text: their properties as numbers, by name."""
    header, body = (study.folder / "mesh.ply").read_text().split("end_header\n", 1)
    names = [line.split()[2] for line in header.split("element face")[0].splitlines() if line.startswith("property")]
    count = int(header.split("element vertex ")[1].split()[0])
    return [dict(zip(names, map(float, line.split()))) for line in body.splitlines()[:count]]


def rim(study, data):
    """How far the surface moves with the half width of the band, where coefficients come from outside the unknowns."""
    rows = []
    for name in ("1crn", "1ubq"):
        wide = None
        for width in (6, 4, 3, 2):
            study.run(data / "structures" / f"{name}.pdb", "--half-width", width, "--ascii")
            points = [(v["x"], v["y"], v["z"]) for v in vertices(study)]
            if wide is None:
                wide = points
                continue
            if len(points) != len(wide):
                sys.exit(f"flow_study: {name} has other vertices with half width {width}")
            moved = [math.dist(p, q) / SPACING for p, q in zip(points, wide)]
            rows.append((name, width, f"{statistics.mean(moved):.1e}", f"{max(moved):.1e}"))
    table("Vertices against those of half width 6, h = 0.25 Å", ("input", "half width", "mean / h", "max / h"), rows)


def reach(study, data):
    rows = []
    for path, spacing in ((data / "structures/1crn.pdb", 0.5), (data / "structures/1crn.pdb", 0.25),
                          (data / "structures/1crn.pdb", 0.125), (data / "structures/1hga.pdb", 0.25),
                          (data / "reference/xyzr/6xm4.xyzr", 0.25)):
        for method in ("flow", "direct"):
            mesh = study.run(path, "--method", method, spacing=spacing)[0]["mesh"]
            rows.append((path.stem, spacing, method, *(f"{mesh[f'{key}_distance']:.6f}" for key in ("mean", "p99", "max")),
                         *(percent(mesh[f"{key}_deviation"]) for key in ("area", "corrected_area", "volume"))))
    table("What it reaches", ("input", "h / Å", "method", "mean / Å", "p99 / Å", "max / Å", "area", "corrected area",
                              "volume"), rows)


def curvature(study, data):
    """Mean curvature at vertices on contact patches, held against 1/r of their atoms."""
    study.run(data / "structures" / "1crn.pdb", "--ascii")
    with (study.folder / "mesh.atoms.csv").open() as file:
        radii = [float(row["radius"]) for row in csv.DictReader(file)]
    errors = [abs(vertex["mean_curvature"] * radii[int(vertex["atom"])] - 1) for vertex in vertices(study) if vertex["patch"] == 0]
    print(f"\nMean curvature on contact patches of 1crn: median relative error {statistics.median(errors):.2%}, "
          f"{len(errors)} vertices", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "cli" / "meniscus")
    parser.add_argument("--data", type=pathlib.Path,
                        default=os.environ.get("MENISCUS_TEST_DATA", ROOT.parent / "shared"))
    parser.add_argument("--figures", type=pathlib.Path)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help=", ".join(TABLES))
    options = parser.parse_args()
    for name in set(options.tables) - set(TABLES):
        parser.error(f"no table {name}: {', '.join(TABLES)}")
    crambin = (options.data / "structures" / "1crn.pdb", "1crn")
    two, four = ((SPHERES / f"{name}.xyzr", name) for name in ("two_spheres", "four_intersecting"))
    with tempfile.TemporaryDirectory() as folder:
        study = Study(options.program, folder)
        for name in options.tables or TABLES:
            if name == "pieces":
                for structure, title in (two, crambin):
                    pieces(study, structure, title)
            elif name == "courses":
                for structure, title in (two, four, crambin):
                    courses(study, structure, title, options.figures)
            else:
                {"choices": choices, "order": order, "solvers": solvers, "waves": waves, "rim": rim, "reach": reach,
                 "curvature": curvature}[name](study, options.data)


if __name__ == "__main__":
    main()

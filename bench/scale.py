#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Makes the numbers of docs/scale.md: what an atom costs, what archives would, and what bad schedules waste.

usage: scale.py [--program FILE] [--data FOLDER] [--kept FOLDER] [TABLE ...]

TABLE: constants, archives, schedule; without any, all of them. The structures of FOLDER/structures are run through
`meniscus batch` with one job and one thread, which takes three to four minutes on a quiet machine; with --kept what was
run stays there and is used again.
"""
import argparse
import heapq
import json
import os
import pathlib
import random
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLES = ("constants", "archives", "schedule")
RUNS = {"measure": ("measure",), "surface, direct": ("surface", "--method", "direct"), "surface, flow": ("surface",)}
SMALLEST = 1000  # atoms; below, starting the process is most of it

# Inputs, atoms kept of each, of the largest. Entries of the PDB and of AlphaFold DB are counted by their keepers (about
# 230,000 and 214 million); atoms per entry are assumptions, to be replaced by one's own.
ARCHIVES = (("PDB", 230_000, 7_000, 2_440_000), ("human proteome", 20_600, 4_200, 35_000 * 8),
            ("AlphaFold DB", 214_000_000, 2_400, 2_700 * 8), ("HIV capsid", 1, 2_400_000, 2_400_000),
            ("cell model", 1, 100_000_000, 100_000_000))


def table(title, columns, rows):
    print(f"\n{title}\n\n| " + " | ".join(columns) + " |\n|" + "---|" * len(columns))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |", flush=True)


class Runs:
    """Results of batches over the structures, by kind of run."""

    def __init__(self, program, data, folder):
        self.program, self.data, self.folder = program, data, pathlib.Path(folder)

    def batch(self, name, inputs, words):
        out = self.folder / name.replace(", ", "-")
        command = [self.program, "batch", *words, *inputs, "--out", out, "--jobs", 1, "--threads", 1, "--mixed-radii", "--resume"]
        subprocess.run(list(map(str, command)), check=False, stdout=subprocess.DEVNULL)
        rows = []
        for result, times in zip(*((out / f"{kind}.jsonl").read_text().splitlines() for kind in ("results", "times"))):
            size = len(result)
            result, times = json.loads(result), json.loads(times)
            if result["status"] == "done":
                files = sum((out / output).stat().st_size for output in result["outputs"])
                rows.append({"atoms": result["report"]["input"]["atoms"], "cpu": times["cpu_s"], "files": files,
                             "memory": times["run"]["peak_memory_mb"], "line": size, "wall": times["wall_s"]})
        return rows

    def of_structures(self, name):
        return self.batch(name, [self.data / "structures"], RUNS[name])

    def start_up(self):
        """Processor time of a process that has next to nothing to do, s."""
        folder = self.folder / "tiny"
        folder.mkdir(exist_ok=True)
        for i in range(100):
            (folder / f"{i}.xyzr").write_text("0 0 0 1.7\n")
        rows = self.batch("start", [folder], ("measure",))
        return statistics.median(row["cpu"] for row in rows), statistics.median(row["wall"] for row in rows)


def constants(runs):
    """Per kind of run: s, bytes of memory and bytes of files per atom; how it spreads."""
    found, rows = {}, []
    start, wall = runs.start_up()
    for name in RUNS:
        large = [row for row in runs.of_structures(name) if row["atoms"] >= SMALLEST]
        seconds = [(row["cpu"] - start) / row["atoms"] for row in large]
        largest = max(large, key=lambda row: row["atoms"])
        found[name] = {"cpu": sum(row["cpu"] - start for row in large) / sum(row["atoms"] for row in large), "start": start,
                       "memory": 2**20 * largest["memory"] / largest["atoms"],
                       "files": sum(row["files"] for row in large) / sum(row["atoms"] for row in large)}
        line = sum(row["line"] for row in large) / sum(row["atoms"] for row in large)
        rows.append((name, len(large), f"{1e6 * statistics.median(seconds):.0f} ({1e6 * min(seconds):.0f} to {1e6 * max(seconds):.0f})",
                     f"{found[name]['memory'] / 1024:.1f}", f"{found[name]['files'] / 1024:.1f}", f"{line:.1f}"))
    print(f"\nA process that has next to nothing to do: {1000 * start:.0f} ms of processor time, {1000 * wall:.0f} ms of wall clock")
    table("Per atom", ("run", "structures", "processor time / µs: median (least to most)", "memory / kB", "files / kB",
                       "line of results / bytes"), rows)
    return found


def archives(found):
    rows = []
    for archive, inputs, atoms, largest in ARCHIVES:
        for run, cost in found.items():
            seconds = inputs * (cost["start"] + atoms * cost["cpu"])
            rows.append((archive, run, f"{seconds / 3600:,.3g}", f"{largest * cost['memory'] / 2**30:.1f}",
                         f"{inputs * atoms * cost['files'] / 2**40:.2g}" if cost["files"] else "0"))
    table("Archives", ("archive", "run", "core hours", "memory of the largest / GB", "files / TB"), rows)


def loads_by_count(costs, shards):
    """What array jobs do that cut a list into pieces of equal length."""
    return [sum(costs[i * len(costs) // shards:(i + 1) * len(costs) // shards]) for i in range(shards)]


def loads_by_size(sizes, costs, shards):
    """What `meniscus batch --shard` does: largest first, each to the shard that has least."""
    heap = [(0.0, i) for i in range(shards)]
    loads = [0.0] * shards
    for i in sorted(range(len(sizes)), key=lambda i: -sizes[i]):
        load, shard = heapq.heappop(heap)
        loads[shard] += costs[i]
        heapq.heappush(heap, (load + sizes[i], shard))
    return loads


def last_of_jobs(costs, jobs):
    """When the last of several jobs ends that each take the next input."""
    heap = [0.0] * jobs
    for cost in costs:
        heapq.heapreplace(heap, heap[0] + cost)
    return max(heap)


def schedule(runs, inputs=20_000):
    """Idle part of what is paid for, with sizes as measured and a heavy tail, and costs that sizes tell only roughly."""
    measured = sorted(row["atoms"] for row in runs.of_structures("measure") if row["atoms"] < 40_000)
    numbers = random.Random(1)
    sizes = [min(numbers.choice(measured) * numbers.paretovariate(1.6), 2.4e6) for _ in range(inputs)]
    costs = [size * numbers.lognormvariate(0.0, 0.3) for size in sizes]
    rows = []
    for shards in (4, 16, 64, 256, 1024):
        row = [shards]
        for loads in (loads_by_count(costs, shards), loads_by_size(sizes, costs, shards)):
            row.append(f"{1 - sum(loads) / (shards * max(loads)):.1%}")
        rows.append([*row, f"{1 - sum(costs) / (shards * max(*costs, sum(costs) / shards)):.1%}"])
    print(f"\n{inputs} inputs; the largest takes {max(costs) / sum(costs):.2%} of the whole")
    table("Idle cores, one core per shard", ("shards", "equal counts", "balanced by size", "best possible"), rows)
    rows = []
    for jobs in (4, 16, 64):
        ordered = [costs[i] for i in sorted(range(inputs), key=lambda i: -sizes[i])]
        rows.append((jobs, *(f"{1 - sum(costs) / (jobs * last_of_jobs(order, jobs)):.2%}" for order in (sorted(costs), costs, ordered))))
    table("Idle jobs within a shard, inputs taken in turn", ("jobs", "smallest first", "by name", "largest first"), rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "cli" / "meniscus")
    parser.add_argument("--data", type=pathlib.Path, default=os.environ.get("MENISCUS_TEST_DATA", ROOT.parent / "shared"))
    parser.add_argument("--kept", type=pathlib.Path)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help=", ".join(TABLES))
    options = parser.parse_args()
    for name in set(options.tables) - set(TABLES):
        parser.error(f"no table {name}: {', '.join(TABLES)}")
    wanted = options.tables or TABLES
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.kept or temporary
        pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
        runs = Runs(options.program.resolve(), pathlib.Path(options.data).resolve(), folder)
        if "constants" in wanted or "archives" in wanted:
            found = constants(runs)
        if "archives" in wanted:
            archives(found)
        if "schedule" in wanted:
            schedule(runs)


if __name__ == "__main__":
    main()

# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""meniscus.map() without a client: the records and files of `meniscus batch`."""
import contextlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import textwrap
import threading
import time
import unittest
import unittest.mock

from support import PROGRAM, UBIQUITIN, InScratchFolder

import meniscus

CHAIN = "".join(f"{1.5 * i:.1f} {i % 3:.1f} 0 1.{5 + i % 4}\n" for i in range(12))


def write(path, text=CHAIN):
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    pathlib.Path(path).write_text(text)
    return path


def contents(folder):
    """Every file below a folder but those of the state: path -> bytes; times are left out."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(pathlib.Path(folder).rglob("*"))
            if path.is_file() and ".batch" not in path.parts and path.name != "times.jsonl"}


def batch(*words):
    subprocess.run([PROGRAM, "batch", *words, "--quiet"], capture_output=True, check=False)


def run(paths, **keywords):
    return meniscus.map(paths, **{"program": PROGRAM, **keywords})


class Map(InScratchFolder):
    def setUp(self):
        super().setUp()
        self.paths = [write("in/b/small.xyzr", "0 0 0 1.7\n"), write("in/a/large.xyzr"),
                      write("in/top.XYZR", "0 0 0 1.7\n1.5 0 0 1.6\n")]

    def test_records_come_in_the_order_of_the_paths(self):
        for paths in (self.paths, self.paths[::-1], [*self.paths, *map(pathlib.Path, self.paths)]):
            for jobs in (1, 3):
                names = [os.path.relpath(path, "in") for path in paths]
                found = run(paths, jobs=jobs)
                self.assertEqual([record["input"] for record in found], names)
                self.assertEqual([record["report"]["input"]["file"] for record in found],
                                 [os.path.basename(name) for name in names])
        self.assertEqual(run([]), [])

    def test_they_are_the_lines_of_a_batch(self):
        batch("measure", "in", "--out", "out", "--probe", "1.2", "--per", "atom")
        lines = [json.loads(line) for line in pathlib.Path("out/results.jsonl").read_text().splitlines()]
        self.assertEqual(run(sorted(self.paths), probe=1.2, per="atom"), lines)

    def test_failures_are_records(self):
        os.mkfifo("in/never.xyzr")
        found = run([write("in/bad.xyzr", "0 0\n"), "in/never.xyzr", *self.paths], time_limit=1)
        self.assertEqual([record["status"] for record in found], ["failed", "timed out", "done", "done", "done"])
        self.assertRegex(found[0]["error"], r"^bad\.xyzr:1:")
        self.assertEqual(found[1]["error"], "took longer than 1 s")
        self.assertIsNone(found[0]["report"])

    def test_a_missing_file_is_a_failure_as_in_a_batch(self):
        paths = [*self.paths, "in/none.xyzr"]
        write("list", "\n".join(paths) + "\n")
        batch("measure", "--list", "list", "--out", "expected")
        found = run(paths, out="out")
        self.assertEqual([record["status"] for record in found], ["done", "done", "done", "failed"])
        self.assertRegex(found[3]["error"], r"^none\.xyzr: cannot be .*: No such file or directory")
        self.assertEqual(contents("out"), contents("expected"))

    def test_the_files_are_those_of_a_batch(self):
        twins = [write("in/twin.xyzr"), write("in/twin.xyzrn", "0 0 0 1.7 1 C_GLY_1\n")]
        bad = write("in/c/bad.xyzr", "0 0\n")
        batch("surface", "in", "--out", "expected", "--spacing", "1", "--density=-0.6", "-o", ".stl", "-o", "_x.obj")
        expected = contents("expected")
        self.assertLess({"twin.xyzr.stl", "twin.xyzrn_x.obj", "a/large.stl", "results.jsonl"}, set(expected))
        found = run([*self.paths, bad, *twins], command="surface", out="out", outputs=[".stl", "_x.obj"], spacing=1.0,
                    density=-0.6)
        self.assertEqual(contents("out"), expected)
        self.assertEqual(sorted(os.listdir("out")), ["a", "b", *sorted(set(os.listdir("expected")) - {"a", "b", ".batch"})])
        self.assertEqual(found[0]["outputs"], ["b/small.atoms.csv", "b/small.stl", "b/small_x.atoms.csv", "b/small_x.obj"])
        times = [json.loads(line)["input"] for line in pathlib.Path("out/times.jsonl").read_text().splitlines()]
        self.assertEqual(times, sorted(record["input"] for record in found))

    def test_what_is_written_unless_asked(self):
        found = run(self.paths[:1], command="surface", out="out", spacing=1)
        self.assertEqual(sorted(contents("out")), ["results.jsonl", "small.atoms.csv", "small.ply"])
        before = sorted(os.listdir())
        kept = run(self.paths[:1], command="surface", spacing=1)
        self.assertEqual(kept, [{**found[0], "outputs": []}])
        self.assertEqual(sorted(os.listdir()), before)

    def test_names_are_paths_below_the_base(self):
        batch("measure", self.paths[0], "--base", ".", "--out", "expected")
        run(self.paths[:1], out="out", base=".")
        self.assertEqual(contents("out"), contents("expected"))
        with self.assertRaisesRegex(meniscus.UsageError, r"small\.xyzr: is not below .*/in/a; base"):
            run(self.paths, base="in/a")

    def test_options_are_those_of_the_command_line(self):
        shutil.copy(UBIQUITIN, "1ubq.pdb")
        write("score.csv", "chain,resnum,score\nA,8,0.9\nA,44,0.7\n")
        record, = run(["1ubq.pdb"], command="surface", spacing=1, waters=True, min_cavity=5, select=None, verify=False,
                      values=["score.csv"], hetero="all", memory_limit="2G", threads=2)
        options = record["report"]["options"]
        self.assertEqual((options["spacing"], options["waters"], options["min_cavity"], options["select"], options["verify"]),
                         (1.0, True, 5.0, None, False))
        self.assertIn("score", json.dumps(record["report"]["values"]))
        pathlib.Path("wet.pqr").write_text("ATOM 1 N ALA 1 0 0 0 0 1.5\nATOM 2 O HOH 2 5 0 0 0 1.5\n")
        counts = [run(["wet.pqr"], waters=waters)[0]["report"]["input"]["atoms"] for waters in (None, True, False)]
        self.assertEqual(counts, [2, 2, 1])
        self.assertEqual(run(["1ubq.pdb"], probe=1, threads=1), run(["1ubq.pdb"], probe=1.0, threads=2))

    def test_radii_are_not_mixed_unasked(self):
        shutil.copy(UBIQUITIN, "in/x.pdb")
        paths = ["in/x.pdb", *self.paths]
        with self.assertRaisesRegex(ValueError, r"has radii file and x\.pdb has radii united.*mixed_radii=True"):
            run(paths, out="out")
        self.assertFalse(os.path.exists("out/results.jsonl"))
        mixed = run(paths, out="out", mixed_radii=True)
        self.assertEqual([record["report"]["input"]["radii"] for record in mixed], ["united", "file", "file", "file"])
        self.assertEqual(run(paths, radii="bondi")[0]["report"]["input"]["radii"], "bondi")

    def test_an_array_of_slurm_does_not_matter(self):
        array = {"SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": "0", "SLURM_ARRAY_TASK_MAX": "1",
                 "SLURM_ARRAY_TASK_ID": "1"}
        with unittest.mock.patch.dict(os.environ, array):
            self.assertEqual([record["status"] for record in run(self.paths)], ["done"] * 3)


class Refusals(InScratchFolder):
    def refused(self, error, why, *arguments, **keywords):
        with self.assertRaisesRegex(error, why):
            run(*arguments, **keywords)

    def test_what_makes_no_sense(self):
        paths = [write("in/a.xyzr")]
        usage = meniscus.UsageError
        self.refused(usage, "--spacing: must be a finite number", paths, command="surface", spacing=0)
        self.refused(usage, "--spacin", paths, spacin=0.5)
        self.refused(usage, "--time-limit", paths, time_limit="soon")
        self.refused(usage, "command: unknown value 'compare'", paths, command="compare")
        self.refused(usage, "outputs: give a folder", paths, outputs=[".csv"])
        self.refused(usage, "give only the ending", paths, out="out", outputs=["a.csv"])
        for out in ("x.tar", "x.tar.gz", "x.tgz", "x.zip"):
            self.refused(usage, f"out: must be a folder, not '{out}'", paths, out=out)
        self.refused(usage, "jobs 0", paths, jobs=0)
        self.refused(usage, "jobs: the workers", paths, client=unittest.mock.Mock(), jobs=2)
        for option in ("report", "resume", "shard", "list"):
            self.refused(usage, f"{option}: is not an option of map", paths, **{option: "x"})
        self.refused(usage, "holds many inputs", ["in"])
        self.refused(usage, "holds many inputs", [write("in.tar", "")])
        self.refused(TypeError, "list of paths", "in/a.xyzr")
        self.refused(TypeError, "a path must be text", [b"a.xyzr"])
        self.refused(FileNotFoundError, "none of the files is there: .*none.xyzr", ["none.xyzr"])
        self.refused(meniscus.OutputError, "cannot be written", paths, out="in/a.xyzr/out")

    def test_outputs_of_two_inputs_at_one_place(self):
        paths = [write("in/a.xyzr"), write("in/a_x.xyzr")]
        self.refused(meniscus.OutputError, "is also an output of a.xyzr", paths, command="surface", spacing=1, out="out",
                     outputs=["_x.ply", ".ply"])

    def test_the_program_is_missing(self):
        paths = [write("a.xyzr")]
        with unittest.mock.patch.dict(os.environ, PATH="/nonexistent"):
            self.refused(FileNotFoundError, "program is neither in this package nor on the PATH; install it", paths, program=None)
        self.refused(FileNotFoundError, "nowhere/meniscus", paths, program="nowhere/meniscus")

    def test_what_is_on_the_path_is_found(self):
        with unittest.mock.patch.dict(os.environ, PATH=os.path.dirname(PROGRAM)):
            self.assertEqual(run([write("a.xyzr")], program=None)[0]["status"], "done")


class Interruption(InScratchFolder):
    def test_ctrl_c_ends_the_programs(self):
        os.mkfifo("never.xyzr")
        code = f"""
            import sys
            import meniscus
            try:
                meniscus.map(["never.xyzr"], program={PROGRAM!r}, out="out")
            except KeyboardInterrupt:
                sys.exit(3)
        """
        process = subprocess.Popen([sys.executable, "-c", textwrap.dedent(code)], start_new_session=True)
        self.addCleanup(process.wait)
        self.addCleanup(self.end_group, process.pid)
        self.wait_until(lambda: len(self.group(process.pid)) == 3)  # Python, the batch and what it has started
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(30), 3)
        self.wait_until(lambda: not self.group(process.pid))
        self.assertEqual(os.listdir("out"), [])

    @staticmethod
    def end_group(leader):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(leader, signal.SIGKILL)

    @staticmethod
    def group(leader):
        """The processes of a process group that run."""
        found = []
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                fields = (entry / "stat").read_text().rpartition(")")[2].split()
                command = (entry / "cmdline").read_bytes()
            except OSError:
                continue
            if int(fields[2]) == leader and fields[0] != "Z" and (b"measure" in command or int(entry.name) == leader):
                found.append(int(entry.name))
        return found

    @staticmethod
    def wait_until(happened):
        end = time.monotonic() + 60
        while not happened():
            if time.monotonic() > end:
                raise TimeoutError
            threading.Event().wait(0.02)


class Imports(unittest.TestCase):
    def test_no_engine_is_imported(self):
        code = "import sys, meniscus; print([m for m in ('dask', 'distributed') if m in sys.modules])"
        result = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, check=True)
        self.assertEqual(result.stdout, "[]\n")


if __name__ == "__main__":
    unittest.main()

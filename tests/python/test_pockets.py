# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Pockets: the same as the command line's, invariance, closed forms, arrays, files, what is refused."""
import copy
import csv
import io
import json
import os
import pathlib
import pickle
import subprocess
import unittest
import warnings

import numpy as np
from support import CENTRES, PROGRAM, RADII, ROOT, UBIQUITIN, InScratchFolder, read

import meniscus

# What only --at and --model all give.
OF_PLACES_AND_MODELS = ("ligand", "track")
ANTIBODY = str(ROOT / "examples" / "1a0q.pdb")
NMR = pathlib.Path(os.environ.get("MENISCUS_TEST_DATA", "")) / "structures" / "1d3z.pdb"


def found_in(path, **options):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", meniscus.ReadWarning)
        return meniscus.pockets(path, **options)


def shell(radius):
    """Beads on a sphere, so near to each other that no probe passes."""
    count = int(4 * radius**2)
    z = 1 - (2 * np.arange(count) + 1) / count
    turn = np.pi * (3 - 5**0.5) * np.arange(count)
    return radius * np.column_stack([np.sqrt(1 - z**2) * np.cos(turn), np.sqrt(1 - z**2) * np.sin(turn), z])


class Numbers(InScratchFolder):
    def test_are_those_of_the_command_line(self):
        subprocess.run([PROGRAM, "pockets", ANTIBODY, "--report", "r.json", "--quiet", "--large-probe", "8", "--count", "4",
                        "--rank", "volume"], check=True)
        report = json.loads(pathlib.Path("r.json").read_text(encoding="utf-8"))
        found = found_in(ANTIBODY, large_probe=8.0, count=4, rank="volume")
        self.assertEqual(found.totals, report["total"])
        self.assertEqual(found.checks, report["checks"])
        self.assertEqual(len(found), len(report["pockets"]))
        for pocket, block in zip(found, report["pockets"]):
            for name, value in block.items():
                if name in OF_PLACES_AND_MODELS:
                    continue
                ours = getattr(pocket, name)
                if name in ("mouths", "openings"):
                    self.assertEqual([(m.area, m.radius, list(m.centre)) for m in ours],
                                     [(m["area"], m["radius"], m["centre"]) for m in value])
                elif name in ("centre", "atoms"):
                    self.assertEqual(list(ours), value, name)
                else:
                    self.assertEqual(ours, value, name)

    def test_add_up(self):
        found = found_in(UBIQUITIN)
        self.assertTrue(found.passed)
        self.assertAlmostEqual(sum(pocket.volume for pocket in found) + found.rest_volume, found.volume, 6)
        for place, pocket in enumerate(found):
            self.assertEqual(pocket.rank, place + 1)
            self.assertAlmostEqual(pocket.wall_atom_areas.sum(), pocket.wall_area, 9)
            self.assertTrue((found.voxels["pocket"][pocket.voxels] == place).all())
            self.assertEqual(pocket.atoms.tolist(), pocket.wall_atoms[pocket.wall_atom_areas > 1.0].tolist())
            if pocket.volume > 0 and not pocket.cavity:
                shares = float(found.voxels["share"][pocket.voxels].sum(dtype=np.float64))
                self.assertAlmostEqual(shares * found.scale / pocket.volume, 1.0, 5)

    def test_of_all_pocket_space_does_not_depend_on_the_orientation(self):
        protein = read(UBIQUITIN, radii="united")
        turned, _ = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))
        there, here = (meniscus.pockets(xyz, protein.radii) for xyz in (protein.xyz @ turned + 7.3, protein.xyz))
        self.assertAlmostEqual(there.volume / here.volume, 1.0, 6)
        self.assertAlmostEqual(there.totals["mouth_area"] / here.totals["mouth_area"], 1.0, 6)

    def test_a_closed_shell_has_its_cavity(self):
        centres = shell(6.0)
        found = meniscus.pockets(centres, np.full(len(centres), 1.7))
        cavity = next(pocket for pocket in found if pocket.cavity)
        exact = meniscus.measure(centres, np.full(len(centres), 1.7)).cavities[0]
        self.assertAlmostEqual(cavity.volume, exact.volume, 6)
        self.assertEqual(cavity.mouths, [])

    def test_do_not_depend_on_threads(self):
        one, two = found_in(UBIQUITIN, threads=1), found_in(UBIQUITIN, run=meniscus.RunOptions(threads=2))
        self.assertEqual(one.pockets, two.pockets)


class Places(InScratchFolder):
    def report(self, *words):
        subprocess.run([PROGRAM, "pockets", ANTIBODY, *words, "--report", "r.json", "--quiet"], check=True)
        return json.loads(pathlib.Path("r.json").read_text(encoding="utf-8"))

    def test_of_a_ligand_are_those_of_the_command_line(self):
        block = self.report("--at", "(HEP)")["pockets"][0]
        of_structure = read(ANTIBODY, radii="united", hetero="none")
        with open(ANTIBODY, "rb") as file:
            for source in (ANTIBODY, file, of_structure):
                pocket = found_in(source, at="(HEP)")[0]
                self.assertEqual(vars(pocket.ligand), block["ligand"])
                for name in ("at", "site", "volume", "score", "residues"):
                    self.assertEqual(getattr(pocket, name), block[name], name)
        ligand = read(ANTIBODY, radii="united", hetero="all", select="(HEP)")
        by_centres, by_spheres = found_in(ANTIBODY, at=[ligand.xyz, ligand])
        self.assertEqual((by_centres.volume, by_centres.ligand), (block["volume"], None))
        self.assertEqual(by_spheres.ligand.inside, block["ligand"]["inside"])

    def test_need_something_that_can_be_read_again(self):
        with self.assertRaisesRegex(meniscus.UsageError, "at: a selection needs a file"):
            meniscus.pockets(CENTRES, RADII, at="(HEM)")
        with self.assertRaisesRegex(meniscus.UsageError, "at: empty"):
            meniscus.pockets(CENTRES, RADII, at=[])

    def compare(self, way, block):
        for name in ("bottleneck_radius", "bottleneck_atoms", "certified_radius", "length", "curvature"):
            self.assertEqual(getattr(way, name), block[name], name)
        self.assertEqual(way.points.tolist(), [point["position"] for point in block["profile"]])
        self.assertEqual(way.radii.tolist(), [point["radius"] for point in block["profile"]])
        self.assertEqual(way.distances.tolist(), [point["distance"] for point in block["profile"]])

    def test_have_the_tunnels_of_the_command_line(self):
        report = self.report("--tunnels", "--count", "3", "--pore", "z")
        tunnels = found_in(ANTIBODY, count=3).tunnels()
        self.assertEqual([(t.pocket, t.rank) for t in tunnels], [(b["pocket"], b["rank"]) for b in report["tunnels"]])
        for tunnel, block in zip(tunnels, report["tunnels"]):
            self.compare(tunnel, block)
        pore = meniscus.pore(read(ANTIBODY, radii="united", hetero="none"), "z")
        self.assertEqual(pore is None, report["pore"] is None)
        if pore is not None:
            self.compare(pore, report["pore"])


class Models(InScratchFolder):
    def write_ensemble(self, *shifts):
        """Of ubiquitin's atoms: those on one side moved along x, by another length in each model."""
        atoms = [line for line in pathlib.Path(UBIQUITIN).read_text(encoding="ascii").splitlines()
                 if line.startswith("ATOM")]
        lines = []
        for number, shift in enumerate(shifts):
            lines.append(f"MODEL     {number + 1:4}")
            for line in atoms:
                x = float(line[30:38])
                lines.append(f"{line[:30]}{x + (shift if x > 30 else 0):8.3f}{line[38:]}")
            lines.append("ENDMDL")
        pathlib.Path("models.pdb").write_text("\n".join(lines) + "\nEND\n", encoding="ascii")
        return "models.pdb"

    def compare_with_the_command_line(self, path, *words, with_tunnels):
        subprocess.run([PROGRAM, "pockets", path, "--model", "all", *words, "--over-models", "all.csv", "--report", "r.json",
                        "-o", "p.csv", "--quiet"], check=True)
        with open("all.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", meniscus.ReadWarning)
            structures = meniscus.read_models(path, radii="united", hetero="none")
        found = [meniscus.pockets(structure) for structure in structures]
        followed = meniscus.follow_pockets(found, [model.tunnels() for model in found] if with_tunnels else None)
        self.assertEqual(len(followed.tracks), len(rows))
        for track, row in zip(followed.tracks, rows):
            self.assertEqual(int(row["of"]), len(found))
            for name, whole in (("track", "number"), ("models", "models"), ("open", "open"), ("best_rank", "best_rank"),
                                *([("ways", "ways")] if with_tunnels else [])):
                self.assertEqual(getattr(track, whole), int(row[name]), name)
            for name in ("score", "volume", "depth", "mouth_radius", "bottleneck"):
                spread = getattr(track, name)
                shown = [spread.mean][:spread.values] + [spread.deviation][:max(0, spread.values - 1)]
                self.assertEqual(shown, [float(cell) for cell in (row[name], row[name + "_sd"]) if cell], name)
            self.assertEqual("; ".join(track.residues), row["residues"])
        reports = json.loads(pathlib.Path("r.json").read_text(encoding="utf-8"))
        self.assertEqual(followed.of_pockets, [[p["track"] for p in report["pockets"]] for report in reports])
        return followed

    def test_are_followed_as_by_the_command_line(self):
        followed = self.compare_with_the_command_line(self.write_ensemble(0.0, 0.4, 0.8), "--tunnels", with_tunnels=True)
        self.assertEqual(followed.tracks[0].models, 3)
        self.assertTrue(any(track.ways for track in followed.tracks))
        self.assertTrue(any(track.volume.deviation > 1.0 for track in followed.tracks))

    @unittest.skipUnless(NMR.exists(), "needs MENISCUS_TEST_DATA")
    def test_of_nmr_are_followed_as_by_the_command_line(self):
        self.compare_with_the_command_line(str(NMR), with_tunnels=False)

    def test_without_names_are_told_apart_by_the_order_of_atoms(self):
        protein = read(UBIQUITIN, radii="united", hetero="none")
        found = meniscus.pockets(protein.xyz, protein.radii)
        numbers = list(range(1, len(found) + 1))
        self.assertEqual(meniscus.follow_pockets([found, found]).of_pockets, [numbers, numbers])

    def test_that_do_not_match_are_refused(self):
        found = meniscus.pockets(shell(6.0), np.full(144, 1.7))
        self.assertEqual(meniscus.follow_pockets([]), meniscus.PocketTracks([], []))
        with self.assertRaisesRegex(TypeError, "models: must be Pockets, not Pocket"):
            meniscus.follow_pockets(found)
        with self.assertRaisesRegex(meniscus.UsageError, "tunnels: of 1 models, but there are pockets of 2"):
            meniscus.follow_pockets([found, found], [[]])
        far = meniscus.Tunnel(99, 1, 1.0, (0, 0, 0), [], False, 1.0, 1.0, 1.0, [], [], [], [])
        with self.assertRaisesRegex(meniscus.UsageError, "tunnels: one begins in pocket 99"):
            meniscus.follow_pockets([found], [[far]])


class Input(InScratchFolder):
    def test_is_read_as_the_ranking_was_fitted_unless_told(self):
        self.assertEqual(found_in(ANTIBODY).structure.radii_set, "united")
        self.assertNotIn("HEP", found_in(ANTIBODY).structure.resname)
        kept = found_in(ANTIBODY, radii="bondi", hetero="ligands").structure
        self.assertEqual(kept.radii_set, "bondi")
        self.assertIn("HEP", kept.resname)
        reading = meniscus.ReadOptions(radii="bondi", hetero="ligands")
        self.assertEqual(found_in(ANTIBODY, reading=reading).structure.resname.tolist(), kept.resname.tolist())

    def test_of_a_structure_is_taken_as_it_is(self):
        protein = read(UBIQUITIN, radii="united")
        self.assertEqual(meniscus.pockets(protein).pockets, found_in(UBIQUITIN).pockets)
        self.assertIs(meniscus.pockets(protein).structure, protein)

    def test_without_pockets_gives_none(self):
        found = meniscus.pockets([[0, 0, 0]], [2.0])
        self.assertEqual((len(found), found.pockets, len(found.voxels["xyz"])), (0, [], 0))

    def test_that_makes_no_sense_is_refused(self):
        for options, message in (({"rank": "beauty"}, "rank: unknown value 'beauty'; choose one of score, volume, depth"),
                                 ({"large_probe": 1.0}, "large_probe 1: must be larger than the probe"),
                                 ({"spacing": 3.0}, "spacing 3: must be from 0.2 to 2"),
                                 ({"count": 0}, "count 0: must be at least 1"),
                                 ({"probe": -1.0}, "probe: must be")):
            with self.assertRaisesRegex(meniscus.UsageError, message):
                meniscus.pockets(CENTRES, RADII, **options)
        for options in ({"probe": "1.4"}, {"count": 1.5}, {"rank": 1}, {"threads": "two"}):
            with self.assertRaises(TypeError):
                meniscus.pockets(CENTRES, RADII, **options)
        with self.assertRaisesRegex(TypeError, "watters"):
            meniscus.pockets(UBIQUITIN, watters=True)
        with self.assertRaisesRegex(TypeError, "radii: required"):
            meniscus.pockets(CENTRES)
        with self.assertRaises(FileNotFoundError):
            meniscus.pockets("no-such-file.pdb")


class Results(InScratchFolder):
    def test_have_arrays_of_their_types(self):
        found = found_in(UBIQUITIN)
        types = {"xyz": np.float64, "share": np.float32, "depth": np.float32, "probability": np.float32, "pocket": np.int32}
        self.assertEqual({name: array.dtype.type for name, array in found.voxels.items()}, types)
        self.assertEqual(found.voxels["xyz"].shape, (len(found.voxels["share"]), 3))
        with self.assertRaises(ValueError):
            found.voxels["share"][0] = 0

    def test_are_copied_to_the_bit(self):
        found = found_in(UBIQUITIN)
        for again in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
            self.assertEqual(again.pockets, found.pockets)
            self.assertEqual((again.totals, again.checks, again.options), (found.totals, found.checks, found.options))
            self.assertEqual(again.voxels["xyz"].tobytes(), found.voxels["xyz"].tobytes())
            self.assertEqual(again[0].wall_atom_areas.tobytes(), found[0].wall_atom_areas.tobytes())

    def test_are_written_as_by_the_command_line(self):
        found = found_in(UBIQUITIN)
        for suffix in ("csv", "json", "pdb", "cif", "dx", "mrc", "npz"):
            subprocess.run([PROGRAM, "pockets", UBIQUITIN, "-o", "a." + suffix, "--quiet"], check=True)
            found.save("b." + suffix)
            stream = io.BytesIO()
            found.write(stream, suffix)
            ours, theirs = pathlib.Path("b." + suffix).read_bytes(), pathlib.Path("a." + suffix).read_bytes()
            self.assertEqual(ours, theirs, suffix)
            self.assertEqual(stream.getvalue(), theirs, suffix)
        found.save("p.dx", field="probability")
        self.assertNotEqual(pathlib.Path("p.dx").read_bytes(), pathlib.Path("a.dx").read_bytes())
        way = found.tunnels()
        pore = meniscus.pore(found.structure, way[0].points[[0, -1]])
        for call in (lambda: found.save("a.gif"), lambda: found.save("a.dx", field="mask"),
                     lambda: found.save("a.csv", view="askew"), lambda: found.save("a.csv", tunnels=way),
                     lambda: found.save("a.pdb", tunnels=[pore, pore])):
            with self.assertRaises(meniscus.UsageError):
                call()
        with self.assertRaises(TypeError):
            found.save("a.pdb", tunnels=[0])

    def test_are_drawn_as_by_the_command_line(self):
        outputs = ["a.html", "a.png", "a.glb", "a.pdb", "a.cif"]
        found = found_in(UBIQUITIN)
        tunnels = found.tunnels()
        ends = tunnels[0].points[[0, -1]].round(3)
        pore = ",".join(str(x) for x in ends.ravel())
        subprocess.run([PROGRAM, "pockets", UBIQUITIN, *(word for path in outputs for word in ("-o", path)), "--quiet",
                        "--tunnels", "--pore", pore, "--size", "200x150", "--view", "left"], check=True)
        subprocess.run([PROGRAM, "pockets", UBIQUITIN, "-o", "a.ply", "--quiet"], check=True)
        ways = [*tunnels, meniscus.pore(found.structure, ends)]
        for path in outputs:
            found.save("b" + path[1:], tunnels=ways, size=(200, 150), view="left")
        found.save("b.ply")
        for path in (*outputs, "a.ply"):
            self.assertEqual(pathlib.Path("b" + path[1:]).read_bytes(), pathlib.Path(path).read_bytes(), path)

    def test_say_where_the_ranking_was_not_fitted(self):
        self.assertEqual(found_in(UBIQUITIN).doubt, "")
        self.assertIn("spacing", found_in(UBIQUITIN, spacing=1.5).doubt)

    def test_are_a_table(self):
        found = found_in(UBIQUITIN)
        rows = found.table()
        self.assertEqual(rows["volume"], [pocket.volume for pocket in found])
        self.assertEqual(rows["residues"][0], "; ".join(found[0].residues))
        self.assertEqual(list(found.to_pandas().columns), list(rows))


if __name__ == "__main__":
    unittest.main()

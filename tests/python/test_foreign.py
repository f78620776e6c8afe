# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Objects of MDAnalysis, MDTraj, Biopython, gemmi, Biotite and OpenMM give the structures that their files give."""
import importlib.util
import os
import pathlib
import pickle
import subprocess
import sys
import unittest
import unittest.mock
import warnings

import foreign
import numpy as np
from support import ROOT, UBIQUITIN, InScratchFolder, read

import meniscus

DATA = os.environ.get("MENISCUS_TEST_DATA", "")
COMPLEX = str(ROOT / "examples" / "1a0q.pdb")
COLUMNS = ("radii", "element", "name", "resname", "resnum", "icode", "chain", "altloc", "serial", "b_factor", "occupancy")

LINE = "{:6}{:5} {:4}{:1}{:3} {:1}{:4}{:1}   {:8.3f}{:8.3f}{:8.3f}{:6.2f}{:6.2f}          {:>2}\n".format
# Alternative locations, an insertion code, a ligand, an ion and a water.
RICH = "".join([
    LINE("ATOM", 1, " N  ", "", "SER", "A", 10, "", 0, 0, 0, 1, 5, "N"),
    LINE("ATOM", 2, " CA ", "", "SER", "A", 10, "", 1.5, 0, 0, 1, 6, "C"),
    LINE("ATOM", 3, " CB ", "A", "SER", "A", 10, "", 2.0, 1.4, 0, 0.4, 7, "C"),
    LINE("ATOM", 4, " CB ", "B", "SER", "A", 10, "", 2.1, 1.3, 0.3, 0.6, 8, "C"),
    LINE("ATOM", 5, " N  ", "", "GLY", "A", 10, "A", 2.0, -1.2, 0, 1, 9, "N"),
    LINE("ATOM", 6, " CA ", "", "GLY", "A", 10, "A", 3.4, -1.3, 0, 1, 10, "C"),
    "TER\n",
    LINE("HETATM", 8, " C1 ", "", "LIG", "B", 1, "", 12, 0, 0, 1, 11, "C"),
    LINE("HETATM", 9, " C2 ", "", "LIG", "B", 1, "", 13.4, 0, 0, 1, 12, "C"),
    LINE("HETATM", 10, "ZN  ", "", " ZN", "B", 2, "", 20, 0, 0, 1, 13, "ZN"),
    LINE("HETATM", 11, " O  ", "", "HOH", "B", 3, "", 25, 0, 0, 1, 14, "O"),
    "END\n"])


def has(package):
    return unittest.skipUnless(importlib.util.find_spec(package), f"{package} is not installed")


def quietly(function, *arguments, **options):
    """Other packages warn of what they miss in a file."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return function(*arguments, **options)


def of_mdanalysis(path):
    import MDAnalysis
    return quietly(MDAnalysis.Universe, path)


def of_biopython(path):
    from Bio.PDB import PDBParser
    return PDBParser(QUIET=True).get_structure(pathlib.Path(path).stem, path)


def of_biopython_cif(path):
    from Bio.PDB import MMCIFParser
    return MMCIFParser(QUIET=True).get_structure(pathlib.Path(path).stem, path)


def of_gemmi(path):
    import gemmi
    return gemmi.read_structure(path)


def of_mdtraj(path):
    import mdtraj
    return quietly(mdtraj.load, path)


READERS = (("MDAnalysis", of_mdanalysis, meniscus.from_mdanalysis), ("Bio", of_biopython, meniscus.from_biopython),
           ("gemmi", of_gemmi, meniscus.from_gemmi))


class SameAsTheFile(InScratchFolder):
    def expect_same(self, made, wanted, but=()):
        self.assertEqual((len(made), made.radii_set), (len(wanted), wanted.radii_set))
        np.testing.assert_allclose(made.xyz, wanted.xyz, atol=1e-5)
        for name in COLUMNS:
            if name in but:
                continue
            one, other = getattr(made, name), getattr(wanted, name)
            if one.dtype.kind == "f":
                np.testing.assert_allclose(one, other, atol=1e-5, err_msg=name)
            else:
                self.assertEqual(one.tolist(), other.tolist(), name)
        if not but:
            self.assertEqual((made.notes, made.dropped), (wanted.notes, wanted.dropped))

    def test_atoms_names_radii_notes_and_areas(self):
        pathlib.Path("rich.pdb").write_text(RICH)
        for package, parse, convert in READERS:
            if not importlib.util.find_spec(package):
                continue
            for path in (UBIQUITIN, COMPLEX, "rich.pdb"):
                with self.subTest(package=package, path=path):
                    made, wanted = quietly(convert, parse(path)), read(path)
                    self.expect_same(made, wanted)
                    self.assertAlmostEqual(meniscus.measure(made).ses_area, meniscus.measure(wanted).ses_area, 2)
                    self.assertEqual(made.stem, wanted.stem)

    def test_options_are_those_of_files(self):
        pathlib.Path("rich.pdb").write_text(RICH)
        for package, parse, convert in READERS:
            if not importlib.util.find_spec(package):
                continue
            for options in ({"hetero": "all", "waters": True}, {"hetero": "ligands"}, {"altloc": "A"}, {"chains": "A"},
                            {"select": "chain A and name CA"}, {"radii": "bondi"}):
                with self.subTest(package=package, options=options):
                    self.expect_same(quietly(convert, parse("rich.pdb"), **options), read("rich.pdb", **options))

    @unittest.skipUnless(DATA, "MENISCUS_TEST_DATA does not name a folder of structures")
    def test_real_structures(self):
        """With alternative residues, insertion codes, sugars, several models, modified residues."""
        for name in ("1en2.cif", "1us0.pdb", "1igy.pdb", "1l2y.pdb", "1ema.cif"):
            path = str(pathlib.Path(DATA) / "structures" / name)
            for package, parse, convert in (*READERS, ("Bio", of_biopython_cif, meniscus.from_biopython)):
                fits = name.endswith(".cif") == (parse is of_biopython_cif) or package == "gemmi"
                if not (fits and importlib.util.find_spec(package)):
                    continue
                with self.subTest(package=package, name=name):
                    self.expect_same(quietly(convert, parse(path)), read(path), but=("notes",))

    @has("mdtraj")
    def test_what_mdtraj_keeps(self):
        """Nanometres become Å; of the names only what MDTraj has is compared."""
        made, wanted = meniscus.from_mdtraj(of_mdtraj(UBIQUITIN)), read(UBIQUITIN)
        self.expect_same(made, wanted, but=("b_factor", "occupancy"))
        self.assertAlmostEqual(meniscus.measure(made).ses_area, meniscus.measure(wanted).ses_area, 2)
        self.assertEqual(made.index[:3].tolist(), [0, 1, 2])

    @has("mdtraj")
    def test_mdtraj_does_not_tell_hetero_groups(self):
        pathlib.Path("rich.pdb").write_text(RICH)
        made = meniscus.from_mdtraj(of_mdtraj("rich.pdb"), hetero="ligands")
        self.assertIn("LIG", made.resname)
        self.assertNotIn("ZN", made.resname)
        self.assertRegex(made.notes[0], "taken as hetero groups: MDTraj does not tell them")


class Everywhere(InScratchFolder):
    def setUp(self):
        super().setUp()
        self.wanted = meniscus.measure(read(UBIQUITIN)).sas_area

    def test_objects_are_taken_as_atoms(self):
        for package, parse, _ in (*READERS, ("mdtraj", of_mdtraj, None)):
            if not importlib.util.find_spec(package):
                continue
            with self.subTest(package=package):
                source = parse(UBIQUITIN)
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore", DeprecationWarning)
                    self.assertAlmostEqual(meniscus.measure(source).sas_area, self.wanted, 2)
                    self.assertEqual(meniscus.measure(source, "bondi").structure.radii_set, "bondi")
                    self.assertEqual(len(meniscus.ExactSurface(source, waters=True).structure), 660)
                    self.assertEqual(len(meniscus.surface(source, spacing=1.0).structure), 602)
                    self.assertGreater(meniscus.signed_distance(source, points=[[0, 0, 0]])[0], 20)
                    part = {"select": "//A/1-10", "spacing": 1.0, "points": 1.0}
                    self.assertLess(meniscus.compare(source, UBIQUITIN, **part).hausdorff, 0.01)

    def test_options_of_files_are_refused(self):
        stack = foreign.AtomArray(read(UBIQUITIN), read(UBIQUITIN).xyz)
        for option in ({"model": 2}, {"assembly": "1"}):
            with self.assertRaisesRegex(TypeError, f"{next(iter(option))}: .* of an object of Biotite, frame=N is taken"):
                meniscus.measure(stack, **option)
        with self.assertRaisesRegex(TypeError, "frame: goes with trajectories"):
            meniscus.measure(UBIQUITIN, frame=0)
        with self.assertRaisesRegex(meniscus.UsageError, "numbers go with an array"):
            meniscus.measure(stack, np.ones(602))
        with self.assertRaisesRegex(TypeError, "from_mdtraj: a Trajectory is needed, not Structure"):
            meniscus.from_mdtraj(read(UBIQUITIN))

    def test_objects_without_atoms(self):
        stack = foreign.AtomArrayStack(read(UBIQUITIN), np.zeros((0, 602, 3)))
        cases = [(meniscus.from_biotite, stack, "Biotite: no models, and so no atoms")]
        if importlib.util.find_spec("gemmi"):
            import gemmi
            cases += [(meniscus.from_gemmi, gemmi.Structure(), "gemmi: no models, and so no atoms"),
                      (meniscus.from_gemmi, gemmi.Model("1"), "gemmi: no atoms")]
        if importlib.util.find_spec("mdtraj"):
            cases += [(meniscus.from_mdtraj, of_mdtraj(UBIQUITIN)[:0], "MDTraj: no frames, and so no atoms")]
        if importlib.util.find_spec("Bio"):
            from Bio.PDB.Structure import Structure
            cases += [(meniscus.from_biopython, Structure("x"), "Biopython: no models, and so no atoms"),
                      (meniscus.from_biopython, [], "Biopython: no atoms")]
        if importlib.util.find_spec("MDAnalysis"):
            import MDAnalysis
            cases += [(meniscus.from_mdanalysis, MDAnalysis.Universe.empty(3), "MDAnalysis: the universe has no coordinates"),
                      (meniscus.from_mdanalysis, MDAnalysis.Universe.empty(3).atoms, "MDAnalysis: the universe has no coord"),
                      (meniscus.from_mdanalysis, MDAnalysis.Universe.empty(0, trajectory=True), "MDAnalysis: no atoms")]
        for convert, source, message in cases:
            for options in ({}, {"frame": 0}) if "and so" in message else ({},):
                with self.subTest(message=message, options=options), self.assertRaisesRegex(meniscus.InputError, message):
                    convert(source, **options)

    def test_warnings_name_the_line_of_the_caller(self):
        atoms = read(UBIQUITIN, select="//A/1-2")
        twice = foreign.AtomArray(atoms, np.zeros((len(atoms), 3)))
        for call in (lambda: meniscus.from_biotite(twice), lambda: meniscus.ExactSurface(twice)):
            with self.assertWarnsRegex(meniscus.ReadWarning, "at exactly the position") as caught:
                call()
            self.assertEqual(caught.filename, __file__)

    def test_nothing_is_imported_before_it_is_asked_for(self):
        code = ("import sys, meniscus; "
                "print([m for m in ('MDAnalysis', 'mdtraj', 'Bio', 'gemmi', 'biotite', 'openmm', 'pandas', 'trimesh', "
                "'pyvista', 'torch', 'distributed') if m in sys.modules])")
        found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual(found.stdout.strip(), "[]")


@has("MDAnalysis")
class OfMDAnalysis(InScratchFolder):
    def setUp(self):
        super().setUp()
        import MDAnalysis
        from MDAnalysis.coordinates.memory import MemoryReader
        self.universe = of_mdanalysis(UBIQUITIN)
        places = self.universe.atoms.positions
        self.universe.load_new(np.stack([places, places + 1, places + 2]), format=MemoryReader)
        self.assertTrue(MDAnalysis)

    def test_the_current_frame_or_another(self):
        universe = self.universe
        first = meniscus.from_mdanalysis(universe).xyz
        universe.trajectory[1]
        np.testing.assert_allclose(meniscus.from_mdanalysis(universe.atoms).xyz, first + 1, atol=1e-4)
        for frame in (2, -1):
            np.testing.assert_allclose(meniscus.from_mdanalysis(universe, frame=frame).xyz, first + 2, atol=1e-4)
        self.assertEqual(universe.trajectory.frame, 1)
        with self.assertRaisesRegex(meniscus.UsageError, "frame 3: there are 3, counted from 0"):
            meniscus.from_mdanalysis(universe, frame=3)
        with self.assertRaisesRegex(TypeError, "frame: must be a whole number"):
            meniscus.measure(universe, frame=1.5)

    def test_a_group_that_changes_with_the_frame(self):
        protein = self.universe.select_atoms("protein")
        low = float(np.median(protein.positions[:, 0])) + 0.5
        chosen = self.universe.select_atoms(f"protein and prop x > {low}", updating=True)
        now, then = (len(meniscus.from_mdanalysis(chosen, frame=frame)) for frame in (0, 2))
        self.assertGreater(then, now)
        self.assertEqual(now, len(chosen))

    def test_index_is_of_the_universe(self):
        chosen = self.universe.select_atoms("resid 10:20")
        made = meniscus.from_mdanalysis(chosen)
        self.assertEqual(made.index.tolist(), chosen.ix.tolist())
        self.assertEqual(pickle.loads(pickle.dumps(made)).index.tolist(), chosen.ix.tolist())
        self.assertEqual(made.split_chains()[0].index.tolist(), chosen.ix.tolist())

    def test_groups_of_residues_and_chosen_waters(self):
        self.assertEqual(len(meniscus.from_mdanalysis(self.universe.residues[:5])), len(read(UBIQUITIN, select="//A/1-5")))
        waters = self.universe.select_atoms("resname HOH")
        with self.assertRaisesRegex(meniscus.InputError, r"MDAnalysis: no atoms left: 58 waters left out"):
            meniscus.measure(waters)
        self.assertEqual(len(meniscus.measure(waters, waters=True).structure), 58)


    def test_a_long_trajectory_leaves_nothing_behind(self):
        def resident_mb():
            with open("/proc/self/statm", encoding="ascii") as file:
                return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20

        atoms = self.universe.select_atoms("resid 1:20")
        for i in range(300):
            meniscus.measure(atoms, frame=i % 3, cavities=False)
            if i == 50:
                before = resident_mb()
        self.assertLess(resident_mb() - before, 8.0)


class OfBiopython(InScratchFolder):
    @has("Bio")
    def test_parts_models_and_lists(self):
        whole = of_biopython(UBIQUITIN)
        chain = whole[0]["A"]
        self.assertEqual(len(meniscus.from_biopython(chain)), 602)
        self.assertEqual(len(meniscus.measure(chain[10]).structure), len(chain[10]))
        some = [atom for atom in whole.get_atoms() if atom.name == "CA"]
        self.assertEqual(len(meniscus.measure(some).structure), 76)
        atoms = [LINE("ATOM", i, f" {name} ", "", "GLY", "A", 1, "", 1.5 * i, 0, 0, 1, 5, name[0])
                 for i, name in enumerate(("N ", "CA"))]
        pathlib.Path("two.pdb").write_text(f"MODEL        1\n{atoms[0]}ENDMDL\nMODEL        2\n{''.join(atoms)}ENDMDL\n")
        models = of_biopython("two.pdb")
        self.assertEqual(len(meniscus.from_biopython(models, frame=1)), 2)
        first = meniscus.from_biopython(models)
        self.assertEqual((len(first), first.notes[0]), (1, "model 0 of 2 taken (choose another with frame=N)"))
        with self.assertRaisesRegex(meniscus.UsageError, "frame: goes with a whole Structure"):
            meniscus.from_biopython(chain, frame=0)

    @has("Bio")
    def test_lists_of_what_cannot_be_used(self):
        from Bio.PDB.Atom import Atom
        whole = of_biopython(UBIQUITIN)
        atoms = list(whole.get_atoms())[:3]
        for source, kind in (([*atoms, 5], "int"), ("abc", "str"), (list(whole.get_residues()), "Residue"), ([None], "NoneType")):
            with self.assertRaisesRegex(TypeError, f"a list of atoms is needed, not one with {kind}"):
                meniscus.from_biopython(source)
        with self.assertRaisesRegex(meniscus.InputError, "Biopython: atom CB belongs to no residue"):
            meniscus.from_biopython([*atoms, Atom("CB", np.zeros(3), 0, 1, " ", " CB ", 1, "C")])
        atoms[1].coord = None
        for source in (atoms, whole):
            with self.assertRaisesRegex(meniscus.InputError, "Biopython: atom CA has no coordinates"):
                meniscus.from_biopython(source)

    @has("gemmi")
    def test_parts_of_gemmi(self):
        whole = of_gemmi(UBIQUITIN)
        self.assertEqual(len(meniscus.from_gemmi(whole[0])), 602)
        self.assertEqual(len(meniscus.measure(whole[0][0]).structure), 602)


class StandIns(InScratchFolder):
    """Of Biotite and OpenMM, which cannot be installed here."""

    def setUp(self):
        super().setUp()
        self.protein = read(UBIQUITIN)

    def test_biotite(self):
        protein = self.protein
        made = meniscus.from_biotite(foreign.AtomArray(protein, protein.xyz, ("b_factor", "atom_id")))
        SameAsTheFile.expect_same(self, made, protein, but=("altloc", "occupancy"))
        stack = foreign.AtomArrayStack(protein, [protein.xyz, protein.xyz + 5])
        np.testing.assert_allclose(meniscus.from_biotite(stack, frame=1).xyz, protein.xyz + 5, atol=1e-4)
        self.assertEqual(meniscus.from_biotite(stack).notes, ["model 0 of 2 taken (choose another with frame=N)"])
        self.assertAlmostEqual(meniscus.measure(stack).ses_area, meniscus.measure(protein).ses_area, 2)

    def test_openmm(self):
        protein = self.protein
        with unittest.mock.patch.dict(sys.modules, foreign.openmm_unit()):
            for source in (foreign.modeller(protein), foreign.simulation(protein), foreign.pdb_file(protein, [protein.xyz])):
                made = meniscus.from_openmm(source)
                SameAsTheFile.expect_same(self, made, protein, but=("b_factor", "occupancy"))
                self.assertAlmostEqual(meniscus.measure(source).ses_area, meniscus.measure(protein).ses_area, 2)
            frames = foreign.pdb_file(protein, [protein.xyz, protein.xyz + 5])
            np.testing.assert_allclose(meniscus.from_openmm(frames, frame=1).xyz, protein.xyz + 5, atol=1e-4)

    def test_a_topology_of_openmm_needs_positions(self):
        topology = foreign.Topology(self.protein)
        np.testing.assert_allclose(meniscus.from_openmm(topology, self.protein.xyz / 10).xyz, self.protein.xyz)
        with unittest.mock.patch.dict(sys.modules, foreign.openmm_unit()):
            one_by_one = [foreign.Quantity(place, 0.1) for place in self.protein.xyz]
            np.testing.assert_allclose(meniscus.from_openmm(topology, one_by_one).xyz, self.protein.xyz)
        with self.assertRaisesRegex(TypeError, "a Topology has no positions; give them, too"):
            meniscus.from_openmm(topology)


if __name__ == "__main__":
    unittest.main()

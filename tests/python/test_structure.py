# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Reading files, structures made of arrays, radii."""
import pathlib
import unittest
import warnings

import numpy as np
from support import CENTRES, RADII, UBIQUITIN, InScratchFolder, read

import meniscus


class Reading(InScratchFolder):
    def test_columns_have_an_entry_per_kept_atom(self):
        protein = read(UBIQUITIN)
        self.assertEqual(len(protein), 602)
        for column in ("radii", "element", "name", "chain", "resname", "resnum", "icode", "residue", "altloc",
                       "serial", "b_factor", "occupancy", "charge"):
            self.assertEqual(getattr(protein, column).shape, (602,), column)
        self.assertEqual(protein.xyz.shape, (602, 3))
        self.assertEqual(protein.xyz[0].tolist(), [27.340, 24.430, 2.614])
        self.assertEqual((protein.name[1], protein.element[1], protein.chain[1]), ("CA", "C", "A"))
        self.assertEqual((protein.resname[601], protein.resnum[601], protein.residue[601]), ("GLY", 76, 75))
        self.assertEqual((protein.b_factor[0], protein.occupancy[0], protein.serial[0]), (9.67, 1.0, 1))

    def test_arrays_of_atoms_are_views_that_cannot_be_written_to(self):
        protein = read(UBIQUITIN)
        self.assertTrue(np.shares_memory(protein.xyz, protein.xyz))
        with self.assertRaises(ValueError):
            protein.xyz[0, 0] = 1.0

    def test_what_happens_with_every_file_is_a_note_and_no_warning(self):
        protein = meniscus.read(UBIQUITIN)  # warnings are errors here
        self.assertEqual(protein.notes, ["58 waters left out (keep them with waters=True)"])
        self.assertEqual((protein.warnings, protein.dropped), ([], {"waters": 58}))
        self.assertEqual(meniscus.read_models(UBIQUITIN)[0].notes, protein.notes)
        self.assertEqual(meniscus.Structure.from_arrays(CENTRES, RADII).notes, [])

    def test_what_may_make_a_number_wrong_is_warned_of_and_kept(self):
        pathlib.Path("twice.xyzr").write_text("0 0 0 1.7\n0 0 0 1.7\n")
        with self.assertWarns(meniscus.ReadWarning) as caught:
            spheres = meniscus.read("twice.xyzr")
        self.assertEqual([str(w.message) for w in caught.warnings], spheres.warnings)
        self.assertEqual(spheres.warnings, ["1 atom at exactly the position of another atom"])
        self.assertEqual((caught.filename, spheres.notes), (__file__, []))

    def test_notes_and_warnings_name_options_as_keywords(self):
        atom = "HETATM{:5}  C{:<2} {} A   1    {:8.3f}   0.000   0.000  1.00  0.00           {}\n".format
        pathlib.Path("m.pdb").write_text("MODEL 1\n" + atom(1, "1", "LIG", 0, " C") + atom(2, "2", "LIG", 2, " C") +
                                         "ATOM      3  CA  GLY A   2       9.000   0.000   0.000\nENDMDL\n"
                                         "MODEL 2\nATOM      3  CA  GLY A   2       9.000   0.000   0.000\nENDMDL\n")
        with self.assertWarns(meniscus.ReadWarning):  # models of different sizes
            notes = meniscus.read("m.pdb").notes
        self.assertIn("model 1 of 2 taken (choose another with model=N)", notes)
        self.assertIn('1 LIG left out (keep it with hetero="ligands")', notes)

    def test_models_can_be_joined(self):
        atom = "ATOM      1  CA  GLY {}   1       {}.000   0.000   0.000  1.00  0.00           C\n".format
        pathlib.Path("unit.pdb1").write_text(f"MODEL 1\n{atom('A', 0)}ENDMDL\nMODEL 2\n{atom('A', 4)}ENDMDL\n")
        self.assertEqual(meniscus.read("unit.pdb1", model="join").chain.tolist(), ["A", "A-2"])
        self.assertEqual(len(meniscus.read("unit.pdb1")), 1)
        pathlib.Path("dock.pdb").write_text(f"{atom('A', 0)}END\n{atom('B', 4)}END\n")
        with self.assertWarnsRegex(meniscus.ReadWarning, r'chain B follows it \(take all with model="join"\)'):
            meniscus.read("dock.pdb")
        self.assertEqual(meniscus.read("dock.pdb", model="join").chain.tolist(), ["A", "B"])

    def test_a_small_molecule_is_kept_unless_none_is_given(self):
        pathlib.Path("l.pdb").write_text("".join(
            f"HETATM{i:5}  C{i}  UNL A   1    {2.0 * i:8.3f}   0.000   0.000  1.00  0.00           C\n" for i in (1, 2)))
        molecule = read("l.pdb")
        self.assertEqual(len(molecule), 2)
        self.assertIn("neither protein nor nucleic acid here, so hetero groups are kept: 1 UNL", molecule.notes)
        self.assertEqual([len(m) for m in (read("l.pdb", hetero="ligands"), read("l.pdb", hetero="all"))], [2, 2])
        with self.assertRaisesRegex(meniscus.InputError, "no atoms left"):
            meniscus.read("l.pdb", hetero="none")

    def test_options_choose_atoms(self):
        self.assertEqual(len(read(UBIQUITIN, waters=True)), 660)
        self.assertEqual(set(read(UBIQUITIN, select="CA").name), {"CA"})
        self.assertEqual(len(read(UBIQUITIN, chains="A")), len(read(UBIQUITIN, chains=["A"])))
        self.assertEqual(read(UBIQUITIN, radii="bondi").radii_set, "bondi")
        self.assertEqual(len(read(pathlib.Path(UBIQUITIN), model=1, altloc="A", hydrogens="drop", hetero="all")), 602)

    def test_waters_and_ligands_of_pqr_files_are_kept_unless_told_otherwise(self):
        atom = "{:6}{:5} {:4} {:3} A{:4}    {:8.3f}   0.000   0.000  0.1000 1.5000\n".format
        pathlib.Path("a.pqr").write_text(atom("ATOM", 1, " N", "ALA", 1, 0) + atom("HETATM", 2, " C1", "LIG", 2, 3) +
                                         atom("HETATM", 3, " C2", "LIG", 2, 4) + atom("HETATM", 4, " O", "HOH", 3, 8))
        with self.assertWarnsRegex(meniscus.ReadWarning, r"1 water of the file kept .*waters=False.*waters=True"):
            self.assertEqual(len(meniscus.read("a.pqr")), 4)
        self.assertEqual(len(meniscus.read("a.pqr", waters=True)), 4)
        self.assertEqual(len(meniscus.read("a.pqr", waters=False)), 3)
        self.assertEqual(len(meniscus.read("a.pqr", waters=False, hetero="none")), 1)
        self.assertEqual(len(meniscus.read_models("a.pqr", waters=False, select="(LIG)")[0]), 2)
        self.assertEqual(len(read(UBIQUITIN, waters=False, hetero="none")), 602)

    def test_unknown_words_are_value_errors_that_name_the_known_ones(self):
        for options, message in (({"hetero": "some"}, "hetero: unknown value 'some'; choose one of none, ligands, all"),
                                 ({"hydrogens": "add"}, "hydrogens: unknown value 'add'; choose one of auto, keep, drop"),
                                 ({"chains": "A,"}, "chains: empty name"),
                                 ({"model": 0}, "model: must be a whole number of at least 1, not 0"),
                                 ({"model": "join", "assembly": 1}, 'model="join": the models of a file are not to be '),
                                 ({"altloc": "AB"}, "altloc: must be one character, not 'AB'"),
                                 ({"select": "hydro"}, "select 'hydro': 'hydro' has no exact counterpart in gemmi's syntax"),
                                 ({"select": "//Z"}, "; chains or select keep none"),
                                 ({"radii": "nosuch"}, "radii=\"nosuch\": neither a radius set nor a file")):
            with self.assertRaises(ValueError) as caught:
                meniscus.read(UBIQUITIN, **options)
            self.assertIn(message, str(caught.exception))

    def test_all_models_are_read_by_another_function(self):
        with self.assertRaisesRegex(TypeError, r"must be a whole number or \"join\", not 'all'; read_models\(\) reads"):
            meniscus.read(UBIQUITIN, model="all")

    def test_types_that_cannot_be_meant_are_type_errors(self):
        for options in ({"model": "1"}, {"model": 1.5}, {"model": True}, {"hetero": 3}):
            with self.assertRaises(TypeError):
                meniscus.read(UBIQUITIN, **options)
        with self.assertRaises(TypeError):
            meniscus.read(3)

    def test_a_missing_file_is_a_file_not_found_error(self):
        with self.assertRaises(FileNotFoundError) as caught:
            meniscus.read("nosuch.pdb")
        self.assertIn("nosuch.pdb", str(caught.exception))
        with self.assertRaises(IsADirectoryError):
            meniscus.read(".")

    def test_a_malformed_file_is_a_value_error_with_its_line(self):
        text = pathlib.Path(UBIQUITIN).read_text().replace("27.340", "27.x40", 1)
        pathlib.Path("bad.pdb").write_text(text)
        with self.assertRaises(meniscus.InputError) as caught:
            meniscus.read("bad.pdb")
        self.assertIsInstance(caught.exception, ValueError)
        self.assertRegex(str(caught.exception), r"^bad\.pdb:\d+:\d+: ")

    def test_all_models_are_read_one_by_one(self):
        pathlib.Path("two.xyzr").write_text("0 0 0 1.5\n")
        self.assertEqual([len(s) for s in meniscus.read_models("two.xyzr")], [1])


class FromArrays(InScratchFolder):
    def test_names_are_kept_and_residues_are_runs(self):
        made = meniscus.Structure.from_arrays(CENTRES, RADII, element=["C", "N", "C", "O"], name="CA", chain="A",
                                              resname=["ALA", "ALA", "GLY", "GLY"], resnum=[1, 1, 2, 2])
        self.assertEqual(made.residue.tolist(), [0, 0, 1, 1])
        self.assertEqual(made.name.tolist(), ["CA"] * 4)
        self.assertEqual(made.resnum.tolist(), [1, 1, 2, 2])
        self.assertEqual(made.serial.tolist(), [1, 2, 3, 4])
        self.assertEqual(made.radii_set, "given")

    def test_radii_may_be_one_number_or_a_set(self):
        self.assertEqual(meniscus.Structure.from_arrays(CENTRES, 2.0).radii.tolist(), [2.0] * 4)
        self.assertEqual(meniscus.Structure.from_arrays(CENTRES, "bondi", element="N").radii.tolist(), [1.55] * 4)

    def test_columns_hold_what_they_are_meant_to(self):
        self.assertEqual(meniscus.Structure.from_arrays(CENTRES, RADII, name=np.array([b"CA"] * 4)).name.tolist(), ["CA"] * 4)
        masked = np.ma.array(CENTRES, mask=np.arange(12).reshape(4, 3) < 3)
        for columns in ({"resnum": [1, 2, 3, 3e9]}, {"resnum": 1.7}, {"serial": [0.5] * 4}, {"chain": [None] * 4},
                        {"b_factor": np.ma.array([1.0] * 4, mask=[1, 0, 0, 0])}):
            with self.assertRaisesRegex(meniscus.UsageError, next(iter(columns))):
                meniscus.Structure.from_arrays(CENTRES, RADII, **columns)
        with self.assertRaisesRegex(meniscus.UsageError, "masked"):
            meniscus.measure(masked, RADII)

    def test_columns_of_the_wrong_length_are_value_errors(self):
        for columns in ({"element": ["C"]}, {"b_factor": [1.0]}, {"resnum": [1, 2]}):
            with self.assertRaisesRegex(ValueError, next(iter(columns))):
                meniscus.Structure.from_arrays(CENTRES, RADII, **columns)

    def test_saving_gives_back_the_same_atoms(self):
        read(UBIQUITIN).save("copy.xyzrn")
        read(UBIQUITIN).save("copy.pdb", values=np.arange(602) / 10)
        read(UBIQUITIN).save("copy.csv")
        self.assertTrue((read("copy.xyzrn").xyz == read(UBIQUITIN).xyz).all())
        self.assertEqual(read("copy.pdb").b_factor[601], 60.1)
        self.assertEqual(len(pathlib.Path("copy.csv").read_text().splitlines()), 603)
        with self.assertRaisesRegex(ValueError, "choose one of"):
            read(UBIQUITIN).save("copy.doc")
        with self.assertRaises(OSError):
            read(UBIQUITIN).save("nosuch/copy.pdb")


class Radii(unittest.TestCase):
    def test_sets_know_elements_or_names(self):
        self.assertEqual(meniscus.radii(["C", "fe"]).tolist(), [1.7, 2.44])
        self.assertEqual(meniscus.radii("O", "OG", "SER", set="united").tolist(), [1.6])
        self.assertEqual(meniscus.radii(["H"], ["HA"], ["ALA"], set="united").tolist(), [0.0])

    def test_they_are_those_of_reading(self):
        protein = read(UBIQUITIN)
        again = meniscus.radii(protein.element, protein.name, protein.resname, set="united")
        self.assertTrue((again == protein.radii).all())

    def test_what_is_not_known_is_a_value_error(self):
        with self.assertRaisesRegex(ValueError, "atom 1 "):
            meniscus.radii(["C", "Xx"])
        with self.assertRaisesRegex(ValueError, "neither a radius set nor a file"):
            meniscus.radii(["C"], set="nosuch")


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()

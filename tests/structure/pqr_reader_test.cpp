// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pqr_reader.h"

#include "fragments.h"
#include "support/test_data.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::error_of;
using meniscus::testing::expect_contains;
using meniscus::testing::has_line;
using meniscus::testing::has_warning;
using meniscus::testing::read_text;

std::string error_in_pqr(const std::string& text) {
    try {
        parse_pqr(text, "f");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

// The only atom of a text, with its residue.
struct OneAtom {
    RawAtom atom;
    RawResidue residue;
};

OneAtom one_atom(const std::string& text) {
    const RawModel model = parse_pqr(text + "\n", "f");
    EXPECT_EQ(model.atoms.size(), 1U) << text;
    return model.atoms.empty() ? OneAtom{} : OneAtom{model.atoms[0], model.residue_of(model.atoms[0])};
}

TEST(Pqr, ReadsAtomsWithAndWithoutAChain) {
    const RawModel model = parse_pqr(
        "REMARK x\nATOM  5 N      MET    1   -6.40600   5.46900  -3.25900 -0.30000 1.85000\n"
        "HETATM 6 ZN ZN B -27A 1 2 3 2.0 1.4\nATOM 7 CA ALA C1000 1 2 3 0 1.7\nTER\nEND\n",
        "f");
    ASSERT_EQ(model.atoms.size(), 3U);
    EXPECT_TRUE(model.has_radii);
    EXPECT_TRUE(model.notes.empty());
    EXPECT_EQ(model.atoms[0].centre, (Vec3{-6.406, 5.469, -3.259}));
    EXPECT_EQ(model.atoms[0].charge, -0.3);
    EXPECT_EQ(model.atoms[0].radius, 1.85);
    EXPECT_EQ(model.atoms[0].element, "N");
    EXPECT_EQ(model.residues[0].number, 1);
    EXPECT_EQ(model.residues[1].chain, "B");
    EXPECT_EQ(model.residues[1].number, -27);
    EXPECT_EQ(model.residues[1].insertion_code, 'A');
    EXPECT_EQ(model.atoms[1].element, "ZN");
    EXPECT_EQ(model.residues[2].chain, "C");
    EXPECT_EQ(model.residues[2].number, 1000);
}

TEST(Pqr, ErrorsNameTheirPlace) {
    EXPECT_TRUE(error_in_pqr("ATOM 1 N ALA 1 0 0 0 0 -1.5\n").starts_with("f:1:24: radius '-1.5' is negative"));
    EXPECT_TRUE(error_in_pqr("ATOM 1 N ALA 1 0 nan 0 0 1.5\n").starts_with("f:1:18: y coordinate 'nan'"));
    EXPECT_TRUE(error_in_pqr("ATOM 1 N ALA 1 0 nan 0 0 1.5 N\n").starts_with("f:1:18: y coordinate 'nan'"));
    EXPECT_TRUE(error_in_pqr("\nATOM 1 N ALA 1 0 0 0 1,0 1.5\n").starts_with("f:2:22: charge '1,0'"));
    expect_contains(error_in_pqr("ATOM 1 N ALA 1 0 0 0 0\n"), "this line has 9");
    expect_contains(error_in_pqr("ATOM 1 N ALA A 0.5 0 0 0 1\n"), "residue number 'A'");
}

TEST(Pqr, AWordThatIsMissingIsNotTakenForAnother) {
    const std::string numbers = " 27.340 24.430 2.614 0.1000";
    const std::string no_radius = error_in_pqr("ATOM 1 N MET A 1" + numbers + "\n");
    EXPECT_TRUE(no_radius.starts_with("f:1:44: a PQR atom has 10 words, or 11 with a chain (here 'A')")) << no_radius;
    const std::string no_serial = error_in_pqr("ATOM N MET A 1" + numbers + " 1.62\n");
    EXPECT_TRUE(no_serial.starts_with("f:1:6: serial number 'N' is not an integer")) << no_serial;
    expect_contains(error_in_pqr("ATOM 1000000HD21 ASN A 1" + numbers + " 1.62\n"), "serial number '1000000HD21'");
    for (const char* serial : {"-1", "A0000", "186a0", "*****", "***"})
        EXPECT_EQ(one_atom(std::string("ATOM ") + serial + " N MET A 1" + numbers + " 1.62").atom.name, "N") << serial;
}

TEST(Pqr, ASerialNumberMayHaveGrownOntoItsRecord) {
    for (const char* record : {"HETATM10000 ", "HETATM 10000", "ATOM  10000 ", "ATOM 10000  ", "hetatm10000 "}) {
        const OneAtom read =
            one_atom(record + std::string("C2   LIG A 900      43.000  20.000   5.000  0.1000 1.7000"));
        EXPECT_EQ(read.atom.serial, 10000) << record;
        EXPECT_EQ(read.atom.centre, (Vec3{43, 20, 5})) << record;
        EXPECT_EQ(read.atom.hetatm, record[0] == 'H' || record[0] == 'h') << record;
    }
    for (const char* record : {"ATOM 100000", "ATOM100000", "ATOM  100000"})
        EXPECT_EQ(one_atom(record + std::string(" N ALA 1 0 0 0 0 1")).atom.serial, 100000) << record;
    EXPECT_EQ(one_atom("HETATM***** N ALA 1 0 0 0 0 1").atom.radius, 1.0);
}

// Of PDB2PQR: what has grown together stands in its columns.
TEST(Pqr, NumbersThatHaveGrownTogetherAreReadByColumns) {
    const OneAtom read = one_atom("ATOM      1  N   MET A   1     -32.660-105.570-117.386  0.1000 1.6200");
    EXPECT_EQ(read.atom.centre, (Vec3{-32.66, -105.57, -117.386}));
    EXPECT_EQ(read.atom.charge, 0.1);
    EXPECT_EQ(read.atom.radius, 1.62);
    EXPECT_EQ(read.residue.chain, "A");
    const OneAtom without_chain = one_atom("ATOM      1  N   MET     1    -132.660-105.570-117.386-10.100010.6200");
    EXPECT_EQ(without_chain.atom.centre, (Vec3{-132.66, -105.57, -117.386}));
    EXPECT_EQ(without_chain.atom.charge, -10.1);
    EXPECT_EQ(without_chain.atom.radius, 10.62);
    EXPECT_EQ(without_chain.residue.chain, "");
}

TEST(Pqr, NamesThatHaveGrownTogetherAreReadByColumns) {
    const std::string numbers = "      27.340  24.430   2.614  0.1600 1.6200";
    const OneAtom four = one_atom("ATOM     12 HD21NASN A  12 " + numbers.substr(1));
    EXPECT_EQ(four.atom.name, "HD21");
    EXPECT_EQ(four.residue.name, "NASN");
    EXPECT_EQ(four.residue.chain, "A");
    const OneAtom water = one_atom("ATOM     12  OH2 TIP3A  12" + numbers);
    EXPECT_EQ(water.residue.name, "TIP3");
    EXPECT_EQ(water.residue.chain, "A");
    EXPECT_EQ(water.residue.number, 12);
    const OneAtom lipid = one_atom("ATOM     12  C1  POPCA1200" + numbers);
    EXPECT_EQ(lipid.residue.name, "POPC");
    EXPECT_EQ(lipid.residue.chain, "A");
    EXPECT_EQ(lipid.residue.number, 1200);
    EXPECT_EQ(one_atom("ATOM     12  C1  POPC12000" + numbers).residue.number, 12000);
    EXPECT_EQ(one_atom("ATOM  100000HD21 ASN A  12" + numbers).atom.name, "HD21");
}

TEST(Pqr, ANameIsCutFromAKnownResidueAnywhere) {
    const OneAtom read = one_atom("ATOM 12 HD21ASN A 12 1 2 3 0.1 1.2");
    EXPECT_EQ(read.atom.name, "HD21");
    EXPECT_EQ(read.residue.name, "ASN");
    EXPECT_EQ(read.residue.chain, "A");
    EXPECT_EQ(one_atom("ATOM 12 HD21ASN 12 1 2 3 0.1 1.2").residue.name, "ASN");
}

TEST(Pqr, WhereNothingHelpsTheMessageNamesTheWords) {
    const std::string numbers = error_in_pqr("ATOM 1 N MET A 1 -32.660-105.570-117.386 0.1 1.62\n");
    EXPECT_TRUE(numbers.starts_with("f:1:18: '-32.660-105.570-117.386' is several words grown together")) << numbers;
    expect_contains(numbers, "--whitespace");
    const std::string with_element = error_in_pqr("ATOM 1 N MET A 1 1.5-105.570 2.0 0.1 1.62 N\n");
    EXPECT_TRUE(with_element.starts_with("f:1:18: '1.5-105.570' is several words")) << with_element;
    expect_contains(error_in_pqr("ATOM 1 HD21LIG 1 1 2 3 0.1 1.62\n"), "f:1:8: 'HD21LIG' is several words");
    expect_contains(error_in_pqr("ATOM 1 HD21LIG A 1 1 2 3 0.1 1.62\n"), "f:1:8: 'HD21LIG' is several words");
    expect_contains(error_in_pqr("ATOM 1 H LIG 1 2 3 0.1 1.62\n"), "this line has 9: words are missing, or");
}

// gmx editconf -mead, cpptraj, ParmEd, fpocket.
TEST(Pqr, ReadsWhatOtherProgramsWrite) {
    const OneAtom gromacs = one_atom("ATOM      1  CA  MET     1      27.340  24.430   2.614  0.16  1.62           C");
    EXPECT_EQ(gromacs.residue.chain, "");
    EXPECT_EQ(gromacs.residue.number, 1);
    EXPECT_EQ(gromacs.atom.radius, 1.62);
    EXPECT_EQ(gromacs.atom.element, "C");
    const OneAtom cpptraj =
        one_atom("ATOM      1  N   MET A   1      27.340  24.430   2.614  0.1592  1.8240       N  ");
    EXPECT_EQ(cpptraj.residue.chain, "A");
    EXPECT_EQ(cpptraj.atom.radius, 1.824);
    const OneAtom parmed = one_atom("ATOM      1  N    MET PROA   1     27.340  24.430   2.614   0.1592   1.8240");
    EXPECT_EQ(parmed.residue.chain, "PROA");
    const OneAtom fpocket = one_atom("ATOM      1 APOL STP     1      27.340  24.430   2.614    0.00     3.62");
    EXPECT_EQ(fpocket.residue.name, "STP");
    EXPECT_EQ(fpocket.atom.radius, 3.62);
}

// "%-6s%5d %-4.4s%4.4s%c%4d %8.3f %8.3f %8.3f %6.2f %6.2f"
TEST(Pqr, GromacsWritesTheChainBehindTheResidue) {
    const OneAtom one = one_atom("ATOM      2  CA  META1001   26.266   25.413    2.842   0.07   1.70");
    EXPECT_EQ(one.residue.name, "MET");
    EXPECT_EQ(one.residue.chain, "A");
    EXPECT_EQ(one.residue.number, 1001);
    EXPECT_EQ(one.atom.centre, (Vec3{26.266, 25.413, 2.842}));
    EXPECT_EQ(one.atom.radius, 1.7);
    EXPECT_EQ(one_atom("ATOM    603 OE1 HISEA  77   45.747   30.081   19.708  -0.83   1.52").residue.name, "HISE");
    const std::string water = "ATOM    603 OW   SOLA  77   45.747   30.081   19.708  -0.83   1.52\n";
    EXPECT_TRUE(has_warning(read_text(water + water, "w.pqr"), "1 water"));
}

TEST(Pqr, TheElementBehindTheRadiusCountsIfTheNameBearsItOut) {
    EXPECT_EQ(one_atom("ATOM 1 CA LIG 1 1 2 3 0.1 1.2 CA").atom.element, "CA");
    EXPECT_EQ(one_atom("ATOM 1 CA LIG 1 1 2 3 0.1 1.2 C").atom.element, "C");
    EXPECT_EQ(one_atom("ATOM 1 CA ALA 1 1 2 3 0.1 1.2 S").atom.element, "C");
}

TEST(Pqr, NoLineThatMayBeAnAtomIsPassedOver) {
    const std::string atom = "ATOM 1 N ALA 1 0 0 0 0 1\n";
    const std::string wrong = error_in_pqr(atom + "ATM 2 C ALA 1 2.0 0.0 0.0 0 1\n");
    EXPECT_TRUE(wrong.starts_with("f:2:1: 'ATM' is not a record, but the line may be meant as an atom")) << wrong;
    expect_contains(error_in_pqr(atom + "2 C ALA 2.0 0.0 0.0\n"), "f:2:1: '2' is not a record");
    const RawModel model = parse_pqr(atom +
                                         "by hand\n# 1 2 3 4 5 6 7 8 9\nREMARK 1.0 2.0 3.0 4 5 6 7 8 9 10\n"
                                         "CONECT10001 1 2 3 4 5 6 7 8\nCRYST1 1.0 1.0 1.0 90 90 90 P 1 1\nmore\n",
                                     "f");
    EXPECT_EQ(model.atoms.size(), 1U);
    EXPECT_EQ(model.notes, std::vector<std::string>{"2 lines of no known record passed over, the first is line 2"});
}

TEST(Pqr, ModelsAreTakenOneByOneAndEndEndsNone) {
    const std::string atom = "ATOM 1 N ALA 1 0.0 0.0 0.0 0 1\n";
    EXPECT_EQ(read_text(atom + "TER\nEND\n" + atom, "a.pqr").atoms.size(), 2U);
    EXPECT_EQ(read_text("MODEL 1\n" + atom + "TER\nENDMDL\n", "a.pqr").notes.size(), 0U);
    const std::string two = "MODEL 1\n" + atom + "ENDMDL\nMODEL 2\n" + atom + atom + "ENDMDL\nEND\n";
    EXPECT_EQ(read_text(two, "a.pqr").atoms.size(), 1U);
    EXPECT_TRUE(has_line(read_text(two, "a.pqr").notes, "model 1 of 2 taken"));
    EXPECT_EQ(read_text(two, "a.pqr", {.model = 2}).atoms.size(), 2U);
    EXPECT_TRUE(has_warning(read_text(atom + two, "a.pqr"), "atoms outside MODEL and ENDMDL"));
    expect_contains(error_of("MODEL 1\n" + atom + "MODEL 2\nATOM 1 N\n", "a.pqr", {.model = 2}), "a.pqr:4:9: ");
}

TEST(Pqr, EndmdlAloneSeparatesModels) {
    const std::string atom = "ATOM 1 N ALA 1 0.0 0.0 0.0 0 1\n";
    const auto atoms = [](const std::string& text, int model) {
        return read_text(text, "a.pqr", {.model = model}).atoms.size();
    };
    const std::string two = atom + " endmdl\n" + atom + "TER\nEND\n" + atom + "ENDMDL\n";
    EXPECT_EQ(atoms(two, 1), 1U);
    EXPECT_EQ(atoms(two, 2), 2U);
    EXPECT_TRUE(has_warning(read_text(two, "a.pqr"), "different number of atoms"));
    const std::string behind = "MODEL 1\n" + atom + "ENDMDL\n" + atom;
    EXPECT_EQ(atoms(behind, 1), 1U);
    EXPECT_TRUE(has_warning(read_text(behind, "a.pqr"), "line 4: atoms outside MODEL and ENDMDL"));
    EXPECT_EQ(atoms("MODEL1\n" + atom + "ENDMDL\n MODEL 2\n" + atom + atom + "ENDMDL\n" + atom, 2), 2U);
}

TEST(Pqr, LinesBetweenModelsAreReadAsWell) {
    const std::string atom = "ATOM 1 N ALA 1 0.0 0.0 0.0 0 1\n";
    const std::string odd = "ATM 1 N ALA 1 0.0 0.0 0.0 0 1\n";
    expect_contains(error_of(odd + atom, "a.pqr"), "a.pqr:1:1: 'ATM' is not a record");
    expect_contains(error_of(atom + "ENDMDL\n" + odd + atom, "a.pqr", {.model = 2}),
                    "a.pqr:3:1: 'ATM' is not a record");
    expect_contains(error_of(atom + "ENDMDL\n" + odd, "a.pqr"), "a.pqr:3:1: 'ATM' is not a record");
    expect_contains(error_of("REMARK\nEND\n", "a.pqr"), "no atoms in this file");
}

TEST(Pqr, NoAtomIsLostInALineOfSomethingElse) {
    const std::string atom = "ATOM      2  C   ALA A   1       1.000   2.000   3.000  0.1000 1.7000\n";
    for (const std::string before : {"END   ", "END", "TER   ", "TER 1 ALA A 1 ", "CONECT    1    2", "ENDMDL"}) {
        const std::string message = error_in_pqr(before + atom);
        EXPECT_TRUE(message.starts_with("f:1:" + std::to_string(before.size() + 1) + ": an atom record begins within"))
            << message;
    }
    const std::string first = "ATOM 1 N ALA A 1 1.0 2.0 3.0 0.1 1.7 ";
    expect_contains(error_in_pqr(first + atom), "f:1:38: another atom begins within the line");
    expect_contains(error_in_pqr(first + "N atom 2 C ALA A 1 1.0 2.0 3.0 0.1 1.7\n"), "f:1:38: another atom begins");
    EXPECT_EQ(error_in_pqr(first + "N N1+ 0.5\n"), "");
}

TEST(Pqr, AnAtomInACommentIsTold) {
    const std::string atom = "ATOM 2 C ALA A 1 1.0 2.0 3.0 0.1 1.7\n";
    const RawModel model = parse_pqr(atom + "#" + atom + "## " + atom + "# 1.0 2.0 3.0\n# ATOM and so on\n", "f");
    EXPECT_EQ(model.atoms.size(), 1U);
    EXPECT_EQ(model.warnings, std::vector<std::string>{"line 2: '#ATOM' begins a comment, but the line has coordinates "
                                                       "as an atom has; left out (2 times)"});
}

TEST(Pqr, OptionsChooseAtoms) {
    const std::string text =
        "ATOM 1 N ALA A 1 0 0 0 0 1\nHETATM 2 C1 LIG B 2 3 0 0 0 1\nHETATM 3 C2 LIG B 2 4 0 0 0 1\n"
        "HETATM 4 ZN ZN B 3 9 0 0 2 1\nHETATM 5 O HOH B 4 7 0 0 0 1\nATOM 6 O WAT 5 7 5 0 0 1\n";
    const auto count = [&](const ReadOptions& options) { return read_text(text, "a.pqr", options).atoms.size(); };
    EXPECT_EQ(count({}), 6U);
    EXPECT_TRUE(has_warning(read_text(text, "a.pqr"), "2 waters of the file kept"));
    EXPECT_EQ(count({.keep_waters = false}), 4U);
    EXPECT_TRUE(read_text(text, "a.pqr", {.keep_waters = false}).warnings.empty());
    EXPECT_TRUE(read_text(text, "a.pqr", {.keep_waters = true}).warnings.empty());
    EXPECT_EQ(count({.hetero = HeteroPolicy::None, .keep_waters = false}), 1U);
    EXPECT_EQ(count({.hetero = HeteroPolicy::Ligands, .keep_waters = false}), 3U);
    EXPECT_EQ(count({.chains = {"B"}}), 4U);
    EXPECT_EQ(count({.select = "(LIG)"}), 2U);
}

TEST(Pqr, ReportsOfUsersAreRead) {
    MENISCUS_NEED_TEST_DATA();
    const std::string folder = (*testing::test_data() / "malformed/reports").string() + "/";
    for (const auto& [name, atoms] : std::vector<std::pair<std::string, std::size_t>>{
             {"pqr_het5digit.pqr", 73}, {"pqr_merged.pqr", 67}, {"gmx_mead.pqr", 67}}) {
        const Structure s = read_structure(folder + name);
        EXPECT_EQ(s.atoms.size(), atoms) << name;
        EXPECT_TRUE(s.warnings.empty()) << name;
        EXPECT_EQ(s.residues.size(), atoms == 73 ? 9U : 8U) << name;
    }
}

}  // namespace
}  // namespace meniscus::reading

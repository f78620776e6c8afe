// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "fragments.h"
#include "structure/element.h"

namespace meniscus {
namespace {

using testing::error_of;
using testing::expect_contains;
using testing::gzipped;
using testing::has_note;
using testing::has_warning;
using testing::pdb_line;
using testing::read_text;

// Glycine of 1CRN, residue 20.
const std::string kGlycine = pdb_line({.name = " N  ", .residue = "GLY", .number = 20, .x = 11.0, .y = 5.0, .z = 2.0}) +
                             pdb_line({.name = " CA ", .residue = "GLY", .number = 20, .x = 12.4, .y = 5.0, .z = 2.0}) +
                             pdb_line({.name = " C  ", .residue = "GLY", .number = 20, .x = 13.0, .y = 6.4, .z = 2.0}) +
                             pdb_line({.name = " O  ", .residue = "GLY", .number = 20, .x = 12.3, .y = 7.4, .z = 2.0});
const std::string kWater = pdb_line({.name = " O  ", .residue = "HOH", .number = 99, .x = 30.0, .record = "HETATM"});

TEST(ReadStructure, TellsWhereFromAndWhat) {
    const Structure s = read_text(kGlycine + kWater, "g.pdb");
    EXPECT_EQ(s.name, "g");
    EXPECT_EQ(s.sha256.size(), 64U);
    EXPECT_EQ(s.radii_set, "united");
    ASSERT_EQ(s.atoms.size(), 4U);
    EXPECT_EQ(s.atoms.radii, (std::vector<double>{1.70, 2.00, 1.74, 1.40}));
    EXPECT_EQ(s.labels.at(1).name, "CA");
    EXPECT_EQ(s.labels.at(1).element, "C");
    EXPECT_EQ(s.labels.at(1).b_factor, 10.0);
    ASSERT_EQ(s.residues.size(), 1U);
    EXPECT_EQ(s.residues[0].name, "GLY");
    EXPECT_EQ(s.residues[0].number, 20);
    EXPECT_EQ(s.dropped.at("waters"), 1U);
    EXPECT_EQ(s.notes.at(0), "1 water left out (keep it with keep_waters = true)");
}

std::string spell_in_capitals(std::string_view option, std::string_view value) {
    return reading::upper_case(option) + "/" + reading::upper_case(value);
}

TEST(ReadStructure, OptionsAreSpeltAsTheCallerSays) {
    const Structure s = read_text(kGlycine + kWater, "g.pdb", {.spelling = spell_in_capitals});
    EXPECT_TRUE(has_note(s, "1 water left out (keep it with KEEP_WATERS/TRUE)"));
}

TEST(ReadStructure, ElementsOfStandardResiduesAreANoteOthersAWarning) {
    const std::string ligand = pdb_line({.name = "CA  ", .residue = "XYZ", .number = 30, .x = 20.0});
    const Structure s = read_text(kGlycine + ligand, "g.pdb");
    EXPECT_TRUE(has_note(s, "4 elements taken from atom names: columns 77-78 are blank"));
    EXPECT_TRUE(has_warning(s, "1 element in non-standard residues guessed from atom names: 1 Ca (columns 77-78"));
    EXPECT_TRUE(read_text(kGlycine, "g.pdb").warnings.empty());
    const std::string known = pdb_line({.name = " N  ", .residue = "XYZ", .element = " N"});
    EXPECT_TRUE(read_text(known, "g.pdb").notes.empty());
    EXPECT_FALSE(has_warning(read_text(known, "g.pdb"), "guessed"));
}

TEST(ReadStructure, LigandsLeftOutAreKnownByName) {
    const std::string ligand = pdb_line({.name = " C1 ", .residue = "LIG", .number = 9, .x = 20, .record = "HETATM"}) +
                               pdb_line({.name = " O1 ", .residue = "LIG", .number = 9, .x = 21, .record = "HETATM"});
    using Ligands = std::map<std::string, std::size_t>;
    EXPECT_EQ(read_text(kGlycine + ligand + kWater, "g.pdb").left_out_ligands, (Ligands{{"LIG", 1}}));
    EXPECT_EQ(read_text(kGlycine + ligand, "g.pdb", {.hetero = HeteroPolicy::Ligands}).left_out_ligands, Ligands{});
}

TEST(ReadStructure, ASmallMoleculeIsKept) {
    const std::string ligand =
        pdb_line({.name = " C1 ", .residue = "UNL", .record = "HETATM", .element = " C"}) +
        pdb_line({.name = " O1 ", .residue = "UNL", .x = 1.4, .record = "HETATM", .element = " O"});
    const Structure s = read_text(ligand + kWater, "l.pdb");
    EXPECT_EQ(s.atoms.size(), 2U);
    EXPECT_TRUE(has_note(s, "neither protein nor nucleic acid here, so hetero groups are kept: 1 UNL"));
    expect_contains(error_of(ligand, "l.pdb", {.hetero = HeteroPolicy::None}),
                    "1 UNL left out (keep it with hetero = l");
    expect_contains(error_of(kWater, "w.pdb"), "w.pdb: no atoms left: 1 water left out");
    const std::string cif =
        "data_l\nloop_\n_atom_site.group_PDB\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
        "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\nHETATM C1 UNL 0 0 0\nHETATM O1 UNL 1.4 0 0\n";
    EXPECT_EQ(read_text(cif, "l.cif").atoms.size(), 2U);
}

TEST(ReadStructure, TakesAFingerprintOnlyIfAskedFor) {
    EXPECT_EQ(read_text(kGlycine, "g.pdb", {.checksum = false}).sha256, "");
}

TEST(ReadStructure, LineEndsMarksAndCompressionChangeNothing) {
    const Structure plain = read_text(kGlycine, "g.pdb");
    std::string dos;
    std::string mac;
    for (const char c : kGlycine) {
        dos += c == '\n' ? "\r\n" : std::string(1, c);
        mac += c == '\n' ? '\r' : c;
    }
    for (const std::string& text : {dos, mac, "\xEF\xBB\xBF" + kGlycine}) {
        const Structure other = read_text(text, "g.pdb");
        EXPECT_EQ(other.atoms.centres, plain.atoms.centres);
        EXPECT_EQ(other.warnings, plain.warnings);
    }
    EXPECT_EQ(read_text(dos, "g.pdb").notes, plain.notes);
    EXPECT_TRUE(has_note(read_text(mac, "g.pdb"), "line 1: a line ends with a carriage return alone"));
    EXPECT_TRUE(has_note(read_text("\xEF\xBB\xBF" + kGlycine, "g.pdb"), "line 1: a byte-order mark"));
    EXPECT_EQ(read_text(gzipped(kGlycine), "g.pdb.gz").atoms.centres, plain.atoms.centres);
}

TEST(ReadStructure, LineEndsBelongToNoValueOfMmcif) {
    const Structure s = read_text(
        "data_x\r\nloop_\r\n_atom_site.label_atom_id\r\n_atom_site.label_comp_id\r\n_atom_site.Cartn_x\r\n"
        "_atom_site.Cartn_y\r\n_atom_site.Cartn_z\r\n;CA\r\n;\r\nGLY 1\r\n;2.5\r\n;\r\n3\r\n",
        "dos.cif");
    EXPECT_EQ(s.labels.at(0).name, "CA");
    EXPECT_EQ(s.atoms.centres.at(0), (Vec3{1, 2.5, 3}));
}

TEST(ReadStructure, ModelsByPosition) {
    const std::string text =
        "MODEL        1\n" + kGlycine + "ENDMDL\nMODEL        2\n" + pdb_line({.x = 7.0}) + "ENDMDL\n";
    const Structure first = read_text(text, "m.pdb");
    EXPECT_EQ(first.atoms.size(), 4U);
    EXPECT_TRUE(has_note(first, "model 1 of 2 taken (choose another with model = N)"));
    EXPECT_EQ(read_text(text, "m.pdb", {.model = 2}).atoms.centres.at(0).x, 7.0);
    expect_contains(error_of(text, "m.pdb", {.model = 3}), "m.pdb: no model 3; there are 2");
    expect_contains(error_of<UsageError>(text, "m.pdb", {.model = 0}), "models are counted from 1");
}

TEST(ReadStructure, AllModelsAreStructuresOfTheirOwn) {
    const testing::ScratchFolder folder;
    testing::write_file(folder / "m.pdb", "MODEL 1\n" + kGlycine + "ENDMDL\nMODEL 2\n" + pdb_line({}) + "ENDMDL\n");
    const std::vector<Structure> models = read_all_models(folder / "m.pdb");
    ASSERT_EQ(models.size(), 2U);
    EXPECT_EQ(models[0].name, "m_m01");
    EXPECT_EQ(models[1].name, "m_m02");
    EXPECT_EQ(models[1].atoms.size(), 1U);
}

TEST(ReadStructure, ABadModelThatIsNotAskedForIsNoMatter) {
    const std::string text = "MODEL 1\n" + kGlycine + "ENDMDL\nMODEL 2\nATOM      1\nENDMDL\n";
    EXPECT_EQ(read_text(text, "m.pdb").atoms.size(), 4U);
    expect_contains(error_of(text, "m.pdb", {.model = 2}), "m.pdb:8:");
}

TEST(ReadStructure, NothingLeftIsAnErrorThatSaysWhatWent) {
    expect_contains(error_of(kWater, "w.pdb"), "w.pdb: no atoms left: 1 water left out (keep it with keep_");
    expect_contains(error_of("", "e.pdb"), "e.pdb: no atoms in this file");
    expect_contains(error_of(kGlycine, "g.pdb", {.select = "//Z"}), "; chains or select keep none");
    expect_contains(error_of("# none\n", "e.xyzr"), "no atoms in this file");
}

// Found by fuzzing: such names made messages and reports that are no text.
TEST(ReadStructure, NamesThatAreNoTextAreRefused) {
    std::string pdb(kGlycine);
    pdb[14] = '\x82';
    expect_contains(error_of(pdb, "n.pdb"), "n.pdb:1:15: a byte that is not a printable character in the names");
    expect_contains(error_of("ATOM 1 N AL\xff 1 0 0 0 0 1\n", "n.pqr"), "n.pqr:1:10: a byte that is not a printable");
    expect_contains(error_of("0 0 0 1 1 C\x01_ALA_1\n", "n.xyzrn"), "n.xyzrn:1:11: a byte that is not a printable");
    expect_contains(error_of("data_n\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
                             "_atom_site.label_atom_id\n_atom_site.label_comp_id\n0 0 0\n;C\nA\n;\nALA\n",
                             "n.cif"),
                    "n.cif:9:1: _atom_site.label_atom_id 'C?A' contains a byte that is not a printable character");
    expect_contains(error_of<UsageError>(kGlycine, "g.pdb", {.select = "\x01["}), "'?['");
}

TEST(ReadStructure, ModifiedResiduesStayLigandsGo) {
    const std::string mse =
        pdb_line({.name = " N  ", .residue = "MSE", .number = 21, .x = 14.3, .y = 6.4, .z = 2.0, .record = "HETATM"}) +
        pdb_line({.name = "SE  ", .residue = "MSE", .number = 21, .x = 17.3, .y = 9.4, .z = 2.0, .record = "HETATM"});
    const std::string calcium = pdb_line({.name = "CA  ", .residue = "CA", .number = 40, .x = 40, .record = "HETATM"});
    const Structure s = read_text(kGlycine + mse + calcium, "g.pdb");
    ASSERT_EQ(s.atoms.size(), 6U);
    EXPECT_EQ(s.labels[5].element, "SE");
    EXPECT_EQ(s.atoms.radii[5], 2.15);
    EXPECT_TRUE(has_note(s, "1 CA left out (keep it with hetero = all)"));
    const Structure all = read_text(kGlycine + mse + calcium, "g.pdb", {.hetero = HeteroPolicy::All});
    EXPECT_EQ(all.labels.at(6).element, "CA");
    EXPECT_EQ(all.atoms.radii.at(6), 1.97);
}

TEST(ReadStructure, AssembliesAreCopied) {
    std::string text =
        "REMARK 350 BIOMOLECULE: 1\n"
        "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n";
    for (const char* shift : {"  0.00000", "100.00000"}) {
        text += std::string("REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000      ") + shift + "\n" +
                "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n" +
                "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n";
    }
    const Structure s = read_text(text + kGlycine, "g.pdb", {.assembly = "1"});
    ASSERT_EQ(s.atoms.size(), 8U);
    EXPECT_EQ(s.atoms.centres[4].x, 111.0);
    EXPECT_EQ(s.residues.at(1).chain, "A-2");
    expect_contains(error_of(text + kGlycine, "g.pdb", {.assembly = "2"}), "no assembly 2; assemblies of the file: 1");
    expect_contains(error_of(kGlycine, "g.pdb", {.assembly = "1"}), "the file has none");
}

TEST(ReadStructure, SpheresBringTheirRadii) {
    const Structure s = read_text("0 0 0 1.5\n5 0 0 0\n", "s.xyzr");
    EXPECT_EQ(s.radii_set, "file");
    EXPECT_EQ(s.atoms.size(), 1U);
    EXPECT_EQ(s.dropped.at("zero_radius"), 1U);
    expect_contains(error_of<UsageError>("0 0 0 1\n", "s.xyzr", {.radii = "bondi"}), "has radii but no atom names");
}

TEST(ReadStructure, APqrFileCanTakeAnotherSet) {
    const std::string text = "ATOM 1 N ALA 1 0 0 0 0.5 1.0\nATOM 2 H ALA 1 1 0 0 0.5 0.5\n";
    EXPECT_EQ(read_text(text, "p.pqr").atoms.radii, (std::vector<double>{1.0, 0.5}));
    EXPECT_EQ(read_text(text, "p.pqr", {.radii = "bondi"}).atoms.radii, (std::vector<double>{1.55, 1.20}));
    EXPECT_EQ(read_text(text, "p.pqr", {.radii = "united"}).atoms.radii, (std::vector<double>{1.70}));
    EXPECT_EQ(read_text(text, "p.pqr", {.hydrogens = HydrogenPolicy::Drop}).atoms.size(), 1U);
}

TEST(ReadStructure, CoincidentAtomsAreKeptAndMentioned) {
    const Structure s = read_text("0 0 0 1\n0 0 0 1\n0 0 0 2\n", "s.xyzr");
    EXPECT_EQ(s.atoms.size(), 3U);
    EXPECT_TRUE(has_warning(s, "2 atoms at exactly the position of another atom"));
}

TEST(ReadStructure, UserRulesAreASet) {
    const testing::ScratchFolder folder;
    testing::write_file(folder / "my.radii", "* @C 2.5\n* * 1\n");
    const Structure s = read_text(kGlycine, "g.pdb", {.radii = folder / "my.radii"});
    EXPECT_EQ(s.atoms.radii, (std::vector<double>{1, 2.5, 2.5, 1}));
    EXPECT_EQ(s.radii_set, folder / "my.radii");
}

}  // namespace
}  // namespace meniscus

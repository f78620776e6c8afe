// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/gemmi/gemmi_reader.h"

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::add_residue;
using meniscus::testing::pdb_line;

RawModel pdb(const std::string& text) {
    return parse_pdb(screen_pdb(text, {0, text.size(), 1}, "f.pdb", true), "f.pdb");
}

TEST(GemmiPdb, AtomsComeInFileOrderWhateverTheirChains) {
    const RawModel model = pdb(pdb_line({.chain = 'A', .serial = 5}) + pdb_line({.number = 2, .x = 1, .chain = 'B'}) +
                               pdb_line({.name = " CB ", .x = 2, .chain = 'A'}));
    ASSERT_EQ(model.atoms.size(), 3U);
    EXPECT_EQ(model.atoms[0].serial, 5);
    EXPECT_EQ(model.atoms[1].centre.x, 1.0);
    EXPECT_EQ(model.atoms[2].name, "CB");
    EXPECT_EQ(model.residue_of(model.atoms[1]).chain, "B");
    EXPECT_EQ(model.residue_of(model.atoms[2]).chain, "A");
}

TEST(GemmiPdb, ResidueNumbersOfFiveDigitsAndHybridOnes) {
    std::string wide = pdb_line({.number = 1234, .insertion_code = '5'});
    std::string hybrid = pdb_line({});
    hybrid.replace(22, 4, "A000");
    const RawModel model = pdb(wide + hybrid + pdb_line({.number = -7, .insertion_code = 'B'}));
    EXPECT_EQ(model.residues[0].number, 12345);
    EXPECT_EQ(model.residues[0].insertion_code, ' ');
    EXPECT_EQ(model.residues[1].number, 10000);
    EXPECT_EQ(model.residues[2].number, -7);
    EXPECT_EQ(model.residues[2].insertion_code, 'B');
}

TEST(GemmiPdb, SequenceListsModifiedResiduesUpToTer) {
    const std::string text = "SEQRES   1 A    2  ALA MSE\n" + pdb_line({}) +
                             pdb_line({.residue = "MSE", .number = 2, .record = "HETATM"}) + "TER\n" +
                             pdb_line({.residue = "MSE", .number = 9, .record = "HETATM"});
    const RawModel model = pdb(text);
    EXPECT_TRUE(model.residues[1].in_sequence);
    EXPECT_FALSE(model.residues[2].in_sequence);
}

TEST(GemmiPdb, ReadsAssemblies) {
    const RawModel model =
        pdb("REMARK 350 BIOMOLECULE: 1\n"
            "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
            "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
            "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
            "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
            "REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000       10.00000\n"
            "REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        0.00000\n"
            "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n" +
            pdb_line({}));
    ASSERT_EQ(model.assemblies.size(), 1U);
    ASSERT_EQ(model.assemblies[0].generators.at(0).operators.size(), 2U);
    EXPECT_EQ(model.assemblies[0].generators[0].operators[1].apply({1, 2, 3}), (Vec3{9, -2, 3}));
}

std::size_t count_selected(const std::string& expression) {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "CA", "C"});
    add_residue(model, "GLY", 2, {"N", "CA"});
    add_residue(model, "HOH", 3, {"O"});
    model.residues[2].chain = "B";
    model.residues[2].kind = ResidueKind::Water;
    model.atoms[0].occupancy = 0.4;
    const std::vector<bool> selected = selected_atoms(model, expression, 1, "select");
    return static_cast<std::size_t>(std::count(selected.begin(), selected.end(), true));
}

TEST(Selection, FollowsTheSyntaxOfGemmi) {
    EXPECT_EQ(count_selected("*"), 6U);
    EXPECT_EQ(count_selected("//A"), 5U);
    EXPECT_EQ(count_selected("B"), 1U);
    EXPECT_EQ(count_selected("//A/2-9"), 2U);
    EXPECT_EQ(count_selected("(ALA,GLY)"), 5U);
    EXPECT_EQ(count_selected("(!ALA)"), 3U);
    EXPECT_EQ(count_selected(";q>0.5"), 5U);
    EXPECT_EQ(count_selected(";polymer"), 5U);
    EXPECT_EQ(count_selected("/2"), 0U);
}

// Of gemmi 0.5: "//A/1" was everything from residue 1 on.
TEST(Selection, ASingleNumberIsOneResidue) {
    EXPECT_EQ(count_selected("//A/1"), 3U);
    EXPECT_EQ(count_selected("1"), 3U);
    EXPECT_EQ(count_selected("1(GLY)"), 0U);
    EXPECT_EQ(count_selected("2-"), 3U);
    EXPECT_EQ(count_selected("//A/1;q>0.5"), 2U);
}

TEST(Selection, WordsOfPyMolAreTranslated) {
    EXPECT_EQ(count_selected("chain A and resi 2"), 2U);
    EXPECT_EQ(count_selected("resn ALA+GLY and name CA"), 2U);
    EXPECT_EQ(count_selected("all"), 6U);
    EXPECT_THROW(count_selected("chain A or chain B"), UsageError);
}

TEST(Selection, ABareNameThatIsNeitherChainNorAtomIsAResidue) {
    EXPECT_EQ(count_selected("GLY"), 2U);
    EXPECT_EQ(count_selected("ALA,GLY"), 5U);
    EXPECT_EQ(count_selected("TRP"), 0U);
}

TEST(Selection, ABareNameThatIsNoChainIsAnAtom) {
    EXPECT_EQ(count_selected("CA"), 2U);
    EXPECT_EQ(count_selected("CA,N"), 4U);
}

TEST(Selection, AnyOfSeveralWithAPlusBetweenThem) {
    EXPECT_EQ(count_selected("//A/1 + B"), 4U);
    EXPECT_EQ(count_selected("//A/1/CA + CA"), 2U);
    EXPECT_EQ(count_selected("chain A and resi 2 + HOH"), 3U);
    EXPECT_EQ(count_selected("resn ALA+GLY"), 5U);
    for (const char* expression : {"//A/1 + ", " + //A/1", "//A/1 +  + B", "//A/1 + //C", "//A/1 + (ALA"})
        EXPECT_THROW(count_selected(expression), UsageError) << expression;
}

TEST(Selection, NonsenseIsAUsageError) {
    for (const char* expression : {"//A/x-y", "(ALA", "CA[", ";z>1", "//A/1/CA/extra"}) {
        EXPECT_THROW(count_selected(expression), UsageError) << expression;
    }
}

}  // namespace
}  // namespace meniscus::reading

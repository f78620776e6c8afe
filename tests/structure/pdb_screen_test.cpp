// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_screen.h"

#include <array>
#include <utility>

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::expect_contains;
using meniscus::testing::pdb_line;

//                        1         2         3         4         5         6         7         8
//               12345678901234567890123456789012345678901234567890123456789012345678901234567890
const std::string kPlain = "ATOM      7  CA  ALA A  12      11.104   6.134  -6.504  1.00  8.20           C1+\n";

CleanPdb screen(const std::string& text, bool with_assemblies = false) {
    return screen_pdb(text, {0, text.size(), 1}, "f.pdb", with_assemblies);
}

std::string error_in(const std::string& text, bool with_assemblies = false) {
    try {
        screen(text, with_assemblies);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string changed(std::size_t column, const std::string& text) {
    std::string line = kPlain;
    return line.replace(column - 1, text.size(), text);
}

TEST(PdbScreen, AGoodRecordPasses) {
    const CleanPdb clean = screen(kPlain);
    ASSERT_EQ(clean.atoms.size(), 1U);
    EXPECT_EQ(clean.atoms[0].centre, (Vec3{11.104, 6.134, -6.504}));
    EXPECT_EQ(clean.atoms[0].name, "CA");
    EXPECT_EQ(clean.atoms[0].element, "C");
    EXPECT_EQ(clean.atoms[0].altloc, ' ');
    EXPECT_EQ(clean.atoms[0].serial, 7);
    EXPECT_EQ(clean.atoms[0].occupancy, 1.0);
    EXPECT_EQ(clean.atoms[0].b_factor, 8.2);
    EXPECT_EQ(clean.atoms[0].charge, 1.0);
    EXPECT_FALSE(clean.atoms[0].hetatm);
    ASSERT_EQ(clean.runs.size(), 1U);
    EXPECT_EQ(clean.runs[0].residue, "ALA");
    EXPECT_FALSE(clean.atoms[0].guessed_element);
    EXPECT_EQ(clean.text.size(), 81U);
}

TEST(PdbScreen, EveryCoordinateMustBeAFiniteNumberInFull) {
    for (const char* text :
         {"********", "        ", "     nan", "     inf", "   1e400", "  11,104", "  1.0 04", "1.00000x"}) {
        EXPECT_TRUE(error_in(changed(31, text)).starts_with("f.pdb:1:31: x coordinate")) << text;
        EXPECT_TRUE(error_in(changed(39, text)).starts_with("f.pdb:1:39: y coordinate")) << text;
        EXPECT_TRUE(error_in(kPlain + changed(47, text)).starts_with("f.pdb:2:47: z coordinate")) << text;
    }
}

TEST(PdbScreen, PlainDecimalsNeedADigitAndAPoint) {
    for (const char* text : {"      .5", "     -5.", "-123.456", "      +5", "    1e-3"})
        EXPECT_EQ(error_in(changed(31, text)), "") << text;
    for (const char* text : {"       .", "      -.", "   1.2.3", "    --.5", "   -1 .5", "   1.5-2"})
        EXPECT_TRUE(error_in(changed(31, text)).starts_with("f.pdb:1:31: x coordinate")) << text;
}

TEST(PdbScreen, AtomsOfOneResidueInARowAreOneRecord) {
    const std::string glycine = changed(18, "GLY");
    const CleanPdb clean = screen(kPlain + changed(13, " CB ") + glycine + kPlain);
    const std::array<std::uint32_t, 4> run_of_atom{0, 0, 1, 2};
    const std::array<const char*, 3> names{"ALA", "GLY", "ALA"};
    ASSERT_EQ(clean.atoms.size(), run_of_atom.size());
    for (std::size_t i = 0; i < run_of_atom.size(); ++i) EXPECT_EQ(clean.atoms[i].residue, run_of_atom[i]);
    ASSERT_EQ(clean.runs.size(), names.size());
    ASSERT_EQ(clean.text.size(), 81 * names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(clean.runs[i].residue, names[i]);
        EXPECT_EQ(clean.text.substr(81 * i + 17, 3), names[i]);
    }
}

TEST(PdbScreen, ChainNumberInsertionAndSegmentEachBeginARun) {
    for (const auto& [column, text] : {std::pair(22, "B"), {26, "3"}, {27, "A"}, {73, "SEG"}})
        EXPECT_EQ(screen(kPlain + changed(column, text)).runs.size(), 2U) << column;
    EXPECT_EQ(screen(kPlain + changed(17, "B")).runs.size(), 1U) << "an alternative";
    EXPECT_EQ(screen(changed(73, " SEG")).runs[0].segment, "SEG");
}

TEST(PdbScreen, ChargesOfOneDigit) {
    for (const auto& [text, charge] :
         {std::pair("2+", 2.0), {"+2", 2.0}, {"1-", -1.0}, {"-1", -1.0}, {"3 ", 3.0}, {" +", 0.0}, {"  ", 0.0}})
        EXPECT_EQ(screen(changed(79, text)).atoms[0].charge, charge) << text;
    EXPECT_EQ(screen(changed(77, "  2+")).atoms[0].charge, 0.0) << "behind no element there is something else";
}

TEST(PdbScreen, OccupancyBFactorAndChargeMayHoldAnything) {
    const CleanPdb clean =
        screen(changed(55, "******") + kPlain + changed(61, "   nan") + changed(55, "******") + changed(79, "x+"));
    EXPECT_EQ(clean.warnings, (std::vector<std::string>{
                                  "line 1: occupancy '******' is not a number; taken as missing (2 times)",
                                  "line 3: B factor 'nan' is not a number; taken as missing",
                                  "line 5: charge 'x+' is neither blank nor a digit and a sign; taken as missing"}));
    EXPECT_EQ(clean.atoms[0].occupancy, 1.0);
    EXPECT_EQ(clean.atoms[2].b_factor, 0.0);
    EXPECT_EQ(clean.atoms[4].charge, 0.0);
    EXPECT_TRUE(screen(changed(79, "+1") + changed(55, "            ")).warnings.empty());
}

TEST(PdbScreen, ShiftedColumnsAreRefused) {
    std::string line = kPlain;
    line.insert(22, "B");
    expect_contains(error_in(kPlain + line),
                    "f.pdb:2:22: columns are shifted by 1 to the right from the chain name 'AB' on");
}

TEST(PdbScreen, LinesMayEndAfterTheCoordinatesNotBefore) {
    EXPECT_EQ(error_in(kPlain.substr(0, 54) + "\n"), "");
    EXPECT_EQ(screen(kPlain.substr(0, 54)).atoms[0].element, "C");
    EXPECT_EQ(screen(kPlain.substr(0, 54)).atoms[0].occupancy, 1.0);
    expect_contains(error_in(kPlain.substr(0, 53) + "\n"), "f.pdb:1:54: the record ends before the coordinates do");
    expect_contains(error_in("ATOM  \n"), "the record ends");
    expect_contains(error_in("ATOM  \t1\tCA\n"), "f.pdb:1:7: a tab");
}

TEST(PdbScreen, OldFilesMayHaveAnythingInColumns73To80) {
    const CleanPdb clean = screen(changed(67, "      4PTI  89"));
    EXPECT_EQ(clean.atoms[0].element, "C");
    EXPECT_TRUE(clean.atoms[0].guessed_element);
    EXPECT_EQ(screen(changed(67, "      1UBQ1071")).atoms[0].element, "C");
    EXPECT_EQ(screen(changed(67, "      PROT N  ")).atoms[0].element, "N") << "a symbol where it belongs counts";
}

TEST(PdbScreen, SerialsWiderThanTheirColumnsAndHybridOnes) {
    EXPECT_EQ(screen(changed(5, " 123456")).atoms[0].serial, 123456);
    EXPECT_EQ(screen(changed(5, "1234567 ")).atoms[0].serial, 1234567);
    EXPECT_EQ(screen(changed(7, "A0000")).atoms[0].serial, 0) << "no decimal number";
    EXPECT_EQ(screen(changed(7, "*****")).atoms[0].serial, 0);
}

TEST(PdbScreen, ResidueNamesOfFourLettersAndChainsOfTwo) {
    EXPECT_EQ(screen(changed(18, "TIP3 ")).runs[0].residue, "TIP3");
    EXPECT_EQ(screen(changed(18, "TIP3W")).runs[0].residue, "TIP3");
    EXPECT_EQ(screen(changed(18, "POPC ")).runs[0].residue, "POPC");
    EXPECT_EQ(screen(changed(18, "ALAAB")).runs[0].residue, "ALA");
    EXPECT_EQ(screen(changed(18, " DA A")).runs[0].residue, "DA");
}

TEST(PdbScreen, OnlyRecordsThatMatterPass) {
    const std::string rest =
        "LINK         garbage\nCONECT  1 2\nHELIX  x\nANISOU    1  CA\nTER   junk\nSEQRES   1 A    1  ALA\n";
    const CleanPdb clean = screen(kPlain + rest);
    for (const char* record : {"LINK", "CONECT", "HELIX", "ANISOU", "junk"}) {
        EXPECT_EQ(clean.text.find(record), std::string::npos) << record;
    }
    EXPECT_NE(clean.text.find("TER\n"), std::string::npos);
    EXPECT_NE(clean.text.find("SEQRES"), std::string::npos);
}

TEST(PdbScreen, OperatorsAreCheckedOnlyWhenAnAssemblyIsAskedFor) {
    const std::string bad = "REMARK 350   BIOMT1   1  1.000000  0.000000  ********        0.00000\n" + kPlain;
    EXPECT_EQ(error_in(bad), "");
    EXPECT_TRUE(error_in(bad, true).starts_with("f.pdb:1:46: assembly operator")) << error_in(bad, true);
}

TEST(PdbScreen, Hybrid36Serials) {
    EXPECT_EQ(hybrid36_serial(1), "    1");
    EXPECT_EQ(hybrid36_serial(99999), "99999");
    EXPECT_EQ(hybrid36_serial(100000), "A0000");
    EXPECT_EQ(hybrid36_serial(100035), "A000Z");
    EXPECT_EQ(hybrid36_serial(0), "    0");
}

TEST(PdbScreen, NumbersAsVmdWritesThemAreAWarning) {
    const CleanPdb clean = screen(changed(23, "270f") + changed(23, "****") + changed(23, "2710"));
    ASSERT_EQ(clean.warnings.size(), 1U);
    expect_contains(clean.warnings[0],
                    "residue number '270f' is as VMD writes those above 9999, in hexadecimal or as stars (taken as 0); "
                    "others may be hexadecimal although they look decimal (2 times)");
}

}  // namespace
}  // namespace meniscus::reading

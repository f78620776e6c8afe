// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/gemmi/cif_file.h"

#include <gtest/gtest.h>

#include "fragments.h"
#include "structure/join_residues.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::expect_contains;

constexpr const char* kHead =
    "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
    "_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.auth_seq_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.pdbx_PDB_model_num\n";

RawModel cif(const std::string& text, int position = 1) { return CifFile(text, "f.cif").model(position); }

std::string cif_error(const std::string& text) {
    try {
        cif(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(GemmiCif, ReadsAtomsAndDefaults) {
    const RawModel model = cif(std::string(kHead) + "HETATM 7 FE \"FE\" . HEM B 12 1.5 -2 3e0 1\n");
    ASSERT_EQ(model.atoms.size(), 1U);
    const RawAtom& atom = model.atoms[0];
    EXPECT_EQ(atom.centre, (Vec3{1.5, -2, 3}));
    EXPECT_EQ(atom.name, "FE");
    EXPECT_EQ(atom.element, "FE");
    EXPECT_EQ(atom.altloc, ' ');
    EXPECT_EQ(atom.serial, 7);
    EXPECT_TRUE(atom.hetatm);
    EXPECT_EQ(atom.occupancy, 1.0);
    EXPECT_EQ(model.residues[0].chain, "B");
    EXPECT_EQ(model.residues[0].number, 12);
}

TEST(GemmiCif, ModelsAreToldApartByNumberAndCountedByPosition) {
    const std::string text = std::string(kHead) + "ATOM 1 C C . ALA A 1 1 0 0 4\nATOM 2 C C . ALA A 1 2 0 0 9\n";
    EXPECT_EQ(CifFile(text, "f").model_count(), 2);
    EXPECT_EQ(cif(text, 2).atoms.at(0).centre.x, 2.0);
}

TEST(GemmiCif, ModelsAreToldApartByTheValueOfTheirNumbers) {
    const auto models = [](const std::string& first, const std::string& second) {
        return kHead + ("ATOM 1 C C . ALA A 1 1 0 0 " + first + "\nATOM 2 C C . ALA A 1 2 0 0 " + second + "\n");
    };
    for (const auto& [first, second] :
         {std::pair{"1", "01"}, {"1", "'1'"}, {"+1", "1"}, {"?", "?"}, {".", "?"}, {"-0", "0"}}) {
        EXPECT_EQ(CifFile(models(first, second), "f").model_count(), 1) << first << second;
        EXPECT_EQ(cif(models(first, second)).atoms.size(), 2U) << first << second;
    }
    EXPECT_EQ(CifFile(models("1", "'2'"), "f").model_count(), 2);
    for (const char* odd : {"?", ".", "x", "1.0", "'?'", "1A"})
        expect_contains(cif_error(models("1", odd)), "f.cif:16:28: _atom_site.pdbx_PDB_model_num ");
    expect_contains(cif_error(models("?", "1")), "f.cif:15:28: _atom_site.pdbx_PDB_model_num '?' is not an integer; ");
}

TEST(GemmiCif, ModelsMayTakeTurns) {
    const std::string text = std::string(kHead) +
                             "ATOM 1 C C . ALA A 1 1 0 0 7\nATOM 2 C C . ALA B 1 2 0 0 3\n"
                             "ATOM 3 O O . ALA A 1 3 0 0 7\n";
    const CifFile file(text, "f.cif");
    EXPECT_EQ(file.atoms_of_models(), (std::vector<std::size_t>{2, 1}));
    EXPECT_EQ(file.place_of_model(2), "line 16");
    EXPECT_EQ(file.chains_of_models(), (std::vector<std::set<std::string>>{{"A"}, {"B"}}));
    EXPECT_EQ(file.model(1).atoms.at(1).centre.x, 3.0);
    EXPECT_EQ(file.model(2).atoms.at(0).centre.x, 2.0);
}

TEST(GemmiCif, ABadCoordinateIsAnErrorWithItsPlace) {
    const std::string good = "ATOM 1 C C . ALA A 1 1 0 0 1\n";
    for (const char* value : {"?", ".", "nan", "1e400", "11,104", "'1 2'", "********"}) {
        const std::string error = cif_error(kHead + good + "ATOM 2 C C . ALA A 1 0 " + value + " 0 1\n");
        EXPECT_TRUE(error.starts_with("f.cif:16:24: _atom_site.Cartn_y")) << error;
    }
    expect_contains(cif_error(std::string(kHead) + "ATOM 2 C C . ALA A 1 1e300 0 0 1\n"),
                    "f.cif:15:22: _atom_site.Cartn_x '1e300' is farther from the origin than 1e12 Å");
    EXPECT_EQ(cif_error(std::string(kHead) + "ATOM 2 C C . ALA A 1 -1e12 0 0 1\n"), "");
}

TEST(GemmiCif, ResidueNumbersAreIntegersWithAtMostOneLetter) {
    const auto row = [](const std::string& number) { return kHead + ("ATOM 1 C C . ALA A " + number) + " 0 0 0 1\n"; };
    for (const char* number : {"x9x", "15-", "15*", "151.", "1.0", "AB", "15AB", "A"})
        expect_contains(cif_error(row(number)), "f.cif:15:20: _atom_site.auth_seq_id '" + std::string(number) +
                                                    "' is not an integer; correct it");
    expect_contains(cif_error(row("2147483653")), "f.cif:15:20: _atom_site.auth_seq_id '2147483653' is larger than ");
    EXPECT_EQ(cif(row("-15A")).residues.at(0).number, -15);
    EXPECT_EQ(cif(row("-15A")).residues[0].insertion_code, 'A');
    EXPECT_EQ(cif(row("2147483647")).residues.at(0).number, 2147483647);
}

// Of a longer one the first letter would make one of two.
TEST(GemmiCif, LettersAreOneCharacter) {
    const auto atom = [](const std::string& alternative) {
        return kHead + ("ATOM 1 C C " + alternative) + " ALA A 1 0 0 0 1\n";
    };
    expect_contains(cif_error(atom("A1")), "f.cif:15:12: _atom_site.label_alt_id 'A1' is longer than one character; ");
    EXPECT_EQ(cif(atom("1")).atoms.at(0).altloc, '1');
    EXPECT_EQ(cif(atom("' '")).atoms.at(0).altloc, ' ');
    EXPECT_EQ(cif(atom("'B '")).atoms.at(0).altloc, 'B');
    const std::string head = std::string(kHead) + "_atom_site.pdbx_PDB_ins_code\n";
    expect_contains(cif_error(head + "ATOM 1 C C . ALA A 1 0 0 0 1 AA\n"),
                    "f.cif:16:30: _atom_site.pdbx_PDB_ins_code 'AA' is longer than one character; ");
}

TEST(GemmiCif, AnElementMayHaveItsCharge) {
    const auto read = [](const std::string& symbol) {
        return cif(kHead + ("HETATM 1 " + symbol) + " CA . LIG A 1 0 0 0 1\n");
    };
    for (const char* symbol : {"Ca2+", "CA2+", "ca+2", "Ca+"}) {
        EXPECT_EQ(read(symbol).atoms.at(0).element, "CA") << symbol;
        EXPECT_FALSE(read(symbol).atoms[0].guessed_element) << symbol;
        EXPECT_EQ(read(symbol).notes.at(0),
                  "line 15: charges in _atom_site.type_symbol such as that of '" + std::string(symbol) + "' left out");
    }
    EXPECT_EQ(read("O-").atoms.at(0).element, "O");
    for (const char* symbol : {"Qq", "C2", "X", "2+", "Qq2+"}) {
        EXPECT_TRUE(read(symbol).atoms.at(0).guessed_element) << symbol;
        EXPECT_EQ(read(symbol).why_guessed,
                  "_atom_site.type_symbol '" + std::string(symbol) + "' in line 15 is not an element");
    }
    EXPECT_EQ(read("?").why_guessed, "");
}

TEST(GemmiCif, StandardUncertaintiesAreLeftOutWithANote) {
    const std::string head = std::string(kHead) + "_atom_site.occupancy\n_atom_site.B_iso_or_equiv\n";
    const RawModel model = cif(head +
                               "ATOM 1 C C . ALA A 1 1 0 0 1 1.00 5\nATOM 2 C C . ALA A 1 1.50(2) -2.25(12) '3(1)' 1 "
                               "0.5(1) 8.2(10)\n");
    EXPECT_EQ(model.atoms.at(1).centre, (Vec3{1.5, -2.25, 3}));
    EXPECT_EQ(model.atoms[1].occupancy, 0.5);
    EXPECT_EQ(model.atoms[1].b_factor, 8.2);
    EXPECT_EQ(
        model.notes,
        (std::vector<std::string>{"line 18: standard uncertainties such as that of '1.50(2)' left out (5 times)"}));
    EXPECT_TRUE(model.warnings.empty());
    for (const char* value : {"1.0()", "1.0(x)", "(2)", "1.0(2", "1.0(2)3", "1(2)(3)", "nan(1)", ")"})
        EXPECT_NE(cif_error(std::string(kHead) + "ATOM 1 C C . ALA A 1 " + value + " 0 0 1\n"), "") << value;
}

TEST(GemmiCif, ColumnsThatNoResultNeedsMayHoldAnything) {
    const std::string head = std::string(kHead) + "_atom_site.occupancy\n_atom_site.pdbx_formal_charge\n";
    const RawModel model = cif(head +
                               "ATOM 1 C C . ALA A 1 1 0 0 1 ? .\nATOM 2 C C . ALA A 1 1 0 0 1 nan 2+\n"
                               "hetatm 3 C C . ALA A 1 1 0 0 1 0.5 word\n");
    EXPECT_EQ(model.warnings,
              (std::vector<std::string>{
                  "line 18: _atom_site.occupancy 'nan' is not a number; taken as missing",
                  "line 18: _atom_site.pdbx_formal_charge '2+' is not a number; taken as missing (2 times)"}));
    EXPECT_EQ(model.atoms.at(1).occupancy, 1.0);
    EXPECT_EQ(model.atoms[1].charge, 0.0);
    EXPECT_EQ(model.atoms[2].occupancy, 0.5);
    EXPECT_TRUE(model.atoms[2].hetatm);
}

TEST(GemmiCif, QuotedAndMultiLineValuesAreValues) {
    const RawModel model = cif(std::string("data_0\n_struct.title\n;two\nloop_ _atom_site.id\n;\n") + (kHead + 7) +
                               "ATOM 1 O 'O5'' . DA A 1 \"1.0\"\n;2.0\n;\n3.0 1\n");
    EXPECT_EQ(model.atoms.at(0).name, "O5'");
    EXPECT_EQ(model.atoms.at(0).centre, (Vec3{1, 2, 3}));
}

// Plain values are taken without gemmi's grammar, which has the last one of a row of them: here in front of every other
// thing that there may be.
TEST(GemmiCif, PlainValuesEndWhereOthersBegin) {
    const std::string head =
        "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\n";
    for (const char* behind : {"", "\n", " # C ALA\n", "\n#C ALA 4 5 6\n", "\nloop_\n_a.b\n1 2\n", "\t_a.b 1\n",
                               "\n_a.b\n;1\n;\n", "\nstop_\n", "\nsave_y\n_a.b 1\nsave_\n", "\r\ndata_y\n"}) {
        SCOPED_TRACE(behind);
        const RawModel model = cif(head + "CA  ALA\t1 2 3\nCB \"ALA\" 2 3\n;4\n;\nCG ALA 3 4 5" + behind);
        ASSERT_EQ(model.atoms.size(), 3U);
        EXPECT_EQ(model.atoms[0].centre, (Vec3{1, 2, 3}));
        EXPECT_EQ(model.atoms[1].centre, (Vec3{2, 3, 4}));
        EXPECT_EQ(model.atoms[2].centre, (Vec3{3, 4, 5}));
        EXPECT_EQ(model.atoms[2].name, "CG");
    }
    expect_contains(cif_error(head + "C ALA 1 2 3\nC ALA 4 5 6 loop_\n_a.b\n1\nloop_\n1\n"), "f.cif:13:1: ");
}

// Room for the rest of a loop is made by how many values the text before gave to it.
TEST(GemmiCif, LongLoopsAreReadWholeWhetherTheirRowsGrowOrShrink) {
    constexpr int kRows = 2000;
    for (const bool grow : {false, true}) {
        std::string text(kHead);
        for (int i = 0; i < kRows; ++i) {
            const std::string number = std::to_string(i);
            const bool wide = grow == (i > kRows / 2);
            text += "ATOM " + number + " C CA . ALA A " + std::to_string(i / 5) + " " + number +
                    (wide ? ".00000000000000000000000000" : ".0") + " 0 0 1\n";
        }
        const RawModel model = cif(text);
        ASSERT_EQ(model.atoms.size(), static_cast<std::size_t>(kRows));
        ASSERT_EQ(model.residues.size(), static_cast<std::size_t>(kRows / 5));
        for (int i = 0; i < kRows; ++i) {
            const RawAtom& atom = model.atoms[static_cast<std::size_t>(i)];
            ASSERT_EQ(atom.centre.x, i);
            ASSERT_EQ(atom.serial, i);
            ASSERT_EQ(model.residue_of(atom).number, i / 5);
        }
    }
}

// Alternatives of one site may take turns, and a residue may come back.
TEST(GemmiCif, ResiduesOfNeighbouringRowsAreToldApart) {
    RawModel model = cif(std::string(kHead) +
                         "ATOM 1 N N A SER A 1 0 0 0 1\nATOM 2 N N B THR A 1 0 0 1 1\n"
                         "ATOM 3 C CA A SER A 1 1 0 0 1\nATOM 4 C CA A SER B 1 2 0 0 1\n"
                         "ATOM 5 C CA A SER B 2 3 0 0 1\nATOM 6 C CB A SER B 2 4 0 0 1\n");
    const auto residues = [&model] {
        std::vector<std::uint32_t> found;
        for (const RawAtom& atom : model.atoms) found.push_back(atom.residue);
        return found;
    };
    EXPECT_EQ(residues(), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 4}));
    join_residues(model);
    EXPECT_EQ(residues(), (std::vector<std::uint32_t>{0, 1, 0, 2, 3, 3}));
}

TEST(GemmiCif, OneAtomMayBeGivenInPairs) {
    const RawModel model =
        cif("data_x\n_atom_site.label_atom_id CA\n_atom_site.label_comp_id CA\n_atom_site.Cartn_x 1\n"
            "_atom_site.Cartn_y 2\n_atom_site.Cartn_z 3\n");
    EXPECT_EQ(model.atoms.at(0).centre, (Vec3{1, 2, 3}));
    EXPECT_EQ(model.atoms.at(0).element, "CA");
}

TEST(GemmiCif, AtomsAreThoseOfTheFirstBlockThatHasSomeOutsideOfFrames) {
    const std::string loop = kHead + 7;  // without the name of a block
    const auto atom = [](int x) { return "ATOM 1 C CA . ALA A 1 " + std::to_string(x) + " 0 0 1\n"; };
    const auto first_x = [](const std::string& text) { return cif(text).atoms.at(0).centre.x; };
    EXPECT_EQ(first_x("data_a\n_a.b 1\ndata_b\n" + loop + atom(2) + "data_c\n" + loop + atom(3)), 2.0);
    EXPECT_EQ(first_x("data_a\nsave_f\n" + loop + atom(1) + "save_\n" + loop + atom(2)), 2.0);
    EXPECT_EQ(
        cif("data_a\n" + loop + atom(1) + "data_b\n" + loop + atom(2) + "data_c\n" + loop + atom(3)).warnings,
        std::vector<std::string>{
            "the first data block with atoms is read; left out: 'b' and 1 more; give each block a file of its own"});
    EXPECT_TRUE(
        cif("data_a\n_a.b 1\ndata_b\n" + loop + atom(2) + "save_f\n" + loop + atom(1) + "save_\n").warnings.empty());
    expect_contains(cif_error("data_a\nsave_f\n" + loop + atom(1) + "save_\n"), "no _atom_site loop");
    expect_contains(cif_error("data_a\n" + loop + atom(1) + "data_b\n" + loop + "ATOM 1\n"),
                    "f.cif:17:1: Wrong number of values");
}

TEST(GemmiCif, BrokenFilesAreErrors) {
    expect_contains(cif_error("data_x\n_a.b 1\n"), "no _atom_site loop");
    expect_contains(cif_error("data_x\nloop_\n_atom_site.id\n_atom_site.Cartn_x\n1 2\n"), "Cartn_y");
    expect_contains(cif_error("data_x\nloop_\n_atom_site.id\n_atom_site.label_atom_id\n1 C\n"), "Cartn_x");
    expect_contains(cif_error("data_x\n_atom_site_fract_x 0.5\n"), "small-molecule");
    const std::string atom = "ATOM 1 C C . ALA A 1 1 0 0 1\n";
    expect_contains(cif_error(kHead + atom + "ATOM 2 C C\n"), "f.cif:");
    expect_contains(cif_error(kHead + atom + (kHead + 7) + atom), "f.cif:");
    expect_contains(cif_error(kHead + atom + "data_x\n_a.b 'never closed\n"), "f.cif:");
    expect_contains(cif_error("no data here\n"), "not valid CIF");
    expect_contains(cif_error("data_x\n_a.c 1\nloop_\n_a.b\n_A.b\n1 2\n"), "f.cif:3:1: duplicate tag _A.b; ");
    expect_contains(cif_error("data_x\n_a.b 1\n_a.b 1\n"), "f.cif:3:1: duplicate tag _a.b; ");
    expect_contains(cif_error("data_x\n_a.b 1\ndata_X\n"), "f.cif: duplicate block name: X; ");
}

TEST(GemmiCif, ColumnsInTwoLoopsAreAnError) {
    const std::string atom = "ATOM 1 C C . ALA A 1 1 0 0 1\n";
    expect_contains(cif_error(kHead + atom + "loop_\n_atom_site.B_iso_or_equiv\n1\n"),
                    "f.cif:16:1: _atom_site is given a second time");
    // The models stand in another loop than the atoms: found by fuzzing, what was before the values was taken for
    // theirs.
    const std::string coordinates =
        "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\nC ALA 0 0 0\n";
    expect_contains(cif_error(coordinates + "loop_\n_atom_site.pdbx_PDB_model_num\n1\n"), "a second time");
    expect_contains(cif_error(coordinates + "loop_\n_other.id\n_atom_site.pdbx_PDB_model_num\n1 1\n"),
                    "contains other columns");
    expect_contains(cif_error(coordinates + "_Atom_Site.pdbx_PDB_model_num 1\n"), "a second time");
    EXPECT_EQ(cif_error(coordinates + "loop_\n_atom_site_anisotrop.id\n1\n"), "");
}

TEST(GemmiCif, LoopsOfSeveralCategoriesAreNoAssemblies) {
    // Found by fuzzing: gemmi, which is to see assemblies alone, got the number of a residue beyond all integers.
    const std::string mixed =
        "data_x\nloop_\n_pdbx_struct_assembly_gen.assembly_id\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
        "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 C ALA 15555555555 0 0 "
        "0\n";
    expect_contains(cif_error(mixed), "f.cif:2:1: a loop of _atom_site contains other columns");
    const RawModel model =
        cif(std::string(kHead) + "ATOM 1 C C . ALA A 1 1 0 0 1\n" +
            "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_struct_ref_seq.seq_align_beg\n1 15555555555\n");
    EXPECT_TRUE(model.assemblies.empty());
}

TEST(GemmiCif, PolymersAreKnownByTheirEntities) {
    const RawModel model =
        cif("data_x\nloop_\n_entity.id\n_entity.type\n1 polymer\n2 non-polymer\nloop_\n_atom_site.label_entity_id\n"
            "_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.Cartn_x\n"
            "_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 C CRO A 0 0 0\n2 C HEM B 0 0 0\n");
    EXPECT_TRUE(model.residues.at(0).in_sequence);
    EXPECT_FALSE(model.residues.at(1).in_sequence);
}

constexpr const char* kAssembly =
    "_pdbx_struct_assembly.id 1\n_pdbx_struct_assembly.details author_defined_assembly\n"
    "_pdbx_struct_assembly.method_details ?\n_pdbx_struct_assembly.oligomeric_details dimeric\n"
    "_pdbx_struct_assembly.oligomeric_count 2\n_pdbx_struct_assembly_gen.assembly_id 1\n"
    "_pdbx_struct_assembly_gen.asym_id_list A\nloop_\n_pdbx_struct_oper_list.id\n_pdbx_struct_oper_list.type\n"
    "_pdbx_struct_oper_list.matrix[1][1]\n_pdbx_struct_oper_list.matrix[1][2]\n_pdbx_struct_oper_list.matrix[1][3]\n"
    "_pdbx_struct_oper_list.matrix[2][1]\n_pdbx_struct_oper_list.matrix[2][2]\n_pdbx_struct_oper_list.matrix[2][3]\n"
    "_pdbx_struct_oper_list.matrix[3][1]\n_pdbx_struct_oper_list.matrix[3][2]\n_pdbx_struct_oper_list.matrix[3][3]\n"
    "_pdbx_struct_oper_list.vector[1]\n_pdbx_struct_oper_list.vector[2]\n_pdbx_struct_oper_list.vector[3]\n"
    "1 x 1 0 0 0 1 0 0 0 1 0 0 0\n2 x 1 0 0 0 1 0 0 0 1 5 0 0\n";

TEST(GemmiCif, ReadsAssemblies) {
    const std::string atom = "ATOM 1 C C . ALA A 1 1 0 0 1\n";
    const RawModel model = cif(kHead + atom + kAssembly + "_pdbx_struct_assembly_gen.oper_expression 1,2\n");
    ASSERT_EQ(model.assemblies.at(0).generators.at(0).operators.size(), 2U);
    EXPECT_TRUE(model.assemblies[0].generators[0].label_names);
    EXPECT_EQ(model.assemblies[0].generators[0].operators[1].apply({1, 0, 0}).x, 6.0);
}

TEST(GemmiCif, ProductsOfOperatorsAreNotHalfRead) {
    const std::string atom = "ATOM 1 C C . ALA A 1 1 0 0 1\n";
    const RawModel model = cif(kHead + atom + kAssembly + "_pdbx_struct_assembly_gen.oper_expression (1)(2)\n");
    EXPECT_TRUE(model.assemblies.at(0).generators.at(0).operators.empty());
}

}  // namespace
}  // namespace meniscus::reading

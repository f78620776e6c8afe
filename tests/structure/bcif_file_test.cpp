// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// BinaryCIF files give what the same mmCIF files give, and damage is told.
#include <algorithm>
#include <filesystem>

#include "bcif_writer.h"
#include "fragments.h"
#include "reading/read_bytes.h"
#include "structure/bcif_tables.h"
#include "structure/gemmi/cif_file.h"
#include "structure/input_file.h"
#include "support/test_data.h"

namespace meniscus::reading {
namespace {

using testing::bcif_of;
using testing::Column;
using testing::encoded;
using testing::expect_contains;
using testing::IntegerCoding;
using testing::packed_data;
using testing::texts;

constexpr const char* kSmallCif =
    "data_x\nloop_\n_entity.id\n_entity.type\n1 polymer\n2 non-polymer\n3 water\n"
    "loop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
    "_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_entity_id\n"
    "_atom_site.auth_seq_id\n_atom_site.pdbx_PDB_ins_code\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
    "_atom_site.Cartn_z\n_atom_site.occupancy\n_atom_site.B_iso_or_equiv\n_atom_site.pdbx_formal_charge\n"
    "_atom_site.auth_asym_id\n_atom_site.pdbx_PDB_model_num\n"
    "ATOM 1 N N . ALA A 1 -1 ? 1.234 -2.000 3.1 1.00 12.50 ? X 1\n"
    "ATOM 2 C CA A ALA A 1 -1 ? 2.001 -2.500 3.2 0.60 12.60 ? X 1\n"
    "ATOM 3 C CA B ALA A 1 -1 ? 2.101 -2.600 3.3 0.40 12.70 ? X 1\n"
    "ATOM 4 P P . DA A 1 7 A -102.5 -3.000 4.5 1.00 12.80 ? X 1\n"
    "ATOM 5 O \"O5'\" . DA A 1 7 A 103.25 -3.500 5.5 1.00 12.90 ? X 1\n"
    "HETATM 6 O \"'Q\" . LIG B 2 1 ? 8.000 0.001 0.0 1.00 13.00 -1 Y 1\n"
    "HETATM 7 O O . HOH C 3 1 ? 9.000 9.001 0.0 1.00 13.10 ? Y 1\n"
    "ATOM 8 N N . ALA A 1 -1 ? 1.334 -2.000 3.1 1.00 12.50 ? X 2\n"
    "_pdbx_struct_assembly.id 1\n_pdbx_struct_assembly.details author_defined_assembly\n"
    "_pdbx_struct_assembly.method_details ?\n_pdbx_struct_assembly.oligomeric_details dimeric\n"
    "_pdbx_struct_assembly.oligomeric_count 2\n"
    "_pdbx_struct_assembly_gen.assembly_id 1\n_pdbx_struct_assembly_gen.oper_expression 1,2\n"
    "_pdbx_struct_assembly_gen.asym_id_list A,B\nloop_\n_pdbx_struct_oper_list.id\n_pdbx_struct_oper_list.type\n"
    "_pdbx_struct_oper_list.matrix[1][1]\n_pdbx_struct_oper_list.matrix[1][2]\n_pdbx_struct_oper_list.matrix[1][3]\n"
    "_pdbx_struct_oper_list.matrix[2][1]\n_pdbx_struct_oper_list.matrix[2][2]\n_pdbx_struct_oper_list.matrix[2][3]\n"
    "_pdbx_struct_oper_list.matrix[3][1]\n_pdbx_struct_oper_list.matrix[3][2]\n_pdbx_struct_oper_list.matrix[3][3]\n"
    "_pdbx_struct_oper_list.vector[1]\n_pdbx_struct_oper_list.vector[2]\n_pdbx_struct_oper_list.vector[3]\n"
    "1 'identity operation' 1 0 0 0 1 0 0 0 1 0 0 0\n"
    "2 'crystal symmetry' -1.0000000000 0 0 0 -1.0 0 0 0 1 10.5 0.0000000 -7.25\n";

void expect_same_residues(const RawModel& a, const RawModel& b) {
    ASSERT_EQ(a.residues.size(), b.residues.size());
    for (std::size_t i = 0; i < a.residues.size(); ++i) {
        const RawResidue& x = a.residues[i];
        const RawResidue& y = b.residues[i];
        ASSERT_EQ(std::tie(x.chain, x.label_chain, x.name, x.number, x.insertion_code, x.in_sequence),
                  std::tie(y.chain, y.label_chain, y.name, y.number, y.insertion_code, y.in_sequence))
            << i;
    }
}

void expect_same_atoms(const RawModel& a, const RawModel& b) {
    ASSERT_EQ(a.atoms.size(), b.atoms.size());
    for (std::size_t i = 0; i < a.atoms.size(); ++i) {
        const RawAtom& x = a.atoms[i];
        const RawAtom& y = b.atoms[i];
        ASSERT_EQ(x.centre, y.centre) << i;
        ASSERT_EQ(
            std::tie(x.residue, x.name, x.element, x.altloc, x.hetatm, x.serial, x.occupancy, x.b_factor, x.charge),
            std::tie(y.residue, y.name, y.element, y.altloc, y.hetatm, y.serial, y.occupancy, y.b_factor, y.charge))
            << i;
    }
}

void expect_same_assemblies(const RawModel& a, const RawModel& b) {
    ASSERT_EQ(a.assemblies.size(), b.assemblies.size());
    for (std::size_t i = 0; i < a.assemblies.size(); ++i) {
        EXPECT_EQ(a.assemblies[i].name, b.assemblies[i].name);
        ASSERT_EQ(a.assemblies[i].generators.size(), b.assemblies[i].generators.size());
        for (std::size_t g = 0; g < a.assemblies[i].generators.size(); ++g) {
            EXPECT_EQ(a.assemblies[i].generators[g].chains, b.assemblies[i].generators[g].chains);
            EXPECT_EQ(a.assemblies[i].generators[g].operators, b.assemblies[i].generators[g].operators);
        }
    }
}

void expect_same(const std::string& cif) {
    const std::string bytes = bcif_of(cif);
    const CifFile text(cif, "f.cif");
    const CifFile binary(bytes, "f.bcif", CifForm::Binary);
    ASSERT_EQ(text.model_count(), binary.model_count());
    for (int position = 1; position <= std::min(text.model_count(), 3); ++position) {
        const RawModel a = text.model(position);
        const RawModel b = binary.model(position);
        expect_same_residues(a, b);
        expect_same_atoms(a, b);
        expect_same_assemblies(a, b);
    }
}

std::string error_of_bcif(const std::string& bytes) { return testing::error_of(bytes, "f.bcif"); }

TEST(BcifFile, GivesWhatTheTextGives) {
    expect_same(kSmallCif);
    const std::string bytes = bcif_of(kSmallCif);
    const RawModel model = CifFile(bytes, "f", CifForm::Binary).model(1);
    ASSERT_EQ(model.atoms.size(), 7U);
    EXPECT_EQ(model.atoms[0].centre, (Vec3{1.234, -2.0, 3.1}));
    EXPECT_EQ(model.atoms[1].altloc, 'A');
    EXPECT_EQ(model.atoms[4].name, "O5'");
    EXPECT_EQ(model.atoms[5].name, "'Q");
    EXPECT_EQ(model.residues.at(1).insertion_code, 'A');
    EXPECT_EQ(model.assemblies.at(0).generators.at(0).operators.size(), 2U);
}

TEST(BcifFile, IsReadByItsSuffixAlsoGzippedAndByContentFromStandardInput) {
    const std::string bytes = bcif_of(kSmallCif);
    const Structure text = testing::read_text(kSmallCif, "a.cif");
    const std::string different = ": this model has a different number of atoms from the first";
    for (const auto& [name, content] :
         {std::pair<std::string, std::string>{"a.bcif", bytes}, {"a.bcif.gz", testing::gzipped(bytes)}}) {
        const Structure binary = testing::read_text(content, name);
        EXPECT_EQ(binary.name, "a");
        EXPECT_EQ(binary.atoms.centres, text.atoms.centres);
        EXPECT_EQ(binary.notes, text.notes);
        EXPECT_EQ(text.warnings, std::vector<std::string>{"line 34" + different});
        EXPECT_EQ(binary.warnings, std::vector<std::string>{"row 8" + different});
        EXPECT_EQ(binary.dropped, text.dropped);
    }
    EXPECT_EQ(load_bytes(bytes, "-").format, Format::Bcif);
    EXPECT_EQ(load_bytes(bytes, "-").text, bytes);
}

TEST(BcifFile, AWrongNameIsRefusedWithTheRightOne) {
    expect_contains(testing::error_of(bcif_of(kSmallCif), "a.cif"), "a.cif: contains BinaryCIF");
    expect_contains(testing::error_of(bcif_of(kSmallCif), "a.pdb"), "rename it to .bcif");
    expect_contains(error_of_bcif(kSmallCif), "contains mmCIF text but is named .bcif");
    expect_contains(error_of_bcif("<!DOCTYPE html>"), "HTML page");
    expect_contains(error_of_bcif(std::string("\0\1\2", 3)), "is not BinaryCIF");
    expect_contains(error_of_bcif(""), "is not BinaryCIF");
}

TEST(BcifFile, CutOffAnywhereIsDamageInOneLine) {
    const std::string bytes = bcif_of(kSmallCif);
    for (std::size_t size = 30; size < bytes.size(); ++size) {
        const std::string cut = bytes.substr(0, size);
        try {
            const CifFile file(cut, "f.bcif", CifForm::Binary);
            FAIL() << "read from " << size << " bytes";
        } catch (const InputError& error) {
            const std::string message = error.what();
            ASSERT_EQ(message.find("f.bcif: damaged BinaryCIF: "), 0U) << message;
            ASSERT_NE(message.find(" at byte " + std::to_string(size) + "; fetch the file again"), std::string::npos)
                << message;
        }
    }
}

// Whatever a byte is changed to, there is an answer: atoms or one line.
TEST(BcifFile, AnyChangedByteIsReadOrRefused) {
    const std::string bytes = bcif_of(kSmallCif);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        for (const int change : {1, 0x80, 0xff}) {
            std::string changed = bytes;
            changed[i] = static_cast<char>(changed[i] ^ change);
            try {
                CifFile(changed, "f.bcif", CifForm::Binary).model(1);
            } catch (const InputError& error) {
                ASSERT_EQ(std::string(error.what()).find("f.bcif: "), 0U) << error.what();
            }
        }
    }
}

Column number_column(const std::string& name, std::vector<double> values) {
    return {name, packed_data(testing::doubles(values))};
}

Column text_column(const std::string& name, const std::vector<std::string>& values) {
    return {name, packed_data(texts(values, IntegerCoding::Plain))};
}

std::vector<Column> two_atoms() {
    return {number_column("Cartn_x", {1, 2}), number_column("Cartn_y", {1, 2}), number_column("Cartn_z", {1, 2}),
            text_column("label_atom_id", {"CA", "CB"}), text_column("label_comp_id", {"ALA", "ALA"})};
}

std::string error_of_atoms(const std::vector<Column>& columns, std::int64_t rows = 2) {
    return error_of_bcif(testing::bcif_file({{"_atom_site", rows, columns}}));
}

TEST(BcifFile, WhatDoesNotFitTogetherIsDamage) {
    EXPECT_EQ(error_of_atoms(two_atoms()), "");
    expect_contains(error_of_atoms(two_atoms(), 3), "2 values in a table of 3 rows at byte ");
    expect_contains(error_of_atoms(two_atoms(), 1000000000000), "more values than a file of this size holds");
    expect_contains(error_of_atoms(two_atoms(), -1), "no number of rows");
    std::vector<Column> columns = two_atoms();
    columns.push_back(number_column("cartn_X", {1, 2}));
    expect_contains(error_of_atoms(columns), "of the same name");
    columns.pop_back();
    columns[0].mask = packed_data(encoded({0, 3}, IntegerCoding::Plain));
    expect_contains(error_of_atoms(columns), "none of 0, 1 and 2");
    columns[0].mask = packed_data(encoded({0}, IntegerCoding::Plain));
    expect_contains(error_of_atoms(columns), "1 values in a table of 2 rows");
    const testing::Table atoms{"_atom_site", 2, two_atoms()};
    expect_contains(error_of_bcif(testing::bcif_file({atoms, {"_ATOM_SITE", 2, {text_column("x", {"a", "b"})}}})),
                    "a second table");
    expect_contains(error_of_bcif(testing::packed_map({{"version", testing::packed("0.3")}})), "\"dataBlocks\"");
    expect_contains(error_of_bcif(testing::bcif_file({{"_entity", 1, {text_column("id", {"1"})}}})), "no _atom_site");
}

TEST(BcifFile, ValuesThatAreNoNumbersAreErrorsWithTheirRow) {
    std::vector<Column> columns = two_atoms();
    columns[1] = number_column("Cartn_y", {0.0, std::numeric_limits<double>::quiet_NaN()});
    expect_contains(error_of_atoms(columns), "f.bcif: row 2: _atom_site.Cartn_y 'nan' is not a finite number");
    columns[1] = number_column("Cartn_y", {0.0, 1.0});
    columns[1].mask = packed_data(encoded({2, 0}, IntegerCoding::Plain));
    expect_contains(error_of_atoms(columns), "f.bcif: row 1: _atom_site.Cartn_y '?' is not a finite number");
    columns[1].mask = testing::packed_nil();
    columns[3] = text_column("label_atom_id", {"CA", "C\n"});
    expect_contains(error_of_atoms(columns), "row 2: _atom_site.label_atom_id 'C?' contains a byte");
}

TEST(BcifFile, TheNumberOfRowsIsWhole) {
    const auto error_of_rows = [](double rows) {
        std::string bytes = testing::bcif_file({{"_atom_site", 2, two_atoms()}});
        const std::string key = testing::packed("rowCount");
        const std::string two = key + testing::packed(std::int64_t{2});
        bytes.replace(bytes.find(two), two.size(), key + testing::packed(rows));
        return error_of_bcif(bytes);
    };
    EXPECT_EQ(error_of_rows(2.0), "");
    expect_contains(error_of_rows(2.5), "no number of rows");
}

TEST(BcifFile, MessagesCountRows) {
    std::vector<Column> columns = two_atoms();
    columns.push_back(number_column("occupancy", {1.0, std::numeric_limits<double>::quiet_NaN()}));
    columns.push_back(text_column("type_symbol", {"C", "Qq"}));
    const RawModel model =
        CifFile(testing::bcif_file({{"_atom_site", 2, columns}}), "f.bcif", CifForm::Binary).model(1);
    EXPECT_EQ(model.warnings,
              std::vector<std::string>{"row 2: _atom_site.occupancy 'nan' is not a number; taken as missing"});
    EXPECT_EQ(model.why_guessed, "_atom_site.type_symbol 'Qq' in row 2 is not an element");
}

TEST(BcifFile, NumbersOfResiduesAreIntegers) {
    std::vector<Column> columns = two_atoms();
    columns.push_back(number_column("auth_seq_id", {1, 2147483653.0}));
    expect_contains(error_of_atoms(columns), "row 2: _atom_site.auth_seq_id '2147483653' is larger than");
    columns.back() = text_column("label_alt_id", {"A1", "A2"});
    expect_contains(error_of_atoms(columns), "row 1: _atom_site.label_alt_id 'A1' is longer than one character");
}

// The columns that are not asked for may hold anything.
TEST(BcifFile, OtherTablesAreNotDecoded) {
    EXPECT_EQ(error_of_bcif(testing::bcif_file(
                  {{"_other", 7, {{"x", testing::packed("no data")}}}, {"_atom_site", 2, two_atoms()}})),
              "");
}

TEST(BcifFile, EntriesGiveWhatTheirTextsGive) {
    MENISCUS_NEED_TEST_DATA();
    for (const char* name : {"1bna", "1crn", "1en2", "1ema", "4hhb"}) {
        SCOPED_TRACE(name);
        const std::string path = (*testing::test_data() / "structures" / (std::string(name) + ".cif")).string();
        expect_same(load_input(path).text);
    }
}

}  // namespace
}  // namespace meniscus::reading

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "meniscus/errors.h"
#include "meniscus/structure.h"

namespace meniscus {
namespace {

TEST(Identifier, OfThePdbGetsTheAddressOfItsFile) {
    const std::string rest =
        " is not a file; Meniscus does not download: get 1ubq.cif from the PDB "
        "(https://files.rcsb.org/download/1ubq.cif)";
    for (const std::string name : {"1UBQ", "1ubq", "pdb_00001ubq"}) EXPECT_EQ(explain_identifier(name), name + rest);
    try {
        read_structure("1UBQ");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), "1UBQ" + rest);
    }
}

TEST(Identifier, OfAProteinGetsTheAddressOfItsModel) {
    for (const char* name : {"P0CG48", "A0A024R1R8", "AF-P0CG48-F1", "AF-P0CG48-F1-model_v4"}) {
        const std::string hint = explain_identifier(name);
        EXPECT_NE(hint.find("does not download"), std::string::npos) << name;
        EXPECT_NE(hint.find("https://alphafold.ebi.ac.uk/entry/"), std::string::npos) << name;
    }
}

TEST(Identifier, OtherNamesAreNone) {
    for (const char* name :
         {"", "-", "1ubq.pdb", "ubq", "1234", "0abc", "dir/1ubq", "protein", "results", "P0CG4", "."})
        EXPECT_EQ(explain_identifier(name), "") << name;
}

TEST(Identifier, AFileOfThatNameIsTaken) {
    const auto folder = std::filesystem::temp_directory_path() / ("meniscus_identifier_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    std::ofstream("9abc.pdb.gz") << "";
    std::ofstream("9xyz") << "";
    EXPECT_EQ(explain_identifier("9ABC"), "9ABC is not a file; did you mean 9abc.pdb.gz?");
    EXPECT_EQ(explain_identifier("9xyz"), "");
    std::filesystem::current_path(before);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "support/scratch_folder.h"
#include "support/small_structures.h"

namespace meniscus {
namespace {

using testing::ScratchFolder;

const std::string kHeader =
    "index,chain,resname,resnum,icode,name,element,altloc,serial,x,y,z,radius,b_factor,occupancy,charge\n";

TEST(AtomTable, OneRowPerAtomWithAllColumns) {
    const ScratchFolder folder;
    write_atom_table(folder / "a.atoms.csv", testing::two_atoms());
    EXPECT_EQ(testing::read_file(folder / "a.atoms.csv"),
              kHeader +
                  "0,A,GLY,-3,B,CA,C,A,17,1.5,-2.25,0.1,1.7,12.5,0.5,-0.25\n"
                  "1,A-2,HOH,101,,O5',,,18,1000.001,0,-3,1.52,0,1,0\n");
}

TEST(AtomTable, FieldsAreQuotedWhereTheyMustBe) {
    const ScratchFolder folder;
    Structure s = testing::two_atoms();
    s.labels[0].name = "C\"1,a";
    s.labels[0].altloc = ',';
    s.residues[0].chain = "A\nB";
    write_atom_table(folder / "a.atoms.csv", s);
    EXPECT_NE(testing::read_file(folder / "a.atoms.csv").find("0,\"A\nB\",GLY,-3,B,\"C\"\"1,a\",C,\",\",17,"),
              std::string::npos);
}

// Rows are made by several threads, some thousand at a time.
TEST(AtomTable, ManyRowsStandInTheirOrder) {
    const ScratchFolder folder;
    constexpr std::size_t kAtoms = 20'001;
    const Structure two = testing::two_atoms();
    Structure many = two;
    many.atoms.centres.assign(kAtoms, two.atoms.centres[0]);
    many.atoms.radii.assign(kAtoms, two.atoms.radii[0]);
    many.labels.assign(kAtoms, two.labels[0]);
    write_atom_table(folder / "a.atoms.csv", many);
    std::string expected = kHeader;
    for (std::size_t i = 0; i < kAtoms; ++i)
        expected += std::to_string(i) + ",A,GLY,-3,B,CA,C,A,17,1.5,-2.25,0.1,1.7,12.5,0.5,-0.25\n";
    EXPECT_TRUE(testing::read_file(folder / "a.atoms.csv") == expected);
}

TEST(AtomTable, NoAtomsGiveTheHeaderOnly) {
    const ScratchFolder folder;
    write_atom_table(folder / "a.atoms.csv", {});
    EXPECT_EQ(testing::read_file(folder / "a.atoms.csv"), kHeader);
}

TEST(AtomTable, FailureLeavesNoFile) {
    const ScratchFolder folder;
    Structure s = testing::two_atoms();
    s.labels.pop_back();
    EXPECT_THROW(write_atom_table(folder / "a.atoms.csv", s), UsageError);
    EXPECT_THROW(write_atom_table(folder / "none/a.atoms.csv", testing::two_atoms()), OutputError);
    EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace meniscus

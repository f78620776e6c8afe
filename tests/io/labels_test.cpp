// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/labels.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "support/small_structures.h"

namespace meniscus {
namespace {

TEST(Labels, ResidueOfAnAtom) {
    const Structure s = testing::two_atoms();
    EXPECT_NO_THROW(check_labels(s));
    EXPECT_EQ(residue_of(s, 1).name, "HOH");
}

TEST(Labels, BareSpheresHaveANamelessResidue) {
    Structure s = testing::two_atoms();
    s.residues.clear();
    EXPECT_NO_THROW(check_labels(s));
    EXPECT_EQ(residue_of(s, 1).name, "");
}

TEST(Labels, ResiduesThatDoNotExistAreRefused) {
    Structure s = testing::two_atoms();
    s.labels[1].residue = 2;
    EXPECT_THROW(check_labels(s), UsageError);
    s.labels.pop_back();
    EXPECT_THROW(check_labels(s), UsageError);
}

}  // namespace
}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/checks.h"

#include <gtest/gtest.h>

#include <limits>

#include "colours/small_meshes.h"

namespace meniscus {
namespace {

TEST(ColourChecks, RangesMustBeFiniteAndOfSchemesOfValues) {
    const auto check = [](ColourScheme scheme, double min, double max) {
        check_options({.scheme = scheme, .range = ValueRange{min, max}});
    };
    EXPECT_NO_THROW(check(ColourScheme::Depth, 0.0, 1.0));
    EXPECT_NO_THROW(check_options({.scheme = ColourScheme::Chain}));
    EXPECT_THROW(check(ColourScheme::Chain, 0.0, 1.0), UsageError);
    EXPECT_THROW(check(ColourScheme::Depth, 1.0, 1.0), UsageError);
    EXPECT_THROW(check(ColourScheme::BFactor, 0.0, std::numeric_limits<double>::infinity()), UsageError);
    EXPECT_THROW(check(ColourScheme::Curvature, std::numeric_limits<double>::quiet_NaN(), 1.0), UsageError);
}

TEST(ColourChecks, ANameOfValuesGoesWithTheirSchemeAlone) {
    EXPECT_NO_THROW(check_options({.scheme = ColourScheme::Value, .value = "phi"}));
    EXPECT_THROW(check_options({.scheme = ColourScheme::Value}), UsageError);
    EXPECT_THROW(check_options({.scheme = ColourScheme::Chain, .value = "phi"}), UsageError);
}

TEST(ColourChecks, AColourGoesWithTheSchemeOfOneAlone) {
    EXPECT_NO_THROW(check_options({.scheme = ColourScheme::Single, .colour = Colour{1, 2, 3}}));
    EXPECT_THROW(check_options({.scheme = ColourScheme::Chain, .colour = Colour{1, 2, 3}}), UsageError);
}

TEST(ColourChecks, VerticesMustNameAtomsThatTheStructureHas) {
    Mesh mesh = testing::vertex_per_atom();
    EXPECT_NO_THROW(check_atoms(mesh, testing::small_complex()));
    mesh.atoms.back() = 6;
    EXPECT_THROW(check_atoms(mesh, testing::small_complex()), UsageError);
    mesh.atoms.pop_back();
    EXPECT_THROW(check_atoms(mesh, testing::small_complex()), UsageError);
}

}  // namespace
}  // namespace meniscus

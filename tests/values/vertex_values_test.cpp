// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/vertex_values.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meniscus/errors.h"
#include "support/shapes.h"
#include "tables/small_complex.h"

namespace meniscus {
namespace {

using testing::extracted_sphere;
using testing::small_complex;

/// x + 2 y - z on nodes from -4 to 4 Å.
Volume slope() {
    Volume volume{{.counts = {9, 9, 9}, .origin = {-4, -4, -4}, .spacing = {1, 1, 1}}, {}};
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j)
            for (int k = 0; k < 9; ++k) volume.values.push_back(static_cast<float>((i - 4) + 2 * (j - 4) - (k - 4)));
    return volume;
}

TEST(SampleVolume, LinearFunctionsAreExactAtTheOffset) {
    Mesh ball = extracted_sphere({.centre = {}, .radius = 2.0}, 0.5);
    for (const Vec3& p : ball.vertices) ball.normals.push_back(to_small(normalised(p)));
    for (const auto interpolation : {Interpolation::Linear, Interpolation::Cubic})
        for (const double offset : {0.0, 1.5, -0.5}) {
            const VertexValues values = sample_volume(ball, "phi", slope(), {interpolation, offset});
            EXPECT_EQ(values.name, "phi");
            for (std::size_t v = 0; v < ball.vertices.size(); ++v) {
                const Vec3 p = ball.vertices[v] + offset * ball.normals[v];
                ASSERT_NEAR(values.values[v], p.x + 2.0 * p.y - p.z, 1e-5);
            }
        }
}

TEST(SampleVolume, BeyondTheMapThereIsNoValue) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {4, 4, 4}, {4.1, 0, 0}};
    const VertexValues values = sample_volume(mesh, "phi", slope());
    EXPECT_EQ(values.values[0], 0.0F);
    EXPECT_EQ(values.values[1], 8.0F);
    EXPECT_TRUE(std::isnan(values.values[2]));
    EXPECT_THROW(sample_volume(mesh, "phi", slope(), {.offset = 1.0}), UsageError);
    EXPECT_THROW(sample_volume(mesh, "phi", slope(), {.offset = std::nan("")}), UsageError);
}

TEST(VertexValues, AreThoseOfTheNearestAtom) {
    Mesh mesh;
    mesh.vertices.resize(3);
    mesh.atoms = {2, 0, 2};
    EXPECT_EQ(values_at_vertices(mesh, {"v", {1, 2, 3}}).values, (std::vector<float>{3, 1, 3}));
    EXPECT_THROW(values_at_vertices(mesh, {"v", {1, 2}}), UsageError);
    mesh.atoms.pop_back();
    EXPECT_THROW(values_at_vertices(mesh, {"v", {1, 2, 3}}), UsageError);
}

TEST(VertexValues, SchemesOfBFactorsBringThem) {
    Structure structure = small_complex();
    structure.labels[3].b_factor = 55.0;
    const auto values = values_of_scheme(ColourScheme::Plddt, structure);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->name, "plddt");
    EXPECT_EQ(values->of_atom[3], 55.0);
    EXPECT_EQ(values_of_scheme(ColourScheme::BFactor, structure)->name, "bfactor");
    EXPECT_FALSE(values_of_scheme(ColourScheme::Depth, structure));
}

TEST(VertexValues, NamesAreWordsThatNoOtherArrayHas) {
    for (const char* name : {"phi", "_x1", "bfactor", "sas_area"}) EXPECT_TRUE(is_value_name(name)) << name;
    for (const char* name : {"", "1a", "a b", "a-b", "x", "NX", "Area", "residue", "red"})
        EXPECT_FALSE(is_value_name(name)) << name;
}

TEST(VertexValues, TheRangeIsTwoSidedWhereTheSignsAre) {
    EXPECT_EQ(range_of({"v", {1, 5, NAN, 3}}), (ValueRange{1, 5}));
    EXPECT_EQ(range_of({"v", {-1, 5}}), (ValueRange{-5, 5}));
    EXPECT_EQ(range_of({"v", {-3, -2}}), (ValueRange{-3, -2}));
    EXPECT_EQ(range_of({"v", {NAN}}), (ValueRange{0, 1}));
}

TEST(VertexValues, UnknownNamesAreRefusedWithThoseThereAre) {
    Mesh mesh;
    mesh.values = {{"phi", {}}, {"psi", {}}};
    EXPECT_EQ(&values_named(mesh, "psi"), &mesh.values[1]);
    try {
        values_named(mesh, "chi");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "there are no values 'chi'; there are phi, psi");
    }
}

}  // namespace
}  // namespace meniscus

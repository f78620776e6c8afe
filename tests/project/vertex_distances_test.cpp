// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/vertex_distances.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace meniscus::testing {
namespace {

// A tenth of them are off the surface.
std::vector<float> mostly_zero(std::size_t count) {
    std::mt19937_64 random(count);
    std::uniform_real_distribution<float> distance(0.0F, 1.0F);
    std::vector<float> distances(count);
    for (float& d : distances)
        if (distance(random) < 0.1F) d = distance(random);
    return distances;
}

VertexDistances listed(const std::vector<float>& distances) {
    std::vector<VertexDistances::Off> off;
    for (VertexId v = 0; v < distances.size(); ++v)
        if (distances[v] != 0.0F) off.push_back({v, distances[v]});
    return {distances.size(), off};
}

void expect_same(const VertexDistances& found, const std::vector<float>& expected) {
    for (VertexId v = 0; v < expected.size(); ++v) EXPECT_EQ(found[v], expected[v]);
    const DistanceSummary a = found.summarise();
    const DistanceSummary b = VertexDistances(expected).summarise();
    EXPECT_NEAR(a.mean, b.mean, 1e-14);
    EXPECT_EQ(a.p99, b.p99);
    EXPECT_EQ(a.max, b.max);
}

TEST(VertexDistances, ListedOnesTellTheSameAsAll) {
    for (const std::size_t count : {1U, 2U, 99U, 100U, 101U, 3000U}) {
        expect_same(listed(mostly_zero(count)), mostly_zero(count));
        expect_same(listed(std::vector<float>(count)), std::vector<float>(count));
        expect_same(listed(std::vector<float>(count, 0.5F)), std::vector<float>(count, 0.5F));
    }
}

TEST(VertexDistances, OfNothingAreZero) {
    for (const VertexDistances& none : {VertexDistances({}), VertexDistances(0, {})}) {
        EXPECT_EQ(none.summarise().mean, 0.0);
        EXPECT_EQ(none.summarise().p99, 0.0);
        EXPECT_EQ(none.summarise().max, 0.0);
    }
}

TEST(VertexDistances, FollowTheRenumberingOfMending) {
    MeshChanges changes;
    changes.with_new = 1002;
    changes.refilled = {{3, 1001}, {500, 1000}, {7, 999}, {3, 998}};
    changes.left = 998;
    std::vector<float> all = mostly_zero(1000);
    all[3] = 0.25F;
    all[999] = 0.0F;
    all[998] = 0.75F;
    VertexDistances some = listed(all);
    some.renumber(changes);
    renumber_entries(changes, all);
    expect_same(some, all);
    some.set(500, 0.125F);
    some.set(3, 0.0F);
    all[500] = 0.125F;
    all[3] = 0.0F;
    expect_same(some, all);
}

}  // namespace
}  // namespace meniscus::testing

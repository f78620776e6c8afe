// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/volume_origins.h"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

// In canonical order, whatever that is.
std::vector<Vec3> origins_of(const std::vector<Vec3>& centres) {
    const AccessibleSurface surface({centres, std::vector<double>(centres.size(), 1.7)}, 1.4);
    const VolumeOrigins origins(surface.data());
    std::vector<Vec3> result(centres.size());
    for (std::uint32_t i = 0; i < centres.size(); ++i) result[surface.data().atoms.original[i]] = origins.of(i);
    return result;
}

TEST(VolumeOrigins, IsTheMiddleOfAStructure) {
    for (const Vec3& origin : origins_of({{0, 0, 0}, {10, 0, 0}, {0, 900, 4}})) EXPECT_EQ(origin, (Vec3{5, 450, 2}));
}

TEST(VolumeOrigins, EachFarClusterHasItsOwn) {
    const std::vector<Vec3> origins = origins_of({{0, 0, 0}, {2, 0, 0}, {1e6, 0, 0}, {1e6, 4, 0}, {1e6, 0, 5e5}});
    EXPECT_EQ(origins[0], (Vec3{1, 0, 0}));
    EXPECT_EQ(origins[0], origins[1]);
    EXPECT_EQ(origins[2], (Vec3{1e6, 2, 0}));
    EXPECT_EQ(origins[2], origins[3]);
    EXPECT_EQ(origins[4], (Vec3{1e6, 0, 5e5}));
}

// What touches is one surface, however long.
TEST(VolumeOrigins, AChainIsNotCut) {
    std::vector<Vec3> chain;
    chain.reserve(3000);
    for (int i = 0; i < 3000; ++i) chain.push_back({3.0 * i, 4.0 * i, 0});
    const std::vector<Vec3> origins = origins_of(chain);
    for (const Vec3& origin : origins) ASSERT_EQ(origin, origins[0]);
}

}  // namespace
}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/measured_arrays.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace meniscus::testing {
namespace {

TEST(MeasuredArrays, AreThoseThatTheMeshHas) {
    Mesh mesh = tetrahedron();
    EXPECT_TRUE(measured_arrays(mesh).empty());
    mesh.shape_indices = {0, 0, 0, 1};
    mesh.areas = {1, 2, 3, 4};
    const std::vector<MeasuredArray> arrays = measured_arrays(mesh);
    ASSERT_EQ(arrays.size(), 2U);
    EXPECT_EQ(arrays[0].name, "area");
    EXPECT_EQ(arrays[1].name, "shape_index");
    EXPECT_EQ(arrays[1].values[3], 1.0F);
    mesh.values = {{"phi", {5, 6, 7, 8}}};
    EXPECT_EQ(measured_arrays(mesh).back().name, "phi");
    EXPECT_EQ(measured_arrays(mesh).back().values[0], 5.0F);
}

}  // namespace
}  // namespace meniscus::testing

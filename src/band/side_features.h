// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Features of the SAS in single precision, relative to a point nearby: enough to tell which side of the SES most points
// are on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/local_features.h"
#include "meniscus/vec3.h"

namespace meniscus {

struct SideBall {
    SmallVec3 centre;
    float rho;
    std::uint32_t atom;
};
struct SideArc {
    SmallVec3 centre;
    SmallVec3 axis;
    SmallVec3 middle;
    float radius;
    float cos_half;  ///< below -1 for a whole circle
};

/// All features that can be nearest to some points.
struct SideFeatures {
    std::vector<SideBall> balls;
    std::vector<SideArc> arcs;
    std::vector<SmallVec3> vertices;

    void clear() {
        balls.clear();
        arcs.clear();
        vertices.clear();
    }
};

/// The features that can be nearest to points of a box, relative to its middle, with columns to choose from them by.
class SideFeaturesOfBox {
public:
    /// from: lists for a box around this one, which are complete as far as `margin` (LocalFeatures).
    void gather(const LocalFeatures& from, const Box& box, double margin);

    const SideFeatures& features() const { return features_; }
    const FeatureList<4, float>& balls() const { return balls_; }        ///< x, y, z, rho
    const FeatureList<6, float>& cells() const { return cells_; }        ///< of the arcs: low x, y, z, high x, y, z
    const FeatureList<3, float>& vertices() const { return vertices_; }  ///< x, y, z

private:
    // The items that are marked.
    std::span<const std::uint32_t> marked(std::size_t count);
    void take_balls(const SphereList& balls, std::span<const std::uint32_t> items, const Vec3& middle);
    void take_arcs(const LocalFeatures& from, std::span<const std::uint32_t> items, const Vec3& middle);
    void take_vertices(const SphereList& vertices, std::span<const std::uint32_t> items, const Vec3& middle);

    SideFeatures features_;
    FeatureList<4, float> balls_;
    FeatureList<6, float> cells_;
    FeatureList<3, float> vertices_;
    std::vector<std::uint64_t> marks_;
    std::vector<std::uint32_t> items_;
};

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/sky_reach.h"

#include <algorithm>

namespace meniscus {
namespace {

/// The sky is blocked by what lies within this share of the molecule's depth, but no farther than kLongestReach: beyond
/// that, hollows of large assemblies would only be black.
constexpr double kReachShare = 0.5;
constexpr double kLongestReach = 25.0;
constexpr double kShortestReach = 2.0;

}  // namespace

double reach_of_sky(const Camera& camera) {
    return std::clamp(kReachShare * camera.depth_range(), kShortestReach, kLongestReach);
}

double mean_edge(const Mesh& mesh) {
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) sum += norm(mesh.vertices[t[1]] - mesh.vertices[t[0]]);
    return sum / static_cast<double>(mesh.triangles.size());
}

}  // namespace meniscus

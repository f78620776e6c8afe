// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The light of the sky for viewers that cast no rays themselves.
#pragma once

#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// About the share of the sky that every vertex sees, smoothed over its neighbours; the same for any number of threads.
///
/// Pictures cast rays for the light of what they show (SkyLight). Here the whole surface is projected along a few dozen
/// axes, which is as near as a viewer needs, takes a fraction of the time and no library.
/// mesh     with normals and a triangle
/// cost     O(vertices + triangles + Å² of surface), times the number of axes
std::vector<float> openness(const Mesh& mesh);

}  // namespace meniscus

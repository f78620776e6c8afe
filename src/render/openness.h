// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The light of the sky for viewers that cast no rays themselves.
#pragma once

#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// The share of the sky that every vertex sees, as pictures have it (SkyLight).
///
/// mesh     with normals and a triangle
/// cost     about 100 rays per vertex
std::vector<float> openness(const Mesh& mesh);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Lengths that the light of the sky depends on: how far away the sky can be blocked, how fine a mesh is.
#pragma once

#include "meniscus/mesh.h"
#include "render/camera.h"

namespace meniscus {

/// How far the sky is blocked, Å: by a share of the molecule's depth.
double reach_of_sky(const Camera& camera);

/// Mean length of the edges of triangles, of which there must be one, Å.
double mean_edge(const Mesh& mesh);

}  // namespace meniscus

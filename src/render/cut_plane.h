// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where a picture is cut open.
#pragma once

#include "meniscus/picture.h"
#include "render/camera.h"
#include "render/half_space.h"

namespace meniscus {

/// What a cut leaves.
/// throws   UsageError for a cavity that the mesh does not have, a normal that is zero, numbers that are not finite
/// cost     O(n)
HalfSpace find_cut(const Mesh& mesh, const Cut& cut, const Camera& camera);

/// True for a mesh that bounds a body: closed, every edge with as many triangles one way as the other, and with a
/// positive volume. Others have no inside that a section could show.
/// cost     O(n log n)
bool is_body(const Mesh& mesh);

}  // namespace meniscus

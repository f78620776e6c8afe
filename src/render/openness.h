// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The light of the sky for viewers that cast no rays themselves, and pictures by that light.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "meniscus/picture.h"
#include "render/ray_scene.h"

namespace meniscus {

/// About the share of the sky that every vertex sees, smoothed over its neighbours.
///
/// Pictures ask for the light of what they show (SkyLight); here it is that of the whole surface, along fewer rays and
/// blurred more. The cost does not grow with the fineness of the mesh.
/// mesh     with normals and a triangle
/// rays     of the mesh
/// cost     a few dozen rays per Å²
std::vector<float> openness(const Mesh& mesh, const RayScene& rays);

/// draw_picture() by light that is known.
/// sky      one share per vertex
/// rays     of the mesh; none if that has no triangle
/// throws   as draw_picture()
Picture draw_picture_by(std::span<const float> sky, const Mesh& mesh, const std::optional<RayScene>& rays,
                        std::span<const Colour> colours, const PictureOptions& options);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pictures by light that is known, as pages have it.
#pragma once

#include <span>

#include "meniscus/picture.h"

namespace meniscus {

/// draw_picture() by the light of the sky that openness() has found.
/// sky      one share per vertex
/// throws   as draw_picture()
Picture draw_picture_by(std::span<const float> sky, const Mesh& mesh, std::span<const Colour> colours,
                        const PictureOptions& options, const Bodies& beside = {});

}  // namespace meniscus

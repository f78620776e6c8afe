// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Takes the place of draw_picture.cpp and draw_legend.cpp in a build without pictures (CMake's MENISCUS_PICTURES=OFF).
#include "meniscus/errors.h"
#include "meniscus/legend.h"
#include "meniscus/picture.h"
#include "render/draw_by.h"

namespace meniscus {
namespace {

[[noreturn]] void refuse() {
    throw UsageError("this build draws no pictures (MENISCUS_PICTURES was off when it was built)");
}

}  // namespace

bool pictures_supported() { return false; }

Picture draw_picture(const Mesh& /*mesh*/, std::span<const Colour> /*colours*/, const PictureOptions& /*options*/,
                     const ColourField& /*exact*/, const Bodies& /*beside*/) {
    refuse();
}

Picture draw_picture_by(std::span<const float> /*sky*/, const Mesh& /*mesh*/, std::span<const Colour> /*colours*/,
                        const PictureOptions& /*options*/, const Bodies& /*beside*/) {
    refuse();
}

Picture draw_legend(const Legend& /*legend*/, const LegendStyle& /*style*/) { refuse(); }

Picture side_by_side(const Picture& /*left*/, const Picture& /*right*/) { refuse(); }

}  // namespace meniscus

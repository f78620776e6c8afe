// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// PNG pictures.
#pragma once

#include <string>

#include "meniscus/picture.h"

namespace meniscus {

/// The content of a PNG file: eight bits per channel, sRGB; with an alpha channel only if a pixel is not opaque.
///
/// throws   UsageError for a picture without pixels or with a number of them that does not match its size
/// cost     O(pixels); the file is held in memory
std::string encode_png(const Picture& picture);

}  // namespace meniscus

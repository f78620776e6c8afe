// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The font in the program: DejaVuSans.ttf of Debian's fonts-dejavu-core, embedded when it is built.
#pragma once

#include <string_view>

namespace meniscus {

/// A TrueType file. Free to use and to pass on with programs (Bitstream Vera and Arev licences, in the package).
extern const std::string_view kFontFile;

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Takes the place of png.cpp in a build without pictures (CMake's MENISCUS_PICTURES=OFF).
#include "io/png.h"
#include "meniscus/errors.h"

namespace meniscus {

std::string encode_png(const Picture& /*picture*/) {
    throw UsageError("this build draws no pictures (MENISCUS_PICTURES was off when it was built)");
}

}  // namespace meniscus

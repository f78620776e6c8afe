// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Takes the place of gunzip.cpp in a build without zlib (CMake's MENISCUS_ZLIB=OFF).
#include "meniscus/errors.h"
#include "reading/gunzip.h"

namespace meniscus::reading {

std::string gunzip(std::string_view /*bytes*/, const std::string& file) {
    throw InputError(file + ": is gzipped, which this build cannot read (it has no zlib); decompress it first");
}

}  // namespace meniscus::reading

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Takes the place of make_page.cpp in a build without zlib or nettle (CMake's MENISCUS_ZLIB, MENISCUS_NETTLE), which
// cannot pack a page into one file; page_content() still has all that a page shows.
#include <stdexcept>

#include "meniscus/page.h"

namespace meniscus {

bool pages_supported() { return false; }

std::string make_page(const Mesh& /*mesh*/, const Structure& /*structure*/, const PageOptions& /*options*/) {
    throw std::runtime_error("this build makes no pages: it has no zlib or no nettle");
}

void write_page(const std::string& /*path*/, const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    make_page(mesh, structure, options);
}

}  // namespace meniscus

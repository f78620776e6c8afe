// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Bytes as text of HTML.
#pragma once

#include <string>
#include <string_view>

namespace meniscus::page {

/// zlib's format (RFC 1950).
std::string deflated(std::string_view bytes);

/// RFC 4648, section 4.
std::string base64(std::string_view bytes);

}  // namespace meniscus::page

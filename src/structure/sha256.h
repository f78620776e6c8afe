// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The fingerprint of a file, for reports.
#pragma once

#include <string>
#include <string_view>

namespace meniscus::reading {

/// SHA-256 of the bytes, as 64 hexadecimal digits in lower case; empty in a build without nettle.
std::string sha256_hex(std::string_view bytes);

}  // namespace meniscus::reading

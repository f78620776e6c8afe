// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Reading of gzip data.
#pragma once

#include <string>
#include <string_view>

namespace meniscus::reading {

/// True if the bytes begin as gzip data do.
inline bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

/// The content of gzip data, all members of it.
///
/// file     name for messages
/// throws   InputError if the data are damaged or end too early, or if this build has no zlib; LimitError above 8 GiB
/// of
///          content
std::string gunzip(std::string_view bytes, const std::string& file);

}  // namespace meniscus::reading

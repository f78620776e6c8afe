// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From a path to the bytes of a file.
#pragma once

#include <cstddef>
#include <string>

namespace meniscus::reading {

/// Reading takes up to six times the size of the text until the atoms are chosen.
inline constexpr std::size_t kMemoryPerText = 6;

/// All bytes of a file, or of standard input if the path is "-", as they are.
///
/// kind     of file that is wanted, for the message about a folder: "structure file"
/// throws   InputError if it cannot be read
std::string read_bytes(const std::string& path, const std::string& kind);

/// The same, decompressed if they are gzip data, whatever the name.
/// throws   also InputError and LimitError as gunzip()
std::string read_unzipped(const std::string& path, const std::string& kind);

}  // namespace meniscus::reading

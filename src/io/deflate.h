// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Compression by all cores, with the same bytes for any number of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus {

struct Deflated {
    std::vector<std::string> pieces;  ///< together one raw deflate stream (RFC 1951)
    std::uint32_t checksum = 0;       ///< CRC-32 of what was compressed
    std::uint64_t size = 0;           ///< bytes of that

    std::uint64_t compressed_size() const;
};

/// Compresses what the parts hold one after the other. Pieces of 1 MiB are compressed on their own, each to a whole
/// number of bytes, which costs less than 0.1 % of the size.
/// cost     some 30 ns per byte and core; memory for the compressed bytes
Deflated deflated(std::span<const std::string_view> parts);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/byte_streams.h"

namespace meniscus::page {

void append_varint(std::string& bytes, std::uint64_t value) {
    for (; value >= 0x80U; value >>= 7U) bytes.push_back(static_cast<char>(value | 0x80U));
    bytes.push_back(static_cast<char>(value));
}

std::string byte_differences(std::span<const std::uint8_t> values) {
    std::string bytes;
    bytes.reserve(values.size());
    std::uint8_t last = 0;
    for (const std::uint8_t value : values) bytes.push_back(static_cast<char>(value - std::exchange(last, value)));
    return bytes;
}

void Streams::add(std::string name, std::string_view bytes) {
    places_.push_back({std::move(name), bytes_.size(), bytes.size()});
    bytes_.append(bytes);
}

}  // namespace meniscus::page

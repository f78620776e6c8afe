// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// MessagePack, the binary form of JSON in which BinaryCIF is written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::reading {

/// What is wrong with MessagePack data, or with what they say, and at which byte of the file.
class DamagedData : public std::runtime_error {
public:
    DamagedData(const std::string& what, std::size_t at) : std::runtime_error(what), at_(at) {}
    std::size_t at() const { return at_; }

private:
    std::size_t at_;
};

/// A value of MessagePack data. Texts and bytes are views of these data.
struct PackedValue {
    enum class Kind : std::uint8_t { Nil, Boolean, Integer, Real, Text, Bytes, Array, Map, Extension };

    Kind kind = Kind::Nil;
    std::int64_t integer = 0;        ///< of Boolean and Integer
    double real = 0.0;               ///< of Real, and of Integer as far as a double has it
    std::string_view text;           ///< of Text and Bytes
    std::vector<PackedValue> items;  ///< of Array; of Map a key and its value by turns
    std::size_t at = 0;              ///< offset of its first byte

    bool is_text() const { return kind == Kind::Text || kind == Kind::Bytes; }
    bool is_number() const { return kind == Kind::Integer || kind == Kind::Real; }

    /// The value of a key of a map; null if there is none, or this is no map.
    const PackedValue* find(std::string_view key) const;
};

/// The one value of which MessagePack data consist.
///
/// throws   DamagedData if they end too early, go on behind the value, or are nested more than 32 levels deep
/// cost     memory of a hundred bytes or so for each value of it, of which each takes a byte at least
PackedValue unpack(std::string_view bytes);

}  // namespace meniscus::reading

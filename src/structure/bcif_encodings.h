// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The seven encodings of BinaryCIF 0.3 (github.com/molstar/BinaryCIF/blob/master/encoding.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "structure/message_pack.h"

namespace meniscus::reading {

/// Floating-point numbers, which were written with the digits of a float or of a double.
struct BcifReals {
    std::vector<double> values;
    bool single = false;
};

using BcifIntegers = std::vector<std::int64_t>;
using BcifTexts = std::vector<std::string_view>;
using BcifArray = std::variant<BcifIntegers, BcifReals, BcifTexts>;

/// Decodes a `data` map of BinaryCIF, {"data": bytes, "encoding": [...]}.
///
/// at_most  values that any step may yield: runs may claim any number of them
/// returns  texts are views of the file's bytes
/// throws   DamagedData
BcifArray decode_bcif(const PackedValue& data, std::size_t at_most);

std::size_t size_of(const BcifArray& array);

}  // namespace meniscus::reading

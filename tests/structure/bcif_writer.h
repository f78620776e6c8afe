// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A small writer of BinaryCIF for tests: MessagePack, the seven encodings, and mmCIF texts as BinaryCIF.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::testing {

// ---- MessagePack

std::string packed(std::int64_t number);
std::string packed(double number);
std::string packed(bool value);
std::string packed(const std::string& text);
inline std::string packed(const char* text) { return packed(std::string(text)); }
std::string packed_bytes(const std::string& bytes);
inline std::string packed_nil() { return "\xc0"; }
std::string packed_array(const std::vector<std::string>& items);

struct PackedMember {
    std::string key;
    std::string value;  ///< packed
};
std::string packed_map(const std::vector<PackedMember>& members);

// ---- encodings

using Integers = std::vector<std::int64_t>;

/// Bytes, and the encodings, packed, that make values of them: the first is undone last.
struct Encoded {
    std::string bytes;
    std::vector<std::string> encodings;
};

enum class IntegerCoding { Plain, Runs, Deltas, Packed8, Packed16, All };

Encoded encoded(const Integers& values, IntegerCoding coding);
Encoded fixed_point(const std::vector<double>& values, double factor, IntegerCoding coding);
Encoded interval(const std::vector<double>& values, double low, double high, int steps);
Encoded floats(const std::vector<double>& values);
Encoded doubles(const std::vector<double>& values);
Encoded texts(const std::vector<std::string>& values, IntegerCoding coding);

/// {"data": ..., "encoding": [...]}
std::string packed_data(const Encoded& encoded);

// ---- files

struct Column {
    std::string name;
    std::string data;  ///< packed
    std::string mask = "\xc0";
};

struct Table {
    std::string name;  ///< "_atom_site"
    std::int64_t rows = 0;
    std::vector<Column> columns;
};

std::string bcif_file(const std::vector<Table>& tables);

/// An mmCIF text of one block as BinaryCIF: integers, decimals and texts in encodings that take turns.
std::string bcif_of(std::string_view cif);

}  // namespace meniscus::testing

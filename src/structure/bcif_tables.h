// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// BinaryCIF files as the texts that mmCIF files have for the same values.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::reading {

/// A column; its values are written as in mmCIF: in quotes where CIF asks for them, "." and "?" for values that are
/// not there.
struct BcifColumn {
    std::string tag;  ///< "_atom_site.Cartn_x"
    std::vector<std::string_view> values;
};

struct BcifCategory {
    std::size_t rows = 0;  ///< at least one, in each of at least one column
    std::vector<BcifColumn> columns;
};

struct BcifBlock {
    std::string name;
    std::vector<BcifCategory> categories;
};

/// What was taken from a file. Views are of the file's bytes and of `texts`, which does not move them.
struct BcifTables {
    std::vector<BcifBlock> blocks;
    std::deque<std::string> texts;
};

/// Which columns are taken, by their tags; the others are passed over without a look at their values.
using BcifChoice = std::function<bool(std::string_view tag)>;

/// True if the bytes begin as those of a BinaryCIF file do.
bool is_bcif(std::string_view bytes);

/// Decodes the chosen columns of a BinaryCIF file.
///
/// bytes    have to outlive the tables
/// throws   InputError "FILE: damaged BinaryCIF: ... at byte N; ..."
/// cost     memory is bounded by the size of the file, however many values it claims to hold
BcifTables read_bcif(std::string_view bytes, const std::string& file, const BcifChoice& chosen);

}  // namespace meniscus::reading

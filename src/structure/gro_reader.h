// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The coordinates of GROMACS (.gro): fixed columns, nanometres, no chains and no elements.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "structure/raw_model.h"

namespace meniscus::reading {

/// The atoms of one frame: a title, their number, a line for each, and the box.
struct GroFrame {
    std::size_t begin = 0;       ///< offset of the first atom's line
    std::size_t first_line = 1;  ///< number of that line
    std::size_t atoms = 0;
    std::size_t width = 8;  ///< of a coordinate; the points of the first atom's coordinates are that far apart
};

/// True if the second line is a number and the third has an atom's columns: the first may hold anything.
bool is_gro(std::string_view text);

/// The frames of a file, which are its models.
/// throws   InputError with the line that is missing or wrong
std::vector<GroFrame> find_gro_frames(std::string_view text, const std::string& file);

/// The atoms of a frame, in Å. Residues of other names than those of amino acids, nucleotides and water are taken as
/// hetero groups; virtual sites of water are left out with a note. Numbers begin again after 99999: a residue ends
/// where number or name change, or its first atom comes again. throws   InputError with line and column
RawModel parse_gro(std::string_view text, const GroFrame& frame, const std::string& file);

}  // namespace meniscus::reading

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The steps from the atoms of a file, or of another program, to the Structure that is handed out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meniscus/structure.h"
#include "structure/input_file.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// Appends lines to lines.
void append(std::vector<std::string>& lines, const std::vector<std::string>& more);

/// throws   UsageError for options that contradict each other or are out of range
void check_options(const ReadOptions& options);

/// Joins the pieces of residues and finds out what kind each of them is.
void complete_model(RawModel& model);

/// A structure, and from which atoms of the model it was made.
struct MadeStructure {
    Structure structure;
    std::vector<std::uint32_t> atoms;  ///< one entry per kept atom, unless there is an assembly, which copies them
};

/// Chooses atoms of a complete model and gives them radii.
///
/// file     where the model comes from; its text is not used
/// throws   InputError if no atoms are left
MadeStructure make_structure(const InputFile& file, const RawModel& model, const ReadOptions& options);

}  // namespace meniscus::reading

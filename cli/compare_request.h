// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What `meniscus compare` is asked to do, and the options that ask it.
#pragma once

#include <optional>
#include <string>

#include "common_request.h"
#include "meniscus/colours.h"
#include "meniscus/compare.h"

namespace meniscus::cli {

/// The first surface is `input`. What is said of atoms holds for both, where they are structures.
struct CompareRequest : CommonRequest {
    std::string second;
    StructureToCompare structure;
    CompareOptions compare;
    std::string of_structures{};  ///< an option that was given and that only structures heed; empty if there is none
    std::optional<ValueRange> range;  ///< of colours; nothing: as far as 99 % of A's area are from B
};

/// Gives a subcommand its options; parsing fills `request`, which must outlive the parser.
/// throws   as add_surface_options
void add_compare_options(CLI::App& command, CompareRequest& request);

/// Refuses what cannot be done before anything is read: files that hold no distances, more than one model,
/// options that would do nothing.
/// throws   UsageError
void check_request(const CompareRequest& request);

}  // namespace meniscus::cli

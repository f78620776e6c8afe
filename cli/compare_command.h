// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// `meniscus compare`: two surfaces in, how far they are from each other out.
#pragma once

#include "compare_request.h"
#include "structure_run.h"

namespace meniscus::cli {

/// Adds `compare` to the program. Parsing runs it and stores how it ended.
void add_compare_command(CLI::App& program, Outcome& outcome);

/// Reads, compares and writes what is asked for.
/// throws   as run_surface
Outcome run_compare(const CompareRequest& request);

}  // namespace meniscus::cli

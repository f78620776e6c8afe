// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// `meniscus pockets`: a structure in, its pockets out.
#pragma once

#include "pockets_request.h"
#include "structure_run.h"

namespace meniscus::cli {

/// Adds `pockets` to the program. Parsing runs it and stores how it ended.
void add_pockets_command(CLI::App& program, Outcome& outcome);

/// Reads, finds pockets and writes what is asked for.
/// throws   as run_surface
Outcome run_pockets(const PocketsRequest& request);

}  // namespace meniscus::cli

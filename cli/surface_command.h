// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// `meniscus surface`: a structure in, its solvent-excluded surface out.
#pragma once

#include "structure_run.h"
#include "surface_request.h"

namespace meniscus::cli {

/// Adds `surface` to the program. Parsing runs it and stores how it ended.
void add_surface_command(CLI::App& program, Outcome& outcome);

/// Reads, computes and writes what is asked for.
/// throws   UsageError, InputError, OutputError, LimitError, Interrupted
Outcome run_surface(const SurfaceRequest& request);

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// `meniscus measure`: a structure in, its exact areas and volumes out.
#pragma once

#include "measure_request.h"
#include "structure_run.h"

namespace meniscus::cli {

/// Adds `measure` to the program. Parsing runs it and stores how it ended.
void add_measure_command(CLI::App& program, Outcome& outcome);

/// Reads, measures and writes what is asked for.
/// throws   as run_surface
Outcome run_measure(const MeasureRequest& request);

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// `meniscus batch`: many inputs, each computed by a process of its own.
#pragma once

#include "batch/request.h"
#include "structure_run.h"

namespace meniscus::cli {

/// Adds the subcommand; `outcome` is set when it has run.
void add_batch_command(CLI::App& program, Outcome& outcome);

/// Computes what is asked for, and collects the results of a batch that is not divided into shards.
/// throws   UsageError, InputError, OutputError, Interrupted; inputs that fail are recorded instead
Outcome run_batch(const batch::Request& request);

}  // namespace meniscus::cli

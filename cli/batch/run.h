// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The course of a batch: a process for every input, its files moved into place, what came of it recorded.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "batch/plan.h"
#include "batch/records.h"
#include "batch/request.h"

namespace meniscus::cli::batch {

struct RunResult {
    std::size_t inputs = 0;  ///< of this shard
    std::size_t done_before = 0;
    std::vector<nlohmann::ordered_json> failed;  ///< results without their reports, by name
    double seconds = 0.0;
};

/// Finds the inputs and what an earlier run has left of them, and does the rest.
/// throws   UsageError, InputError, OutputError, Interrupted; what was done until then is recorded
RunResult run(const Request& request, const Shard& shard, const Places& places);

}  // namespace meniscus::cli::batch

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a run of a batch has to do, in which order, and which part of it one of several shards does.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "batch/inputs.h"

namespace meniscus::cli::batch {

/// Part `index`, from 0, of `count`.
struct Shard {
    int index = 0;
    int count = 1;

    bool operator==(const Shard&) const = default;
};

/// "2/8".
/// throws   UsageError
Shard parse_shard(const std::string& text);

/// The shard of a task of a Slurm array, if this is one.
/// throws   UsageError for an array with gaps
std::optional<Shard> shard_of_array();

struct Task {
    Input input;
    std::string stem;          ///< of its outputs, a path below their folder
    std::uint64_t weight = 0;  ///< what it takes, in bytes of text
};

/// The tasks of one shard, largest first, so that no large one is left for the end. Shards are balanced by size; every
/// shard finds the same division by itself. O(n log n)
///
/// inputs   all, whatever the shard
std::vector<Task> plan(const std::vector<Input>& inputs, const Shard& shard);

/// A number for a list of inputs and their sizes; shards of one batch have the same.
std::string fingerprint(const std::vector<Input>& inputs);

}  // namespace meniscus::cli::batch

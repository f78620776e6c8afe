// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where the files that processes have written go: into a folder laid out as the inputs are, or into an archive.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "batch/plan.h"
#include "batch/read_files.h"
#include "batch/records.h"

namespace meniscus::cli::batch {

class OutputStore {
public:
    virtual ~OutputStore() = default;
    OutputStore(const OutputStore&) = delete;
    OutputStore& operator=(const OutputStore&) = delete;

    /// Takes all files of a folder as outputs of a task.
    /// result   their paths below the store, sorted
    /// throws   OutputError; UsageError for one in the place of a file that the batch reads
    virtual std::vector<std::string> take(const std::string& folder, const Task& task) = 0;

    /// Whether tasks must be taken in the order of the plan.
    virtual bool is_ordered() const = 0;

    /// Bytes that the store has, if it is one file.
    virtual std::int64_t size() const { return 0; }

    /// After the last task.
    virtual void finish() {}

protected:
    OutputStore() = default;
};

/// entries      what earlier runs have left
/// read_files   must outlive the store
std::unique_ptr<OutputStore> open_outputs(const Places& places, const std::map<std::string, Entry>& entries,
                                          const ReadFiles& read_files);

}  // namespace meniscus::cli::batch

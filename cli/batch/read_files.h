// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a batch reads and must not overwrite.
#pragma once

#include <sys/types.h>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "batch/plan.h"
#include "batch/records.h"
#include "batch/request.h"

namespace meniscus::cli::batch {

/// The inputs of a batch, its list, and the files that options of the subcommand name, under any of their names.
class ReadFiles {
public:
    /// cost   a look at every file
    ReadFiles(const Request& request, const std::vector<Input>& inputs);

    /// throws   UsageError if a path leads to one of them
    void refuse_as_output(const std::string& path) const;

private:
    void add(const std::string& path, const std::string& what);

    std::map<std::pair<dev_t, ino_t>, std::string> known_;  // what they are
};

/// Refuses before anything is written what would overwrite what is read, and a folder of inputs as that of outputs that
/// would be inputs the next time.
/// throws   UsageError
void check_outputs(const Request& request, const Places& places, const std::vector<Task>& tasks,
                   const ReadFiles& read_files);

}  // namespace meniscus::cli::batch

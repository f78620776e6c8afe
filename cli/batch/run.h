// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The course of a batch: a process for every input, its files moved into place, what came of it recorded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "batch/outputs.h"
#include "batch/plan.h"
#include "batch/process.h"
#include "batch/progress.h"
#include "batch/read_files.h"
#include "batch/records.h"
#include "batch/request.h"
#include "structure_run.h"

namespace meniscus::cli::batch {

struct RunResult {
    std::size_t inputs = 0;  ///< of this shard
    std::size_t done_before = 0;
    std::vector<nlohmann::ordered_json> failed;  ///< results without their reports, by name
    double seconds = 0.0;
};

class Run {
public:
    /// Finds the inputs and what an earlier run has left of them.
    /// request, places   must outlive the run
    /// throws   UsageError, InputError, OutputError
    Run(const Request& request, const Shard& shard, const Places& places);

    /// throws   UsageError, OutputError, Interrupted; what was done until then is recorded
    RunResult operator()();

private:
    /// A task under way, or one that has ended and is not recorded yet.
    struct Job {
        std::size_t turn;    // of open_
        std::string folder;  // of its own
        std::optional<Process> process;
        ProcessEnd end;
    };

    void compute_all();
    std::size_t running() const;
    void start(std::size_t turn);
    void wait() const;
    void look_at_processes();
    void keep_ended();
    void keep(const Job& job);
    void check_radii(const std::string& name, const Entry& entry);
    std::vector<std::string> words_of(const Task& task, const std::string& folder) const;
    RunResult sum_up();

    const Request& request_;
    const Shard shard_;
    const Places& places_;
    const FoundInputs found_;
    const ReadFiles read_files_;
    const nlohmann::ordered_json header_;
    const std::vector<Task> tasks_;  // of this shard
    Log log_;
    std::vector<const Task*> open_;  // those to be computed, in their turn
    std::unique_ptr<OutputStore> outputs_;
    std::vector<std::unique_ptr<Job>> jobs_;
    std::size_t next_to_start_ = 0;
    std::size_t next_to_keep_ = 0;              // where outputs are ordered
    std::map<std::string, std::string> radii_;  // set -> an input that has it
    std::size_t most_jobs_;
    int threads_;  // of each process
    std::optional<Progress> progress_;
    Stopwatch watch_;
};

}  // namespace meniscus::cli::batch

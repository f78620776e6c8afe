// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The course of every subcommand that takes structures one by one: read, compute, write, report, sum up.
#pragma once

#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common_request.h"
#include "meniscus/structure.h"
#include "output_plan.h"
#include "progress_report.h"
#include "report.h"

namespace meniscus::cli {

/// How a command ended that did not throw.
enum class Outcome {
    Done,
    ChecksFailed,  ///< outputs are written and marked, but a result failed its own checks
};

class Stopwatch {
public:
    Stopwatch() = default;

    /// One that has run since the program was started, before it was loaded.
    static Stopwatch of_program();

    /// Seconds since the stopwatch was made or last read.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
    }

private:
    explicit Stopwatch(std::chrono::steady_clock::time_point start) : start_(start) {}

    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A structure and the files that come of it.
struct Job {
    Structure structure;
    std::vector<Output> outputs;
    int model = 1;        ///< position in the file, or kJoinedModels
    std::string chain{};  ///< the only one, with --per-chain
};

/// One run; a subcommand fills in what is computed and written. compute() is called once per structure, then write()
/// for each of its files, then the others.
class StructureRun {
public:
    /// request   must outlive the run
    /// threads   asked for, 0 for all cores
    StructureRun(const CommonRequest& request, int threads)
        : request_(request), threads_(threads), progress_(resolve(request.progress, request.quiet), std::cerr) {}
    virtual ~StructureRun() = default;
    StructureRun(const StructureRun&) = delete;
    StructureRun& operator=(const StructureRun&) = delete;

    /// throws   UsageError, InputError, OutputError, LimitError, Interrupted
    Outcome operator()();

protected:
    /// The files of one structure, see plan_outputs().
    virtual std::vector<Output> plan(const std::string& name, const std::string& mark) const = 0;
    /// Beside the structure and the radii.
    virtual std::vector<ReadFile> files_read() const { return {}; }
    /// Refuses what can be refused before the first structure is computed; the jobs stay where they are.
    virtual void prepare(const std::vector<Job>& /*jobs*/) {}
    virtual void compute(const Job& job) = 0;
    virtual void write(const Output& output, const Job& job) const = 0;
    /// The file that tells of all structures together, written after the last; empty for none.
    virtual std::string file_of_all() const { return ""; }
    virtual void write_of_all() const {}
    virtual std::string summary_of_all() const { return ""; }
    /// What only the subcommand knows of the run.
    virtual RunFacts facts() const { return {}; }
    /// Which checks the result failed; empty if it passed them all.
    virtual std::string failed() const = 0;
    virtual nlohmann::ordered_json report(const Job& job, const RunFacts& facts) const = 0;
    virtual std::string summary(const Job& job, const RunFacts& facts) const = 0;

    bool shows_progress() const { return progress_.is_on(); }
    /// Processor time that the structure will take, to be shown with its progress, s.
    void expect(double seconds) { progress_.expect(seconds / threads_in_use(threads_)); }
    void warn(const std::string& line);
    /// Unless --quiet was given.
    void note(const std::string& line);
    void show(std::string_view stage, double fraction) { progress_.update(stage, fraction); }

private:
    void check(std::vector<std::string> paths) const;
    void check_asked_paths() const;
    void check_all_paths(const std::vector<Job>& jobs) const;
    std::vector<Job> read_structures() const;
    std::vector<Job> read_jobs() const;
    std::vector<Job> prepare_jobs();
    void run(const Job& job, double read_seconds);
    void write_outputs(const Job& job);
    void record(const Job& job, RunFacts facts);
    void finish();

    const CommonRequest& request_;
    int threads_;
    ProgressReport progress_;
    Stopwatch watch_ = Stopwatch::of_program();
    nlohmann::ordered_json reports_ = nlohmann::ordered_json::array();
    std::string summary_;
    Outcome outcome_ = Outcome::Done;
};

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <set>

#include "heap.h"
#include "interrupt.h"
#include "meniscus/threads.h"
#include "messages.h"
#include "standard_output.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

/// A process does not know when it was started, but the processor time that loading it took.
std::chrono::steady_clock::time_point find_program_start() {
    const std::chrono::duration<double> loading(static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
    return std::chrono::steady_clock::now() - std::chrono::duration_cast<std::chrono::steady_clock::duration>(loading);
}

const std::chrono::steady_clock::time_point kProgramStart = find_program_start();

/// The chains of every structure.
std::vector<Job> split_by_chain(const std::vector<Job>& jobs) {
    std::vector<Job> split;
    for (const Job& job : jobs)
        for (Structure& part : split_chains(job.structure)) {
            const std::string chain = part.residues.empty() ? "" : part.residues.front().chain;
            part.name += mark_of_chain(chain);
            split.push_back({std::move(part), {}, job.model, chain});
        }
    return split;
}

/// Each line once, although every model of a file repeats it.
void print_lines(const std::vector<Job>& jobs, std::vector<std::string> Structure::*lines,
                 void (*print_line)(std::ostream&, std::string_view)) {
    std::set<std::string> seen;
    for (const Job& job : jobs)
        for (const std::string& line : job.structure.*lines)
            if (seen.insert(line).second) print_line(std::cerr, input_label(job.structure.file) + ": " + line);
}

}  // namespace

Stopwatch Stopwatch::of_program() { return Stopwatch(kProgramStart); }

Outcome StructureRun::operator()() {
    const ThreadLimit limit(threads_);
    const std::vector<Job> jobs = prepare_jobs();
    prepare(jobs);
    double read_seconds = watch_.lap();
    for (const Job& job : jobs) run(job, std::exchange(read_seconds, 0.0));
    finish();
    return outcome_;
}

/// Reads the input; every output can be written.
std::vector<Job> StructureRun::prepare_jobs() {
    const WarmStart warm_start;
    check_asked_paths();
    progress_.update("read", 0.0);
    std::vector<Job> jobs = read_jobs();
    progress_.update("read", 1.0);
    check_all_paths(jobs);
    progress_.clear();
    if (!request_.quiet) print_lines(jobs, &Structure::notes, print_note);
    print_lines(jobs, &Structure::warnings, print_warning);
    return jobs;
}

void StructureRun::warn(const std::string& line) {
    progress_.clear();
    print_warning(std::cerr, line);
}

void StructureRun::note(const std::string& line) {
    if (request_.quiet) return;
    progress_.clear();
    print_note(std::cerr, line);
}

/// Whether all these and the report can be written.
void StructureRun::check(std::vector<std::string> paths) const {
    if (!request_.report.empty()) paths.push_back(request_.report);
    if (const std::string file = file_of_all(); !file.empty()) paths.push_back(file);
    std::vector<ReadFile> read = files_read();
    for (ReadFile& file : files_of_structure(request_.input, request_.read)) read.push_back(std::move(file));
    check_paths(paths, read);
}

/// Refuses what can be refused before the input is read.
void StructureRun::check_asked_paths() const {
    plan("", "");
    check(request_.outputs);
}

/// Every file of the run, once names of models and tables are known.
void StructureRun::check_all_paths(const std::vector<Job>& jobs) const {
    std::vector<std::string> paths;
    for (const Job& job : jobs)
        for (const Output& output : job.outputs) paths.push_back(output.path);
    check(std::move(paths));
}

/// The checksum is computed only if an output or the report contains it.
std::vector<Job> StructureRun::read_structures() const {
    const auto& outputs = request_.outputs;
    ReadOptions options = request_.read;
    options.checksum = !request_.report.empty() || std::any_of(outputs.begin(), outputs.end(), holds_structure);
    std::vector<Job> jobs;
    if (!request_.all_models) {
        const int model = options.join_models ? kJoinedModels : options.model;
        jobs.push_back({read_structure(request_.input, options), {}, model, ""});
    } else {
        for (Structure& structure : read_all_models(request_.input, options))
            jobs.push_back({std::move(structure), {}, static_cast<int>(jobs.size()) + 1, ""});
    }
    return jobs;
}

std::vector<Job> StructureRun::read_jobs() const {
    std::vector<Job> jobs = read_structures();
    if (request_.per_chain) jobs = split_by_chain(jobs);
    for (Job& job : jobs) {
        const std::string model = request_.all_models ? fmt::format("_m{:02}", job.model) : "";
        const std::string mark = model + (request_.per_chain ? mark_of_chain(job.chain) : "");
        job.outputs = plan(job.structure.name, mark);
    }
    return jobs;
}

void StructureRun::run(const Job& job, double read_seconds) {
    compute(job);
    const double computing = watch_.lap();
    write_outputs(job);
    RunFacts facts = this->facts();
    facts.model = job.model;
    facts.chain = job.chain;
    facts.threads = threads_in_use(threads_);
    facts.seconds.read = read_seconds;
    facts.seconds.write = watch_.lap();
    facts.seconds.total = facts.seconds.read + computing + facts.seconds.write;
    facts.peak_memory_mb = peak_memory_mb();
    progress_.clear();
    record(job, facts);
}

void StructureRun::write_outputs(const Job& job) {
    double done = 0.0;
    for (const Output& output : job.outputs) {
        progress_.update("write", done++ / static_cast<double>(job.outputs.size()));
        {
            const WritingSection section;
            write(output, job);
        }
        throw_if_interrupted();
    }
    progress_.update("write", 1.0);
}

/// Making a report takes time, which the report itself includes.
void StructureRun::record(const Job& job, RunFacts facts) {
    if (const std::string checks = failed(); !checks.empty()) {
        print_warning(std::cerr, fmt::format("{}: the result failed its checks: {}; outputs are written nevertheless",
                                             input_label(job.structure.file), checks));
        outcome_ = Outcome::ChecksFailed;
    }
    if (!request_.report.empty()) {
        ordered_json& made = reports_.emplace_back(report(job, facts));
        const double making = watch_.lap();
        facts.seconds.write += making;
        facts.seconds.total += making;
        made["time_s"]["write"] = facts.seconds.write;
        made["time_s"]["total"] = facts.seconds.total;
    }
    summary_ += summary(job, facts);
}

void StructureRun::finish() {
    {
        const WritingSection section;
        write_of_all();
    }
    throw_if_interrupted();
    if (!request_.report.empty()) {
        {
            const WritingSection section;
            write_report(request_.report, request_.all_models || request_.per_chain ? reports_ : reports_.front());
        }
        throw_if_interrupted();
    }
    print_summary(request_, summary_ + summary_of_all());
}

}  // namespace meniscus::cli

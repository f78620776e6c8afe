// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "interrupt.h"
#include "messages.h"
#include "output_plan.h"
#include "report.h"
#include "summary.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

class Stopwatch {
public:
    /// Seconds since the stopwatch was made or last read.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A structure and the files its surface goes to.
struct Job {
    Structure structure;
    std::vector<Output> outputs;
    int model = 1;
};

/// Refuses what can be refused before the input is read.
void check_asked_paths(const SurfaceRequest& request) {
    for (const std::string& path : request.outputs) kind_of(path);
    std::vector<std::string> paths = request.outputs;
    if (!request.report.empty()) paths.push_back(request.report);
    check_paths(paths, request.input);
}

/// Every file of the run, once names of models and tables are known.
void check_all_paths(const SurfaceRequest& request, const std::vector<Job>& jobs) {
    std::vector<std::string> paths;
    for (const Job& job : jobs)
        for (const Output& output : job.outputs) paths.push_back(output.path);
    if (!request.report.empty()) paths.push_back(request.report);
    check_paths(paths, request.input);
}

std::vector<Job> read_jobs(const SurfaceRequest& request) {
    std::vector<Job> jobs;
    if (!request.all_models) {
        jobs.push_back({read_structure(request.input, request.read), {}, request.read.model});
    } else {
        for (Structure& structure : read_all_models(request.input, request.read))
            jobs.push_back({std::move(structure), {}, static_cast<int>(jobs.size()) + 1});
    }
    for (Job& job : jobs) {
        const std::string mark = request.all_models ? fmt::format("_m{:02}", job.model) : "";
        job.outputs = plan_outputs(request.outputs, job.structure.name, mark);
    }
    return jobs;
}

/// Each warning once, although every model of a file repeats it.
void print_warnings(const std::vector<Job>& jobs) {
    std::set<std::string> seen;
    for (const Job& job : jobs)
        for (const std::string& warning : job.structure.warnings)
            if (seen.insert(warning).second) print_warning(std::cerr, input_label(job.structure.file) + ": " + warning);
}

void write_mesh_with_residues(const std::string& path, const SurfaceRequest& request, const Structure& structure,
                              const Mesh& mesh) {
    std::vector<std::uint32_t> residues(mesh.atoms.size());
    std::transform(mesh.atoms.begin(), mesh.atoms.end(), residues.begin(),
                   [&](std::uint32_t atom) { return structure.labels[atom].residue; });
    write_mesh(path, mesh, {.encoding = request.encoding, .extra = {{"residue", residues}}});
}

void write_output(const Output& output, const SurfaceRequest& request, const Structure& structure,
                  const Surface& surface) {
    switch (output.kind) {
        case OutputKind::Mesh:
            return write_mesh_with_residues(output.path, request, structure, surface.mesh);
        case OutputKind::Spheres:
            return write_spheres(output.path, structure);
        case OutputKind::AtomTable:
            return write_atom_table(output.path, structure);
    }
}

void write_outputs(const SurfaceRequest& request, const Job& job, const Surface& surface, ProgressReport& progress) {
    double done = 0.0;
    for (const Output& output : job.outputs) {
        progress.update("write", done++ / static_cast<double>(job.outputs.size()));
        {
            const WritingSection section;
            write_output(output, request, job.structure, surface);
        }
        throw_if_interrupted();
    }
    progress.update("write", 1.0);
}

void warn_if_failed(const Job& job, const Surface& surface) {
    if (surface.passed()) return;
    print_warning(std::cerr, fmt::format("{}: the result failed its checks: {}; outputs are written all the same",
                                         input_label(job.structure.file), failed_checks(surface)));
}

/// What is common to all structures of a run.
class Run {
public:
    explicit Run(const SurfaceRequest& request)
        : request_(request), progress_(resolve(request.progress, request.quiet), std::cerr) {}

    Outcome operator()() {
        check_asked_paths(request_);
        progress_.update("read", 0.0);
        const std::vector<Job> jobs = read_jobs(request_);
        progress_.update("read", 1.0);
        check_all_paths(request_, jobs);
        progress_.clear();
        print_warnings(jobs);
        read_seconds_ = watch_.lap();
        for (const Job& job : jobs) run(job);
        finish();
        return outcome_;
    }

private:
    void run(const Job& job) {
        const auto show = [this](std::string_view stage, double fraction) { progress_.update(stage, fraction); };
        const Surface surface = compute_surface(job.structure.atoms, request_.surface, show);
        const double computing = watch_.lap();
        write_outputs(request_, job, surface, progress_);
        RunFacts facts;
        facts.model = job.model;
        facts.threads = threads_in_use(request_.surface.threads);
        facts.read_seconds = std::exchange(read_seconds_, 0.0);
        facts.write_seconds = watch_.lap();
        facts.total_seconds = facts.read_seconds + computing + facts.write_seconds;
        facts.peak_memory_mb = peak_memory_mb();
        progress_.clear();
        record(job, surface, facts);
    }

    void record(const Job& job, const Surface& surface, const RunFacts& facts) {
        warn_if_failed(job, surface);
        if (!surface.passed()) outcome_ = Outcome::ChecksFailed;
        if (!request_.report.empty()) reports_.push_back(make_report(request_, job.structure, surface, facts));
        summary_ += make_summary(job.structure, surface, facts, job.outputs);
    }

    void finish() {
        if (!request_.report.empty()) {
            {
                const WritingSection section;
                write_report(request_.report, request_.all_models ? reports_ : reports_.front());
            }
            throw_if_interrupted();
        }
        if (request_.quiet || request_.report == "-") return;
        print(summary_);
    }

    const SurfaceRequest& request_;
    ProgressReport progress_;
    Stopwatch watch_;
    double read_seconds_ = 0.0;
    ordered_json reports_ = ordered_json::array();
    std::string summary_;
    Outcome outcome_ = Outcome::Done;
};

}  // namespace

void add_surface_command(CLI::App& program, Outcome& outcome) {
    CLI::App* command = program.add_subcommand("surface", "Solvent-excluded surface of a structure, as a mesh");
    const auto request = std::make_shared<SurfaceRequest>();
    add_surface_options(*command, *request);
    command->callback([request, &outcome] { outcome = run_surface(*request); });
}

Outcome run_surface(const SurfaceRequest& request) { return Run(request)(); }

}  // namespace meniscus::cli

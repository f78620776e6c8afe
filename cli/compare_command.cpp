// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_command.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "compare_report.h"
#include "heap.h"
#include "interrupt.h"
#include "meniscus/errors.h"
#include "meniscus/read_mesh.h"
#include "meniscus/threads.h"
#include "meniscus/write.h"
#include "messages.h"
#include "standard_output.h"

namespace meniscus::cli {

namespace {

class CompareRun {
public:
    explicit CompareRun(const CompareRequest& request)
        : request_(request), progress_(resolve(request.progress, request.quiet), std::cerr) {
        check_request(request);
    }

    Outcome operator()() {
        const ThreadLimit limit(request_.compare.threads);
        {
            const WarmStart warm_start;
            check_all_paths();
            read(request_.input, facts_.a);
            read(request_.second, facts_.b);
            print_messages();
        }
        facts_.read_seconds += watch_.lap();
        show("compare", 0.0);
        facts_.comparison = compare_surfaces(facts_.a.surface, facts_.b.surface, request_.compare);
        throw_if_interrupted();
        facts_.compare_seconds = watch_.lap();
        write_meshes();
        finish();
        return Outcome::Done;
    }

private:
    void show(const char* stage, double fraction) { progress_.update(stage, fraction); }

    void check_all_paths() const {
        std::vector<std::string> paths = request_.outputs;
        if (!request_.report.empty()) paths.push_back(request_.report);
        std::vector<ReadFile> read = files_of_structure(request_.input, request_.read);
        read.push_back({"the input", request_.second});
        check_paths(paths, read);
    }

    void read(const std::string& path, ComparedInput& input) {
        show("read", 0.0);
        input.file = path;
        if (is_mesh_file(path)) {
            input.surface = mesh_to_compare(read_mesh(path));
            if (input.surface.mesh.triangles.empty())
                throw InputError(path + ": has no triangles; there is nothing to compare");
            if (!(input.surface.area > 0.0))
                throw InputError(path + ": its triangles have no area; there is nothing to compare");
        } else {
            ReadOptions reading = request_.read;
            reading.checksum = false;  // nothing that is written contains it
            input.structure = read_structure(path, reading);
            show("surface", 0.0);
            StructureToCompare options = request_.structure;
            options.threads = request_.compare.threads;
            input.surface = structure_to_compare(input.structure->atoms, options);
        }
        throw_if_interrupted();
    }

    void print_messages() {
        progress_.clear();
        for (const ComparedInput* input : {&facts_.a, &facts_.b}) {
            const std::string file = input_label(input->file) + ": ";
            if (!request_.quiet)
                for (const std::string& note : notes_of(*input)) print_note(std::cerr, file + note);
            for (const std::string& warning : warnings_of(*input)) print_warning(std::cerr, file + warning);
        }
    }

    ValueRange range() const {
        if (request_.range) return *request_.range;
        const double reach = std::max(facts_.comparison.a_to_b.p99, 1e-3);
        return {-reach, reach};
    }

    void write_meshes() {
        Mesh& mesh = facts_.a.surface.mesh;
        mesh.values.push_back({"distance", facts_.comparison.distances});
        const std::vector<Colour> colours = colour_values(facts_.comparison.distances, range());
        const auto& structure = facts_.a.structure;
        for (const std::string& path : request_.outputs) {
            show("write", 0.0);
            {
                const WritingSection section;
                write_mesh(path, mesh,
                           {.colours = colours,
                            .structure = structure ? &*structure : nullptr,
                            .probe = structure ? std::optional(request_.structure.probe) : std::nullopt,
                            .threads = request_.compare.threads});
            }
            throw_if_interrupted();
        }
    }

    void finish() {
        facts_.range = range();
        facts_.threads = threads_in_use(request_.compare.threads);
        facts_.write_seconds = watch_.lap();
        facts_.peak_memory_mb = peak_memory_mb();
        progress_.clear();
        if (!request_.report.empty()) {
            const WritingSection section;
            write_report(request_.report, make_report(request_, facts_));
        }
        throw_if_interrupted();
        print_summary(request_, make_summary(request_, facts_));
    }

    const CompareRequest& request_;
    ProgressReport progress_;
    Stopwatch watch_ = Stopwatch::of_program();
    CompareFacts facts_;
};

}  // namespace

void add_compare_command(CLI::App& program, Outcome& outcome) {
    CLI::App* command = program.add_subcommand("compare", "How far two surfaces are from each other");
    const auto request = std::make_shared<CompareRequest>();
    add_compare_options(*command, *request);
    command->callback([request, &outcome] {
        resolve_standard_output(*request);
        outcome = run_compare(*request);
    });
}

Outcome run_compare(const CompareRequest& request) { return CompareRun(request)(); }

}  // namespace meniscus::cli

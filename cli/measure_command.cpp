// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure_command.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>

#include "measure_summary.h"
#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "standard_output.h"
#include "summary_text.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

/// Only tables and copies show depth, and those of interfaces do not.
bool needs_depth(const MeasureRequest& request) {
    if (std::find(request.values.begin(), request.values.end(), AtomValue::Depth) != request.values.end()) return true;
    return request.between.empty() && std::any_of(request.outputs.begin(), request.outputs.end(), [](const auto& path) {
               return measure_kind_of(path) == OutputKind::Table;
           });
}

/// How many files of the same kind come before one.
std::size_t place_among_its_kind(const std::vector<Output>& outputs, const Output& output) {
    std::size_t place = 0;
    for (const Output& other : outputs) {
        if (other == output) break;
        if (other.kind == output.kind) ++place;
    }
    return place;
}

class MeasureRun : public StructureRun {
public:
    explicit MeasureRun(const MeasureRequest& request)
        : StructureRun(request, request.measure.threads), request_(request), options_(request.measure) {
        check_request(request);
        options_.depth = needs_depth(request);
    }

private:
    std::vector<Output> plan(const std::string& /*name*/, const std::string& mark) const override {
        return plan_measure_outputs(request_.outputs, mark);
    }

    void compute(const Job& job) override {
        show("measure", 0.0);
        Stopwatch watch;
        exact_ = measure(job.structure.atoms, options_);
        if (!request_.between.empty()) measure_between(job.structure);
        exact_seconds_ = watch.lap();
        show("measure", 1.0);
    }

    void measure_between(const Structure& structure) {
        std::vector<ChainPair> pairs;
        for (const std::string& text : request_.between) {
            if (const std::string restated = restate_between(text); !restated.empty())
                note(fmt::format("--between {}: understood as {}", text, restated));
            if (const auto pair = parse_between(text))
                pairs.push_back(*pair);
            else
                pairs = touching_chains(structure, options_.probe);
        }
        try {
            interfaces_ = chain_interfaces(structure, pairs, options_, spell_as_option);
        } catch (const UsageError& error) {
            throw UsageError(std::string("--between: ") + error.what());
        }
        for (const ChainInterface& i : interfaces_) {
            exact_.agreed = exact_.agreed && i.areas.agreed;
            for (const std::string& name : i.areas.disputed)
                exact_.disputed.push_back(fmt::format("interface {}: {}", interface_name(i.chains), name));
        }
    }

    void write(const Output& output, const Job& job) const override {
        const std::size_t place = place_among_its_kind(job.outputs, output);
        if (output.kind == OutputKind::StructureCopy) {
            const AtomValue value = choice_at(request_.values, place, AtomValue::Sas);
            return write_structure_copy(output.path, job.structure, atom_values(job.structure, exact_, value));
        }
        const RowsPer per = choice_at(request_.per, place, RowsPer::Residue);
        write_table(output.path, request_.between.empty() ? measures_table(job.structure, exact_, per)
                                                          : interface_table(job.structure, interfaces_, per));
    }

    RunFacts facts() const override {
        RunFacts facts{.seconds = {.exact = exact_seconds_}, .checks = {agreement_check(exact_), sums_check(exact_)}};
        if (!request_.between.empty()) facts.interfaces = interfaces_;
        return facts;
    }

    std::string failed() const override {
        std::string list = disputed_patches(exact_.agreed, exact_.disputed);
        if (const Check sums = sums_check(exact_); !sums.passed)
            list += fmt::format("{}{} ({:g}, bound {:g})", list.empty() ? "" : ", ", sums.name, sums.value, sums.bound);
        return list;
    }

    ordered_json report(const Job& job, const RunFacts& facts) const override {
        return make_report(request_, job.structure, exact_, facts);
    }

    std::string summary(const Job& job, const RunFacts& facts) const override {
        std::string text = make_summary(job.structure, exact_, facts, job.outputs);
        if (!request_.between.empty()) text += summarise_interfaces(interfaces_);
        return text;
    }

    const MeasureRequest& request_;
    MeasureOptions options_;
    Measures exact_;
    double exact_seconds_ = 0.0;
    std::vector<ChainInterface> interfaces_;
};

}  // namespace

void add_measure_command(CLI::App& program, Outcome& outcome) {
    CLI::App* command = program.add_subcommand("measure", "Exact areas and volumes, cavities, interfaces");
    const auto request = std::make_shared<MeasureRequest>();
    add_measure_options(*command, *request);
    command->callback([request, &outcome] {
        resolve_standard_output(*request);
        outcome = run_measure(*request);
    });
}

Outcome run_measure(const MeasureRequest& request) { return MeasureRun(request)(); }

}  // namespace meniscus::cli

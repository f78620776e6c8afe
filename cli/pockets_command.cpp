// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets_command.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <memory>

#include "meniscus/describe_pockets.h"
#include "meniscus/volume_file.h"
#include "meniscus/write.h"
#include "messages.h"
#include "standard_output.h"
#include "summary_text.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

constexpr std::size_t kMostLining = 6;
constexpr std::size_t kMostUnranked = 10;  // without a place in the ranking

std::string residues_of(const DescribedPocket& pocket) {
    std::string text;
    for (std::size_t i = 0; i < std::min(pocket.residues.size(), kMostLining); ++i)
        text.append(text.empty() ? "" : ", ").append(one_line(pocket.residues[i]));
    if (pocket.residues.size() > kMostLining) text += fmt::format(" + {}", pocket.residues.size() - kMostLining);
    return text;
}

std::string row_of(const DescribedPocket& described) {
    const Pocket& p = described.pocket;
    return fmt::format("  {:>5} {:>8.2f} {:>6.2f} {:>10.1f} {:>9.1f} {:>8.1f} {:>7}  {}\n", p.rank, p.score,
                       p.probability, p.volume, p.wall_area, p.depth, p.cavity ? "cavity" : "", residues_of(described));
}

bool is_nucleotide(const Residue& residue) {
    constexpr std::array kNames{"A", "C", "G", "U", "DA", "DC", "DG", "DT"};
    return std::find(kNames.begin(), kNames.end(), residue.name) != kNames.end();
}

class PocketsRun : public StructureRun {
public:
    explicit PocketsRun(const PocketsRequest& request) : StructureRun(request, request.run.threads), request_(request) {}

private:
    std::vector<Output> plan(const std::string& /*name*/, const std::string& mark) const override {
        return plan_pockets_outputs(request_.outputs, mark);
    }

    void compute(const Job& job) override {
        say_what_the_ranking_was_not_fitted_to(job.structure);
        Stopwatch watch;
        RunOptions run = request_.run;
        run.progress = [this](std::string_view stage, double fraction) { show(stage, fraction); };
        const ExactSurface exact(job.structure.atoms, {SurfaceKind::Ses, request_.pockets.probe});
        pockets_ = find_pockets(exact, atom_classes(job.structure), request_.pockets, run);
        agreed_ = exact.measures().agreed;
        disputed_ = exact.measures().disputed;
        described_ = describe_pockets(pockets_, job.structure);
        seconds_ = watch.lap();
    }

    void say_what_the_ranking_was_not_fitted_to(const Structure& structure) {
        std::string what;
        if (structure.radii_set != "united") what = fmt::format("{} radii", structure.radii_set);
        const auto add = [&](const char* more) { what.append(what.empty() ? "" : " and ").append(more); };
        if (request_.read.hetero != HeteroPolicy::None) add("hetero atoms");
        if (request_.pockets.spacing != 1.0) add("another spacing");
        if (std::any_of(structure.residues.begin(), structure.residues.end(), is_nucleotide)) add("nucleic acids");
        if (!what.empty())
            note(fmt::format("the ranking was fitted to heavy atoms of proteins with united radii at 1 Å; with {} its "
                             "scores are less sure, volumes and areas are not concerned",
                             what));
    }

    void write(const Output& output, const Job& job) const override {
        if (output.kind == OutputKind::StructureCopy) return write_pocket_atoms(output.path, job.structure, pockets_);
        if (output.kind == OutputKind::Volume)
            return write_volume(output.path, pocket_volume(pockets_, request_.field), request_.field);
        if (output.kind == OutputKind::Arrays) return write_pocket_arrays(output.path, pockets_);
        write_table(output.path, pockets_table(described_));
    }

    RunFacts facts() const override {
        RunFacts facts{.seconds = {.exact = seconds_}, .checks = pocket_checks(pockets_)};
        facts.checks.insert(facts.checks.begin(), {"exact_agreement", agreed_, agreed_ ? 1.0 : 0.0, 1.0});
        return facts;
    }

    std::string failed() const override {
        std::string list = disputed_patches(agreed_, disputed_);
        for (const Check& check : pocket_checks(pockets_))
            if (!check.passed)
                list += fmt::format("{}{} ({:g}, bound {:g})", list.empty() ? "" : ", ", check.name, check.value, check.bound);
        return list;
    }

    ordered_json report(const Job& job, const RunFacts& facts) const override {
        return make_report(request_, job.structure, {pockets_, described_}, facts);
    }

    std::string summary(const Job& job, const RunFacts& facts) const override {
        std::string text = fmt::format("{}: {}, {}, probes {} and {} Å\n", one_line(input_label(job.structure.file)),
                                       counted(job.structure.atoms.size(), "atom", "atoms"),
                                       describe_radii(job.structure.radii_set), request_.pockets.probe,
                                       request_.pockets.large_probe);
        text += summary_line("pocket space", fmt::format("{:.2f} Å³, of which {:.2f} Å³ in no pocket", pockets_.volume,
                                                         pockets_.rest_volume));
        text += described_.empty() ? summary_line("pockets", "none")
                                   : fmt::format("  {:>5} {:>8} {:>6} {:>10} {:>9} {:>8} {:>7}  lined by\n", "rank",
                                                 "score", "prob.", "volume/Å³", "wall/Å²", "depth/Å", "");
        std::size_t cavities = 0;
        for (const DescribedPocket& pocket : described_) {
            const bool ranked = pocket.pocket.score > 0.0;
            if (ranked || cavities++ < kMostUnranked) text += row_of(pocket);
        }
        if (cavities > kMostUnranked)
            text += fmt::format("        and {} smaller cavities; list all with -o FILE.csv\n", cavities - kMostUnranked);
        text += describe_checks(facts.checks);
        return text + describe_run(facts) + describe_files(job.outputs);
    }

    const PocketsRequest& request_;
    Pockets pockets_;
    std::vector<DescribedPocket> described_;
    bool agreed_ = true;
    std::vector<std::string> disputed_;
    double seconds_ = 0.0;
};

}  // namespace

void add_pockets_command(CLI::App& program, Outcome& outcome) {
    CLI::App* command = program.add_subcommand("pockets", "Pockets and cavities, ranked and measured");
    const auto request = std::make_shared<PocketsRequest>();
    add_pockets_options(*command, *request);
    command->callback([request, &outcome] {
        resolve_standard_output(*request);
        outcome = run_pockets(*request);
    });
}

Outcome run_pockets(const PocketsRequest& request) { return PocketsRun(request)(); }

}  // namespace meniscus::cli

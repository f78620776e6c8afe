// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets_command.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "meniscus/describe_pockets.h"
#include "meniscus/draw_pockets.h"
#include "meniscus/volume_file.h"
#include "meniscus/write.h"
#include "messages.h"
#include "platform/files/atomic_file.h"
#include "pockets_places.h"
#include "standard_output.h"
#include "summary_text.h"
#include "volume_options.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

constexpr std::size_t kMostLining = 6;
constexpr std::size_t kMostUnranked = 10;  // without a place in the ranking
constexpr std::size_t kMostTracks = 10;

std::string first_residues(const std::vector<std::string>& residues) {
    std::string text;
    for (std::size_t i = 0; i < std::min(residues.size(), kMostLining); ++i)
        text.append(text.empty() ? "" : ", ").append(one_line(residues[i]));
    if (residues.size() > kMostLining) text += fmt::format(" + {}", residues.size() - kMostLining);
    return text;
}

bool has_kind(const std::vector<Output>& outputs, OutputKind kind) {
    return std::any_of(outputs.begin(), outputs.end(), [kind](const Output& output) { return output.kind == kind; });
}

void write_text(const std::string& path, const std::string& text) {
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

// What only a given place has.
std::string place_lines(const DescribedPocket& described) {
    if (described.at.empty()) return "";
    const Pocket& p = described.pocket;
    std::string text = fmt::format("        at {}", one_line(described.at));
    text +=
        p.site == 0 ? ", which no site of the ranking is near" : fmt::format(", near site {} of the ranking", p.site);
    if (described.ligand) {
        const LigandFit& ligand = *described.ligand;
        text += fmt::format("; {} of {} atoms inside, {:.0f} % of {:.1f} Å² buried", ligand.inside, ligand.atoms,
                            100.0 * ligand.buried_area / std::max(ligand.area, 1e-9), ligand.area);
    }
    return text + "\n";
}

// Scores may be a thousand times smaller in one structure than in another.
std::string score_text(double score) {
    return score > 0.0 && score < 0.1 ? fmt::format("{:.1g}", score) : fmt::format("{:.2f}", score);
}

std::string row_of(const DescribedPocket& described) {
    const Pocket& p = described.pocket;
    return fmt::format("  {:>5} {:>8} {:>6.2f} {:>10.1f} {:>9.1f} {:>8.1f} {:>7}  {}\n", p.rank, score_text(p.score),
                       p.probability, p.volume, p.wall_area, p.depth, p.cavity ? "cavity" : "",
                       first_residues(described.residues)) +
           place_lines(described);
}

std::string spread_text(const Spread& spread) {
    if (spread.values == 0) return "";
    if (spread.values == 1) return fmt::format("{:.1f}", spread.mean);
    return fmt::format("{:.1f} ± {:.1f}", spread.mean, spread.deviation);
}

// Files of spheres have no radii but their own.
bool has_only_spheres(const std::string& input) {
    const auto ends_with = [&](std::string_view suffix) { return input.ends_with(suffix); };
    return ends_with(".xyzr") || ends_with(".xyzrn") || ends_with(".xyzr.gz") || ends_with(".xyzrn.gz");
}

// Options that change nothing are mistakes.
void refuse_without_effect(const CLI::App& command, const PocketsRequest& request) {
    const bool has_map = std::any_of(request.outputs.begin(), request.outputs.end(), [](const std::string& path) {
        return plan_pockets_outputs({path}, "").front().kind == OutputKind::Volume;
    });
    const auto refuse = [&](const char* option, bool has_effect, const char* remedy) {
        if (command.count(option) > 0 && !has_effect)
            throw UsageError(fmt::format("{} has no effect {}", option, remedy));
    };
    for (const char* option : {"--tunnel-radius", "--tunnel-count"})
        refuse(option, request.tunnels.wants_tunnels(), "without --tunnels or --tunnels-from");
    refuse("--at-reach", !request.at.empty(), "without --at");
    refuse("--rank", request.at.empty(), "with --at, whose places keep their order");
    refuse("--field", has_map, "without a map; ask for one with -o FILE.dx or FILE.mrc");
}

class PocketsRun : public StructureRun {
public:
    explicit PocketsRun(const PocketsRequest& request) : StructureRun(request, request.run.threads), request_(request) {
        const PocketOptions& options = request.pockets;
        if (options.large_probe <= options.probe || options.large_probe > kMostLargeProbe)
            throw UsageError(fmt::format("--large-probe {}: must be larger than the probe, {} Å, and at most {} Å",
                                         options.large_probe, options.probe, kMostLargeProbe));
        if (options.spacing < kLeastPocketSpacing || options.spacing > kMostPocketSpacing)
            throw UsageError(fmt::format("--spacing {}: must be from {} to {} Å for pockets", options.spacing,
                                         kLeastPocketSpacing, kMostPocketSpacing));
        if (!request.over_models.empty() && !request.all_models)
            throw UsageError("--over-models: compares models; add --model all");
        check_picture(request.picture);
    }

private:
    std::vector<Output> plan(const std::string& /*name*/, const std::string& mark) const override {
        std::vector<Output> outputs = plan_pockets_outputs(request_.outputs, mark);
        if (!request_.tunnels.table.empty()) outputs.push_back(plan_tunnel_table(request_.tunnels.table, mark));
        check_drawn(request_.picture, outputs);
        for (const Output& output : outputs) check_vdb(output.path);
        return outputs;
    }

    /// Selections are looked up in all models first, so that nothing is written where one of them has no such atoms.
    void prepare(const std::vector<Job>& jobs) override {
        std::set<std::string> said;
        for (const Job& job : jobs) {
            try {
                places_[&job] = read_places(request_, job.structure, job.model);
                check_starts(request_.tunnels, job.structure);
            } catch (const UsageError& error) {
                if (jobs.size() == 1) throw;
                throw UsageError(fmt::format("{} (in {})", error.what(), one_line(job.structure.name)));
            }
            for (const std::string& line : places_[&job].warnings)
                if (said.insert(line).second) warn(input_label(job.structure.file) + ": --at: " + line);
        }
    }

    void compute(const Job& job) override {
        const std::string doubt = doubt_of_ranking(job.structure, request_.pockets.spacing);
        if (!doubt.empty() && doubt != said_) note(doubt);
        said_ = doubt;
        Stopwatch watch;
        RunOptions run = request_.run;
        run.progress = [this](std::string_view stage, double fraction) { show(stage, fraction); };
        const PlacesOfRun& at = places_.at(&job);
        PocketOptions options = request_.pockets;
        for (const NamedPlace& place : at.places) options.places.push_back(place.place);
        const ExactSurface exact(job.structure.atoms, {SurfaceKind::Ses, options.probe});
        pockets_ = find_pockets(exact, atom_classes(job.structure), options, run);
        agreed_ = exact.measures().agreed;
        disputed_ = exact.measures().disputed;
        described_ = describe_pockets(pockets_, job.structure, at.places);
        say_which_places_are_empty(job);
        seconds_ = watch.lap();
        ways_ = find_asked_tunnels(request_.tunnels, exact, pockets_, job.structure, run);
        for (const std::string& line : ways_.notes) note(input_label(job.structure.file) + ": " + line);
        if (request_.all_models) follow(job.structure);
        std::erase_if(described_, is_empty_place);
        tunnel_seconds_ = watch.lap();
        draw(job, exact, run);
        seconds_ += watch.lap();
    }

    /// What is seen: a surface with pockets, and bodies alone for meshes without a surface.
    void draw(const Job& job, const ExactSurface& exact, const RunOptions& run) {
        const auto needs_surface = [](const Output& output) {
            return suffix_of(output.path) == ".glb" || output.kind == OutputKind::Picture ||
                   output.kind == OutputKind::Page;
        };
        drawn_.reset();
        if (std::none_of(job.outputs.begin(), job.outputs.end(), needs_surface)) return;
        drawn_.emplace(exact, pockets_, job.structure, drawable(ways_), run);
        if (has_kind(job.outputs, OutputKind::Picture)) {
            show("picture", 0.0);
            picture_ = drawn_->picture(job.structure, drawing());
            show("picture", 1.0);
        }
        if (has_kind(job.outputs, OutputKind::Page)) {
            show("page", 0.0);
            page_ = drawn_->page(job.structure, described_, drawing());
            show("page", 1.0);
        }
    }

    DrawPocketsOptions drawing() const {
        const PictureRequest& asked = request_.picture;
        return {asked.picture, asked.legend, asked.ligands, request_.run.threads};
    }

    static bool is_empty_place(const DescribedPocket& pocket) {
        return !pocket.at.empty() && pocket.pocket.voxels.empty() && !pocket.pocket.cavity;
    }

    void say_which_places_are_empty(const Job& job) {
        for (const DescribedPocket& pocket : described_)
            if (is_empty_place(pocket))
                note(fmt::format("{}: --at: there is no pocket space at {}{}", input_label(job.structure.file),
                                 one_line(pocket.at),
                                 described_.size() > 1 ? " that is not as near to another place" : ""));
    }

    void follow(const Structure& structure) {
        std::vector<double> bottlenecks(pockets_.pockets.size());
        if (ways_.tunnels)
            for (const DescribedTunnel& tunnel : *ways_.tunnels)
                if (tunnel.pocket) {
                    double& widest = bottlenecks[*tunnel.pocket - 1];
                    widest = std::max(widest, tunnel.way.path.bottleneck.radius);
                }
        const std::vector<std::size_t> tracks = followed_.add(pockets_, structure, bottlenecks);
        for (std::size_t i = 0; i < tracks.size(); ++i) described_[i].track = tracks[i];
    }

    std::string file_of_all() const override { return request_.over_models; }

    void write_of_all() const override {
        if (!request_.over_models.empty())
            write_table(request_.over_models,
                        tracks_table(followed_.described(), followed_.models(), request_.tunnels.wants_tunnels()));
    }

    std::string summary_of_all() const override {
        if (!request_.all_models) return "";
        const bool has_ways = request_.tunnels.wants_tunnels();
        std::string text = fmt::format("over {}:\n  {:>5} {:>7} {:>5} {:>8} {:>16} {:>14}  lined by\n",
                                       counted(followed_.models(), "model", "models"), "track", "models", "open",
                                       "score", "volume/Å³", has_ways ? "bottleneck/Å" : "mouth/Å");
        std::size_t rows = 0;
        const std::vector<DescribedTrack> tracks = followed_.described();
        for (const DescribedTrack& d : tracks) {
            if (rows++ == kMostTracks) break;
            text += fmt::format("  {:>5} {:>7} {:>5} {:>8} {:>16} {:>14}  {}\n", d.number, d.track.models, d.track.open,
                                score_text(d.track.score.mean), spread_text(d.track.volume),
                                spread_text(has_ways ? d.track.bottleneck : d.track.mouth_radius),
                                first_residues(d.residues));
        }
        if (tracks.size() > kMostTracks)
            text +=
                fmt::format("        and {} more; list all with --over-models FILE.csv\n", tracks.size() - kMostTracks);
        return text;
    }

    void write(const Output& output, const Job& job) const override {
        if (output.kind == OutputKind::StructureCopy)
            return write_pocket_atoms(output.path, job.structure, pockets_, paths_of(ways_));
        if (output.kind == OutputKind::Picture) return write_picture(output.path, picture_);
        if (output.kind == OutputKind::Page) return write_text(output.path, page_);
        if (suffix_of(output.path) == ".glb") return drawn_->write_glb(output.path, job.structure, drawing());
        if (output.kind == OutputKind::Mesh) return write_mesh(output.path, pocket_bodies(pockets_));
        if (output.kind == OutputKind::Volume)
            return write_volume(output.path, pocket_volume(pockets_, request_.field), request_.field);
        if (output.kind == OutputKind::TunnelTable) return write_table(output.path, profile_of(ways_));
        if (output.kind == OutputKind::Arrays) return write_pocket_arrays(output.path, pockets_);
        write_table(output.path, pockets_table(described_));
    }

    RunFacts facts() const override {
        RunFacts facts{.seconds = {.exact = seconds_, .tunnels = tunnel_seconds_}, .checks = pocket_checks(pockets_)};
        facts.checks.insert(facts.checks.begin(), {"exact_agreement", agreed_, agreed_ ? 1.0 : 0.0, 1.0});
        return facts;
    }

    std::string failed() const override {
        std::string list = disputed_patches(agreed_, disputed_);
        for (const Check& check : pocket_checks(pockets_))
            if (!check.passed)
                list += fmt::format("{}{} ({:g}, bound {:g})", list.empty() ? "" : ", ", check.name, check.value,
                                    check.bound);
        return list;
    }

    ordered_json report(const Job& job, const RunFacts& facts) const override {
        return make_report(request_, job.structure, {pockets_, described_, ways_}, facts);
    }

    std::string summary(const Job& job, const RunFacts& facts) const override {
        std::string text =
            fmt::format("{}: {}, {}, probes {} and {} Å\n", one_line(input_label(job.structure.file)),
                        counted(job.structure.atoms.size(), "atom", "atoms"), describe_radii(job.structure.radii_set),
                        request_.pockets.probe, request_.pockets.large_probe);
        text += summary_line("pocket space",
                             fmt::format("{:.2f} Å³, of which {:.2f} Å³ in no pocket", std::max(0.0, pockets_.volume),
                                         std::max(0.0, pockets_.rest_volume)));
        text += described_.empty() ? summary_line("pockets", "none")
                                   : fmt::format("  {:>5} {:>8} {:>6} {:>10} {:>9} {:>8} {:>7}  lined by\n", "rank",
                                                 "score", "prob.", "volume/Å³", "wall/Å²", "depth/Å", "");
        std::size_t cavities = 0;
        for (const DescribedPocket& pocket : described_) {
            const bool ranked = pocket.pocket.score > 0.0 || !pocket.at.empty();
            if (ranked || cavities++ < kMostUnranked) text += row_of(pocket);
        }
        if (cavities > kMostUnranked)
            text +=
                fmt::format("        and {} smaller cavities; list all with -o FILE.csv\n", cavities - kMostUnranked);
        text += describe_tunnels(request_.tunnels, ways_);
        text += describe_checks(facts.checks);
        return text + describe_run(facts) + describe_files(job.outputs);
    }

    const PocketsRequest& request_;
    Pockets pockets_;
    std::vector<DescribedPocket> described_;
    FollowedPockets followed_;
    std::map<const Job*, PlacesOfRun> places_;
    std::string said_;  // of the ranking, once for all models
    FoundTunnels ways_;
    std::optional<DrawnPockets> drawn_;
    Picture picture_;
    std::string page_;  // HTML
    bool agreed_ = true;
    std::vector<std::string> disputed_;
    double seconds_ = 0.0;
    double tunnel_seconds_ = 0.0;
};

}  // namespace

void add_pockets_command(CLI::App& program, Outcome& outcome) {
    CLI::App* command = program.add_subcommand("pockets", "Pockets and cavities, ranked and measured");
    const auto request = std::make_shared<PocketsRequest>();
    add_pockets_options(*command, *request);
    command->callback([command, request, &outcome] {
        refuse_without_effect(*command, *request);
        if (command->count("--radii") == 0 && has_only_spheres(request->input)) request->read.radii = "auto";
        resolve_standard_output(*request);
        check_tunnels(request->tunnels);
        outcome = run_pockets(*request);
    });
}

Outcome run_pockets(const PocketsRequest& request) { return PocketsRun(request)(); }

}  // namespace meniscus::cli

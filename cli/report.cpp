// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "exact_blocks.h"
#include "io/options_json.h"
#include "meniscus/errors.h"
#include "meniscus/file_name.h"
#include "meniscus/file_words.h"
#include "meniscus/version.h"
#include "output_plan.h"
#include "platform/files/atomic_file.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

/// `value`, or null where the option has no effect or was not given.
template <class T>
ordered_json if_used(bool used, const T& value) {
    return used ? ordered_json(value) : ordered_json();
}

ordered_json model_json(int model) { return model == kJoinedModels ? ordered_json("join") : ordered_json(model); }

ordered_json input_block(const Structure& structure, double probe, const RunFacts& facts) {
    return {{"file", file_name(structure.file)},
            {"sha256", structure.sha256},
            {"model", model_json(facts.model)},
            {"chain", if_used(!facts.chain.empty(), facts.chain)},
            {"atoms", structure.atoms.size()},
            {"residues", structure.residues.size()},
            {"radii", file_name(structure.radii_set)},
            {"probe", probe},
            {"dropped", structure.dropped},
            {"notes", structure.notes},
            {"warnings", structure.warnings}};
}

bool has(const std::vector<std::string>& outputs, OutputKind kind) {
    return std::any_of(outputs.begin(), outputs.end(),
                       [kind](const std::string& path) { return kind_of(path) == kind; });
}

ordered_json surface_options_block(const SurfaceRequest& request, const Structure& structure, const Surface& surface,
                                   const RunFacts& facts) {
    ordered_json block = options_block(surface.options);
    OptionsAsJson more{surface.options};
    describe_checks(surface.options, more);
    describe(request.run, more);
    block.update(more.block);
    block["threads"] = facts.threads;
    block["exact"] = surface.options.exact;
    block["cavity_files"] = request.cavity_files;
    block["show"] = if_used(!request.show.empty(), request.show);
    block["per_chain"] = request.per_chain;
    block.update(report_picture(request.picture, structure, surface.mesh, has(request.outputs, OutputKind::Picture)));
    block.update(report_volumes(request.volume, has(request.outputs, OutputKind::Volume)));
    block.update(report_values(request.values));
    return block;
}

ordered_json measure_options_block(const MeasureRequest& request, const RunFacts& facts) {
    ordered_json per = ordered_json::array();
    for (const RowsPer rows : request.per) per.push_back(word_for(kRowsPerWords, rows));
    ordered_json values = ordered_json::array();
    for (const AtomValue value : request.values) values.push_back(word_for(kAtomValueWords, value));
    return {{"probe", request.measure.probe},
            {"per", per},
            {"value", values},
            {"between", if_used(!request.between.empty(), request.between)},
            {"threads", facts.threads}};
}

/// Completes the options of a subcommand by those of reading.
ordered_json with_reading(ordered_json block, const CommonRequest& request) {
    const ReadOptions& o = request.read;
    block["radii"] = file_name(o.radii);
    block["hydrogens"] = word_for(kHydrogenWords, o.hydrogens);
    block["model"] = request.all_models ? ordered_json("all") : model_json(o.join_models ? kJoinedModels : o.model);
    block["assembly"] = if_used(!o.assembly.empty(), o.assembly);
    block["altloc"] = if_used(!o.altloc.empty(), o.altloc);
    block["chains"] = if_used(!o.chains.empty(), o.chains);
    block["select"] = if_used(!o.select.empty(), o.select);
    block["hetero"] = word_for(kHeteroWords, o.hetero.value_or(HeteroPolicy::None));
    block["waters"] = o.keep_waters.value_or(false);
    block["strict_radii"] = o.strict_radii;
    return block;
}

/// How far a value is from the exact one, relative to that; nan where there is nothing.
double deviation(double value, double exact) { return (value - exact) / std::abs(exact); }

ordered_json percentiles_json(const Percentiles& p) {
    return {{"min", p.min}, {"p5", p.p5}, {"p50", p.p50}, {"p95", p.p95}, {"max", p.max}};
}

ordered_json quality_json(const Surface& surface) {
    const std::optional<MeshQuality>& quality = surface.quality;
    if (!quality) return nullptr;
    const std::optional<std::size_t>& verified = surface.self_intersections;
    return {{"angle_histogram", quality->angles},
            {"smallest_angles_deg", percentiles_json(quality->smallest_angles)},
            {"edges", percentiles_json(quality->edges)},
            {"aspect_ratios", percentiles_json(quality->aspect_ratios)},
            {"self_intersections", if_used(verified.has_value(), verified.value_or(0))}};
}

ordered_json two_sided_json(const std::optional<TwoSidedDistance>& distance) {
    if (!distance) return nullptr;
    const auto one_way = [](const DistanceSummary& d) {
        return ordered_json{{"mean", d.mean}, {"p99", d.p99}, {"max", d.max}};
    };
    return {{"to_exact", one_way(distance->to_exact)}, {"from_exact", one_way(distance->from_exact)}};
}

ordered_json shown_json(const std::optional<ShownPart>& shown) {
    if (!shown) return nullptr;
    return {{"select", shown->select},
            {"vertices", shown->vertices},
            {"triangles", shown->triangles},
            {"area", shown->area},
            {"open", shown->open}};
}

/// What the numbers of the mesh are compared with: nan without exact measures.
SurfaceTotals exact_of_mesh(const Surface& surface) {
    if (surface.measured) return exact_counterpart(*surface.measured, surface.options);
    SurfaceTotals none;
    none.ses_area = none.ses_volume = std::numeric_limits<double>::quiet_NaN();
    return none;
}

ordered_json mesh_block(const Surface& surface, const std::optional<ShownPart>& shown) {
    const MeshMeasures& m = surface.measures;
    const SurfaceTotals exact = exact_of_mesh(surface);
    return {{"vertices", surface.mesh.vertices.size()},
            {"triangles", surface.mesh.triangles.size()},
            {"area", m.area},
            {"volume", m.volume},
            {"corrected_area", surface.corrected_area},
            {"corrected_volume", surface.corrected_volume},
            {"area_deviation", deviation(m.area, exact.ses_area)},
            {"volume_deviation", deviation(m.volume, exact.ses_volume)},
            {"corrected_area_deviation", deviation(surface.corrected_area, exact.ses_area)},
            {"corrected_volume_deviation", deviation(surface.corrected_volume, exact.ses_volume)},
            {"closed", m.closed && !(shown && shown->open)},
            {"manifold", m.manifold},
            {"components", m.components.size()},
            {"euler_characteristic", m.euler_characteristic},
            {"dropped", {{"cavities", surface.dropped.cavities}, {"islands", surface.dropped.islands}}},
            {"filled",
             {{"cavities", surface.filled.cavities},
              {"islands", surface.filled.islands},
              {"volume", surface.filled.volume}}},
            {"simplified", {{"handles", surface.simplified.handles}, {"pieces", surface.simplified.pieces}}},
            {"mean_distance", surface.distance.mean},
            {"p99_distance", surface.distance.p99},
            {"max_distance", surface.distance.max},
            {"smallest_triangle_angle_deg", m.smallest_angle_deg},
            {"quality", quality_json(surface)},
            {"shown", shown_json(shown)},
            {"two_sided_distance", two_sided_json(surface.two_sided)}};
}

ordered_json history_block(const std::vector<FlowStep>& history) {
    ordered_json list = ordered_json::array();
    for (const FlowStep& s : history)
        list.push_back({{"step", s.step},
                        {"time", s.time},
                        {"area", s.area},
                        {"volume", s.volume},
                        {"mean_distance", s.mean_distance},
                        {"max_distance", s.max_distance},
                        {"residual", s.residual},
                        {"solver_iterations", s.solver_iterations},
                        {"components", s.components},
                        {"genus", s.genus}});
    return list;
}

ordered_json flow_block(const Surface& surface) {
    if (surface.options.method != Method::Flow) return nullptr;
    const FlowSummary& f = surface.flow;
    return {{"steps", f.steps},
            {"time", f.time},
            {"converged", f.converged},
            {"residual", f.residual},
            {"mean_distance", f.mean_distance},
            {"max_distance", f.max_distance},
            {"solver_iterations", f.solver_iterations},
            {"initial_area", f.initial_area},
            {"reinitialisations", f.reinitialisations},
            {"end", word_for(kFlowEndWords, f.end)},
            {"kept_step", f.kept_step},
            {"explanation", f.explanation},
            {"history", history_block(surface.history)}};
}

ordered_json checks_block(const std::vector<Check>& checks) {
    ordered_json list = ordered_json::array();
    for (const Check& c : checks)
        list.push_back({{"name", c.name}, {"passed", c.passed}, {"value", c.value}, {"bound", c.bound}});
    return list;
}

ordered_json expected_block(const Cost& cost) {
    return {{"vertices", std::round(cost.vertices)}, {"memory_mb", cost.memory_mb}, {"cpu_s", cost.seconds}};
}

ordered_json time_block(const StageTimes& s, const RunFacts& facts) {
    return {{"total", facts.seconds.total},
            {"read", facts.seconds.read},
            {"estimate", s.estimate},
            {"geometry", s.geometry},
            {"band", s.band},
            {"flow", s.flow},
            {"mesh", s.mesh},
            {"exact", facts.seconds.exact + s.exact},
            {"picture", facts.seconds.picture},
            {"page", facts.seconds.page},
            {"volume", facts.seconds.volume},
            {"write", facts.seconds.write}};
}

}  // namespace

ordered_json make_report(const SurfaceRequest& request, const Structure& structure, const Surface& surface,
                         const RunFacts& facts) {
    const std::shared_ptr<const Measures>& exact = surface.measured;
    return {{"meniscus", kVersion},
            {"schema", 1},
            {"input", input_block(structure, surface.options.probe, facts)},
            {"options", with_reading(surface_options_block(request, structure, surface, facts), request)},
            {"exact", exact ? exact_json(*exact) : ordered_json()},
            {"components", exact ? components_json(*exact) : ordered_json()},
            {"mesh", mesh_block(surface, facts.shown)},
            {"flow", flow_block(surface)},
            {"checks", checks_block(facts.checks)},
            {"expected", expected_block(surface.expected)},
            {"time_s", time_block(surface.seconds, facts)},
            {"peak_memory_mb", facts.peak_memory_mb}};
}

ordered_json make_report(const MeasureRequest& request, const Structure& structure, const Measures& exact,
                         const RunFacts& facts) {
    return {{"meniscus", kVersion},
            {"schema", 1},
            {"input", input_block(structure, exact.options.probe, facts)},
            {"options", with_reading(measure_options_block(request, facts), request)},
            {"exact", exact_json(exact)},
            {"components", components_json(exact)},
            {"interfaces", nullptr},
            {"mesh", nullptr},
            {"flow", nullptr},
            {"checks", checks_block(facts.checks)},
            {"time_s", time_block({}, facts)},
            {"peak_memory_mb", facts.peak_memory_mb}};
}

void write_report(const std::string& path, const ordered_json& report) {
    const std::string text = report.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
    if (path == "-") return print(text);
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

void print(const std::string& text) {
    std::cout << text << std::flush;
    if (!std::cout) throw OutputError("standard output: cannot be written");
}

int threads_in_use(int asked) {
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return asked > 0 ? std::min(asked, cores) : cores;
}

// What getrusage calls the largest size begins with that of the program that started this one.
double peak_memory_mb() {
    std::ifstream status("/proc/self/status");
    double kilobytes = 0.0;
    for (std::string key; status >> key; status.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
        if (key == "VmHWM:" && status >> kilobytes) return kilobytes / 1024.0;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace meniscus::cli

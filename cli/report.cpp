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
#include <variant>

#include "io/describe_structure.h"
#include "io/options_json.h"
#include "json_schema.h"
#include "meniscus/errors.h"
#include "meniscus/file_name.h"
#include "meniscus/file_words.h"
#include "meniscus/version.h"
#include "output_plan.h"
#include "platform/files/atomic_file.h"

namespace meniscus::cli {

namespace {

/// `value`, or null where the option has no effect or was not given.
template <class T>
ordered_json if_used(bool used, const T& value) {
    return used ? ordered_json(value) : ordered_json();
}

ordered_json model_json(int model) { return model == kJoinedModels ? ordered_json("join") : ordered_json(model); }

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

/// What a report is made of.
struct Report {
    const Structure& structure;
    double probe = 0.0;
    ordered_json options{};
    const Measures* exact = nullptr;   ///< none with --no-exact
    const Surface* surface = nullptr;  ///< none in reports of measure
    const RunFacts& facts;
};

using ModelPosition = std::variant<int, const char*>;

template <class Visitor>
void describe_input(const Structure& s, double probe, const RunFacts& facts, Visitor& visit) {
    describe_file(s, visit);
    visit({"model", "", "position of the model in the file, from 1; the word `join` if all were put together"},
          facts.model == kJoinedModels ? ModelPosition("join") : ModelPosition(facts.model));
    visit({"chain", "", "the chain, with `--per-chain`; `null` without it"},
          facts.chain.empty() ? std::optional<std::string>() : facts.chain);
    describe_kept(s, probe, visit);
}

template <class Visitor>
void describe_shown(const ShownPart& part, Visitor& visit) {
    visit({"select", "", "the selection"}, part.select);
    visit({"vertices", "", "number of its vertices"}, part.vertices);
    visit({"triangles", "", "number of its triangles"}, part.triangles);
    visit({"area", "Å²", "plain sum over them"}, part.area);
    visit({"open", "", "whether the part is open; then `mesh.closed` is `false`"}, part.open);
}

template <class Visitor>
void describe_values(const ArrayNumbers& values, Visitor& visit) {
    visit({"name", "", "name of the vertex array"}, values.name);
    visit({"file", "", "the file it comes from"}, values.file);
    visit({"min", "", "smallest value at a vertex"}, values.min);
    visit({"max", "", "largest value at a vertex"}, values.max);
    visit({"mean", "", "mean over the vertices, weighted by area"}, values.mean);
    visit({"missing", "", "number of vertices without a value"}, values.missing);
}

template <class Visitor>
void describe_times(const StageTimes& stages, const RunSeconds& run, Visitor& visit) {
    visit({"total", "s", "from the start of the program"}, run.total);
    visit({"read", "s", "the start of the program and reading; with `--model all` counted with the first model"},
          run.read);
    visit({"estimate", "s", "estimating what is `expected`"}, stages.estimate);
    visit({"geometry", "s", "exact patches"}, stages.geometry);
    visit({"band", "s", "distance in the narrow band"}, stages.band);
    visit({"flow", "s", "the flow"}, stages.flow);
    visit({"mesh", "s", "extraction and improvement of the mesh"}, stages.mesh);
    visit({"exact", "s", "analytic areas and volumes, including the reference values for the checks"},
          run.exact + stages.exact);
    visit({"picture", "s", "colours and drawing"}, run.picture);
    visit({"page", "s", "pages, including their pictures"}, run.page);
    visit({"volume", "s", "the values of volumes"}, run.volume);
    visit({"write", "s", "writing files"}, run.write);
}

template <class Visitor>
void describe(const Report& report, Visitor& visit) {
    const RunFacts& facts = report.facts;
    const Surface* surface = report.surface;
    const bool has_flow = surface != nullptr && surface->options.method == Method::Flow;
    visit({"meniscus", "", "version of the program"}, kVersion);
    visit({"schema", "", "version of this form, 1"}, 1);
    visit.block({"input", "", "what was read"},
                [&](auto& inner) { describe_input(report.structure, report.probe, facts, inner); });
    visit({"options", "", "the options in force"}, report.options);
    visit.optional_block({"exact", "",
                          "analytic areas and volumes; cavities count negative in the volumes; `null` with "
                          "`--no-exact`"},
                         report.exact, [](auto& inner, const Measures& exact) { describe(exact, inner); });
    visit.optional_list(
        {"components", "", "list of the closed pieces of the exact SES, by falling volume; `null` with `--no-exact`"},
        report.exact != nullptr ? &report.exact->components : nullptr,
        [](auto& inner, const SurfaceComponent& component) { describe(component, inner); });
    if (surface == nullptr)
        visit.optional_list(
            {"interfaces", "", "list, with `measure --between`; `null` without it, absent from reports of `surface`"},
            facts.interfaces, [](auto& inner, const ChainInterface& i) { describe(i, inner); });
    visit.optional_block(
        {"mesh", "", "the mesh; `null` in reports of `measure`"}, surface, [&](auto& inner, const Surface& s) {
            describe_mesh(s, s.measured.get(), inner);
            inner.optional_block({"shown", "",
                                  "the part that `--show` writes; `null` without it. Everything else but `closed` is "
                                  "about the whole surface"},
                                 facts.shown, [](auto& part, const ShownPart& shown) { describe_shown(shown, part); });
        });
    visit.optional_block({"flow", "", "how the flow ran; `null` unless the method is `flow`"},
                         has_flow ? surface : nullptr, [](auto& inner, const Surface& s) { describe_flow(s, inner); });
    visit.list({"checks", "", "list of checks that the result passed or failed"}, facts.checks,
               [](auto& inner, const Check& check) { describe(check, inner); });
    if (surface != nullptr)
        visit.block(
            {"expected", "", "cost estimated before the surface was computed; absent from reports of `measure`"},
            [&](auto& inner) { describe(surface->expected, inner); });
    visit.block({"time_s", "", "wall-clock seconds by stage"}, [&](auto& inner) {
        describe_times(surface != nullptr ? surface->seconds : StageTimes{}, facts.seconds, inner);
    });
    visit({"peak_memory_mb", "MB", "peak memory of the process so far"}, facts.peak_memory_mb);
    if (surface != nullptr)
        visit.list({"values", "", "list of arrays put on the vertices; absent from reports of `measure`"}, facts.values,
                   [](auto& inner, const ArrayNumbers& values) { describe_values(values, inner); });
    if (surface != nullptr)
        visit(
            {"drawn", "",
             "number of ligands that a picture, a page or GLB shows as sticks and balls, by residue name; absent from "
             "reports of `measure`"},
            facts.drawn);
}

/// What a report of pockets is made of.
struct PocketsReport {
    const Structure& structure;
    const FoundPockets& found;
    ordered_json options{};
    const RunFacts& facts;
};

template <class Visitor>
void describe(const PocketsReport& report, Visitor& visit) {
    const RunFacts& facts = report.facts;
    const Pockets& pockets = report.found.pockets;
    visit({"meniscus", "", "version of the program"}, kVersion);
    visit({"schema", "", "version of this form, 1"}, 1);
    visit.block({"input", "", "what was read, as in reports of `surface`"},
                [&](auto& inner) { describe_input(report.structure, pockets.options.probe, facts, inner); });
    visit({"options", "", "the options in force"}, report.options);
    visit.block({"total", "", "pocket space as a whole"}, [&](auto& inner) { describe(pockets, inner); });
    visit.list({"pockets", "", "list of pockets by rank, closed cavities among them"}, report.found.described,
               [](auto& inner, const DescribedPocket& pocket) { describe(pocket, inner); });
    visit.list({"checks", "", "list of checks that the result passed or failed"}, facts.checks,
               [](auto& inner, const Check& check) { describe(check, inner); });
    visit.block({"time_s", "", "wall-clock seconds"}, [&](auto& inner) {
        inner({"total", "s", "from the start of the program"}, facts.seconds.total);
        inner({"read", "s", "the start of the program and reading; with `--model all` counted with the first model"},
              facts.seconds.read);
        inner({"pockets", "s", "finding and measuring pockets"}, facts.seconds.exact);
        inner({"write", "s", "writing files"}, facts.seconds.write);
    });
    visit({"peak_memory_mb", "MB", "peak memory of the process so far"}, facts.peak_memory_mb);
}

ordered_json pockets_options_block(const PocketsRequest& request, const RunFacts& facts) {
    OptionsAsJson options{SurfaceOptions{}};
    describe(request.pockets, options);
    options.block["threads"] = facts.threads;
    return options.block;
}

ordered_json to_json(const Report& report) {
    ordered_json json = described_as_json([&](auto& visit) { describe(report, visit); });
    if (report.facts.shown && report.facts.shown->open) json["mesh"]["closed"] = false;
    return json;
}

ordered_json rules_of(const Surface* surface) {
    const Structure structure;
    const RunFacts facts;
    SchemaVisitor visit;
    describe(Report{.structure = structure, .surface = surface, .facts = facts}, visit);
    return visit.rules();
}

}  // namespace

ordered_json make_report(const SurfaceRequest& request, const Structure& structure, const Surface& surface,
                         const RunFacts& facts) {
    return to_json({.structure = structure,
                    .probe = surface.options.probe,
                    .options = with_reading(surface_options_block(request, structure, surface, facts), request),
                    .exact = facts.excluded != nullptr ? facts.excluded.get() : surface.measured.get(),
                    .surface = &surface,
                    .facts = facts});
}

ordered_json make_report(const MeasureRequest& request, const Structure& structure, const Measures& exact,
                         const RunFacts& facts) {
    return to_json({.structure = structure,
                    .probe = exact.options.probe,
                    .options = with_reading(measure_options_block(request, facts), request),
                    .exact = &exact,
                    .facts = facts});
}

ordered_json make_report(const PocketsRequest& request, const Structure& structure, const FoundPockets& found,
                         const RunFacts& facts) {
    const PocketsReport report{structure, found, with_reading(pockets_options_block(request, facts), request), facts};
    return described_as_json([&](auto& visit) { describe(report, visit); });
}

ordered_json pockets_schema() {
    const Structure structure;
    const Pockets pockets;
    const std::vector<DescribedPocket> described;
    const RunFacts facts;
    SchemaVisitor visit;
    describe(PocketsReport{structure, {pockets, described}, {}, facts}, visit);
    ordered_json schema = schema_document("Report of meniscus pockets, schema 1",
                                          "What --report writes. Lengths are in Å, areas in Å², volumes in Å³. Fields "
                                          "may be added without a new schema number; none is renamed or removed.");
    const ordered_json one{{"$ref", "#/$defs/report"}};
    schema["anyOf"] = ordered_json::array({one, ordered_json{{"type", "array"}, {"items", one}}});
    schema["$defs"]["report"] = visit.rules();
    return schema;
}

ordered_json report_schema() {
    ordered_json schema = schema_document(
        "Report of meniscus surface and meniscus measure, schema 1",
        "What --report writes: one report, or with --model all a list of them. Lengths are in Å, areas in Å², volumes "
        "in Å³. A number that is not finite is written as null. Fields may be added without a new schema number; none "
        "is renamed or removed.");
    const ordered_json one{{"$ref", "#/$defs/report"}};
    const Surface surface;
    schema["anyOf"] = ordered_json::array({one, ordered_json{{"type", "array"}, {"items", one}}});
    schema["$defs"]["report"] = either(rules_of(&surface), rules_of(nullptr));
    schema["$defs"]["options"] = {{"type", "object"}, {"description", "The options in force."}};
    return schema;
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
#ifdef __APPLE__
    constexpr double kPerMegabyte = 1024.0 * 1024.0;  // bytes there, elsewhere kilobytes
#else
    constexpr double kPerMegabyte = 1024.0;
#endif
    return static_cast<double>(usage.ru_maxrss) / kPerMegabyte;
}

}  // namespace meniscus::cli

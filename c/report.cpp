// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Results as JSON, with the keys of the program's reports.
#include "io/describe_structure.h"
#include "io/json_visitor.h"
#include "io/options_json.h"
#include "meniscus/describe_pockets.h"
#include "meniscus/tables.h"
#include "meniscus/version.h"
#include "objects.h"

namespace meniscus::c {
namespace {

ordered_json input_block(const Structure& structure, double probe) {
    return described_as_json([&](auto& visit) {
        describe_file(structure, visit);
        describe_kept(structure, probe, visit);
    });
}

template <class List>
ordered_json described_one_by_one(const List& list) {
    ordered_json all = ordered_json::array();
    for (const auto& element : list) all.push_back(described_as_json([&](auto& visit) { describe(element, visit); }));
    return all;
}

ordered_json cavities_block(const Mesh& mesh, const Structure& structure, std::span<const SurfaceComponent> exact) {
    ordered_json all = ordered_json::array();
    for (const ListedCavity& c : list_cavities(mesh, structure, exact))
        all.push_back({{"volume", c.volume},
                       {"area", c.area},
                       {"centre", json_of(c.centre)},
                       {"radius", c.radius},
                       {"component", c.component == kNone ? ordered_json() : ordered_json(c.component)},
                       {"lining", c.lining}});
    return all;
}

void add_exact(ordered_json& report, const Measures* measures) {
    report["exact"] =
        measures == nullptr ? ordered_json() : described_as_json([&](auto& visit) { describe(*measures, visit); });
    report["components"] = measures == nullptr ? ordered_json() : described_one_by_one(measures->components);
}

std::vector<ChainPair> pairs_from(const std::string& between, const Structure& structure, double probe) {
    if (between == "all") return touching_chains(structure, probe);
    if (const std::optional<ChainPair> pair = split_pair(between)) return {*pair};
    throw UsageError("between: '" + between + "' is not a pair of groups; write A:B, A,C:B or all");
}

std::vector<ChainInterface> interfaces_of(const Structure& structure, const Options& options) {
    const double probe = options.surface.probe;
    const std::vector<ChainPair> pairs = pairs_from(options.between, structure, probe);
    return chain_interfaces(structure, pairs, {.probe = probe, .threads = options.run.threads});
}

std::string text_of(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

std::string report_of(const Structure& structure) { return text_of(input_block(structure, ExactOptions{}.probe)); }

std::string report_of(const Structure& structure, const ExactSurface& exact, const Options& options) {
    ordered_json report{{"meniscus", kVersion}, {"schema", 1}};
    report["input"] = input_block(structure, exact.options().probe);
    const Measures& measures = ses_measures(exact);
    add_exact(report, &measures);
    report["cavities"] = cavities_block({}, structure, measures.components);
    if (!options.between.empty()) report["interfaces"] = described_one_by_one(interfaces_of(structure, options));
    return text_of(report);
}

std::string report_of(const Structure& structure, const ExactSurface& exact, const Pockets& pockets) {
    ordered_json report{{"meniscus", kVersion}, {"schema", 1}};
    report["input"] = input_block(structure, pockets.options.probe);
    OptionsAsJson options{SurfaceOptions{}};
    describe(pockets.options, options);
    report["options"] = options.block;
    report["total"] = described_as_json([&](auto& visit) { describe(pockets, visit); });
    report["pockets"] = described_one_by_one(describe_pockets(pockets, structure));
    std::vector<Check> checks = pocket_checks(pockets);
    checks.insert(checks.begin(), agreement_check(ses_measures(exact)));
    report["checks"] = described_one_by_one(checks);
    return text_of(report);
}

std::string report_of(const Structure& structure, const Surface& surface) {
    const Measures* measured = surface.measured.get();
    ordered_json report{{"meniscus", kVersion}, {"schema", 1}};
    report["input"] = input_block(structure, surface.options.probe);
    report["options"] = options_block(surface.options);
    add_exact(report, measured != nullptr ? &ses_measures(surface.exact) : nullptr);
    report["mesh"] = described_as_json([&](auto& visit) { describe_mesh(surface, measured, visit); });
    report["flow"] = surface.options.method == Method::Flow
                         ? described_as_json([&](auto& visit) { describe_flow(surface, visit); })
                         : ordered_json();
    std::vector<Check> checks = surface.checks;
    if (measured != nullptr) checks.push_back(agreement_check(*measured));
    report["checks"] = described_one_by_one(checks);
    report["expected"] = described_as_json([&](auto& visit) { describe(surface.expected, visit); });
    const std::span<const SurfaceComponent> pieces = measured != nullptr
                                                         ? std::span<const SurfaceComponent>(measured->components)
                                                         : std::span<const SurfaceComponent>();
    report["cavities"] = cavities_block(surface.mesh, structure, pieces);
    return text_of(report);
}

}  // namespace meniscus::c

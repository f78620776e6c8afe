// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_report.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "meniscus/file_name.h"
#include "meniscus/version.h"
#include "messages.h"
#include "report.h"
#include "summary_text.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

std::string describe(const char* letter, const ComparedInput& input, double probe) {
    const std::string name = one_line(input_label(input.file));
    if (input.structure)
        return fmt::format("{}: {}, exact surface, {}, {}, probe {} Å\n", letter, name,
                           counted(input.structure->atoms.size(), "atom", "atoms"),
                           describe_radii(input.structure->radii_set), probe);
    const ComparedSurface& surface = input.surface;
    std::string text = fmt::format("{}: {}, mesh, {} vertices, {} triangles", letter, name,
                                   surface.mesh.vertices.size(), surface.mesh.triangles.size());
    if (surface.merged_vertices > 0) text += fmt::format(", {} coincident vertices merged", surface.merged_vertices);
    return text + "\n";
}

std::string pieces(const ComparedSurface& s) { return fmt::format("{} + {}", s.outer_pieces, s.cavities); }

const char* shape(const ComparedSurface& s) {
    if (s.exact) return "exact";
    if (s.closed) return s.manifold ? "yes" : "not manifold";
    return "no";
}

std::string describe_distance(const char* label, const OneWayDistance& d) {
    return fmt::format("  {:<22} {:>10.4f} {:>10.4f} {:>10.4f} {:>+12.4f}\n", label, d.mean, d.p99, d.max,
                       d.signed_mean);
}

ordered_json surface_json(const ComparedInput& input, double probe) {
    const ComparedSurface& s = input.surface;
    ordered_json block{{"file", file_name(input.file)},
                       {"kind", input.structure ? "structure" : "mesh"},
                       {"area", s.area},
                       {"volume", s.volume},
                       {"outer_pieces", s.outer_pieces},
                       {"cavities", s.cavities},
                       {"closed", s.closed},
                       {"manifold", s.manifold}};
    for (const char* key : {"vertices", "triangles", "merged_vertices", "atoms", "radii", "probe"})
        block[key] = nullptr;
    if (input.structure) {
        block["atoms"] = input.structure->atoms.size();
        block["radii"] = file_name(input.structure->radii_set);
        block["probe"] = probe;
    } else {
        block["vertices"] = s.mesh.vertices.size();
        block["triangles"] = s.mesh.triangles.size();
        block["merged_vertices"] = s.merged_vertices;
    }
    block["notes"] = notes_of(input);
    block["warnings"] = warnings_of(input);
    return block;
}

ordered_json distance_json(const OneWayDistance& d) {
    return {{"mean", d.mean}, {"p99", d.p99}, {"max", d.max}, {"signed_mean", d.signed_mean}, {"points", d.points}};
}

}  // namespace

std::vector<std::string> warnings_of(const ComparedInput& input) {
    if (input.structure) return input.structure->warnings;
    const ComparedSurface& s = input.surface;
    if (!s.closed) return {"the mesh is not closed: its volume and the signs of distances to it may be meaningless"};
    if (s.outer_pieces == 0) return {"all triangles face inwards: the signs of distances to it are reversed"};
    return {};
}

std::vector<std::string> notes_of(const ComparedInput& input) {
    return input.structure ? input.structure->notes : std::vector<std::string>{};
}

std::string make_summary(const CompareRequest& request, const CompareFacts& facts) {
    const ComparedSurface& a = facts.a.surface;
    const ComparedSurface& b = facts.b.surface;
    std::string text =
        describe("A", facts.a, request.structure.probe) + describe("B", facts.b, request.structure.probe);
    text += fmt::format("  {:<22} {:>14} {:>14}\n", "", "A", "B");
    text += fmt::format("  {:<22} {:>14.3f} {:>14.3f}\n", "area/Å²", a.area, b.area);
    text += fmt::format("  {:<22} {:>14.3f} {:>14.3f}\n", "volume/Å³", a.volume, b.volume);
    text += fmt::format("  {:<22} {:>14} {:>14}\n", "outer pieces + cavities", pieces(a), pieces(b));
    text += fmt::format("  {:<22} {:>14} {:>14}\n", "closed", shape(a), shape(b));
    text +=
        fmt::format("  {:<22} {:>10} {:>10} {:>10} {:>12}\n", "distance/Å", "mean", "99 %", "maximum", "signed mean");
    text += describe_distance("from A to B", facts.comparison.a_to_b);
    text += describe_distance("from B to A", facts.comparison.b_to_a);
    text += fmt::format("  {:<22} {:>32.4f}\n", "Hausdorff", facts.comparison.hausdorff());
    text += describe_run({.threads = facts.threads,
                          .peak_memory_mb = facts.peak_memory_mb,
                          .seconds = {.total = facts.total_seconds()}});
    std::vector<Output> written;
    for (const std::string& path : request.outputs) written.push_back({path, OutputKind::Mesh});
    return text + describe_files(written);
}

ordered_json make_report(const CompareRequest& request, const CompareFacts& facts) {
    return {{"meniscus", kVersion},
            {"schema", 1},
            {"a", surface_json(facts.a, request.structure.probe)},
            {"b", surface_json(facts.b, request.structure.probe)},
            {"a_to_b", distance_json(facts.comparison.a_to_b)},
            {"b_to_a", distance_json(facts.comparison.b_to_a)},
            {"hausdorff", facts.comparison.hausdorff()},
            {"options",
             {{"points", request.compare.density},
              {"probe", request.structure.probe},
              {"spacing", request.structure.spacing},
              {"range", {facts.range.min, facts.range.max}},
              {"threads", facts.threads}}},
            {"time_s",
             {{"total", facts.total_seconds()},
              {"read", facts.read_seconds},
              {"compare", facts.compare_seconds},
              {"write", facts.write_seconds}}},
            {"peak_memory_mb", facts.peak_memory_mb}};
}

}  // namespace meniscus::cli

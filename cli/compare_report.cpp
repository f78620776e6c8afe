// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_report.h"

#include <fmt/core.h>

#include <array>
#include <optional>

#include "json_schema.h"
#include "meniscus/file_name.h"
#include "meniscus/version.h"
#include "messages.h"
#include "report.h"
#include "summary_text.h"

namespace meniscus::cli {

namespace {

std::string introduce(const char* letter, const ComparedInput& input, double probe) {
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

constexpr Words<bool, 2> kKindWords{{{"mesh", false}, {"structure", true}}};

/// Nothing where a value does not belong to an input of this kind.
template <class T>
std::optional<T> if_any(bool is_there, const T& value) {
    return is_there ? std::optional<T>(value) : std::nullopt;
}

template <class Visitor>
void describe_input(const ComparedInput& input, double probe, Visitor& visit) {
    const ComparedSurface& s = input.surface;
    const bool is_structure = input.structure.has_value();
    const std::size_t atoms = is_structure ? input.structure->atoms.size() : 0;
    const std::string radii = is_structure ? file_name(input.structure->radii_set) : "";
    visit({"file", "", "file name without folders"}, file_name(input.file));
    visit({"kind", "", "`mesh` or `structure`"}, is_structure, kKindWords);
    describe(s, visit);
    visit({"vertices", "", "number of vertices, for a mesh"}, if_any(!is_structure, s.mesh.vertices.size()));
    visit({"triangles", "", "number of triangles, for a mesh"}, if_any(!is_structure, s.mesh.triangles.size()));
    visit({"merged_vertices", "",
           "for a mesh: number of vertices removed because they were at the same place as another, or had no triangle. "
           "Only meshes that are not closed are treated so"},
          if_any(!is_structure, s.merged_vertices));
    visit({"atoms", "", "number of atoms, for a structure"}, if_any(is_structure, atoms));
    visit({"radii", "", "the radius set, for a structure"}, if_any(is_structure, radii));
    visit({"probe", "Å", "probe radius, for a structure"}, if_any(is_structure, probe));
    visit({"notes", "", "for a structure: what was left out or chosen while reading, one line each"}, notes_of(input));
    visit({"warnings", "", "what may make a number wrong, one line each"}, warnings_of(input));
}

template <class Visitor>
void describe_options(const CompareRequest& request, const CompareFacts& facts, Visitor& visit) {
    visit({"points", "Å⁻²", "least number of points per area"}, request.compare.density);
    visit({"probe", "Å", "probe radius, for structures"}, request.structure.probe);
    visit({"spacing", "Å", "grid spacing of the mesh that points of a structure are taken from"},
          request.structure.spacing);
    visit({"range", "Å", "the two ends of the colours"}, std::array{facts.range.min, facts.range.max});
    visit({"threads", "", "number of threads in use"}, facts.threads);
}

template <class Visitor>
void describe_times(const CompareFacts& facts, Visitor& visit) {
    visit({"total", "s", "from the start of the program"}, facts.total_seconds());
    visit({"read", "s", "the start of the program and reading"}, facts.read_seconds);
    visit({"compare", "s", "finding distances"}, facts.compare_seconds);
    visit({"write", "s", "writing files"}, facts.write_seconds);
}

template <class Visitor>
void describe_report(const CompareRequest& request, const CompareFacts& facts, Visitor& visit) {
    const double probe = request.structure.probe;
    visit({"meniscus", "", "version of the program"}, kVersion);
    visit({"schema", "", "version of this form, 1"}, 1);
    visit.block({"a", "", "the first surface, below"}, [&](auto& inner) { describe_input(facts.a, probe, inner); });
    visit.block({"b", "", "the second surface"}, [&](auto& inner) { describe_input(facts.b, probe, inner); });
    visit.block({"a_to_b", "", "distances from points of the first surface to the second, below"},
                [&](auto& inner) { describe(facts.comparison.a_to_b, inner); });
    visit.block({"b_to_a", "", "distances from points of the second surface to the first"},
                [&](auto& inner) { describe(facts.comparison.b_to_a, inner); });
    visit({"hausdorff", "Å", "the larger `max` of the two"}, facts.comparison.hausdorff());
    visit.block({"options", "", "the options in force"}, [&](auto& inner) { describe_options(request, facts, inner); });
    visit.block({"time_s", "", "wall-clock seconds"}, [&](auto& inner) { describe_times(facts, inner); });
    visit({"peak_memory_mb", "MB", "peak memory of the process"}, facts.peak_memory_mb);
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
        introduce("A", facts.a, request.structure.probe) + introduce("B", facts.b, request.structure.probe);
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
    return described_as_json([&](auto& visit) { describe_report(request, facts, visit); });
}

ordered_json compare_schema() {
    ordered_json schema = schema_document(
        "Report of meniscus compare",
        "What --report writes. Keys may be added; none is renamed or removed while schema is 1. Lengths in Å, areas in "
        "Å², volumes in Å³. Every key is explained in reference/compare.md.");
    SchemaVisitor visit;
    describe_report({}, {}, visit);
    schema.update(visit.rules());
    return schema;
}

}  // namespace meniscus::cli

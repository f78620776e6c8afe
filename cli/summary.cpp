// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "messages.h"
#include "summary_text.h"

namespace meniscus::cli {

namespace {

std::string describe_pieces(const PieceCounts& pieces) {
    return fmt::format("{} ({} outer, {})", pieces.all(), pieces.outer, counted(pieces.cavities, "cavity", "cavities"));
}

/// Cavities of the surface or of the mesh, which may lack the smallest or have others.
bool has_cavities(const Surface& surface) {
    return count_pieces(surface.measures).cavities > 0 ||
           (surface.measured && count_pieces(*surface.measured).cavities > 0);
}

/// What the mesh was made without.
std::string describe_changes(const Surface& surface) {
    std::string text;
    if (surface.dropped.cavities > 0)
        text += fmt::format("; {} below {:g} Å³ dropped", counted(surface.dropped.cavities, "cavity", "cavities"),
                            surface.options.min_cavity);
    if (surface.filled.cavities > 0)
        text += fmt::format("; {} below {:g} Å³ filled", counted(surface.filled.cavities, "cavity", "cavities"),
                            surface.options.fill_cavities);
    if (surface.simplified.handles > 0)
        text += fmt::format("; {} cut", counted(surface.simplified.handles, "handle", "handles"));
    if (surface.simplified.pieces > 0)
        text += fmt::format("; {} vanished", counted(surface.simplified.pieces, "piece", "pieces"));
    return text;
}

bool is_whole(const Surface& surface) {
    return surface.options.pieces == Pieces::All && surface.dropped.cavities == 0 && surface.filled.cavities == 0;
}

/// "mesh", or what it lacks of the surface whose exact numbers are shown.
std::string name_of_mesh(const Surface& surface) {
    if (surface.options.method == Method::Gaussian) return "Gaussian envelope";
    std::string name = "mesh";
    if (surface.options.surface != SurfaceKind::Ses) name += " without creases";
    if (surface.options.pieces == Pieces::Outer) return name + " of outer pieces";
    if (surface.options.pieces == Pieces::Cavities) return name + " of cavities";
    return is_whole(surface) ? name : name + " without small cavities";
}

/// A sum over the mesh, corrected for curvature and of flat triangles, Å² or Å³.
struct MeshSum {
    double corrected;
    double flat;
};

std::string describe_sum(const MeshSum& sum, const char* unit) {
    return fmt::format("{:.2f} {} (flat triangles {:.2f} {})", sum.corrected, unit, sum.flat, unit);
}

/// The exact number of the whole surface first, with what the mesh has beside it.
std::string describe_beside(const std::string& exact, const Surface& surface, const MeshSum& sum, const char* unit) {
    return fmt::format("{} exact{}; {} {:.2f} {}, flat triangles {:.2f} {}", exact,
                       is_whole(surface) ? "" : ", of all pieces", name_of_mesh(surface), sum.corrected, unit, sum.flat,
                       unit);
}

/// Columns of the larger of two numbers, so that they are written below each other.
int common_width(double a, double b) {
    return static_cast<int>(std::max(fmt::format("{:.4f}", a).size(), fmt::format("{:.4f}", b).size()));
}

/// Area and volume. A part that is written alone has numbers of its own further down.
std::string describe_sizes(const Surface& surface, bool is_part_written) {
    const MeshSum area{surface.corrected_area, surface.measures.area};
    const MeshSum volume{surface.corrected_volume, surface.measures.volume};
    if (!surface.measured)
        return summary_line("area", describe_sum(area, "Å²")) + summary_line("volume", describe_sum(volume, "Å³"));
    const SurfaceTotals& t = surface.measured->totals;
    const SurfaceTotals& e = surface.measured->errors;
    const int width = common_width(t.ses_area, t.ses_volume);
    const char* whole = is_part_written ? ", of the whole surface" : "";
    const std::string exact_area = exact_value(t.ses_area, e.ses_area, "Å²", width);
    const std::string exact_volume = exact_value(t.ses_volume, e.ses_volume, "Å³", width);
    return summary_line("area", describe_beside(exact_area, surface, area, "Å²") + whole) +
           summary_line("volume", describe_beside(exact_volume, surface, volume, "Å³") + whole);
}

/// Why the mesh has other pieces than the exact surface.
std::string explain_pieces(const Surface& surface, const PieceCounts& of_mesh) {
    if (surface.options.method == Method::Gaussian) return "the Gaussian envelope is not the solvent-excluded surface";
    if (count_kept_pieces(*surface.measured, surface.options) == of_mesh)
        return "the mesh leaves out the pieces that the options name";
    if (surface.simplified.handles > 0 || surface.simplified.pieces > 0)
        return "the mesh leaves out what is narrower than an edge";
    return "in a mesh, features smaller than the spacing, such as necks between cavities, come out joined or separate";
}

/// One number of pieces where mesh and exact surface agree; else both, and a line that says why.
std::string describe_components(const Surface& surface) {
    const PieceCounts of_mesh = count_pieces(surface.measures);
    const std::string mesh = describe_pieces(of_mesh) + describe_changes(surface);
    if (!surface.measured || count_pieces(*surface.measured) == of_mesh) return summary_line("components", mesh);
    const std::string exact = describe_pieces(count_pieces(*surface.measured));
    const char* what = surface.options.method == Method::Gaussian ? "Gaussian envelope" : "mesh";
    return summary_line("components", fmt::format("{} exact; {} {}", exact, what, mesh)) +
           summary_line("", explain_pieces(surface, of_mesh));
}

std::string describe_mesh(const Surface& surface) {
    const MeshMeasures& m = surface.measures;
    return fmt::format("{} vertices, {} triangles, {}, {}", surface.mesh.vertices.size(), surface.mesh.triangles.size(),
                       m.closed ? "closed" : "not closed", m.manifold ? "manifold" : "not manifold");
}

std::string describe_shown(const ShownPart& shown) {
    return fmt::format("only the part of {}: {} vertices, {} triangles, {:.2f} Å²{}", shown.select, shown.vertices,
                       shown.triangles, shown.area, shown.open ? ", open" : "");
}

std::string describe_surface(const SurfaceOptions& options) {
    if (options.surface == SurfaceKind::Sas)
        return fmt::format("solvent-accessible surface, probe {} Å", options.probe);
    if (options.surface == SurfaceKind::Vdw) return "van der Waals surface";
    return fmt::format("probe {} Å", options.probe);
}

std::string describe_flow(const FlowSummary& flow) {
    const std::string steps = counted(static_cast<std::size_t>(flow.steps), "step", "steps");
    const std::string why = flow.explanation.empty() ? "" : ": " + flow.explanation;
    return fmt::format("{}, {}{}", steps, flow.converged ? "converged" : "not converged", why);
}

std::string explain(const Check& check, const FlowSummary& flow) {
    if (check.name == "converged" && !flow.explanation.empty()) return flow.explanation;
    if (std::isnan(check.bound)) return fmt::format("{:g}, with nothing to compare with", check.value);
    return fmt::format("{:g}, bound {:g}", check.value, check.bound);
}

}  // namespace

std::string make_summary(const Structure& structure, const Surface& surface, const RunFacts& facts,
                         const std::vector<Output>& written) {
    const std::string chain = facts.chain.empty() ? "" : " chain " + one_line(facts.chain);
    std::string text =
        fmt::format("{}{}: {}, {}, {}, spacing {} Å\n", one_line(input_label(structure.file)), chain,
                    counted(structure.atoms.size(), "atom", "atoms"), describe_radii(structure.radii_set),
                    describe_surface(surface.options), surface.options.spacing);
    text += describe_sizes(surface, facts.shown.has_value());
    text += describe_components(surface);
    if (has_cavities(surface) && !structure.left_out_ligands.empty())
        text += summary_line("left out", "ligands that may fill cavities: " + list_ligands(structure));
    text += summary_line("mesh", describe_mesh(surface));
    text +=
        summary_line("distance", fmt::format("mean {:.4f}, 99 % below {:.4f}, largest {:.4f} Å from the exact surface",
                                             surface.distance.mean, surface.distance.p99, surface.distance.max));
    if (surface.options.method == Method::Flow) text += summary_line("flow", describe_flow(surface.flow));
    text += describe_checks(facts.checks);
    if (facts.shown) text += summary_line("written", describe_shown(*facts.shown));
    text += describe_run(facts);
    text += describe_files(written);
    return text;
}

std::string failed_checks(const Surface& surface) {
    std::string list;
    if (surface.measured) list = disputed_patches(surface.measured->agreed, surface.measured->disputed);
    for (const Check& c : surface.checks) {
        if (c.passed) continue;
        list += (list.empty() ? "" : ", ") + c.name + " (" + explain(c, surface.flow) + ")";
    }
    return list;
}

}  // namespace meniscus::cli

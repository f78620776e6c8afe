// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "exact_blocks.h"
#include "messages.h"
#include "summary_text.h"

namespace meniscus::cli {

namespace {

bool has_cavities(const MeshMeasures& measures) {
    return std::any_of(measures.components.begin(), measures.components.end(),
                       [](const MeshComponent& c) { return c.volume <= 0.0; });
}

std::string describe_components(const Surface& surface) {
    const MeshMeasures& measures = surface.measures;
    const auto outer = std::count_if(measures.components.begin(), measures.components.end(),
                                     [](const MeshComponent& c) { return c.volume > 0.0; });
    const std::size_t cavities = measures.components.size() - static_cast<std::size_t>(outer);
    std::string text =
        fmt::format("{} ({} outer, {})", measures.components.size(), outer, counted(cavities, "cavity", "cavities"));
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
    const MeshMeasures& m = surface.measures;
    const std::string chain = facts.chain.empty() ? "" : " chain " + one_line(facts.chain);
    std::string text =
        fmt::format("{}{}: {}, {}, {}, spacing {} Å\n", one_line(input_label(structure.file)), chain,
                    counted(structure.atoms.size(), "atom", "atoms"), describe_radii(structure.radii_set),
                    describe_surface(surface.options), surface.options.spacing);
    if (facts.exact)
        text += summary_line("exact", fmt::format("{:.2f} Å², {:.2f} Å³; what follows is of the mesh, without creases",
                                                  facts.exact->ses_area, facts.exact->ses_volume));
    text += summary_line("area", fmt::format("{:.2f} Å² (flat triangles {:.2f} Å²)", surface.corrected_area, m.area));
    text +=
        summary_line("volume", fmt::format("{:.2f} Å³ (flat triangles {:.2f} Å³)", surface.corrected_volume, m.volume));
    text += summary_line("components", describe_components(surface));
    if (has_cavities(m) && !structure.left_out_ligands.empty())
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

std::string failed_checks(const Surface& surface, const Measures& exact) {
    std::string list = disputed_patches(exact.agreed, exact.disputed);
    for (const Check& c : surface.checks) {
        if (c.passed) continue;
        list += (list.empty() ? "" : ", ") + c.name + " (" + explain(c, surface.flow) + ")";
    }
    return list;
}

}  // namespace meniscus::cli

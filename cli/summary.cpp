// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "summary.h"

#include <fmt/core.h>

#include <algorithm>

#include "messages.h"

namespace meniscus::cli {

namespace {

std::string line(const char* label, const std::string& text) { return fmt::format("  {:<11} {}\n", label, text); }

std::string counted(std::size_t n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string describe_components(const MeshMeasures& measures) {
    const auto outer = std::count_if(measures.components.begin(), measures.components.end(),
                                     [](const MeshComponent& c) { return c.volume > 0.0; });
    const std::size_t cavities = measures.components.size() - static_cast<std::size_t>(outer);
    return fmt::format("{} ({} outer, {})", measures.components.size(), outer, counted(cavities, "cavity", "cavities"));
}

std::string describe_mesh(const Surface& surface) {
    const MeshMeasures& m = surface.measures;
    return fmt::format("{} vertices, {} triangles, {}, {}", surface.mesh.vertices.size(), surface.mesh.triangles.size(),
                       m.closed ? "closed" : "not closed", m.manifold ? "manifold" : "not manifold");
}

std::string describe_flow(const FlowSummary& flow) {
    return fmt::format("{}, {}", counted(static_cast<std::size_t>(flow.steps), "step", "steps"),
                       flow.converged ? "converged" : "not converged");
}

std::string describe_files(const std::vector<Output>& written) {
    std::string list;
    for (const Output& output : written) list.append(list.empty() ? "" : ", ").append(one_line(output.path));
    return list;
}

}  // namespace

std::string make_summary(const Structure& structure, const Surface& surface, const RunFacts& facts,
                         const std::vector<Output>& written) {
    const MeshMeasures& m = surface.measures;
    std::string text =
        fmt::format("{}: {}, radii {}, probe {} Å, spacing {} Å\n", one_line(input_label(structure.file)),
                    counted(structure.atoms.size(), "atom", "atoms"), one_line(structure.radii_set),
                    surface.options.probe, surface.options.spacing);
    text += line("area", fmt::format("{:.2f} Å² (flat triangles {:.2f} Å²)", surface.corrected_area, m.area));
    text += line("volume", fmt::format("{:.2f} Å³ (flat triangles {:.2f} Å³)", surface.corrected_volume, m.volume));
    text += line("components", describe_components(m));
    text += line("mesh", describe_mesh(surface));
    text += line("distance", fmt::format("mean {:.4f}, 99 % below {:.4f}, largest {:.4f} Å from the exact surface",
                                         surface.distance.mean, surface.distance.p99, surface.distance.max));
    if (surface.options.method == Method::Flow) text += line("flow", describe_flow(surface.flow));
    text += line("time", fmt::format("{:.2f} s on {}, {:.0f} MB", facts.total_seconds,
                                     counted(static_cast<std::size_t>(facts.threads), "thread", "threads"),
                                     facts.peak_memory_mb));
    text += line("written", describe_files(written));
    return text;
}

std::string failed_checks(const Surface& surface) {
    std::string list;
    for (const Check& c : surface.checks)
        if (!c.passed)
            list += fmt::format("{}{} ({:g}, bound {:g})", list.empty() ? "" : ", ", c.name, c.value, c.bound);
    return list;
}

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>

#include "meniscus/file_name.h"
#include "meniscus/page.h"
#include "meniscus/words.h"

namespace meniscus {

namespace {

using Rows = std::vector<PageRow>;

/// With commas between thousands, as the viewer writes them beside the table.
std::string grouped(std::string number) {
    const std::size_t first = number.front() == '-' ? 1 : 0;
    for (std::size_t at = std::min(number.find('.'), number.size()); at > first + 3;) number.insert(at -= 3, ",");
    return number;
}

std::string area(double value) { return grouped(fmt::format("{:.1f}", value)) + " Å²"; }
std::string volume(double value) { return grouped(fmt::format("{:.1f}", value)) + " Å³"; }
std::string counted(std::size_t value) { return grouped(std::to_string(value)); }
std::string length(double value) { return fmt::format("{:.4f} Å", value); }

/// Without its folders, on one line.
std::string name_of_file(const std::string& path) {
    std::string name = file_name(path);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return name;
}

std::size_t count(const Measures& exact, ComponentKind kind) {
    return static_cast<std::size_t>(std::count_if(exact.components.begin(), exact.components.end(),
                                                  [kind](const SurfaceComponent& c) { return c.kind == kind; }));
}

const char* exact_section(SurfaceKind kind) {
    if (kind == SurfaceKind::Sas) return "Solvent-accessible surface, exact";
    if (kind == SurfaceKind::Vdw) return "Van der Waals surface, exact";
    return "Solvent-excluded surface, exact";
}

void add_exact(Rows& rows, const Measures& exact, SurfaceKind kind) {
    const SurfaceTotals& t = exact.totals;
    const char* excluded = exact_section(kind);
    rows.push_back({excluded, "area", area(t.ses_area)});
    rows.push_back({excluded, "volume", volume(t.ses_volume)});
    if (kind == SurfaceKind::Ses) {
        rows.push_back({excluded, "contact", area(t.contact_area)});
        rows.push_back({excluded, "toroidal", area(t.toroidal_area)});
        rows.push_back({excluded, "reentrant", area(t.reentrant_area)});
    }
    rows.push_back({excluded, "outer pieces", counted(count(exact, ComponentKind::Outer))});
    rows.push_back({excluded, "cavities", counted(count(exact, ComponentKind::Cavity))});
    if (kind != SurfaceKind::Ses) return;  // that is the same surface
    const char* accessible = "Solvent-accessible surface, exact";
    rows.push_back({accessible, "area", area(t.sas_area)});
    rows.push_back({accessible, "volume", volume(t.sas_volume)});
}

void add_mesh(Rows& rows, const Surface& surface) {
    const MeshMeasures& m = surface.measures;
    const char* section = "This mesh";
    rows.push_back({section, "area", area(surface.corrected_area)});
    rows.push_back({section, "volume", volume(surface.corrected_volume)});
    rows.push_back({section, "vertices", counted(surface.mesh.vertices.size())});
    rows.push_back({section, "triangles", counted(surface.mesh.triangles.size())});
    rows.push_back(
        {section, "closed, manifold", fmt::format("{}, {}", m.closed ? "yes" : "no", m.manifold ? "yes" : "no")});
    const char* distance = "Distance of this mesh from the exact surface";
    rows.push_back({distance, "mean", length(surface.distance.mean)});
    rows.push_back({distance, "99 % below", length(surface.distance.p99)});
    rows.push_back({distance, "largest", length(surface.distance.max)});
}

void add_input(Rows& rows, const Structure& structure, const Surface& surface) {
    const char* section = "How it was made";
    if (!structure.file.empty())
        rows.push_back({section, "file", structure.file == "-" ? "standard input" : name_of_file(structure.file)});
    rows.push_back({section, "atoms", counted(structure.atoms.size())});
    rows.push_back({section, "residues", counted(structure.residues.size())});
    for (const auto& [reason, number] : structure.dropped)
        if (number > 0) rows.push_back({section, "left out: " + reason, counted(number)});
    rows.push_back({section, "radii", name_of_file(structure.radii_set)});
    rows.push_back({section, "probe", fmt::format("{} Å", surface.options.probe)});
    rows.push_back({section, "method", word_for(kMethodWords, surface.options.method)});
    rows.push_back({section, "spacing", fmt::format("{} Å", surface.options.spacing)});
    if (surface.options.remesh.is_on())
        rows.push_back({section, "edge length", fmt::format("{:.3g} Å", surface.options.remesh.edge)});
}

void add_checks(Rows& rows, const std::vector<Check>& checks) {
    const auto passed = std::count_if(checks.begin(), checks.end(), [](const Check& c) { return c.passed; });
    rows.push_back({"Checks", "passed", fmt::format("{} of {}", passed, checks.size())});
    for (const Check& c : checks)
        if (!c.passed) rows.push_back({"Checks", "failed", c.name});
}

std::string lining_of(const DescribedPocket& pocket) {
    constexpr std::size_t kMost = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(kMost, pocket.residues.size()); ++i)
        text.append(text.empty() ? "" : ", ").append(pocket.residues[i]);
    if (pocket.residues.size() > kMost) text += fmt::format(" and {} more", pocket.residues.size() - kMost);
    return text;
}

double area_of_all(const std::vector<PocketMouth>& mouths) {
    double area = 0.0;
    for (const PocketMouth& mouth : mouths) area += mouth.area;
    return area;
}

std::string text_of(const LigandFit& ligand) {
    return fmt::format("{} of {} atoms inside, {:.0f} % buried", ligand.inside, ligand.atoms,
                       100.0 * ligand.buried_area / std::max(ligand.area, 1e-9));
}

}  // namespace

std::vector<PageRow> page_rows(const Structure& structure, const Surface& surface, const Measures& exact) {
    Rows rows;
    add_exact(rows, exact, surface.options.surface);
    add_mesh(rows, surface);
    add_input(rows, structure, surface);
    std::vector<Check> checks = surface.checks;
    checks.push_back(agreement_check(exact));
    add_checks(rows, checks);
    return rows;
}

std::vector<PageRow> page_rows(const Structure& structure, const Surface& surface) {
    Rows rows;
    add_mesh(rows, surface);
    add_input(rows, structure, surface);
    add_checks(rows, surface.checks);
    return rows;
}

std::vector<PagePocket> page_pockets(std::span<const DescribedPocket> described) {
    std::vector<PagePocket> list;
    for (const DescribedPocket& d : described) {
        const Pocket& p = d.pocket;
        list.push_back({.name = d.at.empty() ? std::to_string(p.rank) : d.at,
                        .colour = pocket_colour(static_cast<float>(p.rank)),
                        .cavity = p.cavity,
                        .score = p.score,
                        .volume = p.volume,
                        .depth = p.depth,
                        .wall_area = p.wall_area,
                        .mouths = p.mouths.size(),
                        .mouth_area = area_of_all(p.mouths),
                        .openings = p.openings.size(),
                        .opening_area = area_of_all(p.openings),
                        .centre = p.centre,
                        .lining = lining_of(d),
                        .ligand = d.ligand ? text_of(*d.ligand) : ""});
    }
    return list;
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure_summary.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "messages.h"
#include "summary_text.h"

namespace meniscus::cli {

namespace {

constexpr std::size_t kMostCavities = 10;
constexpr std::size_t kMostResidues = 6;
constexpr std::size_t kMostInterfaces = 30;

std::string value_line(const char* label, double value, double error, const char* unit) {
    constexpr int kWidth = 14;
    return fmt::format("  {:<13} {}\n", label, exact_value(value, error, unit, kWidth));
}

std::string describe_pieces(const Measures& measures) {
    const auto outer = std::count_if(measures.components.begin(), measures.components.end(),
                                     [](const SurfaceComponent& c) { return c.kind == ComponentKind::Outer; });
    const std::size_t cavities = measures.components.size() - static_cast<std::size_t>(outer);
    return fmt::format("  {:<13} SES: {} outer, {}; SAS: {}\n", "pieces", outer,
                       counted(cavities, "cavity", "cavities"), measures.sas_components);
}

std::string describe_lining(const Structure& structure, const SurfaceComponent& cavity) {
    const std::vector<std::uint32_t> residues = lining_residues(structure, cavity);
    std::string text;
    for (std::size_t i = 0; i < std::min(residues.size(), kMostResidues); ++i)
        text.append(text.empty() ? "" : " ").append(one_line(residue_label(structure.residues[residues[i]])));
    if (residues.size() > kMostResidues) text += fmt::format(" + {}", residues.size() - kMostResidues);
    return text;
}

std::string describe_cavities(const Structure& structure, const Measures& measures) {
    std::string text;
    std::size_t count = 0;
    double area_error = 0.0;
    double volume_error = 0.0;
    for (std::size_t i = 0; i < measures.components.size(); ++i) {
        const SurfaceComponent& c = measures.components[i];
        if (c.kind != ComponentKind::Cavity) continue;
        area_error = std::max(area_error, c.errors.ses_area);
        volume_error = std::max(volume_error, c.errors.ses_volume);
        if (count++ == 0)
            text += fmt::format("  {:>9} {:>9} {:>10} {:>8} {:>6}  lined by\n", "cavity", "area/Å²", "volume/Å³",
                                "radius/Å", "atoms");
        if (count > kMostCavities) continue;
        text += fmt::format("  {:>9} {:>9.2f} {:>10.2f} {:>8.3f} {:>6}  {}\n", i, c.ses_area, c.ses_volume,
                            c.inscribed_radius, c.atoms.size(), describe_lining(structure, c));
    }
    if (count > kMostCavities)
        text +=
            fmt::format("  {:>9} and {} smaller; list all with -o FILE.csv --per cavity\n", "", count - kMostCavities);
    if (count > 0)
        text += fmt::format("  {:>9} areas to ± {:.1e} Å², volumes to ± {:.1e} Å³\n", "", area_error, volume_error);
    if (count > 0 && !structure.left_out_ligands.empty())
        text += fmt::format("  {:>9} ligands that may fill them were left out: {}\n", "", list_ligands(structure));
    return text;
}

}  // namespace

std::string make_summary(const Structure& structure, const Measures& measures, const RunFacts& facts,
                         const std::vector<Output>& written) {
    const SurfaceTotals& t = measures.totals;
    const SurfaceTotals& e = measures.errors;
    std::string text = fmt::format("{}: {}, {}, probe {} Å\n", one_line(input_label(structure.file)),
                                   counted(structure.atoms.size(), "atom", "atoms"),
                                   describe_radii(structure.radii_set), measures.options.probe);
    text += value_line("SAS area", t.sas_area, e.sas_area, "Å²");
    text += value_line("SAS volume", t.sas_volume, e.sas_volume, "Å³");
    text += value_line("SES area", t.ses_area, e.ses_area, "Å²");
    text += value_line("  contact", t.contact_area, e.contact_area, "Å²");
    text += value_line("  toroidal", t.toroidal_area, e.toroidal_area, "Å²");
    text += value_line("  reentrant", t.reentrant_area, e.reentrant_area, "Å²");
    text += value_line("SES volume", t.ses_volume, e.ses_volume, "Å³");
    text += describe_pieces(measures);
    text += describe_cavities(structure, measures);
    text += describe_checks(facts.checks);
    text += describe_run(facts);
    text += describe_files(written);
    return text;
}

std::string summarise_interfaces(std::span<const ChainInterface> interfaces) {
    if (interfaces.empty()) return "  no chains touch\n";
    std::string text = fmt::format("  {:<13} {:>11} {:>11} {:>11} {:>11} {:>11} {:>11}  (Å²)\n", "interface", "SAS A",
                                   "SAS B", "SAS AB", "buried SAS", "half of it", "buried SES");
    for (const ChainInterface& i : interfaces.first(std::min(interfaces.size(), kMostInterfaces)))
        text += fmt::format("  {:<13} {:>11.2f} {:>11.2f} {:>11.2f} {:>11.2f} {:>11.2f} {:>11.2f}\n",
                            one_line(interface_name(i.chains)), i.areas.sas_a, i.areas.sas_b, i.areas.sas_ab,
                            i.areas.buried_sas(), i.areas.interface_area(), i.areas.buried_ses());
    if (interfaces.size() > kMostInterfaces)
        text += fmt::format("  {:<13} and {} more; list all with --report FILE.json\n", "",
                            interfaces.size() - kMostInterfaces);
    return text;
}

std::string interface_name(const ChainPair& chains) {
    return fmt::format("{}:{}", fmt::join(chains.a, ","), fmt::join(chains.b, ","));
}

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact_blocks.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

ordered_json totals_json(const SurfaceTotals& totals) {
    return {{"sas_area", totals.sas_area},
            {"sas_volume", totals.sas_volume},
            {"ses_area", totals.ses_area},
            {"ses_volume", totals.ses_volume},
            {"contact_area", totals.contact_area},
            {"toroidal_area", totals.toroidal_area},
            {"reentrant_area", totals.reentrant_area}};
}

ordered_json point_json(const Vec3& p) { return ordered_json::array({p.x, p.y, p.z}); }

ordered_json component_json(const SurfaceComponent& c) {
    const bool cavity = c.kind == ComponentKind::Cavity;
    ordered_json block = {{"kind", cavity ? "cavity" : "outer"},
                          {"ses_area", c.ses_area},
                          {"contact_area", c.contact_area},
                          {"toroidal_area", c.toroidal_area},
                          {"reentrant_area", c.reentrant_area},
                          {"ses_volume", c.ses_volume},
                          {"sas_area", c.sas_area},
                          {"sas_volume", c.sas_volume},
                          {"sas_components", c.sas_components},
                          {"centre", point_json(c.centre)}};
    block["inside_of"] = c.inside_of == kNone ? ordered_json() : ordered_json(c.inside_of);
    block["atoms"] = c.atoms;
    block["inscribed_centre"] = cavity ? point_json(c.inscribed_centre) : ordered_json();
    block["inscribed_radius"] = cavity ? ordered_json(c.inscribed_radius) : ordered_json();
    block["errors"] = totals_json(c.errors);
    return block;
}

}  // namespace

ordered_json exact_json(const Measures& measures) {
    ordered_json block = totals_json(measures.totals);
    block["errors"] = totals_json(measures.errors);
    block["sas_components"] = measures.sas_components;
    const PatchAreas& piece = measures.largest_sas_piece;
    block["largest_sas_piece"] = {{"ses_area", piece.sum()},
                                  {"contact_area", piece.contact},
                                  {"toroidal_area", piece.toroidal},
                                  {"reentrant_area", piece.reentrant}};
    block["degenerate"] = measures.degenerate;
    return block;
}

ordered_json components_json(const Measures& measures) {
    ordered_json list = ordered_json::array();
    for (const SurfaceComponent& component : measures.components) list.push_back(component_json(component));
    return list;
}

ordered_json interface_json(const std::string& a, const std::string& b, const Interface& i) {
    return {
        {"a", a},
        {"b", b},
        {"sas_a", i.sas_a},
        {"sas_b", i.sas_b},
        {"sas_ab", i.sas_ab},
        {"buried_sas", i.buried_sas()},
        {"interface_area", i.interface_area()},
        {"ses_a", i.ses_a},
        {"ses_b", i.ses_b},
        {"ses_ab", i.ses_ab},
        {"buried_ses", i.buried_ses()},
        {"errors", {{"buried_sas", i.sas_error}, {"interface_area", 0.5 * i.sas_error}, {"buried_ses", i.ses_error}}}};
}

std::string disputed_patches(bool agreed, std::span<const std::string> disputed) {
    if (agreed) return "";
    return fmt::format("exact_agreement ({})", fmt::join(disputed, "; "));
}

}  // namespace meniscus::cli

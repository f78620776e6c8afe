// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/vertex_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "meniscus/errors.h"
#include "reading/lower_case.h"
#include "reading/numbers.h"

namespace meniscus {
namespace {

/// Vertex arrays of surfaces, which docs/conventions.md lists.
constexpr std::array<std::string_view, 19> kTaken{
    "x",          "y",   "z",     "nx",   "ny",    "nz",       "atom", "residue",        "patch",
    "component",  "red", "green", "blue", "alpha", "vertices", "area", "mean_curvature", "gaussian_curvature",
    "shape_index"};

bool may_begin_name(char c) { return reading::is_letter(c) || c == '_'; }
bool may_be_in_name(char c) { return may_begin_name(c) || reading::is_digit(c); }

std::vector<Vec3> places(const Mesh& mesh, double offset) {
    std::vector<Vec3> points = mesh.vertices;
    if (offset == 0.0) return points;
    if (mesh.normals.size() != points.size()) throw UsageError("an offset needs a mesh with normals");
    for (std::size_t v = 0; v < points.size(); ++v) points[v] += offset * mesh.normals[v];
    return points;
}

std::vector<float> to_single(const std::vector<double>& values) { return {values.begin(), values.end()}; }

}  // namespace

bool is_value_name(const std::string& name) {
    if (name.empty() || !may_begin_name(name.front())) return false;
    if (!std::all_of(name.begin(), name.end(), may_be_in_name)) return false;
    return std::find(kTaken.begin(), kTaken.end(), lower_case(name)) == kTaken.end();
}

VertexValues values_at_vertices(const Mesh& mesh, const AtomValues& values) {
    if (mesh.atoms.size() != mesh.vertices.size()) throw UsageError("values of atoms need a mesh that names atoms");
    VertexValues result{values.name, {}};
    result.values.reserve(mesh.atoms.size());
    for (const std::uint32_t atom : mesh.atoms) {
        if (atom >= values.of_atom.size())
            throw UsageError("the mesh names an atom that '" + values.name + "' has no value for");
        result.values.push_back(static_cast<float>(values.of_atom[atom]));
    }
    return result;
}

std::optional<AtomValues> values_of_scheme(ColourScheme scheme, const Structure& structure) {
    if (scheme != ColourScheme::BFactor && scheme != ColourScheme::Plddt) return std::nullopt;
    AtomValues values{scheme == ColourScheme::BFactor ? "bfactor" : "plddt", {}};
    values.of_atom.reserve(structure.labels.size());
    for (const AtomLabel& label : structure.labels) values.of_atom.push_back(label.b_factor);
    return values;
}

VertexValues sample_volume(const Mesh& mesh, const std::string& name, const Volume& volume,
                           const SampleVolumeOptions& options) {
    if (!std::isfinite(options.offset)) throw UsageError("an offset must be a finite number of Å");
    return {name, to_single(interpolate(volume, places(mesh, options.offset), options.interpolation))};
}

const VertexValues& values_named(const Mesh& mesh, const std::string& name) {
    const auto found =
        std::find_if(mesh.values.begin(), mesh.values.end(), [&](const VertexValues& v) { return v.name == name; });
    if (found != mesh.values.end()) return *found;
    std::string known;
    for (const VertexValues& v : mesh.values) known.append(known.empty() ? "" : ", ").append(v.name);
    throw UsageError("there are no values '" + name + "'" + (known.empty() ? "" : "; there are " + known));
}

ValueRange range_of(const VertexValues& values) {
    double low = 0.0;
    double high = 0.0;
    bool any = false;
    for (const float value : values.values) {
        if (!std::isfinite(value)) continue;
        low = any ? std::min(low, double{value}) : double{value};
        high = any ? std::max(high, double{value}) : double{value};
        any = true;
    }
    if (!any) return {};
    if (low < 0.0 && high > 0.0) return {-std::max(-low, high), std::max(-low, high)};
    return {low, high};
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/surface_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus::dropins {
namespace {

/// Centres of the components' areas, from shares of vertices.
std::vector<Vec3> centres_of(const Mesh& mesh, std::size_t components) {
    std::vector<Vec3> sums(components);
    std::vector<double> areas(components, 0.0);
    for (const Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3& b = mesh.vertices[t[1]];
        const Vec3& c = mesh.vertices[t[2]];
        const double area = 0.5 * norm(cross(b - a, c - a));
        const std::uint32_t component = mesh.components[t[0]];
        sums[component] += (area / 3.0) * (a + b + c);
        areas[component] += area;
    }
    for (std::size_t c = 0; c < components; ++c)
        if (areas[c] > 0.0) sums[c] = (1.0 / areas[c]) * sums[c];
    return sums;
}

/// How unlike a piece of a mesh is to an exact component, Å².
double difference(const MeshComponent& piece, const Vec3& centre, const SurfaceComponent& exact) {
    const double sizes = std::cbrt(std::abs(piece.volume)) - std::cbrt(exact.ses_volume);
    return squared_norm(centre - exact.centre) + sizes * sizes;
}

bool touched_by_all(const SurfaceComponent& component, std::span<const std::uint32_t> atoms) {
    return std::all_of(atoms.begin(), atoms.end(), [&](std::uint32_t atom) {
        return std::binary_search(component.atoms.begin(), component.atoms.end(), atom);
    });
}

}  // namespace

Mesh piece_of(const Mesh& mesh, std::uint32_t component) {
    Mesh piece;
    std::vector<VertexId> number(mesh.vertices.size(), 0);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (mesh.components[v] != component) continue;
        number[v] = static_cast<VertexId>(piece.vertices.size());
        piece.vertices.push_back(mesh.vertices[v]);
        piece.normals.push_back(mesh.normals[v]);
        piece.atoms.push_back(mesh.atoms[v]);
        piece.patches.push_back(mesh.patches[v]);
    }
    for (const Triangle& t : mesh.triangles)
        if (mesh.components[t[0]] == component) piece.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    return piece;
}

std::vector<std::uint32_t> match_components(const Mesh& mesh, const MeshMeasures& measured,
                                            std::span<const SurfaceComponent> exact) {
    const std::vector<Vec3> centres = centres_of(mesh, measured.components.size());
    std::vector<bool> taken(exact.size(), false);
    std::vector<std::uint32_t> matches;
    for (std::size_t piece = 0; piece < measured.components.size(); ++piece) {
        const bool is_outer = measured.components[piece].volume > 0.0;
        std::uint32_t best = kNone;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t c = 0; c < exact.size(); ++c) {
            if (taken[c] || (exact[c].kind == ComponentKind::Outer) != is_outer) continue;
            const double unlike = difference(measured.components[piece], centres[piece], exact[c]);
            if (unlike < least) best = static_cast<std::uint32_t>(c);
            least = std::min(least, unlike);
        }
        if (best != kNone) taken[best] = true;
        matches.push_back(best);
    }
    return matches;
}

std::uint32_t component_touching(std::span<const SurfaceComponent> components, std::span<const std::uint32_t> atoms) {
    std::uint32_t outer = kNone;
    for (std::size_t c = 0; c < components.size(); ++c) {
        if (!touched_by_all(components[c], atoms)) continue;
        if (components[c].kind == ComponentKind::Cavity) return static_cast<std::uint32_t>(c);
        if (outer == kNone) outer = static_cast<std::uint32_t>(c);
    }
    return outer;
}

std::vector<AtomShare> shares_of_atoms(const Measures& measures, std::uint32_t component) {
    std::vector<AtomShare> shares(measures.atoms.size());
    for (const PatchMeasure& patch : measures.patches) {
        if (patch.component != component) continue;
        const auto others =
            std::count_if(patch.atoms.begin() + 1, patch.atoms.end(), [](std::uint32_t atom) { return atom != kNone; });
        shares[patch.atoms[0]].ses += patch.first_share;
        shares[patch.atoms[0]].sas += patch.sas_area;
        for (std::size_t i = 1; i < patch.atoms.size(); ++i)
            if (patch.atoms[i] != kNone)
                shares[patch.atoms[i]].ses += (patch.ses_area - patch.first_share) / static_cast<double>(others);
    }
    return shares;
}

}  // namespace meniscus::dropins

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/ligand_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/perpendicular.h"

namespace meniscus {
namespace {

constexpr double kBallRadius = 0.42;
constexpr double kHydrogenRadius = 0.27;
constexpr double kMetalRadius = 0.65;

/// Sides of sticks and how often the triangles of an icosahedron are divided for balls: round at any size of pictures.
constexpr VertexId kSides = 16;
constexpr int kDivisions = 2;

/// A ball of radius 1; the places are the normals.
struct Ball {
    std::vector<Vec3> places;
    std::vector<Triangle> triangles;
};

Ball icosahedron() {
    const double g = std::numbers::phi;
    Ball ball;
    for (const double s : {-1.0, 1.0})
        for (const double t : {-g, g})
            for (const Vec3& p : {Vec3{0.0, s, t}, Vec3{s, t, 0.0}, Vec3{t, 0.0, s}})
                ball.places.push_back(normalised(p));
    const auto near = [&](VertexId a, VertexId b) { return dot(ball.places[a], ball.places[b]) > 0.4; };
    for (VertexId a = 0; a < 12; ++a)
        for (VertexId b = a + 1; b < 12; ++b)
            for (VertexId c = b + 1; c < 12; ++c) {
                if (!near(a, b) || !near(b, c) || !near(a, c)) continue;
                const bool turns_out = dot(ball.places[a], cross(ball.places[b], ball.places[c])) > 0.0;
                ball.triangles.push_back(turns_out ? Triangle{a, b, c} : Triangle{a, c, b});
            }
    return ball;
}

Ball divided(const Ball& ball) {
    Ball finer{ball.places, {}};
    std::map<std::pair<VertexId, VertexId>, VertexId> middles;
    const auto middle = [&](VertexId a, VertexId b) {
        const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<VertexId>(finer.places.size()));
        if (is_new) finer.places.push_back(normalised(finer.places[a] + finer.places[b]));
        return found->second;
    };
    for (const auto& [a, b, c] : ball.triangles) {
        const VertexId ab = middle(a, b);
        const VertexId bc = middle(b, c);
        const VertexId ca = middle(c, a);
        for (const Triangle& t : {Triangle{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
            finer.triangles.push_back(t);
    }
    return finer;
}

Ball make_ball() {
    Ball ball = icosahedron();
    for (int i = 0; i < kDivisions; ++i) ball = divided(ball);
    return ball;
}

class Builder {
public:
    Builder(const Ligands& ligands, std::span<const Colour> colours) : ligands_(ligands), colours_(colours) {}

    void add_ball(std::uint32_t atom) {
        const auto first = static_cast<VertexId>(bodies_.mesh.vertices.size());
        const double radius = ball_radius(ligands_.labels[atom]);
        for (const Vec3& place : ball_.places) add_vertex(atom, ligands_.centres[atom] + radius * place, place);
        for (const auto& [a, b, c] : ball_.triangles)
            bodies_.mesh.triangles.push_back({first + a, first + b, first + c});
    }

    /// From an atom halfway to another; its ends are not closed: one lies in a ball, the other at the other half.
    void add_half_stick(std::uint32_t atom, std::uint32_t other) {
        const auto first = static_cast<VertexId>(bodies_.mesh.vertices.size());
        const Vec3& start = ligands_.centres[atom];
        const Vec3 half = 0.5 * (ligands_.centres[other] - start);
        const Vec3 axis = normalised(half);
        const Vec3 x = perpendicular(axis);
        const Vec3 y = cross(axis, x);
        for (VertexId side = 0; side < kSides; ++side) {
            const double turn = 2.0 * std::numbers::pi * side / kSides;
            const Vec3 out = std::cos(turn) * x + std::sin(turn) * y;
            add_vertex(atom, start + kStickRadius * out, out);
            add_vertex(atom, start + half + kStickRadius * out, out);
        }
        for (VertexId side = 0; side < kSides; ++side) {
            const VertexId a = first + 2 * side;
            const VertexId b = first + 2 * ((side + 1) % kSides);
            bodies_.mesh.triangles.push_back({a, b, a + 1});
            bodies_.mesh.triangles.push_back({b, b + 1, a + 1});
        }
    }

    Bodies take() { return std::move(bodies_); }

private:
    void add_vertex(std::uint32_t atom, const Vec3& place, const Vec3& normal) {
        bodies_.mesh.vertices.push_back(place);
        bodies_.mesh.normals.push_back(to_small(normal));
        bodies_.mesh.components.push_back(ligands_.labels[atom].residue);
        bodies_.colours.push_back(colours_[atom]);
    }

    const Ligands& ligands_;
    std::span<const Colour> colours_;
    const Ball ball_ = make_ball();
    Bodies bodies_;
};

bool is_one_of(const std::string& element, std::initializer_list<const char*> symbols) {
    return std::find(symbols.begin(), symbols.end(), element) != symbols.end();
}

}  // namespace

double ball_radius(const AtomLabel& atom) {
    if (is_one_of(atom.element, {"H", "D"})) return kHydrogenRadius;
    const bool metal =
        is_one_of(atom.element, {"LI", "NA", "MG", "K",  "CA", "V",  "CR", "MN", "FE", "CO", "NI", "CU", "ZN",
                                 "MO", "RU", "RH", "PD", "AG", "CD", "W",  "RE", "OS", "IR", "PT", "AU", "HG"});
    return metal ? kMetalRadius : kBallRadius;
}

Bodies ligand_bodies(const Ligands& ligands, const Mesh& mesh, std::span<const Colour> colours) {
    if (ligands.in_surface) return {};
    const Ligands near = ligands_near(ligands, mesh);
    const std::vector<Colour> colours_of_atoms = ligand_colours(near, colours);
    Builder builder(near, colours_of_atoms);
    for (std::uint32_t atom = 0; atom < near.centres.size(); ++atom) builder.add_ball(atom);
    for (const auto& [a, b] : near.bonds) {
        builder.add_half_stick(a, b);
        builder.add_half_stick(b, a);
    }
    return builder.take();
}

}  // namespace meniscus

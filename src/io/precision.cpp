// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/precision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "core/parallel.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

// Neighbouring floats are 2^-13 = 1.2e-4 Å apart from here on.
constexpr double kFarOff = 1024.0;

// Å: nearer to the origin than that, points that round to the same one are less than 3e-4 apart.
constexpr double kTooLongToVanish = 1e-3;

constexpr std::size_t kItemsPerChunk = 1U << 14U;

double reach(const Vec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

bool coincide_when_rounded(const Vec3& a, const Vec3& b) {
    const auto rounded = [](double x) { return static_cast<float>(x); };
    return rounded(a.x) == rounded(b.x) && rounded(a.y) == rounded(b.y) && rounded(a.z) == rounded(b.z);
}

bool collapses_when_rounded(const Mesh& mesh, const Triangle& triangle) {
    const Vec3& a = mesh.vertices[triangle[0]];
    const Vec3& b = mesh.vertices[triangle[1]];
    const Vec3& c = mesh.vertices[triangle[2]];
    return coincide_when_rounded(a, b) || coincide_when_rounded(b, c) || coincide_when_rounded(c, a);
}

template <class Real>
void write_rounded(AtomicFile& file, const Vec3& p) {
    file.number(static_cast<Real>(p.x));
    file.write(' ');
    file.number(static_cast<Real>(p.y));
    file.write(' ');
    file.number(static_cast<Real>(p.z));
}

// Of all vertices: corners that lie apart already in x are told apart without their places, which take six times the
// memory.
std::unique_ptr<const float[]> rounded_x(const Mesh& mesh) {
    std::unique_ptr<float[]> x(new float[mesh.vertices.size()]);
    parallel_for(mesh.vertices.size(), kItemsPerChunk,
                 [&](std::size_t v) { x[v] = static_cast<float>(mesh.vertices[v].x); });
    return x;
}

}  // namespace

void require_single_precision(const Mesh& mesh, const std::string& path) {
    constexpr double kTooFarOff = 1U << 17U;
    constexpr double kFarthest = std::numeric_limits<float>::max();  // beyond that the formats have no numbers
    const auto is_rounded = [](const Vec3& p) { return reach(p) >= kTooFarOff && reach(p) <= kFarthest; };
    if (parallel_any_of(mesh.vertices, is_rounded))
        throw LimitError(path +
                         ": this format has single precision, which is too coarse so far from the origin; write .ply, "
                         "or move the atoms nearer to the origin");
}

Precision precision_needed(const Mesh& mesh, double shortest_edge) {
    if (parallel_any_of(mesh.vertices, [](const Vec3& p) { return reach(p) >= kFarOff; })) return Precision::Double;
    if (shortest_edge > kTooLongToVanish) return Precision::Single;
    const std::unique_ptr<const float[]> x = rounded_x(mesh);
    const auto same_x = [&x](VertexId a, VertexId b) { return static_cast<unsigned>(x[a] == x[b]); };
    const bool collapses = parallel_any_of(mesh.triangles, [&](const Triangle& t) {
        return (same_x(t[0], t[1]) | same_x(t[1], t[2]) | same_x(t[2], t[0])) != 0 && collapses_when_rounded(mesh, t);
    });
    return collapses ? Precision::Double : Precision::Single;
}

void write_point(AtomicFile& file, const Vec3& point, Precision precision) {
    if (precision == Precision::Single)
        write_rounded<float>(file, point);
    else
        write_rounded<double>(file, point);
}

}  // namespace meniscus

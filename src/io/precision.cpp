// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/precision.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace meniscus {
namespace {

// Neighbouring floats are 2^-13 = 1.2e-4 Å apart from here on.
constexpr double kFarOff = 1024.0;

bool is_far_off(const Vec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) >= kFarOff; }

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

}  // namespace

Precision precision_needed(const Mesh& mesh) {
    const bool single_is_enough = std::none_of(mesh.vertices.begin(), mesh.vertices.end(), is_far_off) &&
                                  std::none_of(mesh.triangles.begin(), mesh.triangles.end(),
                                               [&](const Triangle& t) { return collapses_when_rounded(mesh, t); });
    return single_is_enough ? Precision::Single : Precision::Double;
}

void write_point(AtomicFile& file, const Vec3& point, Precision precision) {
    if (precision == Precision::Single)
        write_rounded<float>(file, point);
    else
        write_rounded<double>(file, point);
}

}  // namespace meniscus

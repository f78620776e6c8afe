// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/view_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "meniscus/errors.h"

namespace meniscus {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix kIdentity{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

/// Directions closer than this sine count as parallel.
constexpr double kSmallestSine = 1e-6;

Vec3 unit_vector(const Vec3& v) {
    const double length = norm(v);
    if (!std::isfinite(length) || length == 0.0)
        throw UsageError("a viewpoint needs vectors that are finite and not zero");
    return (1.0 / length) * v;
}

Vec3 mean_of(std::span<const Vec3> points) {
    Vec3 sum;
    for (const Vec3& p : points) sum += p;
    return (1.0 / static_cast<double>(std::max<std::size_t>(points.size(), 1))) * sum;
}

Matrix second_moments(std::span<const Vec3> points, const Vec3& centre) {
    Matrix m{};
    for (const Vec3& p : points) {
        const std::array d{p.x - centre.x, p.y - centre.y, p.z - centre.z};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) m[i][j] += d[i] * d[j];
    }
    return m;
}

/// The rotation of axes p and q after which the element (p, q) of a symmetric matrix vanishes.
struct Rotation {
    Rotation(const Matrix& m, std::size_t p, std::size_t q) {
        const double slope = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
        const double tangent = std::copysign(1.0, slope) / (std::abs(slope) + std::hypot(slope, 1.0));
        cosine = 1.0 / std::hypot(tangent, 1.0);
        sine = tangent * cosine;
    }
    void turn(double& a, double& b) const {
        const double old = a;
        a = cosine * old - sine * b;
        b = sine * old + cosine * b;
    }

    double cosine;
    double sine;
};

/// Eigenvectors of a symmetric matrix as rows, by falling eigenvalue (Jacobi's method).
std::array<Vec3, 3> principal_axes(Matrix m) {
    constexpr int kSweeps = 12;  // converges quadratically; five are usual
    Matrix axes = kIdentity;
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
            if (m[p][q] == 0.0) continue;
            const Rotation rotation(m, p, q);
            for (std::size_t k = 0; k < 3; ++k) rotation.turn(m[k][p], m[k][q]);
            for (std::size_t k = 0; k < 3; ++k) rotation.turn(m[p][k], m[q][k]);
            for (std::size_t k = 0; k < 3; ++k) rotation.turn(axes[p][k], axes[q][k]);
        }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return m[a][a] > m[b][b]; });
    std::array<Vec3, 3> sorted;
    for (std::size_t i = 0; i < 3; ++i) sorted[i] = {axes[order[i]][0], axes[order[i]][1], axes[order[i]][2]};
    return sorted;
}

/// `axis` or its opposite, to the side where the points reach farther.
Vec3 towards_the_tail(std::span<const Vec3> points, const Vec3& centre, const Vec3& axis) {
    double third_moment = 0.0;
    for (const Vec3& p : points) {
        const double along = dot(p - centre, axis);
        third_moment += along * along * along;
    }
    return third_moment < 0.0 ? -axis : axis;
}

}  // namespace

ViewFrame frame_of(const Viewpoint& viewpoint) {
    const Vec3 towards = unit_vector(viewpoint.from);
    const Vec3 right = cross(unit_vector(viewpoint.up), towards);
    if (norm(right) < kSmallestSine) throw UsageError("a viewpoint cannot look along the direction that points up");
    return {normalised(right), cross(towards, normalised(right)), towards};
}

ViewFrame principal_frame(std::span<const Vec3> points) {
    const Vec3 centre = mean_of(points);
    const std::array<Vec3, 3> axes = principal_axes(second_moments(points, centre));
    const Vec3 up = towards_the_tail(points, centre, axes[1]);
    return frame_of({.from = towards_the_tail(points, centre, axes[2]), .up = up});
}

}  // namespace meniscus

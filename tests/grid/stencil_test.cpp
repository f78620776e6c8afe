// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/stencil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/sampled_field.h"
#include "support/spline_of.h"

namespace meniscus::testing {
namespace {

using Padded = std::vector<float>;

// Samples f at the nodes of one block and one layer around it.
template <class Function>
Padded padded_samples(double spacing, const Function& f) {
    Padded padded;
    for (int z = -1; z <= kBlockEdge; ++z)
        for (int y = -1; y <= kBlockEdge; ++y)
            for (int x = -1; x <= kBlockEdge; ++x)
                padded.push_back(static_cast<float>(f(spacing * Vec3{1.0 * x, 1.0 * y, 1.0 * z})));
    return padded;
}

// Largest |stencil(f) - expected| over the block.
template <class Function, class Expected>
double worst_error(const Stencil& stencil, double spacing, const Function& f, const Expected& expected) {
    const std::vector<float> result = with_stencil(stencil, padded_samples(spacing, f));
    double worst = 0.0;
    for (int z = 0; z < kBlockEdge; ++z)
        for (int y = 0; y < kBlockEdge; ++y)
            for (int x = 0; x < kBlockEdge; ++x) {
                const double value = result[static_cast<std::size_t>(node_in_block(x, y, z))];
                const Vec3 p = spacing * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
                worst = std::max(worst, std::abs(value - expected(p)));
            }
    return worst;
}

TEST(Stencil, ValuesOfASplineSumToOneAndItsLaplacianToZero) {
    const auto total = [](const Stencil& s) { return s.centre + 6 * s.face + 12 * s.edge + 8 * s.corner; };
    EXPECT_NEAR(total(spline_value()), 1.0, 1e-15);
    EXPECT_NEAR(total(spline_quasi_interpolant()), 1.0, 1e-15);
    EXPECT_NEAR(total(spline_laplacian(0.25)), 0.0, 1e-13);
}

TEST(Stencil, LaplacianIsTheTensorOfValueAndSecondDerivative) {
    const double h = 0.3;
    const double value[2] = {4.0 / 6.0, 1.0 / 6.0};
    const double second[2] = {-2.0 / (h * h), 1.0 / (h * h)};
    const auto entry = [&](int i, int j, int k) {
        return second[i] * value[j] * value[k] + value[i] * second[j] * value[k] + value[i] * value[j] * second[k];
    };
    const Stencil laplacian = spline_laplacian(h);
    EXPECT_NEAR(laplacian.centre, entry(0, 0, 0), 1e-12);
    EXPECT_NEAR(laplacian.face, entry(1, 0, 0), 1e-12);
    EXPECT_NEAR(laplacian.edge, entry(1, 1, 0), 1e-12);
    EXPECT_NEAR(laplacian.corner, entry(1, 1, 1), 1e-12);
}

TEST(Stencil, LaplacianOfAQuadraticIsExact) {
    const auto f = [](const Vec3& p) {
        return 0.3 * p.x * p.x - 0.2 * p.y * p.y + 0.7 * p.z * p.z + 0.4 * p.x * p.y - 0.1 * p.y * p.z + p.x - 0.5;
    };
    EXPECT_LT(worst_error(spline_laplacian(0.5), 0.5, f, [](const Vec3&) { return 1.6; }), 1e-4);
}

TEST(Stencil, ValueOfASplineReproducesPlanes) {
    const auto plane = [](const Vec3& p) { return 0.3 * p.x - 0.8 * p.y + 0.5 * p.z + 0.1; };
    EXPECT_LT(worst_error(spline_value(), 0.25, plane, plane), 1e-6);
    EXPECT_LT(worst_error(spline_quasi_interpolant(), 0.25, plane, plane), 1e-6);
}

// B Q = 1 to fourth order: what makes the quasi-interpolant a stand-in for the inverse of B.
TEST(Stencil, QuasiInterpolantIsOfFourthOrder) {
    const auto wave = [](const Vec3& p) { return std::sin(p.x) * std::cos(0.8 * p.y) + std::sin(1.2 * p.z); };
    const auto error = [&](double h) {
        const Vec3 size{4, 4, 4};
        const LevelSet spline = spline_of(h, {}, size, wave);
        double worst = 0.0;
        for (double t = 0.0; t < 4.0; t += 0.37) {
            const Vec3 p{std::floor(t / h) * h, std::floor((4 - t) / h) * h, std::floor(0.5 * t / h) * h};
            worst = std::max(worst, std::abs(spline.value(p) - wave(p)));
        }
        return worst;
    };
    const double coarse = error(0.5);
    const double fine = error(0.25);
    EXPECT_GT(std::log2(coarse / fine), 3.6);
    EXPECT_LT(fine, 1e-3);
}

TEST(Stencil, QuasiInterpolantReproducesCubics) {
    const auto cubic = [](const Vec3& p) { return p.x * p.x * p.x - p.x * p.y * p.z + p.y * p.y - p.z; };
    const LevelSet spline = spline_of(0.5, {-1, -1, -1}, {1, 1, 1}, cubic);
    for (const Vec3 p : {Vec3{0.5, -0.5, 0}, Vec3{-1, 1, 0.5}, Vec3{0.13, -0.72, 0.91}, Vec3{0.99, 0.01, -0.33}})
        EXPECT_NEAR(spline.value(p), cubic(p), 5e-6);
}

constexpr Stencil kSteady = 16.0 * spline_value() - spline_laplacian(1.0);  // what the default flow solves

TEST(Stencil, SymbolIsTheFactorOfAWave) {
    const Vec3 turn{0.3, 1.1, 2.6};  // per node
    const auto wave = [&](const Vec3& p) { return std::cos(dot(turn, p) + 0.4); };
    const double factor = symbol_of(kSteady, std::cos(turn.x), std::cos(turn.y), std::cos(turn.z));
    EXPECT_LT(worst_error(kSteady, 1.0, wave, [&](const Vec3& p) { return factor * wave(p); }), 1e-4);
}

TEST(Stencil, ApproximateInverseIsExactAtItsWaves) {
    const double q = std::sqrt(0.5);
    const Stencil inverse = approximate_inverse(kSteady);
    for (const Vec3 c : {Vec3{q, q, q}, Vec3{q, -q, q}, Vec3{-q, q, -q}, Vec3{-q, -q, -q}})
        EXPECT_NEAR(symbol_of(inverse, c.x, c.y, c.z) * symbol_of(kSteady, c.x, c.y, c.z), 1.0, 1e-12);
}

// The bounds are those of 27 waves; any other exceeds them by little.
TEST(Stencil, RangeOfAProductBoundsAllWaves) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> cosine(-1.0, 1.0);
    for (const Stencil& stencil : {kSteady, spline_value(), spline_value() - spline_laplacian(1.0)}) {
        const Stencil inverse = approximate_inverse(stencil);
        const Range range = range_of_product(stencil, inverse);
        EXPECT_GT(range.least, 0.6);
        EXPECT_LT(range.greatest, 1.5);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 c{cosine(random), cosine(random), cosine(random)};
            const double product = symbol_of(stencil, c.x, c.y, c.z) * symbol_of(inverse, c.x, c.y, c.z);
            EXPECT_GT(product, range.least - 0.02);
            EXPECT_LT(product, range.greatest + 0.02);
        }
    }
}

}  // namespace
}  // namespace meniscus::testing

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/density_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace meniscus::testing {
namespace {

constexpr double kRelative = 4.0 * std::numeric_limits<double>::epsilon();

SphereList random_spheres(int count) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> within(-6.0, 6.0);
    SphereList list;
    for (int i = 0; i < count; ++i) list.add({within(random), within(random), within(random), 1.5 + 0.01 * i}, 0);
    return list;
}

struct Bounds {
    std::vector<std::uint64_t> within;
    std::vector<double> largest;
    std::vector<double> least;
};
Bounds bound(const DensityKernels& kernels, const SphereList& atoms, const Box& box, double c, double reach) {
    const std::size_t room = atoms.padded_size();
    Bounds bounds{std::vector<std::uint64_t>(words_for(atoms.size()), ~std::uint64_t{0}), std::vector<double>(room),
                  std::vector<double>(room)};
    kernels.bound_terms(atoms, box, c, reach, bounds.within.data(), bounds.largest.data(), bounds.least.data());
    bounds.largest.resize(atoms.size());
    bounds.least.resize(atoms.size());
    return bounds;
}

double largest_over(const Box& box, const Vec3& centre) {
    const auto far = [](double low, double high, double x) { return std::max(x - low, high - x); };
    return squared_norm({far(box.low.x, box.high.x, centre.x), far(box.low.y, box.high.y, centre.y),
                         far(box.low.z, box.high.z, centre.z)});
}

TEST(DensityKernels, BoundTermsByTheNearestAndTheFarthestPoint) {
    const SphereList atoms = random_spheres(61);
    const Box box{{-1.0, -2.0, 0.5}, {2.0, 0.0, 1.5}};
    const double reach = 4.0;
    for (const double c : {-0.5, -3.0}) {
        const Bounds found = bound(supported_density_kernels().front(), atoms, box, c, reach);
        int near = 0;
        for (std::size_t i = 0; i < atoms.size(); ++i) {
            const Vec3 centre = position_in(atoms, i);
            const double r2 = atoms.column(3)[i] * atoms.column(3)[i];
            const double d2 = box.squared_distance(centre);
            EXPECT_EQ((found.within[i / 64] >> i % 64 & 1U) != 0, d2 < reach * reach);
            near += d2 < reach * reach ? 1 : 0;
            const double largest = d2 < reach * reach ? std::exp(c * (d2 - r2)) : 0.0;
            const double least = d2 < reach * reach ? std::exp(c * (largest_over(box, centre) - r2)) : 0.0;
            EXPECT_NEAR(found.largest[i], largest, kRelative * largest);
            EXPECT_NEAR(found.least[i], least, kRelative * least);
        }
        EXPECT_GT(near, 10);
        EXPECT_LT(near, 60);
    }
}

TEST(DensityKernels, NeitherOverflowNorUnderflow) {
    SphereList atoms;
    atoms.add({0, 0, 0, 100.0}, 0);
    atoms.add({90, 0, 0, 1.0}, 1);
    for (const DensityKernels& kernels : supported_density_kernels()) {
        const Bounds found = bound(kernels, atoms, {{0, 0, 0}, {1, 1, 1}}, -1.0, 1e3);
        EXPECT_NEAR(found.largest[0], std::exp(700.0), 1e-12 * std::exp(700.0));
        EXPECT_EQ(found.largest[1], 0.0);
    }
}

TEST(DensityKernels, TermsAreExponentialsAtTheNodes) {
    const double c = -0.7;
    const double radius = 1.6;
    const double spacing = 0.3;
    for (const Vec3& from : {Vec3{-1.0, 0.4, -3.3}, Vec3{2.0, -0.2, -2.5}, Vec3{-40.0, 1.0, 1.0}}) {
        const double unit = 1.5;
        AxisProduct terms;
        supported_density_kernels().front().find_terms(c, radius, from, spacing, unit, terms);
        for (int z = 0; z < kBlockEdge; ++z)
            for (int y = 0; y < kBlockEdge; ++y)
                for (int x = 0; x < kBlockEdge; ++x) {
                    const Vec3 at = from + spacing * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
                    const double term = std::exp(c * (squared_norm(at) - radius * radius) - unit);
                    EXPECT_NEAR(terms.x[x] * terms.y[y] * terms.z[z], term, 1e-12 * term + 1e-300);
                }
    }
}

TEST(DensityKernels, ValuesAreLogarithmsWithinTheMargin) {
    const DensityLimits limits{.unit = 2.5, .per_length = 1.7, .margin = 3.0, .most = 20.0, .least = 1e-3};
    std::vector<double> sums(kBlockNodes, 1.0);
    for (std::size_t n = 0; n + 4 < sums.size(); ++n) sums[n] = 2e-4 * std::pow(1.026, static_cast<double>(n));
    sums[sums.size() - 1] = 0.0;
    sums[sums.size() - 2] = std::numeric_limits<double>::infinity();
    sums[sums.size() - 3] = std::sqrt(0.5);
    for (const DensityKernels& kernels : supported_density_kernels()) {
        std::vector<float> values(kBlockNodes);
        kernels.find_values(limits, sums.data(), values.data());
        for (std::size_t n = 0; n < sums.size(); ++n) {
            double value = std::clamp(-(2.5 + std::log(sums[n])) / 1.7, -3.0, 3.0);
            if (sums[n] >= limits.most) value = -3.0;
            if (sums[n] <= limits.least) value = 3.0;
            EXPECT_NEAR(values[n], value, 3e-7) << kernels.instructions << ' ' << sums[n];
        }
    }
}

// All the way from the smallest to the largest numbers.
TEST(DensityKernels, LogarithmsAreThoseOfAllNumbers) {
    std::vector<double> sums(kBlockNodes);
    for (std::size_t n = 0; n < sums.size(); ++n)
        sums[n] = std::ldexp(1.0 + 0.9 * std::sin(static_cast<double>(n)) * std::sin(static_cast<double>(n)),
                             static_cast<int>(4 * n) - 1022);
    const double largest = std::numeric_limits<double>::max();
    const DensityLimits limits{.unit = 0.0, .per_length = -1.0, .margin = 1e3, .most = largest, .least = 0x1p-1022};
    std::vector<float> plain(kBlockNodes);
    supported_density_kernels().front().find_values(limits, sums.data(), plain.data());
    for (std::size_t n = 1; n < sums.size(); ++n) EXPECT_EQ(plain[n], static_cast<float>(std::log(sums[n]))) << n;
    for (const DensityKernels& kernels : supported_density_kernels()) {
        std::vector<float> values(kBlockNodes);
        kernels.find_values(limits, sums.data(), values.data());
        EXPECT_EQ(values, plain) << kernels.instructions;
    }
}

TEST(DensityKernels, AllInstructionsGiveTheSameBits) {
    const SphereList atoms = random_spheres(53);
    const std::vector<DensityKernels> all = supported_density_kernels();
    const Box box{{-1.0, -2.0, 0.5}, {2.0, 0.0, 1.5}};
    const Bounds plain = bound(all.front(), atoms, box, -0.5, 5.0);
    AxisProduct expected;
    all.front().find_terms(-0.5, 1.7, {-1.0, 0.4, -3.3}, 0.25, 0.5, expected);
    for (const DensityKernels& kernels : all) {
        const Bounds found = bound(kernels, atoms, box, -0.5, 5.0);
        EXPECT_EQ(found.within, plain.within);
        EXPECT_EQ(found.largest, plain.largest);
        EXPECT_EQ(found.least, plain.least);
        AxisProduct terms;
        kernels.find_terms(-0.5, 1.7, {-1.0, 0.4, -3.3}, 0.25, 0.5, terms);
        for (int n = 0; n < kBlockEdge; ++n) {
            EXPECT_EQ(terms.x[n], expected.x[n]);
            EXPECT_EQ(terms.y[n], expected.y[n]);
            EXPECT_EQ(terms.z[n], expected.z[n]);
        }
    }
}

}  // namespace
}  // namespace meniscus::testing

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// All kernels against the functions of single vertices.
#include "project/shape_kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "meniscus/curvature.h"

namespace meniscus::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLimit = 2.0;  // Å^-1

std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }

void expect_same(double a, double b) { EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << a << " " << b; }

TEST(ShapeKernels, HaveTheBitsOfSamples) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> number;
    std::array<SplineProjection, kBatchLanes> projections;
    for (SplineProjection& projection : projections) {
        LevelSetSample& at = projection.sample;
        at.gradient = {number(random), number(random), number(random)};
        for (double& h : at.hessian) h = number(random);
    }
    projections[5].sample.gradient = {};
    for (const ShapeKernels& kernels : supported_shape_kernels())
        for (const std::size_t count : {std::size_t{1}, std::size_t{7}, kBatchLanes}) {
            ShapeLanes lanes;
            kernels.of_projections(projections, count, lanes);
            for (std::size_t i = 0; i < count; ++i) {
                const LevelSetSample& at = projections[i].sample;
                const Vec3 normal = i == 5 ? Vec3{0.0, 0.0, 1.0} : normalised(at.gradient);
                EXPECT_EQ(normal, (Vec3{lanes.normals.x[i], lanes.normals.y[i], lanes.normals.z[i]}));
                expect_same(lanes.mean[i], at.mean_curvature());
                expect_same(lanes.gaussian[i], at.gaussian_curvature());
            }
        }
}

TEST(ShapeKernels, CapWhatPrincipalCurvaturesAre) {
    std::mt19937_64 random(4);
    std::normal_distribution<double> number;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::pair<double, double>> given{{0.0, 0.0},
                                                 {0.5, 0.25},
                                                 {-0.5, 0.25},
                                                 {0.0, -1.0},
                                                 {0.7, kInfinity},
                                                 {-0.7, kInfinity},
                                                 {0.0, kInfinity},
                                                 {kInfinity, 3.0},
                                                 {-kInfinity, 3.0},
                                                 {nan, 1.0},
                                                 {1.0, nan},
                                                 {kInfinity, kInfinity},
                                                 {-kInfinity, -kInfinity},
                                                 {kInfinity, nan},
                                                 {1e-200, 0.0},
                                                 {1e200, -1e200},
                                                 {0.5, -kInfinity},
                                                 {0.1, 0.011}};
    while (given.size() < kBatchLanes) given.emplace_back(number(random), number(random));
    for (const ShapeKernels& kernels : supported_shape_kernels()) {
        ShapeLanes lanes;
        for (std::size_t i = 0; i < given.size(); ++i) {
            lanes.mean[i] = given[i].first;
            lanes.gaussian[i] = given[i].second;
        }
        kernels.cap(kLimit, given.size(), lanes);
        for (std::size_t i = 0; i < given.size(); ++i) {
            const auto& [mean, gaussian] = given[i];
            const PrincipalCurvatures k = principal_curvatures(mean, gaussian).capped(kLimit);
            EXPECT_EQ(lanes.capped_mean[i], static_cast<float>(k.mean())) << mean << " " << gaussian;
            EXPECT_EQ(lanes.capped_gaussian[i], static_cast<float>(k.gaussian())) << mean << " " << gaussian;
            EXPECT_NEAR(lanes.shape_index[i], k.shape_index(), 1e-7) << mean << " " << gaussian;
        }
    }
}

TEST(ShapeKernels, AllGiveTheSameBits) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> number;
    ShapeLanes given;
    for (std::size_t i = 0; i < kBatchLanes; ++i) {
        given.mean[i] = number(random);
        given.gaussian[i] = i % 3 == 0 ? kInfinity : number(random);
    }
    const std::vector<ShapeKernels> all = supported_shape_kernels();
    ShapeLanes plain = given;
    all.front().cap(kLimit, kBatchLanes, plain);
    for (const ShapeKernels& kernels : all) {
        ShapeLanes lanes = given;
        kernels.cap(kLimit, kBatchLanes, lanes);
        for (std::size_t i = 0; i < kBatchLanes; ++i) {
            EXPECT_EQ(bits_of(lanes.shape_index[i]), bits_of(plain.shape_index[i])) << kernels.instructions;
            EXPECT_EQ(bits_of(lanes.capped_mean[i]), bits_of(plain.capped_mean[i])) << kernels.instructions;
            EXPECT_EQ(bits_of(lanes.capped_gaussian[i]), bits_of(plain.capped_gaussian[i])) << kernels.instructions;
        }
    }
}

}  // namespace
}  // namespace meniscus::testing

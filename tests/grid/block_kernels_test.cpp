// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/block_kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <span>

#include "simd/instructions.h"
#include "support/sampled_field.h"
#include "support/spline_of.h"

namespace meniscus::testing {
namespace {

using Values = std::array<float, kBlockNodes>;

constexpr float kFill = 0.7F;
constexpr Stencil kStencil{2.1, -0.3, 0.17, 0.05};
constexpr double kNegligible = 0.05;
constexpr CgFactors kFactors{0.37F, 0.61F};

std::vector<float> random_values(std::uint64_t seed, std::size_t size) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> value(-1.0F, 1.0F);
    std::vector<float> values(size);
    for (float& v : values) v = value(random);
    return values;
}

Values random_block(std::uint64_t seed) {
    Values block;
    std::ranges::copy(random_values(seed, kBlockNodes), block.begin());
    return block;
}

// A block with random ones around it, two of them missing.
class Neighbourhood {
public:
    Neighbourhood() : grid_(1.0, {}, without_two(box_of_blocks({-1, -1, -1}, {1, 1, 1}))) {
        field_ = random_values(1, grid_.node_count());
        missing_.fill(kFill);
        const auto& blocks = grid_.neighbours(middle());
        for (std::size_t slot = 0; slot < blocks.size(); ++slot)
            around_[slot] =
                blocks[slot] == kNoBlock ? missing_.data() : &field_[std::size_t{blocks[slot]} * kBlockNodes];
    }

    const BlocksAround& around() const { return around_; }
    const float* own() const { return around_[neighbour_slot(0, 0, 0)]; }

    std::vector<float> by_plain_stencil() const {
        return with_stencil(kStencil, gather_padded<float>(grid_, field_, middle(), kFill));
    }

private:
    static std::vector<BlockCoord> without_two(std::vector<BlockCoord> blocks) {
        std::erase(blocks, BlockCoord{.z = 0, .y = 0, .x = 1});
        std::erase(blocks, BlockCoord{.z = -1, .y = 1, .x = 0});
        return blocks;
    }
    BlockId middle() const { return grid_.find({.z = 0, .y = 0, .x = 0}); }

    BlockGrid grid_;
    std::vector<float> field_;
    Values missing_;
    BlocksAround around_;
};

NodeBits random_set(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    NodeBits set;
    for (std::uint8_t& row : set.rows) row = static_cast<std::uint8_t>(random());
    set.rows[7] = 0;
    set.rows[9] = 0xFF;
    return set;
}

bool in_set(const NodeBits& set, std::size_t node) {
    return ((unsigned{set.rows[node / kBlockEdge]} >> (node % kBlockEdge)) & 1U) != 0;
}

double product(std::span<const float> a, std::span<const float> b) {
    double sum = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) sum += double{a[n]} * b[n];
    return sum;
}

AxisProduct axis_product() {
    AxisProduct product;
    for (int n = 0; n < kBlockEdge; ++n) {
        product.x[n] = 1.0 + 0.3 * n;
        product.y[n] = 0.1 * n;
        product.z[n] = 1.0 / (1 + n);
    }
    return product;
}

// What kernels make of the same input.
struct Results {
    Values applied;
    Values within = random_block(7);
    NodeBits near_zero;
    Values image;
    ImageProducts products;
    Values first_residual;
    Values first_direction;
    double first_norm;
    Values x = random_block(4);
    Values residual = random_block(5);
    Values direction = random_block(6);
    double norm;
    Values other_residual;
    double other_norm;
    Values corrected = random_block(4);
    std::array<double, kBlockNodes> sums{};

    explicit Results(const BlockKernels& kernels) {
        const Neighbourhood near;
        const StencilWeights weights = weights_of(kStencil);
        const NodeBits set = random_set(2);
        kernels.apply(weights, near.around(), applied.data());
        products = kernels.apply_to_set(weights, near.around(), set, image.data());
        first_norm = kernels.begin(weights, near.around(), set, random_block(3).data(), first_residual.data(),
                                   first_direction.data());
        kernels.apply_within(weights, near.around(), set, within.data());
        near_zero = kernels.find_near(0.4F, near.own());
        other_norm = kernels.find_residual(weights, near.around(), set, random_block(3).data(), other_residual.data());
        kernels.correct(weights, near.around(), set, corrected.data());
        sums.fill(0.7);
        kernels.add_product(axis_product(), kNegligible, sums.data());
        norm = kernels.advance(kFactors, image.data(), x.data(), residual.data(), direction.data());
    }
};

class EachBlockKernels : public ::testing::TestWithParam<BlockKernels> {
protected:
    const Results results_{GetParam()};
    const Neighbourhood near_;
    const NodeBits set_ = random_set(2);
};

TEST_P(EachBlockKernels, ApplyTheStencil) {
    const std::vector<float> expected = near_.by_plain_stencil();
    for (std::size_t n = 0; n < kBlockNodes; ++n) ASSERT_NEAR(results_.applied[n], expected[n], 2e-6);
}

TEST_P(EachBlockKernels, ApplyItToTheSetOnly) {
    for (std::size_t n = 0; n < kBlockNodes; ++n)
        ASSERT_EQ(results_.image[n], in_set(set_, n) ? results_.applied[n] : 0.0F);
    const std::span<const float> own(near_.own(), kBlockNodes);
    EXPECT_NEAR(results_.products.with_direction, product(results_.image, own), 1e-11);
    EXPECT_NEAR(results_.products.with_itself, product(results_.image, results_.image), 1e-11);
}

TEST_P(EachBlockKernels, ApplyItWithinTheSet) {
    const Values before = random_block(7);
    for (std::size_t n = 0; n < kBlockNodes; ++n)
        ASSERT_EQ(results_.within[n], in_set(set_, n) ? results_.applied[n] : before[n]);
}

TEST_P(EachBlockKernels, FindSmallValues) {
    for (std::size_t n = 0; n < kBlockNodes; ++n)
        ASSERT_EQ(in_set(results_.near_zero, n), std::abs(near_.own()[n]) < 0.4F);
}

TEST_P(EachBlockKernels, AddAProductWhereItCounts) {
    const AxisProduct product = axis_product();
    for (int z = 0; z < kBlockEdge; ++z)
        for (int y = 0; y < kBlockEdge; ++y)
            for (int x = 0; x < kBlockEdge; ++x) {
                const double row = product.y[y] * product.z[z];
                const double expected = 0.7 + (row > kNegligible ? row * product.x[x] : 0.0);
                ASSERT_NEAR(results_.sums[static_cast<std::size_t>(node_in_block(x, y, z))], expected, 1e-12);
            }
}

TEST_P(EachBlockKernels, FindTheResidualThatBeginFinds) {
    EXPECT_EQ(results_.other_residual, results_.first_residual);
    EXPECT_EQ(results_.other_norm, results_.first_norm);
}

TEST_P(EachBlockKernels, CorrectOnTheSetOnly) {
    const Values x = random_block(4);
    for (std::size_t n = 0; n < kBlockNodes; ++n)
        ASSERT_EQ(results_.corrected[n], in_set(set_, n) ? x[n] + results_.applied[n] : x[n]);
}

TEST_P(EachBlockKernels, BeginWithTheResidual) {
    const Values b = random_block(3);
    for (std::size_t n = 0; n < kBlockNodes; ++n)
        ASSERT_EQ(results_.first_residual[n], in_set(set_, n) ? b[n] - results_.applied[n] : 0.0F);
    EXPECT_EQ(results_.first_direction, results_.first_residual);
    EXPECT_NEAR(results_.first_norm, product(results_.first_residual, results_.first_residual), 1e-11);
}

TEST_P(EachBlockKernels, AdvanceByOneStep) {
    const Values x = random_block(4);
    const Values residual = random_block(5);
    const Values direction = random_block(6);
    for (std::size_t n = 0; n < kBlockNodes; ++n) {
        const float left = residual[n] - kFactors.alpha * results_.image[n];
        ASSERT_EQ(results_.x[n], x[n] + kFactors.alpha * direction[n]);
        ASSERT_EQ(results_.residual[n], left);
        ASSERT_EQ(results_.direction[n], left + kFactors.beta * direction[n]);
    }
    EXPECT_NEAR(results_.norm, product(results_.residual, results_.residual), 1e-11);
}

TEST_P(EachBlockKernels, HaveTheBitsOfThePlainOnes) {
    const Results plain(supported_block_kernels().front());
    EXPECT_EQ(results_.applied, plain.applied);
    EXPECT_EQ(results_.within, plain.within);
    EXPECT_EQ(results_.sums, plain.sums);
    EXPECT_EQ(results_.corrected, plain.corrected);
    EXPECT_EQ(results_.image, plain.image);
    EXPECT_EQ(results_.products.with_direction, plain.products.with_direction);
    EXPECT_EQ(results_.products.with_itself, plain.products.with_itself);
    EXPECT_EQ(results_.first_norm, plain.first_norm);
    EXPECT_EQ(results_.norm, plain.norm);
}

INSTANTIATE_TEST_SUITE_P(Instructions, EachBlockKernels, ::testing::ValuesIn(supported_block_kernels()),
                         [](const auto& kernels) { return std::string(kernels.param.instructions); });

TEST(BlockKernels, FollowTheEnvironment) {
    const std::vector<BlockKernels> all = supported_block_kernels();
    EXPECT_EQ(block_kernels().instructions, choose_kernels(all, wanted_instructions()).instructions);
}

}  // namespace
}  // namespace meniscus::testing

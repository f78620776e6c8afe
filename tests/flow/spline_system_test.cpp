// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/spline_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/parallel.h"
#include "meniscus/threads.h"
#include "support/sampled_field.h"

namespace meniscus::testing {
namespace {

using Field = std::vector<float>;

constexpr Solver kSolvers[] = {Solver::Richardson, Solver::Cg, Solver::Gmres};

// Seven blocks in a cross, some neighbours missing.
BlockGrid cross_of_blocks(double spacing) {
    return {spacing,
            {},
            {{.z = 0, .y = 0, .x = 0},
             {.z = 0, .y = 0, .x = 1},
             {.z = 0, .y = 0, .x = -1},
             {.z = 0, .y = 1, .x = 0},
             {.z = 0, .y = -1, .x = 0},
             {.z = 1, .y = 0, .x = 0},
             {.z = -1, .y = 0, .x = 0}}};
}

Field random_field(std::uint64_t seed, std::size_t size) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> value(-1.0F, 1.0F);
    Field field(size);
    for (float& v : field) v = value(random);
    return field;
}

NodeMask random_mask(std::uint64_t seed, std::size_t size, double part) {
    std::mt19937_64 random(seed);
    std::bernoulli_distribution in(part);
    NodeMask mask(size);
    for (std::uint8_t& m : mask) m = in(random) ? 1 : 0;
    return mask;
}

Field applied(const BlockGrid& grid, const Stencil& stencil, const Field& x, const BlockFill& fill) {
    Field result(x.size());
    apply_everywhere(stencil, {grid, x, fill}, result);
    return result;
}

double residual_on_mask(const Field& image, const Field& b, const NodeMask& mask) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t n = 0; n < b.size(); ++n)
        if (mask[n] != 0) {
            sum += std::pow(double{image[n]} - b[n], 2);
            count += 1.0;
        }
    return std::sqrt(sum / count);
}

double product(const Field& a, const Field& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0, std::plus<>(),
                              [](float x, float y) { return double{x} * y; });
}

// Solves a dense system by elimination with pivots; a is row by row with b as its last column.
std::vector<double> eliminate(std::vector<std::vector<double>> a) {
    const std::size_t n = a.size();
    for (std::size_t k = 0; k < n; ++k) {
        const auto pivot = std::max_element(a.begin() + static_cast<std::ptrdiff_t>(k), a.end(),
                                            [&](auto& p, auto& q) { return std::abs(p[k]) < std::abs(q[k]); });
        std::swap(a[k], *pivot);
        for (std::size_t row = k + 1; row < n; ++row)
            for (std::size_t col = n + 1; col-- > k;) a[row][col] -= a[row][k] / a[k][k] * a[k][col];
    }
    std::vector<double> x(n);
    for (std::size_t k = n; k-- > 0;) {
        x[k] = a[k][n];
        for (std::size_t col = k + 1; col < n; ++col) x[k] -= a[k][col] * x[col];
        x[k] /= a[k][k];
    }
    return x;
}

// The dense matrix of the unknowns, column by column from unit vectors, and the right side without known values.
std::vector<std::vector<double>> dense_system(const BlockGrid& grid, const Stencil& stencil,
                                              const std::vector<std::size_t>& unknowns, const Field& b,
                                              const Field& known, const BlockFill& fill) {
    std::vector<std::vector<double>> a(unknowns.size(), std::vector<double>(unknowns.size() + 1));
    const Field from_known = applied(grid, stencil, known, fill);
    const BlockFill no_fill(grid.block_count(), 0.0F);
    for (std::size_t col = 0; col < unknowns.size(); ++col) {
        Field unit(known.size());
        unit[unknowns[col]] = 1.0F;
        const Field column = applied(grid, stencil, unit, no_fill);
        for (std::size_t row = 0; row < unknowns.size(); ++row) a[row][col] = column[unknowns[row]];
        a[col].back() = double{b[unknowns[col]]} - from_known[unknowns[col]];
    }
    return a;
}

// What a step of the flow solves, at a time step in units of h².
Stencil flow_stencil(double spacing, double step, double anchor) {
    const double tau = step * spacing * spacing;
    return (1.0 + tau * anchor / (spacing * spacing)) * spline_value() - tau * spline_laplacian(spacing);
}

TEST(ApplyEverywhere, UsesNeighboursAndTheFillOfEachBlock) {
    const BlockGrid grid(1.0, {}, {{.z = 0, .y = 0, .x = 0}, {.z = 0, .y = 0, .x = 1}, {.z = 9, .y = 0, .x = 0}});
    Field ones(grid.node_count(), 1.0F);
    const Field same = applied(grid, spline_value(), ones, {1.0F, 1.0F, 1.0F});
    for (const float v : same) EXPECT_NEAR(v, 1.0F, 1e-6);
    const Field open = applied(grid, spline_value(), ones, {0.0F, 1.0F, 0.0F});
    EXPECT_NEAR(open[static_cast<std::size_t>(node_in_block(7, 4, 4))], 1.0F, 1e-6);  // its neighbour is there
    EXPECT_NEAR(open[static_cast<std::size_t>(node_in_block(0, 4, 4))], 5.0F / 6.0F, 1e-6);
    EXPECT_NEAR(open[static_cast<std::size_t>(kBlockNodes + node_in_block(7, 4, 4))], 1.0F, 1e-6);
    EXPECT_NEAR(open[static_cast<std::size_t>(2 * kBlockNodes + node_in_block(7, 7, 7))], 125.0F / 216.0F, 1e-6);
}

TEST(NodesNear, AreThoseOfTheMask) {
    const BlockGrid grid = cross_of_blocks(0.5);
    Field field = random_field(16, grid.node_count());
    std::fill_n(field.begin() + kBlockNodes, kBlockNodes, 1.0F);
    const Unknowns unknowns = nodes_near(grid, field, 0.3F);
    EXPECT_EQ(unknowns.blocks, (std::vector<BlockId>{0, 2, 3, 4, 5, 6}));
    std::size_t count = 0;
    for (std::size_t k = 0; k < unknowns.blocks.size(); ++k)
        for (std::size_t n = 0; n < kBlockNodes; ++n) {
            const bool in = ((unsigned{unknowns.nodes[k].rows[n / kBlockEdge]} >> (n % kBlockEdge)) & 1U) != 0;
            EXPECT_EQ(in, std::abs(field[std::size_t{unknowns.blocks[k]} * kBlockNodes + n]) < 0.3F);
            count += in ? 1 : 0;
        }
    EXPECT_EQ(unknowns.count, count);
}

TEST(FillBySign, IsTheMarginWithTheSignThatPrevails) {
    const BlockGrid grid(1.0, {}, {{.z = 0, .y = 0, .x = 0}, {.z = 9, .y = 0, .x = 0}});
    Field field(grid.node_count(), 0.1F);
    std::fill_n(field.begin(), kBlockNodes / 2 + 1, -0.1F);
    EXPECT_EQ(fill_by_sign(grid, field, 2.0), (BlockFill{-2.0F, 2.0F}));
}

TEST(SplineSystem, EqualsElimination) {
    const BlockGrid grid = cross_of_blocks(0.5);
    const NodeMask mask = random_mask(1, grid.node_count(), 0.05);
    std::vector<std::size_t> unknowns;
    for (std::size_t n = 0; n < mask.size(); ++n)
        if (mask[n] != 0) unknowns.push_back(n);
    const Field b = random_field(2, grid.node_count());
    const BlockFill fill = random_field(3, grid.block_count());
    for (const Stencil& stencil : {spline_value(), flow_stencil(0.5, 1.0, 4.0), flow_stencil(0.5, 64.0, 16.0)}) {
        const Field start = random_field(4, grid.node_count());
        Field known = start;
        for (const std::size_t n : unknowns) known[n] = 0.0F;
        const std::vector<double> expected = eliminate(dense_system(grid, stencil, unknowns, b, known, fill));
        for (const Solver solver : kSolvers) {
            Field x = start;
            solve({grid, unknowns_of(mask), stencil, fill, {b}}, x,
                  {.solver = solver, .tolerance = 1e-7 * stencil.centre});
            for (std::size_t k = 0; k < unknowns.size(); ++k) EXPECT_NEAR(x[unknowns[k]], expected[k], 1e-5);
        }
    }
}

TEST(SplineSystem, LeavesNoResidual) {
    const BlockGrid grid = cross_of_blocks(0.25);
    const NodeMask mask = random_mask(5, grid.node_count(), 0.7);
    const Field b = random_field(6, grid.node_count());
    const BlockFill fill(grid.block_count(), 0.5F);
    const Stencil stencil = flow_stencil(0.25, 16.0, 16.0);
    const double tolerance = 1e-6 * stencil.centre;
    for (const Solver solver : kSolvers) {
        Field x(grid.node_count());
        const SolveResult result =
            solve({grid, unknowns_of(mask), stencil, fill, {b}}, x, {.solver = solver, .tolerance = tolerance});
        EXPECT_LE(result.residual, tolerance);
        EXPECT_GT(result.iterations, 3);
        EXPECT_LT(result.iterations, 60);
        EXPECT_LT(residual_on_mask(applied(grid, stencil, x, fill), b, mask), 2.0 * tolerance);
    }
}

TEST(SplineSystem, TakesTheRightSideOfTheBlocksWithUnknownsAlone) {
    const BlockGrid grid = cross_of_blocks(0.5);
    const std::size_t without = std::size_t{3} * kBlockNodes;  // where a block has none
    Field near = random_field(23, grid.node_count());
    std::fill_n(near.begin() + without, kBlockNodes, 1.0F);
    const Field b = random_field(24, grid.node_count());
    Field b_alone = b;
    b_alone.erase(b_alone.begin() + without, b_alone.begin() + without + kBlockNodes);
    const BlockFill fill(grid.block_count(), 0.0F);
    for (const Solver solver : kSolvers) {
        Field x(grid.node_count());
        Field x_alone(grid.node_count());
        const SolveOptions options{.solver = solver, .tolerance = 1e-4};
        solve({grid, nodes_near(grid, near, 0.7F), spline_value(), fill, {b}}, x, options);
        solve({grid, nodes_near(grid, near, 0.7F), spline_value(), fill, {b_alone, RightSide::Blocks::WithUnknowns}},
              x_alone, options);
        EXPECT_EQ(x, x_alone);
    }
}

// The flow's matrix times its approximate inverse is within a quarter of 1: cycles of three gain a factor of 400.
TEST(SplineSystem, RichardsonsIterationNeedsFewSteps) {
    const BlockGrid grid(0.5, {}, box_of_blocks({.z = 0, .y = 0, .x = 0}, {.z = 2, .y = 2, .x = 2}));
    const NodeMask mask = random_mask(17, grid.node_count(), 0.8);
    const Stencil stencil = flow_stencil(0.5, 1e6, 16.0);
    Field x(grid.node_count());
    const SolveResult result = solve(
        {grid, unknowns_of(mask), stencil, BlockFill(grid.block_count(), 0.0F), {random_field(18, grid.node_count())}},
        x, {.solver = Solver::Richardson, .tolerance = 2e-4});
    EXPECT_LE(result.residual, 2e-4);
    EXPECT_LE(result.iterations, 6);
}

// Entries of a field on a grid whose x and z are those of another one swapped.
template <class Values>
Values with_axes_swapped(const BlockGrid& grid, const Values& values, const BlockGrid& swapped) {
    Values result(values.size());
    for (BlockId block = 0; block < grid.block_count(); ++block) {
        const BlockCoord& c = grid.coord(block);
        const std::size_t first = std::size_t{swapped.find({.z = c.x, .y = c.y, .x = c.z})} * kBlockNodes;
        for (int node = 0; node < kBlockNodes; ++node) {
            const int to = node_in_block(node / 64, node / 8 % 8, node % 8);
            result[first + static_cast<std::size_t>(to)] =
                values[std::size_t{block} * kBlockNodes + static_cast<std::size_t>(node)];
        }
    }
    return result;
}

// Only a few layers of blocks of the residual are kept at a time, here of growing and of shrinking ones. Steps do not
// depend on how the blocks are cut into layers.
TEST(SplineSystem, RichardsonsIterationTakesTheSameStepsThroughAnyLayers) {
    for (const bool growing : {true, false}) {
        std::vector<BlockCoord> blocks;
        std::vector<BlockCoord> other_blocks;
        for (std::int32_t z = 0; z < 5; ++z) {
            const std::int32_t edge = 17 + 2 * (growing ? z : 4 - z);
            for (std::int32_t y = 0; y < edge; ++y)
                for (std::int32_t x = 0; x < edge; ++x) {
                    blocks.push_back({.z = z, .y = y, .x = x});
                    other_blocks.push_back({.z = x, .y = y, .x = z});
                }
        }
        const BlockGrid grid(0.5, {}, blocks);
        const BlockGrid other(0.5, {}, other_blocks);
        const NodeMask mask = random_mask(19, grid.node_count(), 0.8);
        const Field b = random_field(20, grid.node_count());
        const BlockFill fill(grid.block_count(), 0.0F);
        const Stencil stencil = flow_stencil(0.5, 1e6, 16.0);
        const SolveOptions three_steps{.solver = Solver::Richardson, .tolerance = 0.0, .max_iterations = 3};
        Field x(grid.node_count());
        Field other_x(grid.node_count());
        solve({grid, unknowns_of(mask), stencil, fill, {b}}, x, three_steps);
        solve({other,
               unknowns_of(with_axes_swapped(grid, mask, other)),
               stencil,
               fill,
               {with_axes_swapped(grid, b, other)}},
              other_x, three_steps);
        const Field expected = with_axes_swapped(other, other_x, grid);
        const float tolerance = 1e-5F * *std::ranges::max_element(x);
        for (std::size_t n = 0; n < x.size(); ++n) ASSERT_NEAR(x[n], expected[n], tolerance) << "entry " << n;
    }
}

TEST(SplineSystem, GmresRestartsWhereItsVectorsDoNotSuffice) {
    const BlockGrid grid(0.5, {}, box_of_blocks({.z = 0, .y = 0, .x = 0}, {.z = 2, .y = 2, .x = 2}));
    const NodeMask mask(grid.node_count(), 1);
    const Field b = random_field(15, grid.node_count());
    const BlockFill fill(grid.block_count(), 0.0F);
    const Stencil stiff = 0.001 * spline_value() - spline_laplacian(grid.spacing());
    Field x(grid.node_count());
    const SolveResult result =
        solve({grid, unknowns_of(mask), stiff, fill, {b}}, x, {.solver = Solver::Gmres, .tolerance = 1e-5});
    EXPECT_GT(result.iterations, 30);
    EXPECT_LT(residual_on_mask(applied(grid, stiff, x, fill), b, mask), 5e-5);
}

TEST(SplineSystem, WritesOnTheMaskOnly) {
    const BlockGrid grid = cross_of_blocks(0.5);
    const NodeMask mask = random_mask(7, grid.node_count(), 0.3);
    const Field before = random_field(8, grid.node_count());
    Field x = before;
    solve({grid,
           unknowns_of(mask),
           spline_value(),
           BlockFill(grid.block_count(), 1.0F),
           {random_field(9, grid.node_count())}},
          x, {});
    for (std::size_t n = 0; n < x.size(); ++n) {
        if (mask[n] == 0) {
            ASSERT_EQ(x[n], before[n]);
        }
    }
}

TEST(SplineSystem, NothingUnknownNeedsNoIteration) {
    const BlockGrid grid = cross_of_blocks(0.5);
    Field x = random_field(10, grid.node_count());
    const Field before = x;
    const SolveResult result = solve(
        {grid, unknowns_of(NodeMask(grid.node_count())), spline_value(), BlockFill(grid.block_count(), 1.0F), {before}},
        x, {});
    EXPECT_EQ(result.iterations, 0);
    EXPECT_EQ(result.residual, 0.0);
    EXPECT_EQ(x, before);
}

TEST(SplineSystem, StopsAtTheAllowedIterations) {
    const BlockGrid grid = cross_of_blocks(0.5);
    const NodeMask mask(grid.node_count(), 1);
    for (const Solver solver : kSolvers) {
        Field x(grid.node_count());
        const SolveResult result = solve({grid,
                                          unknowns_of(mask),
                                          spline_value(),
                                          BlockFill(grid.block_count(), 0.0F),
                                          {random_field(11, grid.node_count())}},
                                         x, {.solver = solver, .tolerance = 0.0, .max_iterations = 3});
        EXPECT_EQ(result.iterations, 3);
        EXPECT_GT(result.residual, 0.0);
    }
}

TEST(SplineSystem, HasTheSameBitsForAnyNumberOfThreads) {
    const BlockGrid grid(0.5, {}, box_of_blocks({.z = 0, .y = 0, .x = 0}, {.z = 4, .y = 4, .x = 4}));
    const NodeMask mask = random_mask(13, grid.node_count(), 0.6);
    const Field b = random_field(14, grid.node_count());
    const auto solved = [&](Solver solver, int threads) {
        const ThreadLimit limit(threads);
        Field x(grid.node_count());
        solve({grid, unknowns_of(mask), flow_stencil(0.5, 16.0, 16.0), BlockFill(grid.block_count(), 0.0F), {b}}, x,
              {.solver = solver});
        return x;
    };
    for (const Solver solver : kSolvers) {
        const Field one = solved(solver, 1);
        EXPECT_EQ(one, solved(solver, 2));
        EXPECT_EQ(one, solved(solver, 0));
    }
}

// (x, A y) = (A x, y) and (x, A x) > 0 with zeros outside: what conjugate gradients need.
TEST(SplineSystem, ItsOperatorIsSymmetricAndPositiveDefinite) {
    const BlockGrid grid = cross_of_blocks(0.25);
    const BlockFill zero(grid.block_count(), 0.0F);
    for (const Stencil& stencil : {spline_value(), flow_stencil(0.25, 0.5, 4.0), flow_stencil(0.25, 64.0, 16.0)})
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            const Field x = random_field(seed, grid.node_count());
            const Field y = random_field(seed + 100, grid.node_count());
            const Field ax = applied(grid, stencil, x, zero);
            EXPECT_NEAR(product(ax, y), product(x, applied(grid, stencil, y, zero)), 1e-3 * stencil.centre);
            EXPECT_GT(product(ax, x), 0.03 * product(x, x));
        }
}

// The highest frequency has the smallest eigenvalue of B, (1/3)³, and the largest of the flow's Laplacian part.
TEST(SplineSystem, SmallestEigenvalueOfTheValuesIsATwentySeventh) {
    const BlockGrid grid(0.5, {}, {{.z = 0, .y = 0, .x = 0}});
    Field checkerboard(kBlockNodes);
    for (int n = 0; n < kBlockNodes; ++n)
        checkerboard[static_cast<std::size_t>(n)] = (n + n / 8 + n / 64) % 2 == 0 ? 1.0F : -1.0F;
    const Field image = applied(grid, spline_value(), checkerboard, {0.0F});
    const auto inner = static_cast<std::size_t>(node_in_block(3, 4, 5));
    EXPECT_NEAR(image[inner] / checkerboard[inner], 1.0 / 27.0, 1e-6);
}

}  // namespace
}  // namespace meniscus::testing

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A place in a tri-cubic B-spline on a block grid: quick for queries that stay in one cell.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "grid/block_grid.h"
#include "grid/spline_kernels.h"
#include "meniscus/level_set.h"

namespace meniscus {

/// Keeps the 4³ coefficients that matter in the current cell. For one thread.
class SplineCursor {
public:
    /// Grid and coefficients, one per node, must outlive the cursor.
    SplineCursor(const BlockGrid& grid, std::span<const float> coefficients)
        : grid_(&grid),
          coefficients_(coefficients),
          kernels_(&spline_kernels()),
          steps_per_length_(1.0 / grid.spacing()) {}

    /// Goes to a point, Å. False outside the band, where the cursor may not be asked anything.
    bool move_to(const Vec3& point);
    /// Goes to the lower corner of the cell above a node, counted from the grid's origin. False outside the band.
    bool move_to_cell(const std::array<std::int64_t, 3>& node);
    /// Goes to a place within the current cell, in spacings from its lower corner: 0 to 1, rounding errors allowed.
    void move_within(const std::array<double, 3>& place) { place_ = place; }

    double value() const { return kernels_->value(place_in_cell()); }
    ValueAndGradient value_and_gradient() const { return kernels_->value_and_gradient(place_in_cell()); }
    LevelSetSample sample() const { return kernels_->sample(place_in_cell()); }

    /// 1 if all coefficients of the cell are positive, -1 if all are negative: then so is the spline, everywhere in it.
    /// 0 if they are not, and nothing is known.
    int sign() const;

private:
    static constexpr int kSupport = 4;  // nodes per axis that a cubic B-spline reaches
    static constexpr std::size_t kCoefficients = std::size_t{kSupport} * kSupport * kSupport;
    static constexpr std::int64_t kNowhere = INT64_MIN;

    PlaceInCell place_in_cell() const {
        return {local_.data(), kSupport, std::size_t{kSupport} * kSupport, place_, steps_per_length_};
    }
    bool load(const std::array<std::int64_t, 3>& node);
    bool copy_coefficients(BlockId block, const std::array<int, 3>& node);

    const BlockGrid* grid_;
    std::span<const float> coefficients_;
    const SplineKernels* kernels_;
    double steps_per_length_;
    BlockId block_ = kNoBlock;  // the last one that was found
    std::array<std::int64_t, 3> node_{kNowhere, kNowhere, kNowhere};
    std::array<double, 3> place_{};
    std::array<float, kCoefficients> local_;  // x fastest
};

/// LevelSet::project. All of the sample is NaN outside the band.
SplineProjection project_to_zero_set(SplineCursor& cursor, const Vec3& point, double spacing);
/// The same without the second derivatives: NaN.
SplineProjection project_to_zero_set_first_order(SplineCursor& cursor, const Vec3& point, double spacing);

/// What a query of a point outside the band returns: NaN throughout.
LevelSetSample nowhere();

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The nearest features of points next to each other, by walking from cell to cell.
//
// A cell is where a feature of the SAS is known to be nearest whatever else there is: of a ball what lies towards its
// exposed sphere, of an arc or vertex the hull with its atoms (SurfaceStep tells why). Cells that share a border are
// those of features that touch, so that the side by which a point is outside of one leads to the next. Most points of
// the SES are in a cell; what is left is beside ridges where the probe reaches through between the atoms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "nearest/nearest_feature.h"
#include "nearest/nearest_kernels.h"

namespace meniscus {

class FeatureWalk {
public:
    static constexpr std::size_t kLandmarks = 512;

    explicit FeatureWalk(const AccessibleSurface& surface, const NearestKernels& kernels = nearest_kernels())
        : data_(&surface.data()), kernels_(kernels), border_(data_->rho_max) {}

    /// The cells of points, best next to each other: of no kind where none is found, for a point may lie in none, or so
    /// near to a border that rounding would decide. Else it is that of the nearest feature, no matter where the walk
    /// began.
    void find(std::span<const Vec3> points, std::span<FeatureCell> cells);

private:
    // Where the last walk ended that led into a cube of space.
    struct Landmark {
        std::uint64_t cube = ~std::uint64_t{0};
        FeatureCell cell;
    };

    void find_batch(std::span<const Vec3> points, std::span<FeatureCell> cells);
    FeatureCell find_one(const Vec3& point);
    std::uint64_t find_in(const FeatureCell& cell, std::uint64_t lanes) const;

    const AccessibleSurface::Data* data_;
    NearestKernels kernels_;
    CellBorder border_;
    LanePoints<double> lanes_;  // a batch
    FeatureCell last_;          // where the last walk ended
    std::array<Landmark, kLandmarks> landmarks_;
};

}  // namespace meniscus

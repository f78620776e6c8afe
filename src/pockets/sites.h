// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From probabilities of points to sites, and from sites to regions of pocket space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pockets/pocket_space.h"

namespace meniscus {

/// Points that resemble a ligand's, and how much each counts.
struct WeightedPoints {
    std::vector<VoxelId> voxels;  ///< ascending
    std::vector<double> weights;
};

/// Those of points whose probability is at least a twentieth of the largest; the weight is its square.
WeightedPoints weighted_points(std::span<const VoxelId> voxels, std::span<const double> probabilities);

/// A place where such points are dense.
struct Site {
    double score = 0.0;
    Vec3 centre;  ///< Å
    VoxelId densest = kNoVoxel;
};

/// The densest place first; the points near it are taken away before the next one is looked for.
std::vector<Site> find_sites(const PocketSpace& space, const WeightedPoints& points, std::size_t most);

/// How dense such points are around every voxel, before any is taken away.
std::vector<double> densities(const PocketSpace& space, const WeightedPoints& points);

/// For each voxel the number of its site, or kNone: the watershed of the densities from the sites on, and of each basin
/// what is at least half as dense as its densest voxel.
///
/// left_out   voxels that no site gets
std::vector<std::uint32_t> regions(const PocketSpace& space, std::span<const double> densities,
                                   std::span<const Site> sites, std::span<const std::uint8_t> left_out);

}  // namespace meniscus

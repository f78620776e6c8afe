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
    double score = 0.0;  ///< how dense
    Vec3 centre;         ///< Å
    VoxelId densest = kNoVoxel;
    WeightedPoints points;  ///< those within 8 Å of the centre that belong to no site before
};

/// The densest place first; its points are taken away before the next one is looked for.
std::vector<Site> find_sites(const PocketSpace& space, const WeightedPoints& points, std::size_t most);

/// The largest density of the points at one of some voxels: the score of a site there.
double largest_density(const PocketSpace& space, const WeightedPoints& points, std::span<const VoxelId> voxels);

/// For each voxel the number of its site, or kNone. A voxel goes to the site whose points are densest around it, if
/// they are at least half as dense there as where they are densest.
///
/// left_out   voxels that no site gets
std::vector<std::uint32_t> regions(const PocketSpace& space, std::span<const Site> sites,
                                   std::span<const std::uint8_t> left_out);

}  // namespace meniscus

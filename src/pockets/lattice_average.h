// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Averages of values on a block grid with a Gaussian's weights.
#pragma once

#include <span>
#include <vector>

#include "pockets/pocket_space.h"

namespace meniscus {

/// At each voxel, the average of the values around it with the weights exp(-d² / 2 sigma²), cut off along each axis at
/// 3 sigma; 0 where there is no voxel.
///
/// values   one per voxel
/// sigma    Å
/// cost     O(voxels · sigma / spacing), parallel
std::vector<double> gaussian_average(const PocketSpace& space, std::span<const double> values, double sigma);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The distance of the band's nodes from the zero set of a spline, by closest points.
#pragma once

#include <span>

#include "grid/block_grid.h"
#include "meniscus/node_field.h"

namespace meniscus {

/// Signed distance of every node from the zero set of a spline, clamped to ±width.
///
/// values   of the spline at the nodes, whose signs stay
/// returns  exact to about 1e-6 spacings where the closest point is unique and the band reaches two nodes beyond it
/// cost     a few hundred ns per node
NodeField distance_by_closest_points(const BlockGrid& grid, std::span<const float> values,
                                     std::span<const float> coefficients, double width);

}  // namespace meniscus

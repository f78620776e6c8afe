// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/box_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "core/workspaces.h"
#include "space/cell_order.h"

namespace meniscus {

double BoxFeatures::enter(const Box& box) {
    box_ = box;
    gathered_ = false;
    middle_distance_ = surface_.nearest(box.middle()).signed_distance;
    return middle_distance_;
}

bool BoxFeatures::search(std::span<const Vec3> points) {
    constexpr double kSlack = 1e-6;    // Å, for rounding
    constexpr double kLargest = 60.0;  // Å: in larger boxes too many features are the nearest somewhere
    if (norm(box_.high - box_.low) > kLargest) return false;
    if (!gathered_) local_.gather(box_, std::abs(middle_distance_) + 0.5 * norm(box_.high - box_.low) + kSlack);
    gathered_ = true;
    const bool open = batch_.start(local_, box_of(points), local_.margin()) == NearestBatch::Claim::Open;
    if (open) batch_.find(points);
    return open;
}

void BoxFeatures::find(std::span<const Vec3> points, std::span<double> distances) {
    const bool open = search(points);
    for (std::size_t i = 0; i < points.size(); ++i)
        distances[i] =
            open && batch_.found(i) ? batch_.signed_distance(i) : surface_.nearest(points[i]).signed_distance;
}

void BoxFeatures::find(std::span<const Vec3> points, std::span<FeatureLabel> labels) {
    const bool open = search(points);
    for (std::size_t i = 0; i < points.size(); ++i)
        labels[i] = open && batch_.found(i) ? batch_.label(i) : label_of(surface_.nearest(points[i]));
}

// Points of one cube after the other, those of a cube together.
std::vector<double> signed_distance(const AccessibleSurface& surface, std::span<const Vec3> points) {
    constexpr double kCellEdge = 6.0;  // Å
    constexpr std::size_t kMostCells = std::size_t{1} << 21;
    constexpr std::size_t kCellsPerTask = 16;
    check_finite(points);
    std::vector<double> distances(points.size());
    if (points.empty()) return distances;
    CellOrder cells;
    for (double edge = kCellEdge; !cells.sort(points, edge, kMostCells);) edge *= 2.0;
    parallel_chunks_with(
        cells.size(), kCellsPerTask, [&] { return std::make_unique<BoxFeatures>(surface); },
        [&](std::size_t begin, std::size_t end, BoxFeatures& exact) {
            std::array<double, kBatchLanes> found;
            for (std::size_t cell = begin; cell < end; ++cell) {
                const auto [group, positions] = cells[cell];
                if (group.empty()) continue;
                found[0] = exact.enter(box_of(group));  // all there is to know of a single point
                for (std::size_t at = 0; at < group.size(); at += kBatchLanes) {
                    const auto some = group.subspan(at, std::min(kBatchLanes, group.size() - at));
                    if (group.size() > 1) exact.find(some, found);
                    for (std::size_t i = 0; i < some.size(); ++i) distances[positions[at + i]] = found[i];
                }
            }
        });
    return distances;
}

}  // namespace meniscus

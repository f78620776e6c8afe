// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/box_distances.h"

#include <cmath>

namespace meniscus {

double BoxDistances::enter(const Box& box) {
    box_ = box;
    gathered_ = false;
    middle_distance_ = surface_.nearest(box.middle()).signed_distance;
    return middle_distance_;
}

void BoxDistances::find(std::span<const Vec3> points, std::span<double> distances) {
    constexpr double kSlack = 1e-6;  // Å, for rounding
    if (!gathered_) local_.gather(box_, std::abs(middle_distance_) + 0.5 * norm(box_.high - box_.low) + kSlack);
    gathered_ = true;
    Box box;
    for (const Vec3& point : points) box.include(point);
    const bool open = batch_.start(local_, box, local_.margin()) == NearestBatch::Claim::Open;
    if (open) batch_.find(points);
    for (std::size_t i = 0; i < points.size(); ++i)
        distances[i] =
            open && batch_.found(i) ? batch_.signed_distance(i) : surface_.nearest(points[i]).signed_distance;
}

}  // namespace meniscus

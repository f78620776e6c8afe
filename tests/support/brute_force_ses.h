// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Signed distance to the SES from the definition: every sphere, every circle of two, every point of three,
// each candidate held against every ball. No contours, no cells, no trees: the oracle for all that has them.
#pragma once

#include <vector>

#include "meniscus/atoms.h"

namespace meniscus::testing {

class BruteForceSes {
public:
    BruteForceSes(const Atoms& atoms, double probe);

    /// R - dist(p, K) outside K; in K the distance to the nearest enlarged ball plus R.
    double signed_distance(const Vec3& p) const;

private:
    struct Circle {
        std::size_t i, j;
        Vec3 centre, axis;
        double radius;
    };
    bool in_some_ball(const Vec3& x, const std::vector<std::size_t>& balls) const;
    void find_circles();
    void find_points();

    double probe_;
    std::vector<Vec3> centres_;
    std::vector<double> rho_;
    std::vector<std::vector<std::size_t>> neighbours_;
    std::vector<Circle> circles_;
    std::vector<Vec3> points_;
};

}  // namespace meniscus::testing

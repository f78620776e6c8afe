// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/neighbour_caps.h"

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

// `half_inverse` is 0.5 / rho.
Cap cap_towards(const Vec3& between, double rho, double half_inverse, double other_rho, std::uint32_t other) {
    const double d2 = squared_norm(between);
    const double inverse = 1.0 / std::sqrt(d2);
    return {inverse * between, (d2 + rho * rho - other_rho * other_rho) * (inverse * half_inverse), other};
}

}  // namespace

Cap cap_between(const AccessibleSurface::Data& data, std::uint32_t i, std::uint32_t j) {
    const Vec3 between = data.atoms.centres[j] - data.atoms.centres[i];
    return cap_towards(between, data.rho[i], 0.5 / data.rho[i], data.rho[j], j);
}

void NeighbourCaps::search_around(std::uint32_t i) {
    const CanonicalAtoms& atoms = data_.atoms;
    Box box;
    searched_begin_ = searched_end_ = i;
    while (searched_end_ < atoms.size() && atoms.cell_keys[searched_end_] == atoms.cell_keys[i])
        box.include(atoms.centres[searched_end_++]);
    const double reach = 2.0 * data_.rho_max;
    std::size_t count = 0;
    cells_.for_each_cell_near(box, reach, [&](std::uint32_t begin, std::uint32_t end) {
        candidates_.resize(count + end - begin);
        for (std::uint32_t j = begin; j < end; ++j) {
            candidates_[count] = j;
            count += box.squared_distance(atoms.centres[j]) < reach * reach ? 1 : 0;
        }
    });
    candidates_.resize(count);
    balls_.resize(candidates_.size());
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
        const Vec3& centre = atoms.centres[candidates_[c]];
        balls_[0][c] = centre.x;
        balls_[1][c] = centre.y;
        balls_[2][c] = centre.z;
        balls_[3][c] = data_.rho[candidates_[c]];
    }
    excess_.resize(candidates_.size() + 7);
    neighbours_.resize(candidates_.size() + 1);
}

// Without a branch for each candidate: whether it is a neighbour is anyone's guess.
void NeighbourCaps::find_neighbours(std::uint32_t i) {
    cap_kernels().find_excess(balls_, data_.atoms.centres[i], data_.rho[i], excess_.data());
    neighbour_count_ = 0;
    for (std::uint32_t c = 0; c < candidates_.size(); ++c) {
        neighbours_[neighbour_count_] = c;
        neighbour_count_ += excess_[c] < 0.0 ? 1 : 0;
    }
}

bool NeighbourCaps::gather(std::uint32_t i, std::span<const std::uint32_t> known, std::vector<Cap>& caps) {
    if (i < searched_begin_ || i >= searched_end_) search_around(i);
    find_neighbours(i);
    const Vec3& centre = data_.atoms.centres[i];
    const double rho = data_.rho[i];
    const double half_inverse = 0.5 / rho;
    std::size_t count = caps.size();
    caps.resize(count + neighbour_count_);
    for (std::size_t n = 0; n < neighbour_count_; ++n) {
        const std::uint32_t c = neighbours_[n];
        const std::uint32_t j = candidates_[c];
        if (j == i || std::find(known.begin(), known.end(), j) != known.end()) continue;
        const Vec3 between = Vec3{balls_[0][c], balls_[1][c], balls_[2][c]} - centre;
        caps[count] = cap_towards(between, rho, half_inverse, balls_[3][c], j);
        if (caps[count].t <= -1.0) return false;
        count += caps[count].t < 1.0 ? 1 : 0;
    }
    caps.resize(count);
    return true;
}

}  // namespace meniscus

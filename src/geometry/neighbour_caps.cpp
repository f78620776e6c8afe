// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/neighbour_caps.h"

#include <algorithm>
#include <cmath>

#include "core/bits.h"

namespace meniscus {

Cap cap_between(const AccessibleSurface::Data& data, std::uint32_t i, std::uint32_t j) {
    const Vec3 between = data.atoms.centres[j] - data.atoms.centres[i];
    const double rho = data.rho[i];
    const double other = data.rho[j];
    const double d2 = squared_norm(between);
    const double inverse = 1.0 / std::sqrt(d2);
    return {inverse * between, (d2 + rho * rho - other * other) * (inverse * (0.5 / rho)), j};
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
    caps_.resize(candidates_.size());
    marks_.resize(words_for(candidates_.size()));
    neighbours_.resize(candidates_.size());
}

void NeighbourCaps::find_neighbours(std::uint32_t i) {
    cap_kernels().find_caps(balls_, data_.atoms.centres[i], data_.rho[i], caps_, marks_.data());
    neighbour_count_ = list_items(marks_.data(), candidates_.size(), neighbours_.data());
}

bool NeighbourCaps::gather(std::uint32_t i, std::span<const std::uint32_t> known, std::vector<Cap>& caps) {
    if (i < searched_begin_ || i >= searched_end_) search_around(i);
    find_neighbours(i);
    std::size_t count = caps.size();
    caps.resize(count + neighbour_count_);
    for (std::size_t n = 0; n < neighbour_count_; ++n) {
        const std::uint32_t c = neighbours_[n];
        const std::uint32_t j = candidates_[c];
        if (j == i || std::find(known.begin(), known.end(), j) != known.end()) continue;
        caps[count] = {{caps_[0][c], caps_[1][c], caps_[2][c]}, caps_[3][c], j};
        if (caps[count].t <= -1.0) return false;
        count += caps[count].t < 1.0 ? 1 : 0;
    }
    caps.resize(count);
    return true;
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/neighbour_caps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/bits.h"

namespace meniscus {

namespace {

// Of what rounding to single precision may take from the distance of two balls, or add to it: they lie within three
// cells of where distances are measured from, along each axis.
constexpr double kSlackOfCell = 4e-6;

// Leaves out caps from one on that bury nothing; false if one buries all.
bool drop_outside(CapList& caps, std::size_t from) {
    for (std::size_t k = from; k < caps.atoms.size(); ++k) {
        const double t = caps.planes[3][k];
        if (t <= -1.0) return false;
        for (std::size_t column = 0; column < 4; ++column) caps.planes[column][from] = caps.planes[column][k];
        caps.atoms[from] = caps.atoms[k];
        from += t < 1.0 ? 1 : 0;
    }
    caps.planes.resize(from);
    caps.atoms.resize(from);
    return true;
}

}  // namespace

Cap cap_between(const AccessibleSurface::Data& data, std::uint32_t i, std::uint32_t j) {
    const Vec3 between = data.atoms.centres[j] - data.atoms.centres[i];
    const double rho = data.rho[i];
    const double other = data.rho[j];
    const double d2 = squared_norm(between);
    const double reach = other + rho;
    const double inverse = 1.0 / std::sqrt(d2);
    // By the same test as in CapKernels::find_caps, so that both say the same of spheres that touch but for rounding.
    const double t = d2 < reach * reach ? (d2 + rho * rho - other * other) * (inverse * (0.5 / rho)) : 1.0;
    return {inverse * between, t, j};
}

void CapList::clear() {
    planes.resize(0);
    atoms.clear();
}

void CapList::add(const Cap& cap) {
    const std::size_t at = atoms.size();
    planes.resize(at + 1);
    planes[0][at] = cap.axis.x;
    planes[1][at] = cap.axis.y;
    planes[2][at] = cap.axis.z;
    planes[3][at] = cap.t;
    atoms.push_back(cap.atom);
}

void NeighbourCaps::search_around(std::uint32_t i) {
    const CanonicalAtoms& atoms = data_.atoms;
    Box box;
    searched_.begin = searched_.end = i;
    while (searched_.end < atoms.size() && atoms.cell_keys[searched_.end] == atoms.cell_keys[i])
        box.include(atoms.centres[searched_.end++]);
    candidates_.clear();
    cells_.for_each_cell_near(box, 2.0 * data_.rho_max, [&](std::uint32_t begin, std::uint32_t end) {
        if (begin <= i && i < end) searched_.place = candidates_.size() + (i - begin);
        const std::size_t at = candidates_.size();
        candidates_.resize(at + (end - begin));
        std::iota(candidates_.begin() + static_cast<std::ptrdiff_t>(at), candidates_.end(), begin);
    });
    balls_.resize(candidates_.size());
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
        const Vec3 centre = atoms.centres[candidates_[c]] - atoms.centres[i];
        balls_[0][c] = static_cast<float>(centre.x);
        balls_[1][c] = static_cast<float>(centre.y);
        balls_[2][c] = static_cast<float>(centre.z);
        balls_[3][c] = static_cast<float>(data_.rho[candidates_[c]]);
    }
    marks_.resize(words_for(candidates_.size()));
}

void NeighbourCaps::find_neighbours(std::uint32_t i, std::span<const std::uint32_t> known) {
    const std::size_t self = searched_.place + (i - searched_.begin);
    cap_kernels().mark_meeting(balls_, self, static_cast<float>(kSlackOfCell * data_.atoms.cell), marks_.data());
    marks_[self / 64] &= ~(std::uint64_t{1} << self % 64);
    neighbours_.resize(candidates_.size());
    neighbours_.resize(list_items(marks_.data(), candidates_.size(), neighbours_.data()));
    for (std::uint32_t& neighbour : neighbours_) neighbour = candidates_[neighbour];
    if (known.empty()) return;
    std::erase_if(neighbours_,
                  [&](std::uint32_t j) { return std::find(known.begin(), known.end(), j) != known.end(); });
}

bool NeighbourCaps::gather(std::uint32_t i, std::span<const std::uint32_t> known, CapList& caps) {
    if (i < searched_.begin || i >= searched_.end) search_around(i);
    find_neighbours(i, known);
    if (neighbours_.empty()) return true;
    const std::size_t at = caps.atoms.size();
    const std::size_t count = at + neighbours_.size();
    caps.atoms.insert(caps.atoms.end(), neighbours_.begin(), neighbours_.end());
    neighbours_.resize(neighbours_.size() + CapColumns::kStep, neighbours_.back());
    caps.planes.resize(count + CapColumns::kStep);
    const bool all_meet =
        cap_kernels().find_caps(data_.atoms.centres.data(), data_.rho.data(), {neighbours_.data(), count - at},
                                data_.atoms.centres[i], data_.rho[i], at, caps.planes);
    caps.planes.resize(count);
    return all_meet || drop_outside(caps, at);
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/neighbour_caps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/bits.h"

namespace meniscus {

namespace {

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
    const double inverse = 1.0 / std::sqrt(d2);
    return {inverse * between, (d2 + rho * rho - other * other) * (inverse * (0.5 / rho)), j};
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
    searched_begin_ = searched_end_ = i;
    while (searched_end_ < atoms.size() && atoms.cell_keys[searched_end_] == atoms.cell_keys[i])
        box.include(atoms.centres[searched_end_++]);
    candidates_.clear();
    cells_.for_each_cell_near(box, 2.0 * data_.rho_max, [&](std::uint32_t begin, std::uint32_t end) {
        if (begin <= i && i < end) searched_at_ = candidates_.size() + (i - begin);
        const std::size_t at = candidates_.size();
        candidates_.resize(at + (end - begin));
        balls_.resize(candidates_.size());
        std::iota(candidates_.begin() + static_cast<std::ptrdiff_t>(at), candidates_.end(), begin);
        for (std::size_t c = at; c < candidates_.size(); ++c) {
            const Vec3& centre = atoms.centres[candidates_[c]];
            balls_[0][c] = centre.x;
            balls_[1][c] = centre.y;
            balls_[2][c] = centre.z;
            balls_[3][c] = data_.rho[candidates_[c]];
        }
    });
    marks_.resize(words_for(candidates_.size()));
    neighbours_.resize(candidates_.size() + CapColumns::kStep);
}

// Their positions among the candidates; behind the last one the list goes on to the end of a vector.
std::span<const std::uint32_t> NeighbourCaps::find_neighbours(std::uint32_t i, std::span<const std::uint32_t> known) {
    cap_kernels().mark_meeting(balls_, data_.atoms.centres[i], data_.rho[i], marks_.data());
    const std::size_t self = searched_at_ + (i - searched_begin_);
    marks_[self / 64] &= ~(std::uint64_t{1} << self % 64);
    const auto begin = neighbours_.begin();
    auto end = begin + static_cast<std::ptrdiff_t>(list_items(marks_.data(), candidates_.size(), neighbours_.data()));
    if (!known.empty())
        end = std::remove_if(begin, end, [&](std::uint32_t c) {
            return std::find(known.begin(), known.end(), candidates_[c]) != known.end();
        });
    if (end != begin) std::fill_n(end, CapColumns::kStep, *(end - 1));
    return {begin, end};
}

bool NeighbourCaps::gather(std::uint32_t i, std::span<const std::uint32_t> known, CapList& caps) {
    if (i < searched_begin_ || i >= searched_end_) search_around(i);
    const std::span<const std::uint32_t> neighbours = find_neighbours(i, known);
    std::size_t at = caps.atoms.size();
    const std::size_t count = at + neighbours.size();
    caps.planes.resize(count + CapColumns::kStep);
    const bool all_meet =
        cap_kernels().find_caps(balls_, neighbours, data_.atoms.centres[i], data_.rho[i], at, caps.planes);
    caps.planes.resize(count);
    caps.atoms.resize(count);
    for (std::size_t n = 0; n < neighbours.size(); ++n) caps.atoms[at + n] = candidates_[neighbours[n]];
    return all_meet || drop_outside(caps, at);
}

}  // namespace meniscus

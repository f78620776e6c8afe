// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tunnels/clearance.h"

#include <algorithm>
#include <limits>

namespace meniscus {
namespace {

constexpr double kSortingCell = 4.0;  // Å

BoxTree tree_of(const CanonicalAtoms& atoms) {
    std::vector<Box> boxes(atoms.size());
    for (std::size_t i = 0; i < atoms.size(); ++i)
        boxes[i] = Box{atoms.centres[i], atoms.centres[i]}.grown(atoms.radii[i]);
    return BoxTree(boxes);
}

double distance_from_segment(const Vec3& point, const Vec3& begin, const Vec3& end) {
    const Vec3 along = end - begin;
    const double length2 = squared_norm(along);
    const double t = length2 > 0.0 ? std::clamp(dot(point - begin, along) / length2, 0.0, 1.0) : 0.0;
    return norm(point - (begin + t * along));
}

}  // namespace

Clearance::Clearance(const Atoms& atoms)
    : atoms_(canonical_atoms(atoms, kSortingCell)), box_(box_of(atoms_.centres)), tree_(tree_of(atoms_)) {}

double Clearance::at(const Vec3& point) const {
    double best = std::numeric_limits<double>::infinity();
    // Boxes that hold the point are looked at even when the best is negative.
    const auto bound = [&] { return best > 0.0 ? best * best : std::numeric_limits<double>::min(); };
    tree_.search_nearest(point, bound, [&](std::uint32_t atom) { best = std::min(best, of_atom(atom, point)); });
    return best;
}

double Clearance::along(const Vec3& begin, const Vec3& end, double of_ends) const {
    double least = of_ends;
    Box box;
    box.include(begin);
    box.include(end);
    tree_.for_each_overlapping(box.grown(std::max(least, 0.0)), [&](std::uint32_t atom) {
        least = std::min(least, distance_from_segment(atoms_.centres[atom], begin, end) - atoms_.radii[atom]);
    });
    return least;
}

void Clearance::list_atoms(const Vec3& point, double most, std::vector<std::uint32_t>& list) const {
    list.clear();
    tree_.for_each_overlapping(Box{point, point}.grown(std::max(most, 0.0)), [&](std::uint32_t atom) {
        if (of_atom(atom, point) <= most) list.push_back(atom);
    });
}

}  // namespace meniscus

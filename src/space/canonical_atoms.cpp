// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "space/canonical_atoms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

#include "core/bits.h"
#include "core/largest_length.h"
#include "core/mix_bits.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

constexpr double kMaxCells = 1 << 20;  // per axis: leaves a bit of the 21 in a Morton key for rounding

std::uint64_t spread_bits(std::uint64_t v) {
    v &= 0x1FFFFF;
    v = (v | v << 32U) & 0x1F00000000FFFFULL;
    v = (v | v << 16U) & 0x1F0000FF0000FFULL;
    v = (v | v << 8U) & 0x100F00F00F00F00FULL;
    v = (v | v << 4U) & 0x10C30C30C30C30C3ULL;
    return (v | v << 2U) & 0x1249249249249249ULL;
}

void check(const Atoms& atoms) {
    if (atoms.empty()) throw std::invalid_argument("no atoms");
    if (atoms.centres.size() != atoms.radii.size())
        throw std::invalid_argument("the number of radii must be that of the centres");
    if (atoms.size() > std::numeric_limits<std::uint32_t>::max() - 1) throw std::invalid_argument("too many atoms");
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        if (!is_finite(atoms.centres[i]))
            throw std::invalid_argument("atom " + std::to_string(i) + ": a coordinate is not finite");
        if (!(atoms.radii[i] > 0.0) || !std::isfinite(atoms.radii[i]))
            throw std::invalid_argument("atom " + std::to_string(i) + ": the radius is not positive and finite");
        const Vec3& c = atoms.centres[i];
        if (std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z), atoms.radii[i]}) > kLargestLength)
            throw LimitError("atom " + std::to_string(i) + ": larger or farther from the origin than 1e12 Å");
    }
}

std::pair<Vec3, double> corner_and_extent(const std::vector<Vec3>& points) {
    Vec3 low = points.front();
    Vec3 high = points.front();
    for (const Vec3& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 size = high - low;
    return {low, std::max({size.x, size.y, size.z})};
}

}  // namespace

std::uint64_t morton_key(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return spread_bits(x) | spread_bits(y) << 1U | spread_bits(z) << 2U;
}

double symmetry_breaking_offset(const Vec3& centre, double radius, std::uint64_t seed) {
    std::uint64_t h = mix_bits(seed + kMixIncrement);
    for (const double v : {centre.x, centre.y, centre.z, radius})
        h = mix_bits(h ^ bits_of(v + 0.0)) + kMixIncrement;  // + 0.0: -0 is 0
    return signed_unit(mix_bits(h));
}

CanonicalAtoms canonical_atoms(const Atoms& atoms, double cell) {
    check(atoms);
    CanonicalAtoms result;
    const auto [corner, extent] = corner_and_extent(atoms.centres);
    result.corner = corner;
    result.cell = std::max(cell, extent / kMaxCells);

    // What decides nearly always is sorted along: two thirds of what it takes to look it up by index.
    struct Ranked {
        std::uint64_t key;
        double x;
        std::uint32_t index;
    };
    std::vector<Ranked> order(atoms.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        const Vec3 at = (1.0 / result.cell) * (atoms.centres[i] - corner);
        order[i] = {morton_key(static_cast<std::uint32_t>(at.x), static_cast<std::uint32_t>(at.y),
                               static_cast<std::uint32_t>(at.z)),
                    atoms.centres[i].x, i};
    }
    const auto rest = [&](std::uint32_t i) {
        return std::tuple(atoms.centres[i].y, atoms.centres[i].z, atoms.radii[i], i);
    };
    std::sort(order.begin(), order.end(), [&](const Ranked& a, const Ranked& b) {
        if (a.key != b.key) return a.key < b.key;
        if (a.x != b.x) return a.x < b.x;
        return rest(a.index) < rest(b.index);
    });
    result.centres.reserve(order.size());
    result.radii.reserve(order.size());
    result.original.reserve(order.size());
    result.cell_keys.reserve(order.size());
    for (const auto& [key, x, i] : order) {
        // Of one centre the largest comes last, and of equal ones the caller's first.
        if (!result.original.empty() && atoms.centres[i] == result.centres.back()) {
            if (atoms.radii[i] == result.radii.back()) continue;
            result.radii.back() = atoms.radii[i];
            result.original.back() = i;
            continue;
        }
        result.centres.push_back(atoms.centres[i]);
        result.radii.push_back(atoms.radii[i]);
        result.original.push_back(i);
        result.cell_keys.push_back(key);
    }
    return result;
}

}  // namespace meniscus

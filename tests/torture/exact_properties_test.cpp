// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Properties of what is exact: measures, signed distances, and the distances of the band's nodes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "band/distance_band.h"
#include "band/surface_blocks.h"
#include "meniscus/measures.h"
#include "support/brute_force_ses.h"
#include "torture/properties.h"

namespace meniscus::testing {
namespace {

Atoms grown(const Atoms& atoms, double by) {
    Atoms result = atoms;
    for (double& radius : result.radii) radius = std::max(radius + by, 1e-12);
    return result;
}

// Whether a hair more or less of radius makes another surface, as where four spheres meet in a point that a probe may
// just reach or not: what is exact is then a matter of the perturbation, and the program says so.
bool is_on_the_brink(const Arrangement& a) {
    constexpr double kHair = 1e-7;
    const MeasureOptions options{.probe = a.probe, .cavities = false, .threads = 1};
    const double smaller = measure(grown(a.atoms, -kHair), options).totals.ses_volume;
    const double larger = measure(grown(a.atoms, kHair), options).totals.ses_volume;
    return larger - smaller > 1e-5 * larger;
}

double sum_of(const Measures& m, double SurfaceComponent::*field) {
    return std::accumulate(m.components.begin(), m.components.end(), 0.0,
                           [&](double sum, const SurfaceComponent& c) { return sum + c.*field; });
}

TEST(ExactProperties, MeasuresAreFiniteAgreedAndOrdered) {
    for_all<Arrangement>(2000, any_arrangement(), [](const Arrangement& a) {
        const Measures m = measure(a.atoms, {.probe = a.probe, .threads = 1});
        const Measures vdw = measure(a.atoms, {.probe = 0.0, .cavities = false, .threads = 1});
        RC_ASSERT(m.agreed || is_on_the_brink(a));
        RC_ASSERT(std::isfinite(m.totals.ses_area));
        RC_ASSERT(std::isfinite(m.totals.ses_volume));
        const double slack = 1e-6 * m.totals.sas_volume;
        RC_ASSERT(m.totals.ses_volume >= vdw.totals.ses_volume - slack);
        RC_ASSERT(m.totals.ses_volume <= m.totals.sas_volume + slack);
        RC_ASSERT(std::abs(sum_of(m, &SurfaceComponent::ses_area) - m.totals.ses_area) <= 1e-9 * m.totals.ses_area);
        for (const SurfaceComponent& c : m.components) {
            RC_ASSERT(c.ses_area > -1e-6);
            RC_ASSERT(c.kind == ComponentKind::Outer || c.inscribed_radius >= a.probe);
        }
    });
}

// Where four spheres meet in a point, or two touch, the least change of radii decides: between those of atoms a hair
// smaller and a hair larger every distance is right.
TEST(ExactProperties, SignedDistanceIsThatOfBruteForce) {
    for_all<Arrangement>(1000, any_arrangement(), [](const Arrangement& a) {
        if (a.atoms.size() > 40) return;
        constexpr double kHair = 1e-6;
        const AccessibleSurface exact(a.atoms, a.probe);
        const BruteForceSes smaller(grown(a.atoms, -kHair), a.probe);
        const BruteForceSes larger(grown(a.atoms, kHair), a.probe);
        const Atoms around{{a.atoms.centres[0]}, {a.atoms.radii[0]}};
        for (const Vec3& p : random_points_around(around, 50, a.atoms.radii[0] + a.probe + 1.0)) {
            const double s = exact.nearest(p).signed_distance;
            RC_ASSERT(s <= smaller.signed_distance(p) + 3.0 * kHair);
            RC_ASSERT(s >= larger.signed_distance(p) - 3.0 * kHair);
        }
    });
}

TEST(ExactProperties, EveryNodeOfTheBandIsClaimed) {
    for_all<Arrangement>(300, any_arrangement(), [](const Arrangement& a) {
        const AccessibleSurface exact(a.atoms, a.probe);
        const double largest = *std::max_element(a.atoms.radii.begin(), a.atoms.radii.end());
        const double h = std::max(0.5, 0.1 * largest);
        const double margin = 2.5 * h;
        const Lattice lattice{h, {0.1, 0.2, 0.3}};
        const BlockGrid grid(h, lattice.origin, blocks_near_surface(exact, lattice, margin, 1U << 20U));
        const DistanceBand band = sample_distance(exact, grid, margin);
        const auto limit = static_cast<float>(margin);
        for (const float s : band.distance) RC_ASSERT(s >= -limit && s <= limit);
        for (const float k : band.curvature) RC_ASSERT(std::abs(k) <= static_cast<float>(1.0 / h));
        std::mt19937_64 random(1);
        for (int i = 0; i < 300; ++i) {
            const auto block = static_cast<BlockId>(random() % grid.block_count());
            const int x = static_cast<int>(random() % 8);
            const int y = static_cast<int>(random() % 8);
            const int z = static_cast<int>(random() % 8);
            const double s = exact.nearest(grid.corner(block) + h * Vec3{1.0 * x, 1.0 * y, 1.0 * z}).signed_distance;
            const float found = band.distance[std::size_t{block} * kBlockNodes + node_in_block(x, y, z)];
            RC_ASSERT(std::abs(std::clamp(s, -margin, margin) - found) <= 1e-6 * (1.0 + std::abs(s)));
        }
    });
}

}  // namespace
}  // namespace meniscus::testing

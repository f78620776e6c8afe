// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/feature_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "nearest/near_surface.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

using Kind = FeatureCell::Kind;

// Points on a lattice around an arrangement, row by row: with ties where the arrangement is symmetric.
std::vector<Vec3> lattice_around(const Atoms& atoms, double step) {
    Box box;
    for (const Vec3& c : atoms.centres) box.include(c);
    box = box.grown(3.0);
    std::vector<Vec3> points;
    for (double z = box.low.z; z < box.high.z; z += step)
        for (double y = box.low.y; y < box.high.y; y += step)
            for (double x = box.low.x; x < box.high.x; x += step) points.push_back({x, y, z});
    return points;
}

std::size_t count_found(const std::vector<FeatureCell>& cells) {
    const auto is_found = [](const FeatureCell& cell) { return cell.kind != Kind::None; };
    return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), is_found));
}

std::vector<FeatureCell> cells_of(const AccessibleSurface& surface, const std::vector<Vec3>& points,
                                  const NearestKernels& kernels = nearest_kernels()) {
    std::vector<FeatureCell> cells(points.size());
    FeatureWalk(surface, kernels).find(points, cells);
    return cells;
}

TEST(FeatureWalk, EndsAtTheNearestFeature) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        const AccessibleSurface surface(a.atoms, a.probe);
        const std::vector<Vec3> points = lattice_around(a.atoms, 0.4);
        const std::vector<FeatureCell> cells = cells_of(surface, points);
        std::size_t found = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (cells[i].kind == Kind::None) continue;
            ++found;
            const NearestFeature exact = surface.nearest(points[i]);
            const FeatureLabel label = label_in(surface.data(), points[i], cells[i]);
            ASSERT_EQ(label.signed_distance, exact.signed_distance);
            ASSERT_EQ(label.patch, exact.patch);
            ASSERT_EQ(label.atom, exact.atom);
        }
        EXPECT_GT(found, 50U);
    }
}

TEST(FeatureWalk, EndsAtTheSameFeatureWhereverItBegan) {
    const Atoms atoms = random_cluster(4, 60, 9.0);
    const AccessibleSurface surface(atoms, 1.4);
    std::vector<Vec3> points = lattice_around(atoms, 0.6);
    const std::vector<FeatureCell> forwards = cells_of(surface, points);
    std::reverse(points.begin(), points.end());
    const std::vector<FeatureCell> backwards = cells_of(surface, points);
    std::size_t both = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const FeatureCell& other = backwards[points.size() - 1 - i];
        if (forwards[i].kind == Kind::None || other.kind == Kind::None) continue;
        ++both;
        EXPECT_EQ(forwards[i], other);
    }
    EXPECT_GT(both, 1000U);
}

TEST(FeatureWalk, EveryInstructionSetFindsTheSame) {
    const Atoms atoms = random_cluster(4, 60, 9.0);
    const AccessibleSurface surface(atoms, 1.4);
    const std::vector<Vec3> points = lattice_around(atoms, 0.3);
    const std::vector<FeatureCell> plain = cells_of(surface, points, supported_nearest_kernels().front());
    for (const NearestKernels& kernels : supported_nearest_kernels())
        EXPECT_EQ(cells_of(surface, points, kernels), plain) << kernels.instructions;
}

TEST(FeatureWalk, FindsMostPointsOfTheSurface) {
    const Atoms atoms = random_cluster(4, 60, 9.0);
    const AccessibleSurface surface(atoms, 1.4);
    const std::vector<Vec3> near = near_surface(surface, lattice_around(atoms, 0.4), 0.2);
    EXPECT_GT(count_found(cells_of(surface, near)), near.size() * 8 / 10);
}

// Each walk begins anew, from a ball whose centre is farther away than any of an atom's.
TEST(FeatureWalk, FindsMostPointsOfTheSurfaceOfLargeBeads) {
    constexpr double kScale = 8.0;
    Atoms atoms = random_cluster(4, 60, 9.0);
    for (Vec3& c : atoms.centres) c = kScale * c;
    for (double& r : atoms.radii) r *= kScale;
    const AccessibleSurface surface(atoms, kScale * 1.4);
    std::vector<Vec3> near = near_surface(surface, lattice_around(atoms, 5.0), 0.7);
    ASSERT_GT(near.size(), 200U);
    std::size_t found = 0;
    for (const Vec3& p : near) found += count_found(cells_of(surface, {p}));
    EXPECT_GT(found, near.size() * 8 / 10);
}

// Further inside of a cell than rounding, which grows with the radii, could tell: here outside of a ball's sphere.
TEST(FeatureWalk, LeavesMoreToASearchTheLargerTheRadii) {
    for (const double scale : {1.0, 10.0}) {
        const AccessibleSurface surface(two_spheres(scale * 3.0, scale * 1.7, scale * 1.7), scale * 1.4);
        const AccessibleSurface::Data& data = surface.data();
        const double border = CellBorder(data.rho_max).length;
        EXPECT_GT(border, 1e-16 * data.rho_max);
        const std::uint32_t atom = data.arcs.front().atoms[0];
        const Vec3 away = -1.0 * data.arcs.front().axis;  // from the other atom, or towards it
        const Vec3 outwards = dot(away, data.atoms.centres[atom] - data.arcs.front().centre) > 0.0 ? away : -1.0 * away;
        const auto inside_by = [&](double depth) {
            return data.atoms.centres[atom] + (data.rho[atom] - depth) * outwards;
        };
        const std::vector<FeatureCell> cells = cells_of(surface, {inside_by(0.5 * border), inside_by(2.0 * border)});
        EXPECT_EQ(cells[0].kind, Kind::None);
        EXPECT_EQ(cells[1], (FeatureCell{Kind::Ball, atom}));
    }
}

// There the border of the cell, which a point must be inside of, is as long as the way to the axis; the circle has no
// ends to go on to.
TEST(FeatureWalk, StaysInTheCellOfAWholeCircleBesideItsAxis) {
    const AccessibleSurface surface(two_spheres(3.0), 1.4);
    const SasArc& arc = surface.data().arcs.front();
    ASSERT_TRUE(arc.whole_circle());
    double length = CellBorder(surface.data().rho_max).length;
    for (int ulp = -8; ulp < 0; ++ulp) length = std::nextafter(length, 0.0);
    for (int ulp = -8; ulp <= 8; ++ulp, length = std::nextafter(length, 1.0))
        for (const double side : {-1.0, 1.0}) {
            const FeatureCell cell = cells_of(surface, {arc.centre + side * length * arc.middle}).front();
            EXPECT_TRUE(cell.kind == Kind::None || cell == (FeatureCell{Kind::Arc, 0})) << ulp;
            if (ulp > 4) {
                EXPECT_EQ(cell.kind, Kind::Arc);
            }
        }
}

TEST(FeatureWalk, LeavesPointsOnABorderToASearch) {
    const AccessibleSurface surface(two_spheres(3.0), 1.4);
    const SasArc& arc = surface.data().arcs.front();
    const Vec3 on_arc = arc.centre + arc.radius * arc.middle;
    const Vec3 border = 0.5 * (on_arc + surface.data().atoms.centres[arc.atoms[0]]);
    const std::vector<FeatureCell> cells =
        cells_of(surface, {border, border + 1e-3 * arc.axis, border - 1e-3 * arc.axis});
    EXPECT_EQ(cells[0].kind, Kind::None);
    EXPECT_EQ(cells[1].kind, Kind::Arc);
    EXPECT_EQ(cells[2].kind, Kind::Ball);
}

}  // namespace
}  // namespace meniscus::testing

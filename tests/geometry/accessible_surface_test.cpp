// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/accessible_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "core/parallel.h"
#include "geometry/accessible_surface_data.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "support/arrangements.h"
#include "support/test_data.h"

namespace meniscus::testing {
namespace {

constexpr double kProbe = 1.4;

struct Counts {
    std::size_t atoms = 0;
    std::size_t exposed = 0;
    std::size_t arcs = 0;
    std::size_t vertices = 0;
    bool operator==(const Counts&) const = default;
};

Counts counts_of(const AccessibleSurface& surface) {
    return {surface.atom_count(), surface.exposed_atom_count(), surface.arc_count(), surface.vertex_count()};
}
Counts counts_of(const Atoms& atoms, double probe = kProbe) { return counts_of(AccessibleSurface(atoms, probe)); }

std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.atoms << " atoms, " << c.exposed << " exposed, " << c.arcs << " arcs, " << c.vertices
               << " vertices";
}

void expect_in_no_ball(const AccessibleSurface::Data& data, const Vec3& p) {
    for (std::size_t i = 0; i < data.atoms.size(); ++i) EXPECT_GT(norm(p - data.atoms.centres[i]), data.rho[i] - 1e-8);
}

void expect_on_ball(const AccessibleSurface::Data& data, std::uint32_t atom, const Vec3& p) {
    EXPECT_NEAR(norm(p - data.atoms.centres[atom]), data.rho[atom], 1e-8);
}

// From the definitions: what a vertex, an arc and the perturbation of the radii are.
void expect_right_features(const AccessibleSurface& surface) {
    const AccessibleSurface::Data& data = surface.data();
    EXPECT_LE(data.perturbation, 1e-9);
    for (std::size_t i = 0; i < data.atoms.size(); ++i)
        EXPECT_NEAR(data.rho[i], data.atoms.radii[i] + data.probe, 1.0001 * data.perturbation);
    for (const SasVertex& vertex : data.vertices) {
        for (const std::uint32_t atom : vertex.atoms) expect_on_ball(data, atom, vertex.position);
        expect_in_no_ball(data, vertex.position);
    }
    std::size_t arc_ends = 0;
    for (const SasArc& arc : data.arcs) {
        const Vec3 middle = arc.centre + arc.radius * arc.middle;
        for (const std::uint32_t atom : arc.atoms) expect_on_ball(data, atom, middle);
        expect_in_no_ball(data, middle);
        EXPECT_LT(arc.atoms[0], arc.atoms[1]);
        if (arc.whole_circle()) continue;
        arc_ends += 2;
        for (const std::uint32_t end : {arc.start, arc.end}) {
            ASSERT_LT(end, data.vertices.size());
            const Vec3 radial = normalised(data.vertices[end].position - arc.centre);
            EXPECT_NEAR(dot(radial, arc.middle), arc.cos_half, 1e-6);
        }
    }
    EXPECT_EQ(arc_ends, 3 * data.vertices.size());
}

void expect_same_distances(const AccessibleSurface& a, const AccessibleSurface& b, const std::vector<Vec3>& points) {
    const std::vector<double> expected = signed_distance(a, points);
    const std::vector<double> actual = signed_distance(b, points);
    EXPECT_EQ(expected, actual);
}

Vec3 turned(const Vec3& p) {  // by a rotation that leaves no coordinate axis in place
    const Vec3 axis = normalised({1, 2, -0.7});
    const double angle = 0.8;
    return std::cos(angle) * p + std::sin(angle) * cross(axis, p) + (1 - std::cos(angle)) * dot(axis, p) * axis;
}

TEST(AccessibleSurface, OneSphereHasNoArcs) { EXPECT_EQ(counts_of({{{1, 2, 3}}, {1.7}}), (Counts{1, 1, 0, 0})); }

TEST(AccessibleSurface, TwoSpheresShareAWholeCircle) {
    const AccessibleSurface surface(two_spheres(3.0, 1.7, 1.5), kProbe);
    EXPECT_EQ(counts_of(surface), (Counts{2, 2, 1, 0}));
    const SasArc& arc = surface.data().arcs[0];
    EXPECT_TRUE(arc.whole_circle());
    const double x = (9.0 + 3.1 * 3.1 - 2.9 * 2.9) / 6.0;
    EXPECT_NEAR(arc.centre.x, x, 1e-9);
    EXPECT_NEAR(arc.radius, std::sqrt(3.1 * 3.1 - x * x), 1e-9);
    EXPECT_NEAR(arc.height0 + arc.height1, 3.0, 1e-12);
    expect_right_features(surface);
}

TEST(AccessibleSurface, SpheresApartShareNothing) {
    EXPECT_EQ(counts_of(two_spheres(9.0)), (Counts{2, 2, 0, 0}));
    EXPECT_EQ(counts_of({{{0, 0, 0}, {1e6, 0, 0}, {0, 0, 1e9}}, {1, 1, 1}}), (Counts{3, 3, 0, 0}));
}

TEST(AccessibleSurface, ThreeSpheresHaveTwoVerticesAndThreeArcs) {
    EXPECT_EQ(counts_of(triangle(3.0, 1.5)), (Counts{3, 3, 3, 2}));
}

TEST(AccessibleSurface, ThreeWideSpheresLeaveAHoleBetweenThem) {
    EXPECT_EQ(counts_of(triangle(6.0, 1.7)), (Counts{3, 3, 3, 0}));
}

// A patch per exposed atom, each bounded by one loop: V - E + F = 2.
TEST(AccessibleSurface, CountsOfClosedSurfacesFollowEuler) {
    EXPECT_EQ(counts_of(tetrahedral_spheres(2.4, 1.5)), (Counts{4, 4, 6, 4}));
    EXPECT_EQ(counts_of(octahedron(2.6, 1.7)), (Counts{6, 6, 12, 8}));
    EXPECT_EQ(counts_of(equal_spheres({{0, 0, 0}, {2, 0, 0}, {1, 1, 1.5}, {1, 1, -1.5}, {1, 1.7, 0}}, 1.6)).exposed,
              5U);
}

TEST(AccessibleSurface, AVoidDoublesTheCounts) {
    // Balls reach neither the middle nor leave a gap: an outer surface and a wall, each of them closed.
    EXPECT_EQ(counts_of(octahedron(3.5, 1.7)), (Counts{6, 6, 24, 16}));
}

TEST(AccessibleSurface, CollinearSpheresHaveParallelCircles) {
    EXPECT_EQ(counts_of(line(5, 1.5, 1.6)), (Counts{5, 5, 4, 0}));
}

TEST(AccessibleSurface, AnAtomInsideAnotherIsBuried) {
    EXPECT_EQ(counts_of({{{0, 0, 0}, {0.3, 0, 0}}, {2.0, 1.0}}), (Counts{2, 1, 0, 0}));
    EXPECT_EQ(counts_of({{{0, 0, 0}, {0, 0, 0}}, {2.0, 1.0}}), (Counts{1, 1, 0, 0}));
}

TEST(AccessibleSurface, DuplicatesCountOnce) {
    EXPECT_EQ(counts_of({{{0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {-0.0, 0, 0}}, {1.7, 1.5, 1.7, 1.7}}), (Counts{2, 2, 1, 0}));
}

TEST(AccessibleSurface, RingHasTwoVerticesPerCrowdedTripleOrNone) {
    const Counts wide = counts_of(ring(12, 5.0, 1.7));
    EXPECT_EQ(wide.exposed, 12U);
    EXPECT_EQ(3 * wide.vertices % 2, 0U);
    EXPECT_EQ(counts_of(ring(6, 4.0, 1.0)), (Counts{6, 6, 6, 0}));
}

TEST(AccessibleSurface, TangentSpheresAreDecidedOneWayOrTheOther) {
    const Counts counts = counts_of(two_spheres(6.2));
    EXPECT_LE(counts.arcs, 1U);
    EXPECT_EQ(counts.vertices, 0U);
}

TEST(AccessibleSurface, SixSpheresThroughOneProbePositionAreResolved) {
    const double rho = 1.7 + kProbe;
    const AccessibleSurface tie(octahedron(rho, 1.7), kProbe);
    expect_right_features(tie);
    EXPECT_GE(tie.vertex_count(), 8U);
    EXPECT_EQ(counts_of(octahedron(rho - 1e-6, 1.7)), (Counts{6, 6, 12, 8}));
    EXPECT_EQ(counts_of(octahedron(rho + 1e-6, 1.7)), (Counts{6, 6, 24, 16}));
}

TEST(AccessibleSurface, FeaturesOfAwkwardArrangementsAreRight) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        expect_right_features(AccessibleSurface(a.atoms, a.probe));
    }
}

TEST(AccessibleSurface, FeaturesOfRandomClustersAreRight) {
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        expect_right_features(AccessibleSurface(random_cluster(seed, 150, 14.0), seed % 2 == 0 ? kProbe : 0.3));
}

TEST(AccessibleSurface, FeaturesOfLargeLatticesAreRight) {
    for (const double step : {1.5, 2.0, 3.1, 4.0, 5.0}) {
        SCOPED_TRACE(step);
        expect_right_features(AccessibleSurface(cubic_lattice(5, step, 1.6), kProbe));
    }
}

TEST(AccessibleSurface, DistancesKeepTheirBitsUnderReordering) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        const std::vector<Vec3> points = random_points_around(a.atoms, 300, 3.0);
        const AccessibleSurface surface(a.atoms, a.probe);
        for (std::uint64_t seed = 1; seed < 4; ++seed) {
            const AccessibleSurface other(shuffled(a.atoms, seed).atoms, a.probe);
            EXPECT_EQ(counts_of(surface), counts_of(other));
            expect_same_distances(surface, other, points);
        }
    }
}

TEST(AccessibleSurface, FeaturesKnowThoseThatTouchThem) {
    const AccessibleSurface surface(random_cluster(7, 150, 14.0), kProbe);
    const AccessibleSurface::Data& data = surface.data();
    const auto belongs = [&](std::uint32_t arc, std::uint32_t atom) {
        return data.arcs[arc].atoms[0] == atom || data.arcs[arc].atoms[1] == atom;
    };
    for (std::uint32_t v = 0; v < data.vertices.size(); ++v)
        for (std::size_t k = 0; k < 3; ++k) {
            const SasArc& arc = data.arcs.at(data.vertices[v].arcs[k]);
            EXPECT_TRUE(arc.start == v || arc.end == v);
            EXPECT_FALSE(belongs(data.vertices[v].arcs[k], data.vertices[v].atoms[k]));
        }
    ASSERT_EQ(data.cap_arc.size(), data.caps.size());
    std::size_t linked = 0;
    for (std::uint32_t i = 0; i < data.atoms.size(); ++i)
        for (std::uint64_t c = data.cap_begin[i]; c < data.cap_begin[i + 1]; ++c) {
            if (data.cap_arc[c] == kNoArc) continue;
            ++linked;
            ASSERT_TRUE(belongs(data.cap_arc[c], i));
            const SasArc& arc = data.arcs[data.cap_arc[c]];
            EXPECT_NEAR(std::abs(dot(arc.axis, data.caps[c].axis)), 1.0, 1e-12);
        }
    EXPECT_GT(linked, 100U);
}

TEST(AccessibleSurface, AtomsAreNamedInTheCallersOrder) {
    const Atoms atoms = random_cluster(8, 60, 10.0);
    const AccessibleSurface surface(atoms, kProbe);
    const Shuffled other = shuffled(atoms, 2);
    const AccessibleSurface reordered(other.atoms, kProbe);
    for (const Vec3& p : random_points_around(atoms, 500, 3.0))
        EXPECT_EQ(surface.nearest(p).atom, other.order[reordered.nearest(p).atom]);
}

TEST(AccessibleSurface, DistancesKeepTheirBitsForAnyNumberOfThreads) {
    const Atoms atoms = random_cluster(9, 2000, 40.0);
    const AccessibleSurface two(atoms, kProbe);
    const ThreadLimit limit(1);
    const AccessibleSurface one(atoms, kProbe);
    EXPECT_EQ(counts_of(one), counts_of(two));
    expect_same_distances(one, two, random_points_around(atoms, 1000, 3.0));
}

TEST(AccessibleSurface, MovesWithTheAtoms) {
    const Atoms atoms = random_cluster(10, 100, 12.0);
    const std::vector<Vec3> points = random_points_around(atoms, 1000, 3.0);
    const AccessibleSurface surface(atoms, kProbe);
    const std::vector<double> expected = signed_distance(surface, points);
    const auto expect_moved = [&](const auto& move) {
        Atoms moved = atoms;
        for (Vec3& c : moved.centres) c = move(c);
        const AccessibleSurface other(moved, kProbe);
        EXPECT_EQ(counts_of(surface), counts_of(other));
        for (std::size_t i = 0; i < points.size(); ++i)
            EXPECT_NEAR(other.nearest(move(points[i])).signed_distance, expected[i], 2e-9);
    };
    expect_moved([](const Vec3& p) { return p + Vec3{1000.25, -77.5, 3.125}; });
    expect_moved([](const Vec3& p) { return turned(p); });
    expect_moved([](const Vec3& p) { return Vec3{-p.x, p.y, p.z}; });
}

TEST(AccessibleSurface, LipschitzConstantOfTheDistanceIsOne) {
    const Atoms atoms = random_cluster(11, 80, 10.0);
    const AccessibleSurface surface(atoms, kProbe);
    const std::vector<Vec3> from = random_points_around(atoms, 2000, 4.0, 1);
    const std::vector<Vec3> step = random_points_around({{{0, 0, 0}}, {1.0}}, 2000, 0.3, 2);
    for (std::size_t i = 0; i < from.size(); ++i)
        EXPECT_LE(
            std::abs(surface.nearest(from[i] + step[i]).signed_distance - surface.nearest(from[i]).signed_distance),
            norm(step[i]) + 1e-8);
}

// perturbed() finds the contours with the help of the first ones; the constructor does without.
TEST(AccessibleSurface, PerturbedIsWhatTheConstructorFindsWithThatSeed) {
    std::vector<Atoms> arrangements = {
        two_spheres(3.0), cubic_lattice(4, 2.8, 1.6), {{{0, 0, 0}, {0.1, 0, 0}}, {3, 1}}};
    // Which of these covers the other the perturbation decides.
    arrangements.push_back({{{0.3, 0, 0}, {std::nextafter(0.3, 1.0), 0, 0}}, {1.7, 1.7}});
    for (std::uint64_t seed = 0; seed < 20; ++seed) arrangements.push_back(random_cluster(seed, 120, 12.0));
    for (const Atoms& atoms : arrangements) {
        const AccessibleSurface anew(atoms, kProbe, 1);
        const AccessibleSurface perturbed = AccessibleSurface(atoms, kProbe).perturbed(1);
        EXPECT_EQ(counts_of(perturbed), counts_of(anew));
        for (const Vec3& p : random_points_around(atoms, 200, 4.0, 3))
            EXPECT_NEAR(perturbed.nearest(p).signed_distance, anew.nearest(p).signed_distance, 1e-13);
    }
}

TEST(AccessibleSurface, RefusesInvalidInput) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Atoms one{{{0, 0, 0}}, {1.5}};
    EXPECT_THROW(AccessibleSurface({}, kProbe), std::invalid_argument);
    EXPECT_THROW(AccessibleSurface({{{0, 0, 0}}, {0.0}}, kProbe), std::invalid_argument);
    EXPECT_THROW(AccessibleSurface({{{0, 0, 0}}, {kNan}}, kProbe), std::invalid_argument);
    EXPECT_THROW(AccessibleSurface({{{0, kInfinity, 0}}, {1.0}}, kProbe), std::invalid_argument);
    EXPECT_THROW(AccessibleSurface({{{0, 0, 0}, {1, 1, 1}}, {1.0}}, kProbe), std::invalid_argument);
    for (const double probe : {-0.1, kNan, kInfinity}) EXPECT_THROW(AccessibleSurface(one, probe), UsageError);
    const AccessibleSurface surface(one, kProbe);
    EXPECT_THROW(signed_distance(surface, std::vector<Vec3>{{0, 0, kNan}}), std::invalid_argument);
    EXPECT_THROW(signed_distance(surface, std::vector<Vec3>{{kInfinity, 0, 0}}), std::invalid_argument);
}

TEST(AccessibleSurface, CanBeMoved) {
    AccessibleSurface a(two_spheres(3.0), kProbe);
    AccessibleSurface b = std::move(a);
    EXPECT_EQ(b.arc_count(), 1U);
    b = AccessibleSurface({{{0, 0, 0}}, {1.0}}, 0.7);
    EXPECT_EQ(b.atom_count(), 1U);
    EXPECT_EQ(b.probe(), 0.7);
}

TEST(AccessibleSurface, FeaturesOfEverySphereFileAreRight) {
    MENISCUS_NEED_TEST_DATA();
    for (const auto& entry : std::filesystem::directory_iterator(*test_data() / "reference/spheres")) {
        SCOPED_TRACE(entry.path().filename().string());
        expect_right_features(AccessibleSurface(read_spheres(entry.path()), kProbe));
    }
}

TEST(AccessibleSurface, FeaturesOfCrambinAreRight) {
    MENISCUS_NEED_TEST_DATA();
    expect_right_features(AccessibleSurface(read_spheres(*test_data() / "reference/xyzr/1crn.xyzr"), kProbe));
}

}  // namespace
}  // namespace meniscus::testing

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Properties of the exact measures on thousands of arrangements made to be degenerate.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact/reentrant_patches.h"
#include "geometry/accessible_surface.h"
#include "meniscus/measures.h"

namespace meniscus {
namespace {

class Arrangements {
public:
    explicit Arrangements(unsigned seed) : random_(seed) {}

    enum Kind { Gas, Rounded, Lattice, HalfLattice, Planar, Collinear, Cospherical, Tangent, Nested, Sheet };
    static constexpr int kKinds = Sheet + 1;

    Atoms make(Kind kind) {
        const int count = 1 + pick(pick(4) == 0 ? 200 : 30);
        const double extent = std::cbrt(count) * real(0.5, 3.5);
        const bool equal = pick(2) == 0;
        const double common = real(0.5, 2.5);
        Atoms atoms;
        for (int i = 0; i < count; ++i) {
            Vec3 p{real(0, extent), real(0, extent), real(0, extent)};
            double r = equal ? common : real(0.3, 2.5);
            shape(kind, extent, atoms, p, r);
            atoms.centres.push_back(p);
            atoms.radii.push_back(std::max(r, 0.05));
        }
        return atoms;
    }

    double probe() { return pick(5) == 0 ? real(0.1, 4.0) : 1.4; }

private:
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    double real(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
    static Vec3 rounded(const Vec3& p, double to) {
        return {to * std::round(p.x / to), to * std::round(p.y / to), to * std::round(p.z / to)};
    }

    void shape(Kind kind, double extent, const Atoms& before, Vec3& p, double& r) {
        const Vec3 middle = 0.5 * Vec3{extent, extent, extent};
        if (kind == Rounded) p = rounded(p, 0.001);
        if (kind == Lattice) p = rounded(p, 1.0);
        if (kind == HalfLattice) p = rounded(p, 0.5), r = 0.5 * std::round(2.0 * r) + 0.5;
        if (kind == Planar) p.z = 0.0;
        if (kind == Collinear) p.y = p.z = 0.0;
        if (kind == Cospherical && norm(p - middle) > 1e-6) p = (0.4 * extent + 0.1) * normalised(p - middle);
        if (kind == Sheet) p = 1.2 * rounded({p.x, p.y, 0.0}, 1.0), r = 1.0;
        if (before.empty()) return;
        if (kind == Tangent && norm(p - middle) > 1e-6)
            p = before.centres.back() + (before.radii.back() + r) * normalised(p - middle);
        if (kind == Nested && pick(2) == 0) {
            p = before.centres[static_cast<std::size_t>(pick(static_cast<int>(before.size())))];
            if (pick(3) != 0) p += Vec3{real(-0.3, 0.3), real(-0.3, 0.3), real(-0.3, 0.3)};
        }
    }

    std::mt19937_64 random_;
};

// Area of all spherical triangles before they are trimmed, Å².
double triangle_area(const Atoms& atoms, double probe) {
    double solid_angle = 0.0;
    for (const ReentrantPatch& patch : trim_reentrant_patches(AccessibleSurface(atoms, probe), 0))
        solid_angle += patch.triangle;
    return probe * probe * solid_angle;
}

class Torture : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Kinds, Torture, ::testing::Range(0, Arrangements::kKinds));

TEST_P(Torture, MeasuresAreFiniteOrderedAndAgreed) {
    Arrangements arrangements(static_cast<unsigned>(100 + GetParam()));
    for (int round = 0; round < 300; ++round) {
        SCOPED_TRACE(round);
        const Atoms atoms = arrangements.make(static_cast<Arrangements::Kind>(GetParam()));
        const double probe = arrangements.probe();
        const Measures m = measure(atoms, {.probe = probe});
        const Measures vdw = measure(atoms, {.probe = 0.0, .cavities = false});
        const Measures larger = measure(atoms, {.probe = 1.1 * probe, .cavities = false});
        EXPECT_TRUE(m.agreed);
        EXPECT_TRUE(std::isfinite(m.totals.ses_area) && std::isfinite(m.totals.ses_volume));
        const double slack = 1e-6 * m.totals.sas_volume;
        EXPECT_GE(m.totals.reentrant_area, -1e-7);
        EXPECT_LE(m.totals.reentrant_area, triangle_area(atoms, probe) + 1e-6 * m.totals.ses_area);
        EXPECT_GE(m.totals.ses_volume, vdw.totals.ses_volume - slack);
        EXPECT_LE(m.totals.ses_volume, m.totals.sas_volume + slack);
        EXPECT_GE(larger.totals.ses_volume, m.totals.ses_volume - slack) << "monotone in the probe radius";
        for (const SurfaceComponent& c : m.components) EXPECT_GT(c.ses_area, -1e-6);
    }
}

}  // namespace
}  // namespace meniscus

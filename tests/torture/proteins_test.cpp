// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Real molecules, turned and moved at random: what is exact does not change, what is meshed stays sound.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "meniscus/structure.h"
#include "support/test_data.h"
#include "torture/surface_checks.h"
#include "torture/torture_count.h"

namespace meniscus::testing {
namespace {

// Evenly distributed turns, from unit quaternions, and a shift of up to 1000 Å.
class RigidMotion {
public:
    explicit RigidMotion(std::mt19937_64& random) {
        std::normal_distribution<double> normal;
        w_ = normal(random);
        v_ = {normal(random), normal(random), normal(random)};
        const double length = std::sqrt(w_ * w_ + squared_norm(v_));
        w_ /= length;
        v_ = (1.0 / length) * v_;
        std::uniform_real_distribution<double> shift(-1000.0, 1000.0);
        shift_ = {shift(random), shift(random), shift(random)};
    }
    Vec3 operator()(const Vec3& p) const {
        const Vec3 t = 2.0 * cross(v_, p);
        return p + w_ * t + cross(v_, t) + shift_;
    }

private:
    double w_ = 1.0;
    Vec3 v_;
    Vec3 shift_;
};

Atoms moved(Atoms atoms, const RigidMotion& motion) {
    for (Vec3& c : atoms.centres) c = motion(c);
    return atoms;
}

void expect_sound(const Atoms& atoms, Method method, double spacing, SignCount& signs) {
    const Surface surface = compute_surface(atoms, {.method = method, .spacing = spacing}, {.threads = 1});
    const AccessibleSurface exact(atoms, 1.4);
    EXPECT_TRUE(surface.passed());
    EXPECT_EQ(what_is_wrong_with_mesh(surface, atoms.size()), "");
    EXPECT_EQ(what_is_wrong_with_places(surface, exact), "");
    if (method == Method::Flow) signs += count_signs(surface, atoms, exact, 5000);
}

void expect_same_wherever_it_lies(const Atoms& atoms, int motions) {
    std::mt19937_64 random(atoms.size());
    const Measures m = measure(atoms, {.threads = 1});
    SignCount signs;
    for (int i = 0; i < motions; ++i) {
        const Atoms elsewhere = moved(atoms, RigidMotion(random));
        const Measures other = measure(elsewhere, {.threads = 1});
        EXPECT_TRUE(other.agreed);
        EXPECT_NEAR(other.totals.sas_area / m.totals.sas_area, 1.0, 1e-8);
        EXPECT_NEAR(other.totals.ses_area / m.totals.ses_area, 1.0, 1e-8);
        EXPECT_NEAR(other.totals.ses_volume / m.totals.ses_volume, 1.0, 1e-8);
        EXPECT_EQ(other.components.size(), m.components.size());
        expect_sound(elsewhere, i % 2 == 0 ? Method::Flow : Method::Direct, i % 4 < 2 ? 0.5 : 0.7, signs);
    }
    EXPECT_EQ(signs.far_wrong, 0U) << signs.first_far;
    EXPECT_LE(1e3 * static_cast<double>(signs.wrong), static_cast<double>(signs.asked));
}

TEST(Proteins, UbiquitinStaysItself) {
    expect_same_wherever_it_lies(read_structure(MENISCUS_EXAMPLES "/1ubq.pdb").atoms, torture_count(4));
}

TEST(Proteins, OthersStayThemselves) {
    MENISCUS_NEED_TEST_DATA();
    for (const char* name :
         {"1crn.pdb", "1bna.pdb", "1l2y.pdb", "1ETN.xyzr", "fullerene.xyzr", "1en2.cif", "4pti.ent"}) {
        const std::filesystem::path path = *test_data() / "structures" / name;
        if (!std::filesystem::exists(path)) continue;
        SCOPED_TRACE(name);
        expect_same_wherever_it_lies(read_structure(path.string()).atoms, torture_count(2));
    }
}

}  // namespace
}  // namespace meniscus::testing

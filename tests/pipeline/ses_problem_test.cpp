// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "meniscus/errors.h"
#include "meniscus/surface.h"

namespace meniscus {
namespace {

const Atoms kTwo{{{0, 0, 0}, {5, 0, 0}}, {1.5, 2.0}};

TEST(SesProblem, EnlargesAtomsForTheAccessibleSurface) {
    const SesProblem ses = ses_problem(kTwo, {.probe = 1.25});
    EXPECT_EQ(ses.atoms.radii, kTwo.radii);
    EXPECT_EQ(ses.probe, 1.25);
    const SesProblem sas = ses_problem(kTwo, {.surface = SurfaceKind::Sas, .probe = 1.25});
    EXPECT_EQ(sas.atoms.radii, (std::vector<double>{2.75, 3.25}));
    EXPECT_EQ(sas.atoms.centres, kTwo.centres);
    EXPECT_EQ(sas.probe, 0.0);
    const SesProblem vdw = ses_problem(kTwo, {.surface = SurfaceKind::Vdw, .probe = 1.25});
    EXPECT_EQ(vdw.atoms.radii, kTwo.radii);
    EXPECT_EQ(vdw.probe, 0.0);
}

TEST(SesProblem, ABallsSurfacesAreSpheres) {
    const Atoms ball{{{0.1, 0.2, 0.3}}, {1.6}};
    for (const Method method : {Method::Flow, Method::Direct}) {
        const Surface sas = compute_surface(ball, {.method = method, .surface = SurfaceKind::Sas, .spacing = 0.25});
        EXPECT_NEAR(sas.corrected_area / (4.0 * std::numbers::pi * 9.0), 1.0, 1e-3);
        EXPECT_NEAR(sas.corrected_volume / (36.0 * std::numbers::pi), 1.0, 1e-3);
        EXPECT_TRUE(sas.passed());
        for (const PatchKind patch : sas.mesh.patches) ASSERT_EQ(patch, PatchKind::Contact);
        const Surface vdw = compute_surface(ball, {.method = method, .surface = SurfaceKind::Vdw, .spacing = 0.25});
        EXPECT_NEAR(vdw.corrected_area / (4.0 * std::numbers::pi * 1.6 * 1.6), 1.0, 1e-3);
    }
}

TEST(SesProblem, TheEnvelopeIsOneForAll) {
    EXPECT_THROW(compute_surface(kTwo, {.method = Method::Gaussian, .surface = SurfaceKind::Sas}), UsageError);
}

}  // namespace
}  // namespace meniscus

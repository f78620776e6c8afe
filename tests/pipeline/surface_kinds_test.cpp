// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "meniscus/errors.h"
#include "meniscus/surface.h"

namespace meniscus {
namespace {

const Atoms kTwo{{{0, 0, 0}, {5, 0, 0}}, {1.5, 2.0}};

TEST(SurfaceKinds, ABallsSurfacesAreSpheres) {
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

TEST(SurfaceKinds, TheEnvelopeIsOneForAll) {
    EXPECT_THROW(compute_surface(kTwo, {.method = Method::Gaussian, .surface = SurfaceKind::Sas}), UsageError);
}

}  // namespace
}  // namespace meniscus

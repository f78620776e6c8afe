// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Properties of surfaces of arrangements made to be awkward, for both methods, several spacings and probes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "torture/properties.h"
#include "torture/surface_checks.h"

namespace meniscus::testing {
namespace {

using Case = std::pair<Arrangement, double>;

// At one of the spacings, or a coarser one where that would make more than some thousand vertices.
SurfaceOptions options_of(const Case& made, Method method) {
    constexpr double kMostVertices = 4000.0;
    SurfaceOptions options{.method = method, .probe = made.first.probe, .spacing = made.second};
    while (estimate_cost(made.first.atoms, options).vertices > kMostVertices) options.spacing *= 1.25;
    return options;
}

struct Computed {
    Computed(const Case& made, Method method)
        : atoms(made.first.atoms),
          surface(compute_surface(atoms, options_of(made, method), {.threads = 1})),
          exact(atoms, made.first.probe) {}

    Atoms atoms;
    Surface surface;
    AccessibleSurface exact;
};

// No atom and no probe is small against the grid. Without a probe there are creases, which a mesh cuts off.
bool shows_all(const Atoms& atoms, double probe, double h) {
    return h <= 0.6 && probe > 1.5 * h && *std::min_element(atoms.radii.begin(), atoms.radii.end()) > 1.5 * h;
}

void expect_sound(const Computed& computed) {
    const double h = computed.surface.options.spacing;
    const bool shown = shows_all(computed.atoms, computed.exact.probe(), h);
    for (const std::string& wrong :
         {what_is_wrong_with_mesh(computed.surface, computed.atoms.size()),
          what_is_wrong_with_places(computed.surface, computed.exact),
          what_is_wrong_with_size(computed.surface, computed.atoms, shown ? 0.5 : 1.0, 0.05)})
        if (!wrong.empty()) RC_FAIL(wrong + ", spacing " + std::to_string(h));
}

TEST(SurfaceProperties, OfTheDirectMethod) {
    for_all<Case>(800, arrangements_with_spacings(), [](const Case& made) {
        const Computed computed(made, Method::Direct);
        expect_sound(computed);
        const SignCount signs = count_windings(computed.surface, computed.atoms, computed.exact, 30);
        if (signs.far_wrong > 0) RC_FAIL("the mesh is on the wrong side " + signs.first_far);
    });
}

TEST(SurfaceProperties, OfTheFlow) {
    SignCount fine;
    SignCount coarse;
    for_all<Case>(1000, arrangements_with_spacings(), [&](const Case& made) {
        const Computed computed(made, Method::Flow);
        expect_sound(computed);
        const SignCount signs = count_signs(computed.surface, computed.atoms, computed.exact, 1000);
        for (const Check& check : computed.surface.checks)
            if (check.name == "pieces" && !check.passed)
                RC_FAIL("pieces with the wrong side in the middle: " + std::to_string(check.value));
        if (signs.far_wrong > 0) RC_FAIL("the level set has the wrong sign " + signs.first_far);
        (computed.surface.options.spacing <= 0.6 ? fine : coarse) += signs;
    });
    // One arrangement alone may have much of what no grid shows.
    std::printf(
        "points farther than a tenth of a spacing on the wrong side: %zu of %zu at spacings up to 0.6 Å, %zu of "
        "%zu at larger ones; farther than a spacing: none\n",
        fine.wrong, fine.asked, coarse.wrong, coarse.asked);
    fine += coarse;
    EXPECT_LE(1e3 * static_cast<double>(fine.wrong), static_cast<double>(fine.asked));
}

// Pieces that the grid shows are all there, on the right side, and there are no others.
TEST(SurfaceProperties, OfVesselsWithAndWithoutIslands) {
    for_all<Vessel>(60, any_vessel(), [](const Vessel& vessel) {
        const Measures exact = measure(vessel.atoms, {.threads = 1});
        RC_ASSERT(exact.components.size() == (vessel.island ? 3U : 2U));
        for (const Method method : {Method::Direct, Method::Flow}) {
            const Surface surface =
                compute_surface(vessel.atoms, {.method = method, .spacing = vessel.spacing}, {.threads = 1});
            const std::vector<MeshComponent>& found = surface.measures.components;
            RC_ASSERT(found.size() == exact.components.size());
            for (std::size_t c = 0; c < found.size(); ++c) {  // both by falling volume
                const SurfaceComponent& piece = exact.components[c];
                RC_ASSERT((found[c].volume < 0.0) == (piece.kind == ComponentKind::Cavity));
                RC_ASSERT(std::abs(std::abs(found[c].volume) - piece.ses_volume) <
                          0.1 * vessel.spacing * piece.ses_area);
            }
        }
    });
}

}  // namespace
}  // namespace meniscus::testing

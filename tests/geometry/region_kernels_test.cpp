// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/region_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "core/perpendicular.h"
#include "geometry/random_caps.h"

namespace meniscus::testing {
namespace {

// Contours of random caps, with whole rims among them.
struct Contours {
    ContourBuilder builder;
    std::span<const CapPlane> planes;  // that arcs number

    explicit Contours(std::uint64_t seed) {
        const std::vector<Cap> given = random_caps(seed, 11, 0.3, 0.95);
        EXPECT_TRUE(builder.build(columns_of(given)));
        planes = builder.kept_caps();
    }
    // An arc that each one might be followed by.
    std::vector<std::uint32_t> next() const {
        std::vector<std::uint32_t> next;
        for (std::uint32_t a = 0; a < builder.arcs().size(); ++a)
            next.push_back(static_cast<std::uint32_t>((a + 1) % builder.arcs().size()));
        return next;
    }
    std::vector<MeasuredArc> measured_by(const RegionKernels& kernels) const {
        std::vector<MeasuredArc> measured(builder.arcs().size());
        kernels.find_corners(planes, builder.arcs(), measured);
        for (std::size_t a = 0; a < measured.size(); ++a)
            if (builder.arcs()[a].from == kWholeCircle) measured[a].start = perpendicular(planes[0].axis);
        kernels.measure_arcs(planes, builder.arcs(), next(), measured);
        return measured;
    }
};

TEST(RegionKernels, AllInstructionSetsGiveTheSameBits) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        const Contours contours(seed);
        const auto plain = contours.measured_by(supported_region_kernels().front());
        for (const RegionKernels& kernels : supported_region_kernels()) {
            const auto measured = contours.measured_by(kernels);
            for (std::size_t a = 0; a < plain.size(); ++a) {
                EXPECT_EQ(measured[a].start, plain[a].start) << kernels.instructions;
                EXPECT_EQ(measured[a].end, plain[a].end) << kernels.instructions;
                EXPECT_EQ(measured[a].area, plain[a].area) << kernels.instructions;
                EXPECT_EQ(measured[a].angle, plain[a].angle) << kernels.instructions;
                if (contours.builder.arcs()[a].from == kWholeCircle) continue;
                EXPECT_EQ(measured[a].corner, plain[a].corner) << kernels.instructions;
            }
        }
    }
}

TEST(RegionKernels, ArcsStartWhereRimsCross) {
    const Contours contours(7);
    const auto measured = contours.measured_by(region_kernels());
    for (std::size_t a = 0; a < measured.size(); ++a) {
        const ContourArc& arc = contours.builder.arcs()[a];
        if (arc.from == kWholeCircle) continue;
        const CapPlane& from = contours.planes[arc.from];
        const CapPlane& onto = contours.planes[arc.cap];
        const Vec3 crossing = rim_crossing({from.axis, from.t, arc.from}, {onto.axis, onto.t, arc.cap});
        EXPECT_NEAR(norm(measured[a].start - crossing), 0.0, 1e-14);
        // The corner is the angle of both rims' directions there.
        const Vec3 before = normalised(cross(measured[a].start, from.axis));
        const Vec3 after = normalised(cross(measured[a].start, onto.axis));
        EXPECT_NEAR(std::cos(measured[a].corner), dot(before, after), 1e-13);
        EXPECT_GE(measured[a].corner, 0.0);
    }
}

}  // namespace
}  // namespace meniscus::testing

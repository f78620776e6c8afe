// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/check_options.h"

#include <cmath>
#include <string>

#include "core/number_text.h"
#include "core/requirements.h"
#include "meniscus/describe_options.h"

namespace meniscus {
namespace {

constexpr double kFinest = 1e-6;        // Å, of grids: no structure's coordinates are finer
constexpr double kNarrowestBand = 2.0;  // spacings
constexpr double kWidestBand = 16.0;

// Holds numbers against the ranges that their descriptions have.
struct RangeCheck {
    const SurfaceOptions& options;

    void operator()(const Option& option, double value) const {
        if (has_effect(option, options))
            require(contains(option.range, value), option.name, value, words_for(option.range));
    }
    template <class Member, class... Words>
    void operator()(const Option& /*option*/, const Member& /*member*/, const Words&... /*words*/) const {}
};

}  // namespace

void check_options(const SurfaceOptions& options) {
    const FlowOptions& flow = options.flow;
    const RemeshOptions& remesh = options.remesh;
    describe(options, RangeCheck{options});
    if (options.method == Method::Gaussian && options.surface != SurfaceKind::Ses)
        throw UsageError(
            "method gaussian gives a single envelope of the atoms; for surface sas or vdw use method flow or direct");
    require(options.spacing >= kFinest, "spacing", options.spacing, "at least 1e-6");
    if (options.method == Method::Flow) {
        require(std::isfinite(flow.time_step) || flow.anchor > 0.0, "time step", flow.time_step,
                "finite without an anchor");
        require(flow.half_width >= kNarrowestBand && flow.half_width <= kWidestBand, "half width", flow.half_width,
                joined("from 2 to ", in_short(kWidestBand)));
        require(flow.max_steps >= 1, "max steps", flow.max_steps, "at least 1");
    }
    require(remesh.edge == 0.0 || (is_positive(remesh.edge) && remesh.edge >= kFinest), "edge", remesh.edge,
            "finite and at least 1e-6");
    require(!remesh.is_on() || options.spacing <= kCoarsestForRemeshing, "spacing", options.spacing,
            joined("at most ", in_short(kCoarsestForRemeshing), " for a mesh of even triangles"));
    require(remesh.corners == Corners::Near || remesh.is_on(), "edge", remesh.edge,
            "positive with any corners but near");
    require(!remesh.simplify_topology || remesh.is_on(), "edge", remesh.edge, "positive with simplify_topology");
}

void refuse_without_effect(const Option& option, const SurfaceOptions& others, OptionSpelling spelling) {
    if (has_effect(option, others)) return;
    if (option.effect == Effect::WithFlow)
        throw UsageError(spelling(option.name, "") + " applies to the flow; use " + spelling("method", "flow"));
    if (option.effect == Effect::WithGaussianMap)
        throw UsageError(spelling(option.name, "") + " applies to the initial Gaussian map, which " +
                         spelling("method", "direct") + " does not use; leave it out");
    throw UsageError(spelling(option.name, "") + " shapes even triangles; ask for them with " + spelling("edge", ""));
}

}  // namespace meniscus

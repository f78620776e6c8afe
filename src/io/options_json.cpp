// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/options_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "meniscus/file_name.h"
#include "meniscus/version.h"
#include "meniscus/words.h"

namespace meniscus {
namespace {

using nlohmann::ordered_json;

template <class T>
ordered_json if_used(bool used, const T& value) {
    return used ? ordered_json(value) : ordered_json();
}

ordered_json options_block(const SurfaceOptions& o) {
    const bool flows = o.method == Method::Flow;
    const bool even = o.remesh.is_on();
    const FlowOptions& f = o.flow;
    return {{"method", word_for(kMethodWords, o.method)},
            {"surface", word_for(kSurfaceWords, o.surface)},
            {"curvature", if_used(flows, word_for(kCurvatureWords, f.curvature))},
            {"anchor", if_used(flows, f.anchor)},
            {"reinitialise", if_used(flows, word_for(kReinitialiserWords, f.reinitialiser))},
            {"solver", if_used(flows, word_for(kSolverWords, f.solver))},
            {"slope", if_used(flows, word_for(kSlopeWords, f.slope))},
            {"spacing", o.spacing},
            {"components", word_for(kPiecesWords, o.pieces)},
            {"min_cavity", o.min_cavity},
            {"edge", if_used(even, o.remesh.edge)},
            {"adaptive", if_used(even, o.remesh.adaptive)},
            {"keep_ridges", if_used(even, o.remesh.keep_ridges)},
            {"corners", if_used(even, word_for(kCornersWords, o.remesh.corners))},
            {"simplify_topology", if_used(even, o.remesh.simplify_topology)},
            {"density", if_used(o.method != Method::Direct, o.density)},
            {"time_step", std::isinf(f.time_step) ? if_used(flows, "inf") : if_used(flows, f.time_step)},
            {"half_width", if_used(flows, f.half_width)},
            {"max_steps", if_used(flows, f.max_steps)},
            {"tolerance", if_used(flows, f.tolerance)}};
}

}  // namespace

std::string options_json(const SurfaceOptions& options, const Structure& structure) {
    const ordered_json input{{"file", file_name(structure.file)},
                             {"sha256", structure.sha256},
                             {"radii", file_name(structure.radii_set)},
                             {"probe", options.probe}};
    const ordered_json json{{"meniscus", kVersion}, {"input", input}, {"options", options_block(options)}};
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace meniscus

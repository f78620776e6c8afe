// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "colours/feature_colours.h"
#include "colours/palettes.h"
#include "meniscus/colours.h"
#include "meniscus/errors.h"

namespace meniscus {

std::vector<Colour> colour_values(std::span<const float> values, const ValueRange& range) {
    if (!(std::isfinite(range.min) && std::isfinite(range.max) && range.min < range.max))
        throw UsageError("the range of colours must be finite, the smaller value first");
    std::vector<Colour> colours;
    colours.reserve(values.size());
    for (const float value : values)
        colours.push_back(std::isnan(value) ? kNeutral : ramp_colour(diverging_ramp(), place_in(range, double{value})));
    return colours;
}

}  // namespace meniscus

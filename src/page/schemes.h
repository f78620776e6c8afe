// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The colour schemes that a page offers, each in the form in which the browser applies it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "meniscus/colours.h"
#include "meniscus/legend.h"
#include "page/byte_streams.h"

namespace meniscus::page {

/// A scheme as a page names it.
struct OfferedScheme {
    std::string id;  ///< what --color says
    std::string label;
    ColourOptions options;
};

/// Those that show something of this structure and mesh, and whatever `first` asks for, in a fixed order; then every
/// array of Mesh::values.
std::vector<OfferedScheme> offered_schemes(const Mesh& mesh, const Structure& structure, const ColourOptions& first);

/// What the browser needs of one scheme: its legend, and by kind
/// atom        a stream of the atoms' colours (reds, then greens, then blues), colours of patches that go before it
/// component   a colour for each
/// class       which array of vertices, the colour of each of its numbers, and of none
/// value       which array of vertices, ramp, range
nlohmann::ordered_json describe(const OfferedScheme& scheme, const Mesh& mesh, const Structure& structure,
                                Streams& streams);

/// "#rrggbb"
std::string hex(const Colour& colour);

}  // namespace meniscus::page

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Colours for the vertices and points of a surface, from the palettes that docs/conventions.md describes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meniscus/colour.h"
#include "meniscus/exact_surface.h"
#include "meniscus/level_set.h"
#include "meniscus/mesh.h"
#include "meniscus/structure.h"

namespace meniscus {

/// Which colours a surface gets.
struct ColourOptions {
    ColourScheme scheme = ColourScheme::Automatic;
    std::optional<ValueRange> range{};  ///< Curvature, BFactor, Depth and Value only; nothing: default_range()
    std::string value{};                ///< Value only: the name of an array of Mesh::values
    std::optional<Colour> colour{};     ///< Single only; nothing: light blue

    bool operator==(const ColourOptions&) const = default;
};

/// Radius of the probe that cannot enter what ColourScheme::Depth calls deep, Å.
inline constexpr double kDepthProbe = 10.0;

/// The colour that a text names: a colour name of CSS ("tomato", in any case) or "#rrggbb"; nothing for any other text.
///
/// source   CSS Color Module Level 4, W3C 2022, section 6.1; without its words for transparency
std::optional<Colour> colour_of_text(std::string_view text);

/// The colour of the pocket of a rank, from 1; grey for none (NaN).
Colour pocket_colour(float rank);

/// The colour of a place on a tunnel, by its radius, Å: dark violet up to 1 Å, lighter with its logarithm to pale pink
/// from 16 Å.
Colour passage_colour(double radius);

/// How deep in pockets and cavities every vertex lies, Å: its depth below the SES of a probe of kDepthProbe, 0 outside
/// that SES. The array is called "depth".
///
/// exact    surface of the same atoms, with any probe
/// cost     that of ExactSurface::signed_distance() for every vertex
VertexValues depth_values(const Mesh& mesh, const ExactSurface& exact);

/// The scheme that is used: for Automatic the one chosen for the structure, else the given one.
ColourScheme scheme_in_force(ColourScheme scheme, const Structure& structure);

/// True for schemes that show numbers: Curvature, Depth, BFactor and Value.
bool takes_range(ColourScheme scheme);

/// The range of a scheme unless another is given: curvature -0.7 to 0.7 Å^-1, depth 0 to 10 Å, B factors the smallest
/// to the largest of the structure's atoms.
ValueRange default_range(ColourScheme scheme, const Structure& structure);

/// The range that is used: ColourOptions::range if there is one, else range_of() for Value, else default_range().
/// throws   UsageError for values that the mesh does not have
ValueRange range_in_force(const ColourOptions& options, const Mesh& mesh, const Structure& structure);

/// Opaque colours, one per vertex.
///
/// mesh     needs `atoms`, which index the structure's atoms, and the array that the scheme shows
/// throws   UsageError for an array that is missing, an atom that the structure does not have, a range that is empty
///          or not finite, and a range for a scheme that takes none
/// cost     O(n), and for Depth that of depth_values(); values of the mesh called "depth" are shown instead if present
std::vector<Colour> colour_vertices(const Mesh& mesh, const Structure& structure, const ColourOptions& options = {});

/// Colours of values on a diverging scale from blue over white to red, one per value; NaN is grey.
/// throws   UsageError for a range that is empty or not finite
std::vector<Colour> colour_values(std::span<const float> values, const ValueRange& range);

/// The colours of colour_vertices() at any point, by the nearest feature of that point: borders between patches and
/// between atoms are sharp. Curvature is that of the exact surface.
///
/// surface  exact surface of the structure's atoms
/// returns  an empty function for Component, Depth and Value
/// throws   as colour_vertices()
/// cost     O(log n) per point of a call, and a tenth of that for points close together
ColourField colour_by_feature(const ExactSurface& surface, const Structure& structure,
                              const ColourOptions& options = {});

/// Colours by the curvature of the level set through a point.
///
/// level_set  must outlive the returned function; points outside its band get the colour of the lowest curvature
/// returns    an empty function for schemes other than Curvature
/// throws     as colour_vertices()
ColourField colour_by_level_set(const LevelSet& level_set, const ColourOptions& options);

}  // namespace meniscus

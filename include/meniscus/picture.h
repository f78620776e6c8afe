// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pictures of surfaces, drawn by casting rays.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "meniscus/colour.h"
#include "meniscus/mesh.h"
#include "meniscus/vec3.h"

namespace meniscus {

struct Legend;

/// Pixels in rows from the top, each from the left.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Colour> pixels{};
};

enum class Projection { Orthographic, Perspective };

/// From where a surface is seen. Vectors need not be of unit length or perpendicular.
struct Viewpoint {
    Vec3 from{0.0, 0.0, 1.0};  ///< from the molecule towards the viewer
    Vec3 up{0.0, 1.0, 0.0};    ///< shown upwards

    bool operator==(const Viewpoint&) const = default;
};

/// A plane that opens a surface: what lies on one side of it is left out, the molecule's inside is flat and grey.
struct Cut {
    enum class Through {
        LargestCavity,  ///< its centre; the middle of what is seen if there is no cavity
        Cavity,         ///< the centre of the one that `cavity` numbers
        Depth,          ///< `depth` behind the point nearest to the viewer
        Point,          ///< `point`
    };
    Through through = Through::LargestCavity;
    std::size_t cavity = 1;        ///< from 1, by falling volume
    double depth = 0.0;            ///< Å
    Vec3 point{};                  ///< Å
    std::optional<Vec3> normal{};  ///< towards what is left out, of any length; nothing: towards the viewer

    bool operator==(const Cut&) const = default;
};

inline constexpr Colour kWhite{255, 255, 255, 255};
inline constexpr Colour kTransparent{255, 255, 255, 0};

/// Largest width and height of a picture, pixels.
inline constexpr int kLargestPicture = 16384;

struct PictureOptions {
    int width = 1600;  ///< pixels
    int height = 1200;
    /// Nothing: the longest principal axis of the vertices lies horizontally, the second vertically.
    std::optional<Viewpoint> viewpoint{};
    Projection projection = Projection::Orthographic;
    Colour background = kWhite;
    std::optional<Cut> cut{};
    bool outline = false;    ///< dark lines where one part of the surface ends in front of another
    double depth_cue = 0.0;  ///< share of the background in what is farthest away, 0 to 1
    int threads = 0;         ///< 0: all cores; the picture does not depend on it

    bool operator==(const PictureOptions&) const = default;
};

/// Draws a mesh, as large as fits.
///
/// Normals are interpolated between vertices, and so are colours. Light comes from the sky around, as far as the
/// surface itself leaves it open, and from two lamps beside the viewer. What a cut leaves out takes no light away. The
/// section of the molecule is drawn where the mesh is closed and has an outside; a mesh of cavity walls alone has none.
///
/// mesh     with normals, closed or not; an empty one gives the background alone. A cut through cavities needs
///          `components`
/// colours  one per vertex; their alpha is not used
/// exact    if given, is asked for the colour in triangles whose corners differ, so that borders are sharp
/// throws   UsageError for arrays whose sizes do not match, a size that is not 1 to kLargestPicture, a viewpoint whose
///          vectors are zero, parallel or not finite, a depth cue outside 0 to 1, a cut through a cavity that the mesh
///          does not have or with numbers that are not finite
/// cost     O(pixels), and 100 rays per vertex that can be seen
Picture draw_picture(const Mesh& mesh, std::span<const Colour> colours, const PictureOptions& options = {},
                     const ColourField& exact = {});

struct LegendStyle {
    int width = 800;    ///< pixels; a legend is as wide as it must be, never wider than this
    int height = 1200;  ///< pixels
    Colour background = kWhite;
};

/// Draws a legend: title, classes in as many columns as they need, or a bar of colours with a scale.
///
/// Text is a forty-second of the height, or less if that does not fit. Labels may be any UTF-8; long ones are cut
/// short. Of more classes than have room in letters of 9 pixels the first are shown and the others counted.
///
/// returns  a picture of the given height; 0 pixels wide for a legend without colours
/// throws   UsageError where not even one class has room
Picture draw_legend(const Legend& legend, const LegendStyle& style);

/// throws   UsageError for pictures of different heights
Picture side_by_side(const Picture& left, const Picture& right);

}  // namespace meniscus

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

/// A picture: rows of pixels from the top, each row from the left.
struct Picture {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    std::vector<Colour> pixels{};
};

/// How space is projected onto the picture.
enum class Projection { Orthographic, Perspective };

/// The direction from which a surface is seen. The vectors need not be of unit length or perpendicular.
struct Viewpoint {
    Vec3 from{0.0, 0.0, 1.0};  ///< from the molecule towards the viewer
    Vec3 up{0.0, 1.0, 0.0};    ///< points upwards in the picture

    bool operator==(const Viewpoint&) const = default;
};

/// A plane that cuts a surface open: one side is left out, and the section through the molecule is drawn flat and grey.
struct Cut {
    /// What the plane passes through.
    enum class Through {
        LargestCavity,  ///< the centre of the largest cavity; halfway through the mesh if there is none
        Cavity,         ///< the centre of cavity number `cavity`
        Depth,          ///< a point `depth` behind the point of the mesh nearest to the viewer
        Point,          ///< `point`
    };
    Through through = Through::LargestCavity;
    std::size_t cavity = 1;        ///< number from 1, by falling volume
    double depth = 0.0;            ///< Å
    Vec3 point{};                  ///< Å
    std::optional<Vec3> normal{};  ///< points to the side left out, any length; nothing: to the viewer

    bool operator==(const Cut&) const = default;
};

/// What is seen beside a surface without belonging to it: closed bodies, with one colour per vertex. A cut leaves them
/// whole, or out where it keeps nothing of them.
struct Bodies {
    Mesh mesh;                    ///< with normals; `components` number the bodies
    std::vector<Colour> colours;  ///< alpha is the opacity of the whole body
};

/// Both, with numbers of their own.
Bodies joined(Bodies bodies, const Bodies& more);

inline constexpr Colour kWhite{255, 255, 255, 255};
inline constexpr Colour kTransparent{255, 255, 255, 0};

/// Largest width and height of a picture, pixels.
inline constexpr int kLargestPicture = 16384;

/// How a picture is drawn.
struct PictureOptions {
    int width = 1600;   ///< pixels, 1 to kLargestPicture
    int height = 1200;  ///< pixels, 1 to kLargestPicture
    /// Nothing: the longest principal axis of the vertices is horizontal, the second longest vertical.
    std::optional<Viewpoint> viewpoint{};
    Projection projection = Projection::Orthographic;
    Colour background = kWhite;
    std::optional<Cut> cut{};
    bool outline = false;    ///< dark lines where one part of the surface ends in front of another
    double opacity = 1.0;    ///< of the surface, 0 to 1: less shows bodies behind it, and the background
    double depth_cue = 0.0;  ///< share of background in the colours of the farthest parts, 0 to 1
    int threads = 0;         ///< 0: all cores; the picture does not depend on it

    bool operator==(const PictureOptions&) const = default;
};

/// True unless the library was built without pictures (CMake's MENISCUS_PICTURES=OFF). Without, whatever draws or
/// writes a picture throws UsageError.
bool pictures_supported();

/// Draws a mesh, and bodies beside it, as large as fits into the picture.
///
/// Normals and colours are interpolated between vertices. Light comes from two lamps beside the viewer and from the
/// sky, as far as the surface does not hide it (ambient occlusion). Parts that a cut leaves out cast no shadow. The
/// section through the molecule is drawn if the mesh is closed and not only walls of cavities.
///
/// mesh     needs normals, and `components` for a cut through cavities; an empty mesh gives only background
/// colours  one per vertex; alpha is not used
/// beside   seen from the viewpoint that the mesh alone has
/// exact    if given, colours triangles whose corners differ in colour, so that borders are sharp
/// throws   UsageError for arrays whose sizes do not match, a size that is not 1 to kLargestPicture, a viewpoint whose
///          vectors are zero, parallel or not finite, a depth cue outside 0 to 1, a cut through a cavity that the mesh
///          does not have or with numbers that are not finite
/// cost     O(pixels), and 100 rays per visible vertex
Picture draw_picture(const Mesh& mesh, std::span<const Colour> colours, const PictureOptions& options = {},
                     const ColourField& exact = {}, const Bodies& beside = {});

/// Size and background of a drawn legend.
struct LegendStyle {
    int width = 800;    ///< largest width, pixels; a legend is only as wide as it must be
    int height = 1200;  ///< pixels
    Colour background = kWhite;
};

/// Draws a legend: its title, and classes in as many columns as they need or a bar of colours with a scale.
///
/// Text is a forty-second of the height, or less if that does not fit. Labels may be any UTF-8; long labels are cut
/// short. If not all classes fit in letters of 9 pixels, the first are shown and the others counted.
///
/// returns  a picture of the given height; 0 pixels wide for a legend without colours
/// throws   UsageError for a size in which not even one class fits
Picture draw_legend(const Legend& legend, const LegendStyle& style);

/// Puts two pictures beside each other.
/// throws   UsageError for pictures of different heights
Picture side_by_side(const Picture& left, const Picture& right);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How far a mesh is from a point, up and down an axis: depth maps that keep every layer.
#pragma once

#include <cstdint>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// A mesh projected along an axis onto a grid of pixels, each with the heights at which the mesh crosses its middle.
class DepthLayers {
public:
    /// axis     unit vector
    /// pixel    width of a pixel, Å; it becomes wider where the mesh would need more than 2^24 of them
    /// cost     O(triangles + pixels that they cover)
    DepthLayers(const Mesh& mesh, const Vec3& axis, double pixel);

    /// Distances, Å, to the nearest layers; infinite where there is none.
    struct Gaps {
        float above;  ///< along the axis
        float below;  ///< against it
    };
    /// The gaps of the middle of the pixel beneath a point, at the height of the point.
    Gaps gaps(const Vec3& point) const;

private:
    /// In pixels from the corner of the grid; z is the height, Å.
    struct Place {
        float x, y, z;
    };
    struct Crossing {
        std::uint32_t pixel;
        float height;
    };
    Place place(const Vec3& point) const;
    void fit(const Mesh& mesh, double pixel);
    void cross(const Place& a, const Place& b, const Place& c, std::vector<Crossing>& crossings) const;
    void sort(const std::vector<Crossing>& crossings);

    Vec3 right_, up_, axis_;
    double left_ = 0.0, bottom_ = 0.0;  // Å
    double per_angstrom_ = 1.0;         // pixels
    int columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> begins_;  // of each pixel's heights
    std::vector<float> heights_;
};

}  // namespace meniscus

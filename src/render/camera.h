// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The camera: which ray belongs to which point of the picture.
#pragma once

#include <span>

#include "meniscus/picture.h"
#include "render/ray_scene.h"
#include "render/view_frame.h"

namespace meniscus {

/// A camera that looks at points and has them all in its picture.
class Camera {
public:
    /// Fits the points into the picture with a margin of a twenty-fifth of it on every side. In perspective the field
    /// of view is 30 degrees high.
    /// options  width, height, viewpoint and projection are used
    /// throws   as frame_of()
    /// cost     O(n)
    Camera(std::span<const Vec3> points, const PictureOptions& options);

    const ViewFrame& frame() const { return frame_; }
    double pixel_size() const { return pixel_size_; }    ///< Å at the middle of what is seen
    double depth_range() const { return depth_range_; }  ///< from the nearest to the farthest point, Å, along the view

    /// In the middle of the picture, as near to the viewer as the nearest point.
    Vec3 nearest() const { return middle_ + nearest_ * frame_.towards; }

    /// The ray through a point of the picture in pixels from its upper left corner. It begins in front of all points.
    Ray ray(double x, double y) const;

    /// Distance of a point behind the nearest one, Å, along the view.
    double depth(const Vec3& point) const { return nearest_ - dot(point - middle_, frame_.towards); }

private:
    void fit_orthographic(double half_width, double half_height);
    void fit_perspective(std::span<const Vec3> points);

    ViewFrame frame_;
    int width_;
    int height_;
    bool perspective_;
    Vec3 middle_;           // of the box around the points, in the picture's middle
    double nearest_ = 0.0;  // of the points towards the viewer, from the middle
    double depth_range_ = 0.0;
    double pixel_size_ = 1.0;
    double eye_distance_ = 0.0;  // from the middle
};

}  // namespace meniscus

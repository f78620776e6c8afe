// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace meniscus {
namespace {

/// What is seen may fill this share of the picture's width and height.
constexpr double kFilled = 0.92;

constexpr double kFieldOfView = 30.0 * std::numbers::pi / 180.0;

/// How far rays begin in front of the nearest point, Å; any length will do.
constexpr double kClearance = 1.0;

/// Smallest and largest coordinate along an axis.
struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    double middle() const { return 0.5 * (low + high); }
    double half() const { return 0.5 * (high - low); }
};

Extent extent_along(std::span<const Vec3> points, const Vec3& axis) {
    Extent extent;
    for (const Vec3& p : points) {
        extent.low = std::min(extent.low, dot(p, axis));
        extent.high = std::max(extent.high, dot(p, axis));
    }
    return points.empty() ? Extent{0.0, 0.0} : extent;
}

ViewFrame choose_frame(std::span<const Vec3> points, const PictureOptions& options) {
    return options.viewpoint ? frame_of(*options.viewpoint) : principal_frame(points);
}

}  // namespace

Camera::Camera(std::span<const Vec3> points, const PictureOptions& options)
    : frame_(choose_frame(points, options)),
      width_(options.width),
      height_(options.height),
      perspective_(options.projection == Projection::Perspective) {
    const Extent x = extent_along(points, frame_.right);
    const Extent y = extent_along(points, frame_.up);
    const Extent z = extent_along(points, frame_.towards);
    middle_ = x.middle() * frame_.right + y.middle() * frame_.up + z.middle() * frame_.towards;
    nearest_ = z.half();
    depth_range_ = 2.0 * z.half();
    if (perspective_)
        fit_perspective(points);
    else
        fit_orthographic(x.half(), y.half());
}

void Camera::fit_orthographic(double half_width, double half_height) {
    const double needed = std::max(2.0 * half_width / width_, 2.0 * half_height / height_);
    if (needed > 0.0) pixel_size_ = needed / kFilled;
}

/// The nearest eye from which every point is within the field of view.
void Camera::fit_perspective(std::span<const Vec3> points) {
    const double slope_y = std::tan(0.5 * kFieldOfView);
    const double slope_x = slope_y * width_ / height_;
    eye_distance_ = nearest_ + kClearance;
    for (const Vec3& point : points) {
        const Vec3 p = point - middle_;
        const double aside = std::max(std::abs(dot(p, frame_.right)) / slope_x, std::abs(dot(p, frame_.up)) / slope_y);
        eye_distance_ = std::max(eye_distance_, dot(p, frame_.towards) + aside / kFilled);
    }
    pixel_size_ = 2.0 * eye_distance_ * slope_y / height_;
}

Ray Camera::ray(double x, double y) const {
    const Vec3 aside = (pixel_size_ * (x - 0.5 * width_)) * frame_.right;
    const Vec3 upwards = (pixel_size_ * (0.5 * height_ - y)) * frame_.up;
    const Vec3 target = middle_ + aside + upwards;
    if (!perspective_) return {target + (nearest_ + kClearance) * frame_.towards, -frame_.towards};
    const Vec3 eye = middle_ + eye_distance_ * frame_.towards;
    return {eye, normalised(target - eye)};
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Mean and Gaussian curvature of the surface parallel to the SES through a point, from the point's nearest feature.
//
// Exact at every offset, positive on a sphere (docs/design/exact-geometry.md): with D the distance to the
// nearest point of K, the parallel surface has the principal radii of the patch, each changed by the offset.
#pragma once

namespace meniscus {

/// Contact patch: the point is at distance l from the atom's centre.
inline double contact_curvature(double l) { return 1.0 / l; }
inline double contact_gaussian_curvature(double l) { return 1.0 / (l * l); }

/// Reentrant patch: at distance D from the probe position.
inline double reentrant_curvature(double distance) { return -1.0 / distance; }
inline double reentrant_gaussian_curvature(double distance) { return 1.0 / (distance * distance); }

/// Toroidal patch: at distance D from a circle of radius a, and from_axis from the circle's axis. With φ between the
/// line to the circle and its plane, the principal curvatures are cos φ / from_axis along the circle, of either sign,
/// and -1/D across it.
inline double toroidal_curvature(double circle_radius, double from_axis, double distance) {
    const double cos_phi = (circle_radius - from_axis) / distance;
    return 0.5 * (cos_phi / from_axis - 1.0 / distance);
}
inline double toroidal_gaussian_curvature(double circle_radius, double from_axis, double distance) {
    return (from_axis - circle_radius) / (from_axis * distance * distance);
}

}  // namespace meniscus

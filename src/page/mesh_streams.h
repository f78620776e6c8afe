// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A mesh as streams of bytes: rounded, put into the order in which triangles first use vertices, differences.
#pragma once

#include <span>
#include <vector>

#include "meniscus/mesh.h"
#include "page/byte_streams.h"

namespace meniscus::page {

/// Coordinates are whole multiples of this, Å, from Box::low.
inline constexpr double kQuantum = 1.0 / 512.0;

/// Steps of the other values.
inline constexpr double kCurvatureStep = 1.0 / 512.0;  // Å^-1
inline constexpr double kShapeStep = 1.0 / 100.0;
inline constexpr double kDepthStep = 1.0 / 25.0;  // Å

/// More per vertex than a mesh holds; each has one value per vertex, or none.
struct VertexExtras {
    std::vector<float> sky{};     ///< 0 to 1
    std::vector<double> depth{};  ///< Å, 0 to kDepthProbe
};

/// How values from elsewhere, Mesh::values, are encoded: as whole multiples of `step` above `low`, from 0 to
/// kLastValueStep; -1 where there is none. The stream of the n-th is "value-n".
struct ValueScale {
    double low = 0.0;
    double step = 1.0;
};
inline constexpr int kLastValueStep = 32000;
ValueScale scale_of(const VertexValues& values);

/// The vertices that triangles use, in the order of first use.
struct VertexOrder {
    std::vector<VertexId> vertices{};  ///< the mesh's numbers, in the new order
    std::string triangles{};           ///< for every corner a varint: how far its number lies below the next new one
};
VertexOrder order_of_use(const Mesh& mesh);

/// Whole multiples of kQuantum above `low`.
std::vector<std::int64_t> quantised(std::span<const Vec3> points, double Vec3::*axis, double low);

/// A unit vector as two bytes: the octahedral map (Cigolle et al., J. Comput. Graph. Tech. 3, 2014, 1).
std::pair<std::uint8_t, std::uint8_t> octahedral(const Vec3& normal);

/// Adds: triangles, x y z, nu nv, atom, patch, component, and of what there is: curvature, shape, depth, sky, value-0
/// and so on.
/// low   the smallest coordinates of the vertices
void add_mesh(Streams& streams, const Mesh& mesh, const VertexExtras& extras, const Vec3& low);

/// Adds triangles, x, y, z, nu, nv and component.
///
/// kind      how the names of the streams begin: "body-"
/// returns   the vertices that triangles use, in the order of the streams
std::vector<VertexId> add_bodies(Streams& streams, const std::string& kind, const Mesh& mesh, const Vec3& low);

}  // namespace meniscus::page

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/mesh_streams.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus::page {
namespace {

constexpr VertexId kUnused = std::numeric_limits<VertexId>::max();

std::int64_t rounded(double value) { return std::llround(value); }

/// What is no number has no place among whole ones.
std::int64_t steps(double value, double step) { return std::isfinite(value) ? rounded(value / step) : 0; }

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(rounded(std::clamp(value, 0.0, 255.0))); }

/// get(v) for the vertices in order.
template <class Get>
auto in_order(const VertexOrder& order, const Get& get) {
    std::vector<decltype(get(VertexId{}))> values;
    values.reserve(order.vertices.size());
    for (const VertexId v : order.vertices) values.push_back(get(v));
    return values;
}

/// kind   how the names of the streams begin
void add_shape(Streams& streams, const std::string& kind, const Mesh& mesh, const VertexOrder& order, const Vec3& low) {
    streams.add(kind + "triangles", order.triangles);
    const std::vector<Vec3> points = in_order(order, [&](VertexId v) { return mesh.vertices[v]; });
    streams.add(kind + "x", differences(quantised(points, &Vec3::x, low.x)));
    streams.add(kind + "y", differences(quantised(points, &Vec3::y, low.y)));
    streams.add(kind + "z", differences(quantised(points, &Vec3::z, low.z)));

    std::vector<std::uint8_t> u;
    std::vector<std::uint8_t> v;
    for (const VertexId vertex : order.vertices) {
        const auto [first, second] = octahedral(mesh.normals[vertex]);
        u.push_back(first);
        v.push_back(second);
    }
    streams.add(kind + "nu", byte_differences(u));
    streams.add(kind + "nv", byte_differences(v));
}

void add_components(Streams& streams, const std::string& kind, const Mesh& mesh, const VertexOrder& order) {
    streams.add(kind + "component",
                differences(in_order(order, [&](VertexId v) { return std::int64_t{mesh.components[v]}; })));
}

void add_values(Streams& streams, const Mesh& mesh, const VertexExtras& extras, const VertexOrder& order) {
    if (!mesh.mean_curvatures.empty())
        streams.add("curvature", differences(in_order(order, [&](VertexId v) {
                        return steps(double{mesh.mean_curvatures[v]}, kCurvatureStep);
                    })));
    if (!mesh.shape_indices.empty())
        streams.add("shape", differences(in_order(
                                 order, [&](VertexId v) { return steps(double{mesh.shape_indices[v]}, kShapeStep); })));
    if (!extras.depth.empty())
        streams.add("depth", byte_differences(
                                 in_order(order, [&](VertexId v) { return to_byte(extras.depth[v] / kDepthStep); })));
    if (!extras.sky.empty())
        streams.add("sky", byte_differences(
                               in_order(order, [&](VertexId v) { return to_byte(255.0 * double{extras.sky[v]}); })));
}

void add_brought_values(Streams& streams, const Mesh& mesh, const VertexOrder& order) {
    for (std::size_t i = 0; i < mesh.values.size(); ++i) {
        const ValueScale scale = scale_of(mesh.values[i]);
        const auto step = [&](VertexId v) {
            const double value{mesh.values[i].values[v]};
            return std::isfinite(value) ? rounded((value - scale.low) / scale.step) : std::int64_t{-1};
        };
        streams.add("value-" + std::to_string(i), differences(in_order(order, step)));
    }
}

}  // namespace

ValueScale scale_of(const VertexValues& values) {
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (const float value : values.values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return low < high ? ValueScale{double{low}, (double{high} - double{low}) / kLastValueStep}
                      : ValueScale{std::isfinite(low) ? double{low} : 0.0, 1.0};
}

VertexOrder order_of_use(const Mesh& mesh) {
    VertexOrder order;
    std::vector<VertexId> place(mesh.vertices.size(), kUnused);
    for (const Triangle& triangle : mesh.triangles)
        for (const VertexId v : triangle) {
            const auto next = static_cast<VertexId>(order.vertices.size());
            if (place[v] == kUnused) {
                place[v] = next;
                order.vertices.push_back(v);
            }
            append_varint(order.triangles, next - place[v]);
        }
    return order;
}

std::vector<std::int64_t> quantised(std::span<const Vec3> points, double Vec3::*axis, double low) {
    std::vector<std::int64_t> values;
    values.reserve(points.size());
    for (const Vec3& point : points) values.push_back(rounded((point.*axis - low) / kQuantum));
    return values;
}

std::pair<std::uint8_t, std::uint8_t> octahedral(const Vec3& normal) {
    const double sum = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
    double u = sum > 0.0 ? normal.x / sum : 0.0;
    double v = sum > 0.0 ? normal.y / sum : 0.0;
    if (normal.z < 0.0) {
        const double folded = (1.0 - std::abs(v)) * std::copysign(1.0, u);
        v = (1.0 - std::abs(u)) * std::copysign(1.0, v);
        u = folded;
    }
    return {to_byte(127.0 + 127.0 * u), to_byte(127.0 + 127.0 * v)};
}

void add_mesh(Streams& streams, const Mesh& mesh, const VertexExtras& extras, const Vec3& low) {
    const VertexOrder order = order_of_use(mesh);
    add_shape(streams, "", mesh, order, low);
    streams.add("atom", differences(in_order(order, [&](VertexId v) { return std::int64_t{mesh.atoms[v]}; })));
    streams.add("patch", byte_differences(
                             in_order(order, [&](VertexId v) { return static_cast<std::uint8_t>(mesh.patches[v]); })));
    if (!mesh.components.empty()) add_components(streams, "", mesh, order);
    add_values(streams, mesh, extras, order);
    add_brought_values(streams, mesh, order);
}

std::vector<VertexId> add_bodies(Streams& streams, const std::string& kind, const Mesh& mesh, const Vec3& low) {
    VertexOrder order = order_of_use(mesh);
    add_shape(streams, kind, mesh, order, low);
    add_components(streams, kind, mesh, order);
    return order.vertices;
}

}  // namespace meniscus::page

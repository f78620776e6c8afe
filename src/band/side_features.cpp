// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/side_features.h"

#include <algorithm>

#include "core/bits.h"
#include "geometry/accessible_surface_data.h"
#include "geometry/nearest_kernels.h"

namespace meniscus {

void SideFeaturesOfBox::gather(const LocalFeatures& from, const Box& box, double margin) {
    const NearestKernels& kernels = nearest_kernels();
    const Vec3 middle = 0.5 * (box.low + box.high);
    const SphereList& balls = from.balls();
    const BoxList& arcs = from.arcs();
    const SphereList& vertices = from.vertices();
    marks_.resize(
        std::max({marks_.size(), words_for(balls.size()), words_for(arcs.size()), words_for(vertices.size())}));
    features_.clear();
    balls_.clear();
    cells_.clear();
    vertices_.clear();
    kernels.mark_reaching(balls, from.beyond_balls(), box, marks_.data());
    for_each_item(marks_.data(), balls.size(), [&](std::size_t b) { add_ball(balls, b, middle); });
    kernels.mark_overlapping(arcs, box, marks_.data());
    for_each_item(marks_.data(), arcs.size(), [&](std::size_t a) { add_arc(from, a, middle); });
    kernels.mark_reaching(vertices, margin, box, marks_.data());
    for_each_item(marks_.data(), vertices.size(), [&](std::size_t v) { add_vertex(vertices, v, middle); });
}

void SideFeaturesOfBox::add_ball(const SphereList& balls, std::size_t item, const Vec3& middle) {
    const SmallVec3 centre = to_small(position_in(balls, item) - middle);
    const auto rho = static_cast<float>(balls.column(3)[item]);
    features_.balls.push_back({centre, rho, balls.index(item)});
    balls_.add({centre.x, centre.y, centre.z, rho}, balls.index(item));
}

void SideFeaturesOfBox::add_arc(const LocalFeatures& from, std::size_t item, const Vec3& middle) {
    constexpr float kAnyAngle = -2.0F;  // below every cosine
    const BoxList& cells = from.arcs();
    const SasArc& arc = from.surface().data().arcs[cells.index(item)];
    features_.arcs.push_back({to_small(arc.centre - middle), to_small(arc.axis), to_small(arc.middle),
                              static_cast<float>(arc.radius),
                              arc.whole_circle() ? kAnyAngle : static_cast<float>(arc.cos_half)});
    const SmallVec3 low = to_small(position_in(cells, item) - middle);
    const SmallVec3 high = to_small(Vec3{cells.column(3)[item], cells.column(4)[item], cells.column(5)[item]} - middle);
    cells_.add({low.x, low.y, low.z, high.x, high.y, high.z}, cells.index(item));
}

void SideFeaturesOfBox::add_vertex(const SphereList& vertices, std::size_t item, const Vec3& middle) {
    const SmallVec3 position = to_small(position_in(vertices, item) - middle);
    features_.vertices.push_back(position);
    vertices_.add({position.x, position.y, position.z}, vertices.index(item));
}

}  // namespace meniscus

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
    const std::size_t most = std::max({balls.size(), arcs.size(), vertices.size()});
    marks_.resize(std::max(marks_.size(), words_for(most)));
    items_.resize(std::max(items_.size(), most));
    kernels.mark_reaching(balls, from.beyond_balls(), box, marks_.data());
    take_balls(balls, marked(balls.size()), middle);
    kernels.mark_overlapping(arcs, box, marks_.data());
    take_arcs(from, marked(arcs.size()), middle);
    kernels.mark_reaching(vertices, margin, box, marks_.data());
    take_vertices(vertices, marked(vertices.size()), middle);
}

std::span<const std::uint32_t> SideFeaturesOfBox::marked(std::size_t count) {
    return std::span(items_).first(list_items(marks_.data(), count, items_.data()));
}

void SideFeaturesOfBox::take_balls(const SphereList& balls, std::span<const std::uint32_t> items, const Vec3& middle) {
    features_.balls.resize(items.size());
    balls_.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        const SmallVec3 centre = to_small(position_in(balls, items[i]) - middle);
        const auto rho = static_cast<float>(balls.column(3)[items[i]]);
        const std::uint32_t atom = balls.index(items[i]);
        features_.balls[i] = {centre, rho, atom};
        balls_.set(i, {centre.x, centre.y, centre.z, rho}, atom);
    }
}

void SideFeaturesOfBox::take_arcs(const LocalFeatures& from, std::span<const std::uint32_t> items, const Vec3& middle) {
    const BoxList& cells = from.arcs();
    const std::vector<SasArc>& arcs = from.surface().data().arcs;
    features_.arcs.resize(items.size());
    cells_.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::uint32_t cell = items[i];
        const SasArc& arc = arcs[cells.index(cell)];
        features_.arcs[i] = {to_small(arc.centre - middle), to_small(arc.axis), to_small(arc.middle),
                             static_cast<float>(arc.radius), static_cast<float>(arc.cos_half)};
        const SmallVec3 low = to_small(position_in(cells, cell) - middle);
        const SmallVec3 high =
            to_small(Vec3{cells.column(3)[cell], cells.column(4)[cell], cells.column(5)[cell]} - middle);
        cells_.set(i, {low.x, low.y, low.z, high.x, high.y, high.z}, cells.index(cell));
    }
}

void SideFeaturesOfBox::take_vertices(const SphereList& vertices, std::span<const std::uint32_t> items,
                                      const Vec3& middle) {
    features_.vertices.resize(items.size());
    vertices_.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        const SmallVec3 position = to_small(position_in(vertices, items[i]) - middle);
        features_.vertices[i] = position;
        vertices_.set(i, {position.x, position.y, position.z}, vertices.index(items[i]));
    }
}

}  // namespace meniscus

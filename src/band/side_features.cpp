// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/side_features.h"

#include <algorithm>

#include "core/bits.h"
#include "core/parallel.h"
#include "nearest/nearest_kernels.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kAtomsPerChunk = 4096;

void take_balls(const SphereList& balls, std::span<const std::uint32_t> items, const Vec3& middle, SideFeatures& near) {
    near.balls.resize(items.size());
    near.atoms.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        set_position(near.balls, i, to_small(position_in(balls, items[i]) - middle));
        near.balls[3][i] = static_cast<float>(balls.column(3)[items[i]]);
        near.atoms[i] = balls.index(items[i]);
    }
}

void take_arcs(const LocalFeatures& from, std::span<const std::uint32_t> items, const Vec3& middle,
               SideFeaturesOfBox& near) {
    const BoxList& cells = from.arcs();
    const std::span<const SasArc> arcs(from.surface().data().arcs);
    const double origin[3] = {middle.x, middle.y, middle.z};
    near.features.arcs.resize(items.size());
    near.cells.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        const SasArc& arc = arcs[cells.index(items[i])];
        near.features.arcs[i] = {to_small(arc.centre - middle), to_small(arc.axis), to_small(arc.middle),
                                 static_cast<float>(arc.radius), static_cast<float>(arc.cos_half)};
        for (std::size_t side = 0; side < 6; ++side)
            near.cells[side][i] = static_cast<float>(cells.column(side)[items[i]] - origin[side % 3]);
    }
}

void take_vertices(const SphereList& vertices, std::span<const std::uint32_t> items, const Vec3& middle,
                   SideFeatures& near) {
    near.vertices.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i)
        set_position(near.vertices, i, to_small(position_in(vertices, items[i]) - middle));
}

}  // namespace

void SideGatherer::gather(const LocalFeatures& from, const Box& box, double margin, SideFeaturesOfBox& near) {
    const NearestKernels& kernels = nearest_kernels();
    const Vec3 middle = box.middle();
    const SphereList& balls = from.balls();
    const BoxList& arcs = from.arcs();
    const SphereList& vertices = from.vertices();
    const std::size_t most = std::max({balls.size(), arcs.size(), vertices.size()});
    marks_.resize(std::max(marks_.size(), words_for(most)));
    items_.resize(std::max(items_.size(), most));
    kernels.mark_reaching(balls, from.beyond_balls(), box, marks_.data());
    take_balls(balls, marked(balls.size()), middle, near.features);
    kernels.mark_overlapping(arcs, box, marks_.data());
    take_arcs(from, marked(arcs.size()), middle, near);
    kernels.mark_reaching(vertices, margin, box, marks_.data());
    take_vertices(vertices, marked(vertices.size()), middle, near.features);
}

std::span<const std::uint32_t> SideGatherer::marked(std::size_t count) {
    return std::span(items_).first(list_items(marks_.data(), count, items_.data()));
}

SideCaps::SideCaps(const AccessibleSurface::Data& data) : exposed_(data.exposed), begins_(data.atoms.size() + 1) {
    for (std::uint32_t i = 0; i < data.atoms.size(); ++i) {
        const std::size_t caps = is_exposed(i) ? data.caps_of(i).size() : 0;
        begins_[i + 1] = begins_[i] + (caps + EightCaps::kCount - 1) / EightCaps::kCount;
    }
    resize_touched(caps_, begins_.back());
    parallel_for(data.atoms.size(), kAtomsPerChunk, [&](std::size_t i) {
        const auto atom = static_cast<std::uint32_t>(i);
        const std::span<const CapPlane> caps = data.caps_of(atom);
        const std::span<EightCaps> eights = std::span(caps_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
        if (eights.empty()) return;
        for (std::size_t c = 0; c < caps.size(); ++c) {
            const CapPlane& cap = caps[c];
            EightCaps& eight = eights[c / EightCaps::kCount];
            eight.x[c % EightCaps::kCount] = static_cast<float>(cap.axis.x);
            eight.y[c % EightCaps::kCount] = static_cast<float>(cap.axis.y);
            eight.z[c % EightCaps::kCount] = static_cast<float>(cap.axis.z);
            eight.t[c % EightCaps::kCount] = static_cast<float>(cap.t);
        }
    });
}

}  // namespace meniscus

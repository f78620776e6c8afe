// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "cavities/filled_space.h"
#include "core/number_text.h"
#include "core/requirements.h"
#include "core/workspaces.h"
#include "geometry/accessible_surface.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "nearest/box_features.h"
#include "pipeline/memory_limit.h"
#include "project/level_set_side.h"
#include "space/box_tree.h"

namespace meniscus {
namespace {

constexpr std::size_t kEdge = 8;  // nodes along each edge of a block: a slab of one is a batch
static_assert(kEdge * kEdge == kBatchLanes);
constexpr std::size_t kBlocksPerTask = 4;

constexpr double kSafe = 1e-6;  // Å: rounding of distances

// From the inner part of the band, which the flow has shaped, to the exact distance around it.
constexpr double kBlend = 1.0;  // spacings before the end of the band's half width

// The band is wider on either side of the surface.
constexpr double kBeside = 2.0;  // spacings

// The signed distance that a surface means at any point of space, negative inside. Told the exact one to its SES.
class SidedDistance {
public:
    explicit SidedDistance(const Surface& surface)
        : level_set_(surface.level_set.get()),
          accessible_(surface.exact.accessible()),
          filled_(surface.filled, surface.options.spacing),
          spacing_(surface.options.spacing) {
        const SurfaceOptions& options = surface.options;
        anchored_ = options.method == Method::Flow && options.flow.anchor > 0.0;
        const double half_width = options.method == Method::Flow ? options.flow.half_width : FlowOptions{}.half_width;
        end_ = half_width * options.spacing;
        begin_ = end_ - kBlend * options.spacing;
    }

    const AccessibleSurface& accessible() const { return accessible_; }

    /// A point outside of the level set's band, and its side of the surface: those within two spacings lie on it, too.
    struct Beside {
        Vec3 point;
        bool known = false;
        bool inside = false;
    };
    double operator()(const Vec3& point, double exact, Beside& last) const {
        return filled_.distance(point, with_cavities(point, exact, last));
    }

    /// Nodes lie on the same side as a point whose value is above this by more than their distance from it, Å.
    double slack() const {
        const double of_mesh = filled_.empty() ? kSafe : spacing_;
        if (level_set_ == nullptr) return of_mesh;
        return anchored_ ? std::max(end_, of_mesh) : std::numeric_limits<double>::infinity();
    }

private:
    double with_cavities(const Vec3& point, double exact, Beside& last) const {
        if (level_set_ == nullptr) return exact;
        return anchored_ ? blended(point, exact) : from_level_set(point, exact, last);
    }

    double blended(const Vec3& point, double exact) const {
        const double t = (std::abs(exact) - begin_) / (end_ - begin_);
        if (t >= 1.0) return exact;
        const double value = level_set_->value(point);
        if (std::isnan(value)) return exact;
        if (t <= 0.0) return value;
        const double share = t * t * (3.0 - 2.0 * t);
        return (1.0 - share) * value + share * exact;
    }

    double from_level_set(const Vec3& point, double exact, Beside& last) const {
        const double value = level_set_->value(point);
        if (!std::isnan(value)) return value;
        const double reach = kBeside * spacing_;
        if (!last.known || squared_norm(point - last.point) > reach * reach)
            last.inside = is_inside(*level_set_, point);
        last.known = true;
        last.point = point;
        return std::copysign(std::max(std::abs(exact), end_), last.inside ? -1.0 : 1.0);
    }

    const LevelSet* level_set_;
    const AccessibleSurface& accessible_;
    FilledSpace filled_;
    double spacing_;
    bool anchored_ = false;
    double begin_ = 0.0;
    double end_ = 0.0;
};

// Å to the atoms enlarged by the ion radius, negative in them and in cavities that are filled. It is told the distance
// to these atoms.
class IonDistance {
public:
    IonDistance(const Surface& surface, double ion_radius)
        : enlarged_(surface.exact.of_same_atoms({SurfaceKind::Sas, ion_radius})),
          filled_(surface.filled, surface.options.spacing) {}

    const AccessibleSurface& accessible() const { return enlarged_.accessible(); }

    struct Beside {};  // nothing to remember of it
    double operator()(const Vec3& point, double exact, Beside& /*last*/) const {
        return exact >= 0.0 && filled_.contains(point) ? -kSafe : exact;
    }

    double slack() const { return filled_.empty() ? kSafe : std::numeric_limits<double>::infinity(); }

private:
    ExactSurface enlarged_;
    FilledSpace filled_;
};

// Neighbouring nodes of a grid.
struct NodeBlock {
    std::array<std::size_t, 3> begin;
    std::array<std::size_t, 3> end;

    Box box(const VolumeGrid& grid) const {
        return {grid.node(begin[0], begin[1], begin[2]), grid.node(end[0] - 1, end[1] - 1, end[2] - 1)};
    }
};

// Blocks that hold all nodes of a grid.
class NodeBlocks {
public:
    explicit NodeBlocks(const VolumeGrid& grid) : counts_(grid.counts) {
        for (std::size_t axis = 0; axis < 3; ++axis) blocks_[axis] = (counts_[axis] + kEdge - 1) / kEdge;
    }
    std::size_t size() const { return blocks_[0] * blocks_[1] * blocks_[2]; }
    NodeBlock operator[](std::size_t number) const {
        const std::array at{number / (blocks_[1] * blocks_[2]), number / blocks_[2] % blocks_[1], number % blocks_[2]};
        NodeBlock block{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            block.begin[axis] = at[axis] * kEdge;
            block.end[axis] = std::min(block.begin[axis] + kEdge, counts_[axis]);
        }
        return block;
    }

private:
    std::array<std::size_t, 3> counts_;
    std::array<std::size_t, 3> blocks_{};
};

// Sets the nodes of a grid to what follows from the distances there, block by block.
template <class Distance>
class FieldFiller {
public:
    FieldFiller(const VolumeGrid& grid, const Distance& distance)
        : distance_(distance), volume_{grid, std::vector<float>(grid.size())} {}

    Volume distances() && {
        for_each_block([&](const NodeBlock& block, BoxFeatures& exact) {
            exact.enter(block.box(volume_.grid));
            set_nodes(block, exact, [](double d) { return static_cast<float>(-d); });
        });
        return std::move(volume_);
    }

    // A distance changes by no more than 1 per Å: blocks that are smaller than that lie on one side.
    Volume sides(float inner, float outer) && {
        const auto side = [&](double d) { return d < 0.0 ? inner : outer; };
        for_each_block([&](const NodeBlock& block, BoxFeatures& exact) {
            const Box box = block.box(volume_.grid);
            const double middle = exact.enter(box);
            if (std::isfinite(distance_.slack())) {
                typename Distance::Beside last;
                const double d = distance_(box.middle(), middle, last);
                if (std::abs(d) - distance_.slack() > 0.5 * norm(box.high - box.low)) return fill(block, side(d));
            }
            set_nodes(block, exact, side);
        });
        return std::move(volume_);
    }

private:
    template <class Visit>
    void for_each_block(const Visit& visit) const {
        const NodeBlocks blocks(volume_.grid);
        parallel_chunks_with(
            blocks.size(), kBlocksPerTask, [&] { return std::make_unique<BoxFeatures>(distance_.accessible()); },
            [&](std::size_t begin, std::size_t end, BoxFeatures& exact) {
                for (std::size_t b = begin; b < end; ++b) visit(blocks[b], exact);
            });
    }

    float* row(const NodeBlock& block, std::size_t i, std::size_t j) {
        return &volume_.values[volume_.grid.index(i, j, block.begin[2])];
    }

    void fill(const NodeBlock& block, float value) {
        for (std::size_t i = block.begin[0]; i < block.end[0]; ++i)
            for (std::size_t j = block.begin[1]; j < block.end[1]; ++j)
                std::fill_n(row(block, i, j), block.end[2] - block.begin[2], value);
    }

    template <class Value>
    void set_nodes(const NodeBlock& block, BoxFeatures& exact, const Value& value) {
        std::array<Vec3, kBatchLanes> points;
        std::array<double, kBatchLanes> found;
        typename Distance::Beside last;
        for (std::size_t i = block.begin[0]; i < block.end[0]; ++i) {
            std::size_t count = 0;
            for (std::size_t j = block.begin[1]; j < block.end[1]; ++j)
                for (std::size_t k = block.begin[2]; k < block.end[2]; ++k)
                    points[count++] = volume_.grid.node(i, j, k);
            exact.find(std::span(points).first(count), found);
            std::size_t n = 0;
            for (std::size_t j = block.begin[1]; j < block.end[1]; ++j) {
                float* const values = row(block, i, j);
                for (std::size_t k = 0; k < block.end[2] - block.begin[2]; ++k, ++n)
                    values[k] = value(distance_(points[n], found[n], last));
            }
        }
    }

    const Distance& distance_;
    Volume volume_;
};

void check(const VolumeGrid& grid, const FieldOptions& options) {
    for (const std::size_t count : grid.counts)
        if (count == 0) throw UsageError("a grid without nodes; give at least one along each axis");
    for (const double spacing : {grid.spacing.x, grid.spacing.y, grid.spacing.z})
        require_positive("grid spacing", spacing);
    if (!is_finite(grid.origin)) throw UsageError("the origin of the grid is not finite; correct it");
    require_positive("inner dielectric constant", options.inner_dielectric);
    require_positive("outer dielectric constant", options.outer_dielectric);
    require_not_negative("ion radius", options.ion_radius);
    check_threads(options.threads);
    refuse_grid_that_would_not_fit(grid, 1, {}, {});
}

// Counts may be such that their product has no place in an integer.
double megabytes(const VolumeGrid& grid, std::size_t volumes) {
    return static_cast<double>(grid.counts[0]) * static_cast<double>(grid.counts[1]) *
           static_cast<double>(grid.counts[2]) * sizeof(float) / kMegabyte * static_cast<double>(volumes);
}

}  // namespace

VolumeGrid enclosing_grid(const ExactSurface& exact, double spacing) {
    const Atoms& atoms = exact.balls();
    if (atoms.empty()) throw std::invalid_argument("no atoms");
    Box box;
    for (std::size_t i = 0; i < atoms.size(); ++i)
        box.include(Box{atoms.centres[i], atoms.centres[i]}.grown(atoms.radii[i]));
    const std::array low{box.low.x, box.low.y, box.low.z};
    const std::array high{box.high.x, box.high.y, box.high.z};
    VolumeGrid grid;
    std::array<double, 3> origin{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double first = std::floor(low[axis] / spacing - kFieldMargin);
        const double last = std::ceil(high[axis] / spacing + kFieldMargin);
        origin[axis] = first * spacing;
        // Beyond what any memory holds; what is asked for is refused afterwards.
        constexpr double kMost = 1e9;
        grid.counts[axis] = static_cast<std::size_t>(std::min(last - first, kMost)) + 1;
    }
    grid.origin = {origin[0], origin[1], origin[2]};
    grid.spacing = {spacing, spacing, spacing};
    return grid;
}

Volume surface_field(const Surface& surface, const VolumeGrid& grid, const FieldOptions& options) {
    check(grid, options);
    const ThreadLimit limit(options.threads);
    if (options.content == VolumeContent::Ions)
        return FieldFiller(grid, IonDistance(surface, options.ion_radius)).sides(0.0F, 1.0F);
    const SidedDistance distance(surface);
    FieldFiller filler(grid, distance);
    switch (options.content) {
        case VolumeContent::Mask:
            return std::move(filler).sides(1.0F, 0.0F);
        case VolumeContent::Dielectric:
            return std::move(filler).sides(static_cast<float>(options.inner_dielectric),
                                           static_cast<float>(options.outer_dielectric));
        default:
            return std::move(filler).distances();
    }
}

Volume apbs_map(const Surface& surface, const VolumeGrid& grid, ApbsMap map, const FieldOptions& options) {
    FieldOptions of_map = options;
    of_map.content = content_of(map);
    VolumeGrid shifted = grid;
    if (map == ApbsMap::DielectricX) shifted.origin.x += 0.5 * grid.spacing.x;
    if (map == ApbsMap::DielectricY) shifted.origin.y += 0.5 * grid.spacing.y;
    if (map == ApbsMap::DielectricZ) shifted.origin.z += 0.5 * grid.spacing.z;
    return surface_field(surface, shifted, of_map);
}

void refuse_grid_that_would_not_fit(const VolumeGrid& grid, std::size_t volumes, const Cost& cost,
                                    std::size_t memory_limit_mb) {
    const double needed = megabytes(grid, volumes) + cost.memory_mb;
    if (needed <= limit_mb(memory_limit_mb)) return;
    throw LimitError(joined("the grid of ", grid.counts[0], " x ", grid.counts[1], " x ", grid.counts[2],
                            " nodes needs about ", with_decimals(needed, 0), " MB of memory in all, but only ",
                            with_decimals(limit_mb(memory_limit_mb), 0), " MB are ",
                            memory_limit_mb > 0 ? "allowed" : "free", "; choose a coarser or smaller grid"));
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// All blocks of a grid, each with the features near it gathered first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "core/group_by.h"
#include "core/parallel.h"
#include "core/workspaces.h"
#include "grid/block_grid.h"
#include "nearest/local_features.h"

namespace meniscus {

/// The box of a cube of nodes, `edge` along each axis.
inline Box box_of_nodes(const Vec3& corner, int edge, double spacing) {
    const double length = (edge - 1) * spacing;
    return {corner, corner + Vec3{length, length, length}};
}

/// Blocks in cubes of a power of two on an edge, for which features are gathered together, and in halves of these
/// cubes.
class BlockGroups {
public:
    explicit BlockGroups(const BlockGrid& grid);

    std::size_t size() const { return groups_.size(); }
    std::span<const BlockId> blocks(std::size_t group) const { return groups_[group]; }
    /// Calls visit(blocks) for each part of a group.
    template <class Visit>
    void for_each_part(std::size_t group, const Visit& visit) const {
        const std::span<const BlockId> all = blocks(group);
        std::size_t begin = 0;
        for (std::size_t i = 1; i <= all.size(); ++i)
            if (i == all.size() || part(all[i]) != part(all[begin])) {
                visit(all.subspan(begin, i - begin));
                begin = i;
            }
    }
    Box box_of(std::span<const BlockId> blocks) const;

private:
    BlockCoord part(BlockId b) const;

    const BlockGrid& grid_;
    int shift_;
    Groups groups_;
};

/// Calls visit(evaluator, features, block) for every block of the grid, in parallel. make() makes an evaluator for some
/// blocks one after the other; `features` are those near a block, gathered as `empty` ones tell.
template <class Make, class Visit>
void for_each_block(const BlockGrid& grid, const LocalFeatures& empty, const Make& make, const Visit& visit) {
    constexpr std::size_t kGroupsPerChunk = 2;
    struct Workspace {
        LocalFeatures around;  // many blocks
        LocalFeatures part;    // fewer of them
        std::invoke_result_t<Make> evaluator;
    };
    const BlockGroups groups(grid);
    parallel_chunks_with(
        groups.size(), kGroupsPerChunk,
        [&] {
            return std::make_unique<Workspace>(Workspace{empty, empty, make()});
        },
        [&](std::size_t begin, std::size_t end, Workspace& work) {
            for (std::size_t g = begin; g < end; ++g) {
                work.around.gather(groups.box_of(groups.blocks(g)));
                groups.for_each_part(g, [&](std::span<const BlockId> blocks) {
                    work.part.gather_from(work.around, groups.box_of(blocks));
                    for (const BlockId b : blocks) visit(*work.evaluator, work.part, b);
                });
            }
        });
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Things with equal keys brought together without sorting all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <unordered_map>
#include <vector>

namespace meniscus {

/// Numbers of things, group after group.
struct Groups {
    std::vector<std::uint32_t> items;
    std::vector<std::size_t> begins;  ///< where each group begins among the items, and the end

    std::size_t size() const { return begins.size() - 1; }
    std::span<const std::uint32_t> operator[](std::size_t group) const {
        return std::span(items).subspan(begins[group], begins[group + 1] - begins[group]);
    }
};

/// Groups of equal keys in the order of their first members, the members in their own order.
/// cost     O(n); keys that are equal to the one before take no look into a table
template <class Hash, class Key>
Groups group_by(const std::vector<Key>& keys) {
    std::unordered_map<Key, std::uint32_t, Hash> number;
    std::vector<std::uint32_t> group_of;
    group_of.reserve(keys.size());
    Groups groups{.items = std::vector<std::uint32_t>(keys.size()), .begins = {0}};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (i > 0 && keys[i] == keys[i - 1]) {
            group_of.push_back(group_of.back());
        } else {
            const auto [found, is_new] = number.try_emplace(keys[i], static_cast<std::uint32_t>(number.size()));
            if (is_new) groups.begins.push_back(0);
            group_of.push_back(found->second);
        }
        ++groups.begins[group_of.back() + 1];
    }
    std::partial_sum(groups.begins.begin(), groups.begins.end(), groups.begins.begin());
    std::vector<std::size_t> next(groups.begins.begin(), groups.begins.end() - 1);
    for (std::uint32_t i = 0; i < keys.size(); ++i) groups.items[next[group_of[i]]++] = i;
    return groups;
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Disjoint sets of consecutive numbers: which pieces hang together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meniscus {

/// Union-find with path halving; the root of a set is its smallest member, whatever the order of joins.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t size = 0) { grow(size); }

    std::size_t size() const { return parent_.size(); }

    /// Adds sets of one member each until there are `size` members.
    void grow(std::size_t size) {
        parent_.reserve(size);
        for (auto i = static_cast<std::uint32_t>(parent_.size()); i < size; ++i) parent_.push_back(i);
    }

    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    /// Returns whether they were apart.
    bool join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
        return a != b;
    }

    /// The number of each member's set; sets are numbered in the order of their smallest members.
    std::vector<std::uint32_t> numbers() {
        std::vector<std::uint32_t> number(parent_.size());
        std::uint32_t sets = 0;
        for (std::uint32_t i = 0; i < parent_.size(); ++i) {
            const std::uint32_t first = root(i);
            number[i] = first == i ? sets++ : number[first];
        }
        return number;
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// How many sets `numbers` tells apart.
inline std::size_t set_count(const std::vector<std::uint32_t>& numbers) {
    return numbers.empty() ? 0 : std::size_t{*std::max_element(numbers.begin(), numbers.end())} + 1;
}

}  // namespace meniscus

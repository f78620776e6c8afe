// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A few triangles of a mesh with numbers of their own for its vertices.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/bits.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// Numbers the corners of some triangles, each once, in the order of the mesh.
class LocalCorners {
public:
    /// corners  of the triangles, as often as they have them
    /// cost     O(n) where their numbers are near to each other, else O(n log n)
    explicit LocalCorners(std::vector<VertexId> corners) : vertices_(std::move(corners)) {
        if (vertices_.empty()) return;
        const auto [least, largest] = std::minmax_element(vertices_.begin(), vertices_.end());
        first_ = *least;
        const std::size_t words = (*largest - first_) / kBits + 1;
        if (words <= vertices_.size()) {
            count(words);
        } else {
            std::sort(vertices_.begin(), vertices_.end());
            vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
        }
    }

    /// The mesh's number of each.
    const std::vector<VertexId>& vertices() const { return vertices_; }

    /// One of the triangles, given with the mesh's numbers.
    Triangle local(const Triangle& triangle) const {
        return {number(triangle[0]), number(triangle[1]), number(triangle[2])};
    }

private:
    static constexpr std::size_t kBits = 64;

    // Which of the next 64 vertices are there, and how many before them.
    struct Word {
        std::uint64_t bits = 0;
        VertexId before = 0;
    };

    void count(std::size_t words) {
        words_.resize(words);
        for (const VertexId v : vertices_) words_[(v - first_) / kBits].bits |= 1ULL << (v - first_) % kBits;
        vertices_.clear();
        for (std::size_t i = 0; i < words; ++i) {
            words_[i].before = static_cast<VertexId>(vertices_.size());
            for (std::uint64_t left = words_[i].bits; left != 0; left &= left - 1)
                vertices_.push_back(first_ + static_cast<VertexId>(i * kBits) +
                                    static_cast<VertexId>(std::countr_zero(left)));
        }
    }

    VertexId number(VertexId v) const {
        if (words_.empty())
            return static_cast<VertexId>(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
        const Word& word = words_[(v - first_) / kBits];
        const std::uint64_t below = word.bits & ((1ULL << (v - first_) % kBits) - 1);
        return word.before + static_cast<VertexId>(count_bits(below));
    }

    std::vector<VertexId> vertices_;
    VertexId first_ = 0;
    std::vector<Word> words_;  // empty where the numbers lie far apart
};

}  // namespace meniscus

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
#include "core/mix_bits.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// Numbers the corners of some triangles, each once, in the order of the mesh.
class LocalCorners {
public:
    /// corners  of the triangles, as often as they have them
    /// cost     O(n), and a sort of as many items as there are 64 numbers on end with a corner among them, if these lie
    ///          far apart
    explicit LocalCorners(std::vector<VertexId> corners) : vertices_(std::move(corners)) {
        if (vertices_.empty()) return;
        const auto [least, largest] = std::minmax_element(vertices_.begin(), vertices_.end());
        first_ = *least / kBits;
        const std::size_t span = *largest / kBits - first_ + 1;
        is_dense_ = span <= vertices_.size();
        words_.resize(is_dense_ ? span : std::bit_ceil(vertices_.size() + 1));
        for (const VertexId v : vertices_) word_of(v).bits |= bit_of(v);
        vertices_.clear();
        if (!is_dense_) {
            number_in_order();
        } else {
            for (std::size_t i = 0; i < span; ++i) number(words_[i], first_ + static_cast<VertexId>(i));
        }
    }

    /// The mesh's number of each.
    const std::vector<VertexId>& vertices() const { return vertices_; }

    /// One of the triangles, given with the mesh's numbers.
    Triangle local(const Triangle& triangle) const {
        return {number_of(triangle[0]), number_of(triangle[1]), number_of(triangle[2])};
    }

private:
    static constexpr std::size_t kBits = 64;

    // Tells which of 64 successive vertices are there, and how many come before them.
    struct Word {
        std::uint64_t bits = 0;  // none: the place is free
        VertexId before = 0;
        VertexId name = 0;  // the number of its first vertex, divided by 64
    };

    static std::uint64_t bit_of(VertexId v) { return std::uint64_t{1} << v % kBits; }

    // The place for a vertex, or a free one for it.
    std::size_t place_of(VertexId v) const {
        const auto name = static_cast<VertexId>(v / kBits);
        if (is_dense_) return name - first_;
        const std::size_t mask = words_.size() - 1;  // a power of two
        std::size_t place = mix_bits(name) & mask;
        while (words_[place].bits != 0 && words_[place].name != name) place = (place + 1) & mask;
        return place;
    }
    Word& word_of(VertexId v) {
        Word& word = words_[place_of(v)];
        word.name = static_cast<VertexId>(v / kBits);
        return word;
    }

    void number_in_order() {
        std::vector<std::pair<VertexId, std::size_t>> taken;  // name and place
        for (std::size_t place = 0; place < words_.size(); ++place)
            if (words_[place].bits != 0) taken.emplace_back(words_[place].name, place);
        std::sort(taken.begin(), taken.end());
        for (const auto& [name, place] : taken) number(words_[place], name);
    }

    // The vertices of a word, which come next.
    void number(Word& word, VertexId name) {
        word.before = static_cast<VertexId>(vertices_.size());
        for_each_bit(word.bits,
                     [&](std::size_t bit) { vertices_.push_back(static_cast<VertexId>(name * kBits + bit)); });
    }

    VertexId number_of(VertexId v) const {
        const Word& word = words_[place_of(v)];
        return word.before + static_cast<VertexId>(count_bits(word.bits & (bit_of(v) - 1)));
    }

    std::vector<VertexId> vertices_;
    std::vector<Word> words_;
    VertexId first_ = 0;     // name, where they lie one behind the other
    bool is_dense_ = false;  // whether they do
};

}  // namespace meniscus

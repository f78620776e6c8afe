// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Lists that several threads find parts of.
#pragma once

#include <cstddef>
#include <vector>

#include "core/parallel.h"

namespace meniscus {

/// What find(begin, end, list) appends for fixed chunks of [0, n), in the order of the chunks: the same for any number
/// of threads.
template <class T, class Find>
std::vector<T> parallel_list(std::size_t n, std::size_t chunk, const Find& find) {
    struct Part {
        std::vector<T> list;
        Part& operator+=(const Part& b) {
            list.insert(list.end(), b.list.begin(), b.list.end());
            return *this;
        }
    };
    return parallel_sum<Part>(n, chunk,
                              [&](std::size_t begin, std::size_t end) {
                                  Part part;
                                  find(begin, end, part.list);
                                  return part;
                              })
        .list;
}

}  // namespace meniscus

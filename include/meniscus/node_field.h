// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers on the nodes of a grid, in memory that is not zeroed first.
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace meniscus {

/// An allocator whose vectors leave new elements uninitialised, for large arrays that are written in full anyway.
template <class T>
class UnsetAllocator : public std::allocator<T> {
public:
    UnsetAllocator() = default;
    template <class U>
    UnsetAllocator(const UnsetAllocator<U>& /*other*/) noexcept {}

    template <class U>
    void construct(U* at) noexcept {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Values>
    void construct(U* at, Values&&... values) {
        ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
    }
};

/// One number per node, in the order of the grid's blocks. The n numbers of NodeField(n) are uninitialised.
using NodeField = std::vector<float, UnsetAllocator<float>>;

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Memory that one task after the other works in.
#pragma once

#include <cstddef>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "core/parallel_list.h"

namespace meniscus {

/// What tasks work with, as many as run at once: made where none is free, and handed on with the memory that it has
/// grown to. What a task finds out must not depend on what another has left there.
template <class Make>
class Workspaces {
public:
    /// make   returns a pointer that owns a workspace
    explicit Workspaces(Make make) : make_(std::move(make)) {}

    /// Calls body(workspace); from any thread.
    template <class Body>
    void with_one(const Body& body) {
        Workspace workspace = take();
        body(*workspace);
        const std::scoped_lock lock(mutex_);
        free_.push_back(std::move(workspace));
    }

private:
    using Workspace = std::invoke_result_t<const Make&>;

    Workspace take() {
        {
            const std::scoped_lock lock(mutex_);
            if (!free_.empty()) {
                Workspace workspace = std::move(free_.back());
                free_.pop_back();
                return workspace;
            }
        }
        return make_();
    }

    const Make make_;
    std::mutex mutex_;
    std::vector<Workspace> free_;
};

/// Calls body(begin, end, workspace) for fixed chunks of [0, n), with workspaces as make() returns them.
template <class Make, class Body>
void parallel_chunks_with(std::size_t n, std::size_t chunk, Make make, const Body& body) {
    Workspaces workspaces(std::move(make));
    parallel_chunks(n, chunk, [&](std::size_t begin, std::size_t end) {
        workspaces.with_one([&](auto& workspace) { body(begin, end, workspace); });
    });
}

/// parallel_list of what find(begin, end, workspace, list) appends, with such workspaces.
template <class T, class Make, class Find>
std::vector<T> parallel_list_with(std::size_t n, std::size_t chunk, Make make, const Find& find) {
    Workspaces workspaces(std::move(make));
    return parallel_list<T>(n, chunk, [&](std::size_t begin, std::size_t end, std::vector<T>& list) {
        workspaces.with_one([&](auto& workspace) { find(begin, end, workspace, list); });
    });
}

}  // namespace meniscus

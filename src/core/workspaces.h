// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Memory that one task after the other works in.
#pragma once

#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

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

}  // namespace meniscus

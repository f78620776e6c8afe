// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>

#include "core/library_on_one_thread.h"
#include "core/parallel.h"
#include "meniscus/threads.h"

namespace meniscus {
namespace {

thread_local int alone = 0;  // limits of one thread that live

}  // namespace

// The thread library's own limit takes memory from an allocator that is loaded with the first of them: one thread alone
// does without.
struct ThreadLimit::Control {
    explicit Control(int threads) {
        if (threads == 1)
            ++alone;
        else
            limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                          static_cast<std::size_t>(threads));
    }
    ~Control() {
        if (limit == nullptr) --alone;
    }
    Control(const Control&) = delete;
    Control& operator=(const Control&) = delete;

    std::unique_ptr<tbb::global_control> limit;
};

ThreadLimit::ThreadLimit(int threads) : control_(threads > 0 ? std::make_unique<Control>(threads) : nullptr) {}

ThreadLimit::~ThreadLimit() = default;

bool is_alone() { return alone > 0; }

struct LibraryOnOneThread::Control {
    tbb::global_control limit{tbb::global_control::max_allowed_parallelism, 1};
};

LibraryOnOneThread::LibraryOnOneThread() : control_(std::make_unique<Control>()) {}

LibraryOnOneThread::~LibraryOnOneThread() = default;

}  // namespace meniscus

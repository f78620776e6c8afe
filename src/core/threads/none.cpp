// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The calling thread does everything itself, as in a browser.
#include "core/threads/backend.h"

namespace meniscus::threads {

void for_ranges(std::size_t n, std::size_t /*grain*/, void (*run)(const void*, std::size_t, std::size_t),
                const void* body) {
    run(body, 0, n);
}

void isolated(void (*run)(const void*), const void* work) { run(work); }

struct Limit::Control {};
Limit::Limit(int /*threads*/) {}
Limit::~Limit() = default;

void start(void (* /*meanwhile*/)(), void (* /*begin*/)()) {}

}  // namespace meniscus::threads

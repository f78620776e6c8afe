// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Work that needs no Python, done by a given number of threads while other Python threads run.
#pragma once

#include <pybind11/pybind11.h>

#include "meniscus/threads.h"

namespace meniscus::python {

/// What `work()` returns; it must not touch Python's objects.
///
/// threads   0: all cores
template <class Work>
auto by_threads(int threads, Work work) {
    const pybind11::gil_scoped_release release;
    const ThreadLimit limit(threads);
    return work();
}

}  // namespace meniscus::python

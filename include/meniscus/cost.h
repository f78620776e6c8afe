// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a surface will take, told before it is computed.
#pragma once

#include <cstddef>

#include "meniscus/atoms.h"

namespace meniscus {

struct SurfaceOptions;

/// Expected size and cost of a computation, from the exposure of some of the atoms.
struct Cost {
    double area = 0.0;       ///< of the surface, Å²
    double vertices = 0.0;   ///< of its mesh
    double memory_mb = 0.0;  ///< peak of the process, in units of 2^20 bytes
    double seconds = 0.0;    ///< of processor time, on the machine of docs/benchmarks.md, files not included
};

/// Mostly within a quarter of what is measured afterwards; docs/design/performance.md has the comparison.
///
/// cost     a millisecond, for large structures 0.2 µs per atom
Cost estimate_cost(const Atoms& atoms, const SurfaceOptions& options);

/// Whether it is expected to take no more memory than is allowed, or than the machine has left if that is 0.
bool fits_into_memory(const Cost& cost, std::size_t memory_limit_mb = 0);

/// Throws LimitError with the numbers, and the options that would help, where a computation does not fit.
void refuse_what_would_not_fit(const Atoms& atoms, const SurfaceOptions& options, const Cost& cost,
                               std::size_t memory_limit_mb = 0);

}  // namespace meniscus

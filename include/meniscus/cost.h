// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Estimates, before a surface is computed, of the memory and time that this will take.
#pragma once

#include <cstddef>

#include "meniscus/atoms.h"

namespace meniscus {

struct SurfaceOptions;

/// Expected size and cost of a computation.
struct Cost {
    double area = 0.0;       ///< area of the surface, Å²
    double vertices = 0.0;   ///< vertices of the grid's mesh
    double memory_mb = 0.0;  ///< peak memory of the process, in units of 2^20 bytes
    double seconds = 0.0;    ///< processor time without reading and writing, on the machine of docs/benchmarks.md
};

/// Estimates the cost of a computation from the exposure to solvent of a sample of the atoms: mostly within a quarter
/// of what is measured afterwards (docs/design/performance.md).
///
/// cost     a millisecond, for large structures 0.2 µs per atom
Cost estimate_cost(const Atoms& atoms, const SurfaceOptions& options);

/// Whether a computation is expected to fit into a limit of memory (units of 2^20 bytes; 0: what the machine has left).
bool fits_into_memory(const Cost& cost, std::size_t memory_limit_mb = 0);

/// Throws a LimitError that gives the numbers, and the options that would help, unless a computation fits into memory.
void refuse_what_would_not_fit(const Atoms& atoms, const SurfaceOptions& options, const Cost& cost,
                               std::size_t memory_limit_mb = 0);

}  // namespace meniscus

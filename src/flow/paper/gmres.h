// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The linear solver of the paper.
#pragma once

#include <span>

#include "flow/spline_system.h"

namespace meniscus {

/// As solve(), by GMRES that is restarted every 30 iterations and needs as many vectors.
///
/// source   Saad & Schultz 1986
SolveResult solve_gmres(const SplineSystem& system, std::span<float> x, const SolveOptions& options);

}  // namespace meniscus

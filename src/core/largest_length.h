// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The coordinates and radii that geometry takes.
#pragma once

namespace meniscus {

/// Å: doubles still tell 1e-4 Å apart there, which no structure comes near.
inline constexpr double kLargestLength = 1e12;

}  // namespace meniscus

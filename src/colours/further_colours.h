// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// More colours than any published palette has, for structures of dozens of chains.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "meniscus/colour.h"

namespace meniscus {

/// The given colours and behind them others, each as different as can be from all before it and from the grey of what
/// is unknown, neither too light for a white page nor too dark for shade. No two are the same.
///
/// first    the same at every call, since the row is made once
/// count    of all of them, at most a few thousand
/// cost     of the first call: O(count)
const std::vector<Colour>& further_colours(std::span<const Colour> first, std::size_t count);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Volumes from fuzzed files.
#pragma once

#include "fuzzed_file.h"

namespace meniscus::fuzz {

/// Writes the bytes and reads them as a volume: a value for each node, all finite, and the grid alone the same.
int run_volume(const FuzzedFile& file, const std::uint8_t* data, std::size_t size);

}  // namespace meniscus::fuzz

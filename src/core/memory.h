// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How much memory this process can have.
#pragma once

#include <cstddef>

namespace meniscus {

/// Bytes that can be allocated without swapping, as the operating system estimates it, within the limits set for this
/// process (control group, ulimit); a large number where nothing tells.
std::size_t available_memory();

}  // namespace meniscus

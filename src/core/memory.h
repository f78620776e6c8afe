// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How much memory the machine has left.
#pragma once

#include <cstddef>

namespace meniscus {

/// Bytes that can be allocated without swapping, as the operating system estimates it; a large number where it
/// does not tell.
std::size_t available_memory();

}  // namespace meniscus

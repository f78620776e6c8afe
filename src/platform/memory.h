// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How much memory this process can have.
#pragma once

#include <cstddef>
#include <string>

namespace meniscus {

/// Bytes that can be allocated without swapping, as the operating system estimates it, within the limits set for this
/// process (control group, ulimit); a large number where nothing tells.
std::size_t available_memory();

/// What control groups (version 2) leave to a process, the tightest of its own and those around it; a large number
/// where nothing tells.
///
/// groups  a file as /proc/self/cgroup
/// root    where the groups are mounted
std::size_t memory_left_by_groups(const std::string& groups, const std::string& root);

}  // namespace meniscus

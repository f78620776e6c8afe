// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How a long computation reports its progress.
#pragma once

#include <functional>
#include <string_view>

namespace meniscus {

/// Called with the name of a stage ("geometry", "exact", "band", "flow", "mesh") and the fraction of that stage that is
/// done, 0 to 1, always on the thread that called compute_surface(). May be empty.
using Progress = std::function<void(std::string_view stage, double fraction)>;

}  // namespace meniscus

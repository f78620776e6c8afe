// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How a long computation tells its caller where it is.
#pragma once

#include <functional>
#include <string_view>

namespace meniscus {

/// Called with the stage's name ("geometry", "band", "flow", "mesh") and the fraction of that stage
/// that is done, 0 to 1. Always called from the calling thread. May be empty.
using Progress = std::function<void(std::string_view stage, double fraction)>;

}  // namespace meniscus

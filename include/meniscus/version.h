// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The library's version.
#pragma once

namespace meniscus {

inline constexpr const char* kVersion = "0.1.0";

}  // namespace meniscus

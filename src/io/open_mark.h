// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How files say in a comment that their mesh is not a whole surface.
#pragma once

namespace meniscus {

inline constexpr const char* kOpenMark = "open: part of a surface";

}  // namespace meniscus

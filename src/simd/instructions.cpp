// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "simd/instructions.h"

#include <algorithm>
#include <cstdlib>

namespace meniscus {

std::string_view wanted_instructions() {
    const char* wanted = std::getenv("MENISCUS_INSTRUCTIONS");
    return wanted != nullptr ? wanted : "";
}

std::size_t choose_instructions(std::span<const std::string_view> available, std::string_view wanted) {
    const auto found = std::find(available.begin(), available.end(), wanted);
    return found != available.end() ? static_cast<std::size_t>(found - available.begin()) : available.size() - 1;
}

}  // namespace meniscus

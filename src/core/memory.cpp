// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/memory.h"

#include <fstream>
#include <limits>
#include <string>

namespace meniscus {

std::size_t available_memory() {
    std::ifstream info("/proc/meminfo");
    std::size_t kilobytes = 0;
    for (std::string key; info >> key; info.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
        if (key == "MemAvailable:" && info >> kilobytes) return kilobytes * 1024;
    return std::numeric_limits<std::size_t>::max() / 2;
}

}  // namespace meniscus

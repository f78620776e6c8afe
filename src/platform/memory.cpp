// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/memory.h"

#ifdef __EMSCRIPTEN__
#include <emscripten/heap.h>
#include <malloc.h>
#endif
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>

namespace meniscus {
namespace {

constexpr std::size_t kPlenty = std::numeric_limits<std::size_t>::max();

#ifdef __EMSCRIPTEN__
// How far the module may still grow, with what it has freed: a browser does not tell what the machine has left.
std::size_t free_in_machine() { return emscripten_get_heap_max() - static_cast<std::uint32_t>(mallinfo().uordblks); }
#else
// What the machine has left.
std::size_t free_in_machine() {
    std::ifstream info("/proc/meminfo");
    std::size_t kilobytes = 0;
    for (std::string key; info >> key; info.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
        if (key == "MemAvailable:" && info >> kilobytes) return kilobytes * 1024;
    return kPlenty;
}
#endif

// What one control group (version 2) leaves of its own limit.
std::size_t free_in_group(const std::string& folder) {
    std::size_t limit = 0;
    if (!(std::ifstream(folder + "/memory.max") >> limit)) return kPlenty;  // "max", or no such file
    std::ifstream statistics(folder + "/memory.stat");
    std::string key;
    std::size_t used = 0;  // but for cached files, which give way
    while (statistics >> key >> used && key != "anon") continue;
    return limit - std::min(limit, used);
}

// What `ulimit -v` allows.
std::size_t address_space() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kPlenty;
    return static_cast<std::size_t>(limit.rlim_cur);
}

}  // namespace

std::size_t available_memory() {
    // Batch systems and containers set the limits of groups.
    return std::min({free_in_machine(), memory_left_by_groups("/proc/self/cgroup", "/sys/fs/cgroup"), address_space()});
}

std::size_t memory_left_by_groups(const std::string& groups, const std::string& root) {
    std::ifstream file(groups);
    std::string group;
    while (std::getline(file, group) && !group.starts_with("0::")) continue;
    // In a container the root is its own group, while the path may be the one that its host knows. A whole machine's
    // root has no limit.
    std::size_t least = free_in_group(root);
    for (group.erase(0, 3); group.size() > 1; group.resize(group.rfind('/')))
        least = std::min(least, free_in_group(root + group));
    return least;
}

}  // namespace meniscus

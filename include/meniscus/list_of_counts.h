// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Short lists of names with their numbers, for messages, summaries and pages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace meniscus {

/// Lists names with their numbers, "4 HEM, 2 PO4": the most frequent first, at most six; empty if there are none.
inline std::string list_of_counts(const std::map<std::string, std::size_t>& counts) {
    constexpr std::size_t kMostNames = 6;
    std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string list;
    for (std::size_t i = 0; i < std::min(sorted.size(), kMostNames); ++i) {
        const std::string& name = sorted[i].first;
        list += (i > 0 ? ", " : "") + std::to_string(sorted[i].second) + " " + (name.empty() ? "nameless" : name);
    }
    if (sorted.size() > kMostNames) {
        const std::size_t more = sorted.size() - kMostNames;
        list += " and " + std::to_string(more) + (more == 1 ? " more kind" : " more kinds");
    }
    return list;
}

}  // namespace meniscus

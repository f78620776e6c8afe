// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Distances between two surfaces, summed up over area.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "meniscus/mesh_quality.h"

namespace meniscus {

/// Distances, Å, each with the area, Å², that it stands for.
class WeightedDistances {
public:
    explicit WeightedDistances(std::size_t count) : pairs_(count) {}
    void set(std::size_t i, double distance, double weight) { pairs_[i] = {distance, weight}; }

    DistanceSummary summarise() && {
        if (pairs_.empty()) return {};
        std::sort(pairs_.begin(), pairs_.end());
        double weight = 0.0;
        double sum = 0.0;
        for (const auto& [distance, area] : pairs_) {
            weight += area;
            sum += area * distance;
        }
        DistanceSummary result{sum / weight, 0.0, pairs_.back().first};
        double below = 0.0;
        for (const auto& [distance, area] : pairs_) {
            below += area;
            result.p99 = distance;
            if (below >= 0.99 * weight) break;
        }
        return result;
    }

private:
    std::vector<std::pair<double, double>> pairs_;
};

}  // namespace meniscus

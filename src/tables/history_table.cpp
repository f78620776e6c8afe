// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/tables.h"

namespace meniscus {

Table history_table(std::span<const FlowStep> history) {
    Table table{{"step", "time", "area", "volume", "mean_distance", "max_distance", "residual", "solver_iterations",
                 "components", "genus"},
                {}};
    for (const FlowStep& s : history)
        table.rows.push_back({std::int64_t{s.step}, s.time, s.area, s.volume, s.mean_distance, s.max_distance,
                              s.residual, std::int64_t{s.solver_iterations}, static_cast<std::int64_t>(s.components),
                              s.genus});
    return table;
}

}  // namespace meniscus

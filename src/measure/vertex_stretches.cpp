// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/vertex_stretches.h"

#include <numeric>

#include "core/parallel_list.h"

namespace meniscus {
namespace {

constexpr std::size_t kRunsPerTask = 1024;  // runs per task: some hundred microseconds

}  // namespace

VertexStretches::VertexStretches(std::size_t vertex_count, std::span<const Triangle> triangles)
    : vertex_count_(vertex_count), triangles_(triangles), begins_(size() + 2, 0) {
    const std::size_t runs = (triangles.size() + kRun - 1) / kRun;
    const auto touches = parallel_list<Touch>(
        runs, kRunsPerTask, [this](std::size_t begin, std::size_t end, auto& list) { find_touches(begin, end, list); });
    // While filling, entry s + 1 is where the next run of s goes; in the end that is where its runs end.
    for (const Touch& touch : touches) ++begins_[touch.stretch + std::size_t{2}];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    runs_.resize(touches.size());
    for (const Touch& touch : touches) runs_[begins_[touch.stretch + std::size_t{1}]++] = touch.run;
}

void VertexStretches::find_touches(std::size_t first_run, std::size_t last_run, std::vector<Touch>& touches) const {
    std::vector<std::size_t> touched_by(size(), last_run);  // the last run so far that touches a stretch
    for (std::size_t run = first_run; run < last_run; ++run)
        for (const Triangle& t : triangles_.subspan(run * kRun, std::min(kRun, triangles_.size() - run * kRun)))
            for (const VertexId v : t) {
                const auto stretch = static_cast<std::uint32_t>(v / kLength);
                if (touched_by[stretch] == run) continue;
                touched_by[stretch] = run;
                touches.push_back({stretch, run});
            }
}

}  // namespace meniscus

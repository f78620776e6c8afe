// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/vertex_stretches.h"

#include <numeric>

#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 1024;  // runs per task: some hundred microseconds

}  // namespace

VertexStretches::VertexStretches(std::size_t vertex_count, std::span<const Triangle> triangles)
    : vertex_count_(vertex_count), triangles_(triangles), begins_(size() + 2, 0) {
    const std::size_t runs = (triangles.size() + kRun - 1) / kRun;
    const Touches touches = parallel_sum<Touches>(
        runs, kChunk, [this](std::size_t begin, std::size_t end) { return touches_of(begin, end); });
    // While filling, entry s + 1 is where the next run of s goes; in the end that is where its runs end.
    for (const Touch& touch : touches.list) ++begins_[touch.stretch + std::size_t{2}];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    runs_.resize(touches.list.size());
    for (const Touch& touch : touches.list) runs_[begins_[touch.stretch + std::size_t{1}]++] = touch.run;
}

VertexStretches::Touches VertexStretches::touches_of(std::size_t first_run, std::size_t last_run) const {
    std::vector<std::size_t> touched_by(size(), last_run);  // the last run so far that touches a stretch
    Touches touches;
    for (std::size_t run = first_run; run < last_run; ++run)
        for (const Triangle& t : triangles_.subspan(run * kRun, std::min(kRun, triangles_.size() - run * kRun)))
            for (const VertexId v : t) {
                const auto stretch = static_cast<std::uint32_t>(v / kLength);
                if (touched_by[stretch] == run) continue;
                touched_by[stretch] = run;
                touches.list.push_back({stretch, run});
            }
    return touches;
}

}  // namespace meniscus

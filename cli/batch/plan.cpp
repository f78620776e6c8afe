// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <functional>
#include <map>
#include <numeric>
#include <queue>
#include <string_view>
#include <tuple>
#include <utility>

#include "meniscus/errors.h"

namespace meniscus::cli::batch {

namespace {

constexpr std::uint64_t kPackedRatio = 4;   // text of structures to its gzipped size
constexpr std::uint64_t kStartUp = 10'000;  // bytes of text that take as long as the start of a process

std::optional<int> whole_number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < 0) return std::nullopt;
    return value;
}

std::optional<int> number_in_environment(const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? std::nullopt : whole_number(text);
}

/// What a task takes, in bytes of text.
std::uint64_t weight(const Input& input) {
    return kStartUp + input.size * (input.name.ends_with(".gz") ? kPackedRatio : 1);
}

}  // namespace

Shard parse_shard(const std::string& text) {
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto index = whole_number(std::string_view(text).substr(0, slash));
    const auto count = slash < text.size() ? whole_number(std::string_view(text).substr(slash + 1)) : std::nullopt;
    if (!index || !count || *index >= *count)
        throw UsageError(
            fmt::format("--shard: '{}' is not a part of a batch; with four parts, write 0/4, 1/4, 2/4 or 3/4", text));
    return {*index, *count};
}

std::optional<Shard> shard_of_array() {
    const auto task = number_in_environment("SLURM_ARRAY_TASK_ID");
    const auto count = number_in_environment("SLURM_ARRAY_TASK_COUNT");
    const auto first = number_in_environment("SLURM_ARRAY_TASK_MIN");
    const auto last = number_in_environment("SLURM_ARRAY_TASK_MAX");
    if (!task || !count || !first || !last) return std::nullopt;
    if (*last - *first + 1 != *count)
        throw UsageError(
            fmt::format("the {} tasks of this array are not numbered from {} to {} without gaps; give --shard", *count,
                        *first, *last));
    return Shard{*task - *first, *count};
}

std::vector<Task> plan(const std::vector<Input>& inputs, const Shard& shard) {
    std::map<std::string, int> uses;
    for (const Input& input : inputs) ++uses[without_suffix(input.name)];
    std::vector<std::size_t> order(inputs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::make_tuple(weight(inputs[b]), std::string_view(inputs[a].name)) <
               std::make_tuple(weight(inputs[a]), std::string_view(inputs[b].name));
    });
    // Each goes to the shard that has least so far: at most 4/3 of the best division (Graham 1969).
    using Load = std::pair<std::uint64_t, int>;
    std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
    for (int i = 0; i < shard.count; ++i) loads.emplace(0, i);
    std::vector<Task> tasks;
    for (const std::size_t i : order) {
        const auto [load, owner] = loads.top();
        loads.pop();
        loads.emplace(load + weight(inputs[i]), owner);
        if (owner != shard.index) continue;
        const std::string stem = without_suffix(inputs[i].name);
        tasks.push_back({inputs[i], uses[stem] > 1 ? inputs[i].name : stem, weight(inputs[i])});
    }
    return tasks;
}

std::string fingerprint(const std::vector<Input>& inputs) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    const auto take = [&hash](std::string_view text) {
        for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    };
    for (const Input& input : inputs) take(fmt::format("{}\t{}\n", input.name, input.size));
    return fmt::format("{} inputs, {:016x}", inputs.size(), hash);
}

}  // namespace meniscus::cli::batch

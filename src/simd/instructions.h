// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which of several sets of kernels is used, where the same ones are compiled for several sets of instructions.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace meniscus {

/// What the environment variable MENISCUS_INSTRUCTIONS names; empty if it is not set.
std::string_view wanted_instructions();

/// The position of `wanted` among the names of what this machine can run, the slowest first; the last one if it is not
/// among them.
std::size_t choose_instructions(std::span<const std::string_view> available, std::string_view wanted);

/// The same of sets of kernels, whose member `instructions` is the name.
template <class Kernels>
const Kernels& choose_kernels(const std::vector<Kernels>& available, std::string_view wanted) {
    std::vector<std::string_view> names;
    names.reserve(available.size());
    for (const Kernels& kernels : available) names.push_back(kernels.instructions);
    return available[choose_instructions(names, wanted)];
}

}  // namespace meniscus

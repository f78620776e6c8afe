// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What meniscus/describe_options.h says of options, for programs that make pages, forms and stubs of it.
#pragma once

#include <nlohmann/json.hpp>

namespace meniscus::cli {

/// By group of help ("Surface", "Flow", "Triangles", "Findings", "Running"), lists of options: name, kind (number,
/// flag, choice, count, memory), symbol, words of a choice, range, effect, default (null: off, or what "standard"
/// says), brief, meaning, example.
nlohmann::ordered_json described_options();

}  // namespace meniscus::cli

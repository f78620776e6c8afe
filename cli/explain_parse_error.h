// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What to say of a command line that the parser refuses, in the words of this program.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace meniscus::cli {

/// "--probe: a value is missing; write --probe R".
/// program   after a parse that failed with `error`, which is none that unknown_words.h is for
std::string explain_parse_error(const CLI::App& program, const CLI::ParseError& error);

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Messages on standard error: one line each, "meniscus: error: ...", "meniscus: warning: ..." or "meniscus: note: ...".
#pragma once

#include <ostream>
#include <string>
#include <string_view>

namespace meniscus::cli {

/// Whether the system refused to start a thread, which the thread library reports as an error without a class of its
/// own.
bool is_out_of_threads(const std::exception& error);

inline constexpr const char* kOutOfThreads =
    "no memory to start another thread; use fewer --threads, or raise the limit";

/// The text with every line break and other control character replaced by a space.
std::string one_line(std::string_view text);

void print_error(std::ostream& out, std::string_view text);
void print_warning(std::ostream& out, std::string_view text);
void print_note(std::ostream& out, std::string_view text);

/// How messages and the summary call an input: its path, or "standard input" for "-".
std::string input_label(const std::string& path);

}  // namespace meniscus::cli

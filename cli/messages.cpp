// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "messages.h"

#include <algorithm>

namespace meniscus::cli {

bool is_out_of_threads(const std::exception& error) {
    return std::string_view(error.what()).find("pthread_create") != std::string_view::npos;
}

std::string one_line(std::string_view text) {
    std::string line(text);
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return line;
}

void print_error(std::ostream& out, std::string_view text) { out << "meniscus: error: " << one_line(text) << '\n'; }

void print_warning(std::ostream& out, std::string_view text) { out << "meniscus: warning: " << one_line(text) << '\n'; }

void print_note(std::ostream& out, std::string_view text) { out << "meniscus: note: " << one_line(text) << '\n'; }

std::string input_label(const std::string& path) { return path == "-" ? "standard input" : path; }

}  // namespace meniscus::cli

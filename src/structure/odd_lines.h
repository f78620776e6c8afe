// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Oddities of a file's lines, told in one message per kind: a file that has one often has it in every line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reading/text.h"

namespace meniscus::reading {

/// How often one kind of oddity occurs, and what it looks like where it occurs first.
struct OddLines {
    std::size_t count = 0;
    std::size_t first_line = 0;
    std::string example;

    void add(std::size_t line, std::string_view text) {
        if (count++ > 0) return;
        first_line = line;
        example = shown(text);
    }

    /// Appends "line 31: BEFORE 'example' AFTER (3 times)"; nothing if there is none of the kind.
    ///
    /// unit   what first_line counts
    void tell(const std::string& before, const std::string& after, std::vector<std::string>& lines,
              const std::string& unit = "line") const {
        if (count == 0) return;
        const std::string times = count > 1 ? " (" + std::to_string(count) + " times)" : "";
        lines.push_back(unit + " " + std::to_string(first_line) + ": " + before + example + after + times);
    }
};

}  // namespace meniscus::reading

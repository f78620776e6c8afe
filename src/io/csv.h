// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Text in comma-separated files.
#pragma once

#include <algorithm>
#include <string_view>

namespace meniscus {

/// A field as RFC 4180 wants it: in quotes if it holds a comma, a quote or a line end. file: also a TextBuffer
template <class File>
void write_csv_field(File& file, std::string_view text) {
    const auto is_special = [](char c) {
        return c <= ',' && (c == ',' || c == '"' || c == '\r' || c == '\n');  // letters and digits are above
    };
    if (std::none_of(text.begin(), text.end(), is_special)) return file.write(text);
    file.write('"');
    for (const char c : text) {
        if (c == '"') file.write('"');
        file.write(c);
    }
    file.write('"');
}

}  // namespace meniscus

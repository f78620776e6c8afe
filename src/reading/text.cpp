// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/text.h"

namespace meniscus::reading {
namespace {

bool is_unprintable(char c) { return c < 0x20 || c >= 0x7f; }

}  // namespace

void fail_at(const std::string& file, Place place, const std::string& message) {
    throw InputError(file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": " + message);
}

std::size_t find_unprintable(std::string_view text) {
    const auto* const found = std::find_if(text.begin(), text.end(), is_unprintable);
    return found == text.end() ? std::string_view::npos : static_cast<std::size_t>(found - text.begin());
}

std::string printable(std::string_view text, std::size_t at_most) {
    std::string result(text.substr(0, at_most));
    std::replace_if(result.begin(), result.end(), is_unprintable, '?');
    if (text.size() > at_most) result += "...";
    return result;
}

std::string shown(std::string_view word) { return std::string("'").append(printable(word, kOfWord)).append("'"); }

std::string_view Words::next() {
    constexpr std::string_view kBlank = " \t\v\f";
    const std::size_t first = std::min(line_.find_first_not_of(kBlank, position_), line_.size());
    position_ = std::min(line_.find_first_of(kBlank, first), line_.size());
    column_ = first + 1;
    return line_.substr(first, position_ - first);
}

void normalise_line_ends(std::string& text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    if (text.find('\r') == std::string::npos) return;
    std::size_t length = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
        text[length++] = text[i] == '\r' ? '\n' : text[i];
    }
    text.resize(length);
}

}  // namespace meniscus::reading

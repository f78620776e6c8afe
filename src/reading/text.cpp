// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/text.h"

namespace meniscus::reading {

void fail_at(const std::string& file, Place place, const std::string& message) {
    throw InputError(file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": " + message);
}

std::string shown(std::string_view word) {
    constexpr std::size_t kLongest = 40;
    std::string text(word.substr(0, kLongest));
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7f; }, '?');
    if (word.size() > kLongest) text += "...";
    return std::string("'").append(text).append("'");
}

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

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "radii/rule_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "meniscus/errors.h"
#include "reading/numbers.h"
#include "reading/text.h"

namespace meniscus {
namespace {

using reading::shown;

constexpr std::string_view kBlank = " \t\r\v\f";

// The text of a rule file, in upper case, and the rules that point into it.
struct RuleText {
    std::string text;
    std::vector<RadiusRule> rules;
};

// One line being read: hands out words and knows where they stand.
struct Line {
    const std::string& file;
    std::size_t number;
    std::string_view text;
    std::size_t position = 0;

    std::string_view next_word() {
        position = std::min(text.find_first_not_of(kBlank, position), text.size());
        const std::size_t end = std::min(text.find_first_of(kBlank, position), text.size());
        const std::string_view word = text.substr(position, end - position);
        position = end;
        return word;
    }

    [[noreturn]] void fail(std::string_view word, const std::string& what) const {
        const std::size_t column = static_cast<std::size_t>(word.data() - text.data()) + 1;
        throw InputError(file + ":" + std::to_string(number) + ":" + std::to_string(column) + ": " + what);
    }
};

double read_radius(const Line& line, std::string_view word) {
    if (word.empty()) line.fail(word, "the radius is missing; write RESIDUE ATOM RADIUS");
    double radius = 0.0;
    const auto [end, error] = reading::from_chars(word.data(), word.data() + word.size(), radius);
    const bool is_number = error == std::errc() && end == word.data() + word.size() && std::isfinite(radius);
    if (!is_number) line.fail(word, "the radius " + shown(word) + " is not a number; write it in Å, such as 1.70");
    if (radius < 0.0) line.fail(word, "the radius " + shown(word) + " is negative; 0 leaves an atom out");
    return radius;
}

void read_hydrogens_word(Line& line, RadiusSet& set) {
    const std::string_view word = line.next_word();
    if (word != "DROP" && word != "KEEP") line.fail(word, "'hydrogens' must be followed by 'drop' or 'keep'");
    set.united = word == "DROP";
}

void read_line(Line line, RuleText& content, RadiusSet& set) {
    line.text = line.text.substr(0, line.text.find('#'));
    const std::string_view residue = line.next_word();
    if (residue.empty()) return;
    if (residue == "HYDROGENS") {
        read_hydrogens_word(line, set);
    } else {
        const std::string_view atom = line.next_word();
        if (atom.empty()) line.fail(atom, "the atom is missing; write RESIDUE ATOM RADIUS");
        content.rules.push_back({residue, atom, read_radius(line, line.next_word())});
    }
    const std::string_view extra = line.next_word();
    if (!extra.empty()) line.fail(extra, shown(extra) + " is unexpected; a line ends after the radius");
}

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

}  // namespace

RadiusSet parse_radius_rules(std::string_view text, const std::string& file) {
    auto content = std::make_shared<RuleText>();
    content->text.resize(text.size());
    std::transform(text.begin(), text.end(), content->text.begin(), upper);
    RadiusSet set{file, false, {}, content};
    std::string_view rest = content->text;
    for (std::size_t number = 1; !rest.empty(); ++number) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        read_line(Line{file, number, rest.substr(0, end)}, *content, set);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (content->rules.empty()) throw InputError(file + ": no rules in this file; write RESIDUE ATOM RADIUS lines");
    set.rules = content->rules;
    return set;
}

RadiusSet read_radius_rules(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream || !text) {
        throw InputError(path + ": cannot be read as a file of radius rules; choose " + radius_set_names() +
                         ", auto or a file");
    }
    return parse_radius_rules(text.str(), path);
}

}  // namespace meniscus

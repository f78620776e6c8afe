// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/selection_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>
#include <vector>

#include "meniscus/errors.h"
#include "reading/lower_case.h"
#include "reading/numbers.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

enum class Part { Chain, Residue, Numbers, Atom, Element, AltLoc, BFactor, Occupancy };

struct Keyword {
    std::string_view word;
    Part part;
};

constexpr auto kKeywords = std::to_array<Keyword>({
    {"chain", Part::Chain},     {"c.", Part::Chain},       {"resn", Part::Residue}, {"r.", Part::Residue},
    {"resname", Part::Residue}, {"resi", Part::Numbers},   {"i.", Part::Numbers},   {"resid", Part::Numbers},
    {"name", Part::Atom},       {"n.", Part::Atom},        {"elem", Part::Element}, {"e.", Part::Element},
    {"element", Part::Element}, {"symbol", Part::Element}, {"alt", Part::AltLoc},   {"altloc", Part::AltLoc},
    {"b", Part::BFactor},       {"beta", Part::BFactor},   {"q", Part::Occupancy},  {"occupancy", Part::Occupancy},
});

// Words that stand alone and have no exact counterpart, with what to write instead.
struct Refused {
    std::string_view word;
    std::string_view remedy;
};

constexpr const char* kForms = "write for instance //A,B/10-50, //A/(HEM) or //A/10-50/CA";
constexpr const char* kPolymerRemedy =
    "the polymer is kept without any selection; name its chains, as in //A,B, or write ;polymer";
constexpr const char* kHydrogenRemedy = "leave hydrogens out by the option 'hydrogens': drop";
constexpr const char* kOneRange = "write one range, as in //A/10-50, or //A/10 + //A/20";

constexpr auto kRefused = std::to_array<Refused>({
    {"protein", kPolymerRemedy},
    {"polymer.protein", kPolymerRemedy},
    {"nucleic", kPolymerRemedy},
    {"polymer.nucleic", kPolymerRemedy},
    {"hetatm", "name the residues, as in (HEM,NAG)"},
    {"hetero", "name the residues, as in (HEM,NAG)"},
    {"ligand", "name the residues, as in (HEM,NAG)"},
    {"ligands", "name the residues, as in (HEM,NAG)"},
    {"organic", "name the residues, as in (HEM,NAG)"},
    {"backbone", "name its atoms, as in N,CA,C,O"},
    {"bb.", "name its atoms, as in N,CA,C,O"},
    {"sidechain", "the atoms beside the main chain are !N,CA,C,O"},
    {"sc.", "the atoms beside the main chain are !N,CA,C,O"},
    {"hydrogens", kHydrogenRemedy},
    {"hydrogen", kHydrogenRemedy},
    {"hydro", kHydrogenRemedy},
    {"noh", kHydrogenRemedy},
    {"h.", kHydrogenRemedy},
    {"or", "write //A,B for chains, and + between selections: //A/10-50 + //B/(HEM)"},
    {"|", kForms},
    {"not", "an exclamation mark at the head of a list excludes it, as in //!A or (!HEM)"},
    {"segi", kForms},
    {"segid", kForms},
    {"segname", kForms},
    {"within", kForms},
    {"around", kForms},
    {"byres", kForms},
    {"br.", kForms},
    {"same", kForms},
    {"index", kForms},
    {"residue", kForms},
});

// Words that gemmi's syntax has counterparts of, in the place after the atoms.
constexpr auto kKinds = std::to_array<Refused>({
    {"polymer", ";polymer"},
    {"solvent", ";solvent"},
    {"sol.", ";solvent"},
    {"water", ";solvent"},
    {"waters", ";solvent"},
});

template <class List>
auto find_word(const List& list, const std::string& word) {
    return std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.word == word; });
}

bool is_and(const std::string& word) { return word == "and" || word == "&"; }

bool is_known(const std::string& word) {
    return find_word(kKeywords, word) != kKeywords.end() || find_word(kRefused, word) != kRefused.end() ||
           find_word(kKinds, word) != kKinds.end() || word == "all";
}

std::string_view without_quotes(std::string_view word) {
    const bool is_quoted = word.size() >= 2 && (word[0] == '\'' || word[0] == '"') && word.front() == word.back();
    return is_quoted ? word.substr(1, word.size() - 2) : word;
}

// "(chain A and resn SER)": brackets around the whole, as other programs' lists and examples have them.
std::string without_brackets(const std::string& expression) {
    const std::string text(trimmed(expression));
    const bool is_bracketed = text.starts_with('(') && text.find(')') == text.size() - 1;
    return is_bracketed && text.find(' ') != std::string::npos ? text.substr(1, text.size() - 2) : text;
}

std::vector<std::string> split_words(const std::string& expression) {
    std::string spaced;
    for (const char c : without_brackets(expression)) {
        const bool parts = c == '&' || c == '|' || c == '<' || c == '>' || c == '=';
        spaced += parts ? std::string{' ', c, ' '} : std::string(1, c);
    }
    std::vector<std::string> result;
    Words walk(spaced);
    for (std::string_view word = walk.next(); !word.empty(); word = walk.next())
        result.emplace_back(without_quotes(word));
    return result;
}

// "A+B", "A,B" and "A B" as "A,B".
std::string listed(const std::vector<std::string>& values) {
    std::string list;
    for (const std::string& value : values) list += (list.empty() ? "" : ",") + value;
    std::replace(list.begin(), list.end(), '+', ',');
    return list;
}

bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

class Translation {
public:
    Translation(const std::string& expression, const std::string& option) : expression_(expression), option_(option) {}

    std::string operator()() {
        const std::vector<std::string> words = split_words(expression_);
        for (auto word = words.begin(); word != words.end();) {
            const auto end = std::find_if(word, words.end(), [](const auto& w) { return is_and(lower_case(w)); });
            add_condition({word, end});
            word = end == words.end() ? end : std::next(end);
            if (end != words.end() && word == words.end()) refuse("nothing follows " + *end, kForms);
        }
        return composed();
    }

private:
    [[noreturn]] void refuse(const std::string& problem, std::string_view remedy) const {
        throw UsageError(option_ + " " + shown(expression_) + ": " + problem + "; " + std::string(remedy));
    }

    void add_condition(const std::vector<std::string>& words) {
        if (words.empty()) refuse("a condition is missing", kForms);
        for (const std::string& word : words)
            if (const auto found = find_word(kRefused, lower_case(word)); found != kRefused.end())
                refuse("'" + word + "' has no exact counterpart in gemmi's syntax", found->remedy);
        const std::string first = lower_case(words.front());
        if (words.size() == 1 && first == "all") return;
        if (const auto kind = find_word(kKinds, first); words.size() == 1 && kind != kKinds.end()) {
            kinds_ += kind->remedy;
            return;
        }
        const auto keyword = find_word(kKeywords, first);
        if (keyword == kKeywords.end() || words.size() == 1)
            refuse(shown(words.front()) + " is not a condition", kForms);
        for (auto word = words.begin() + 1; word != words.end(); ++word)
            if (begins_condition(*word)) refuse("'and' is missing before '" + *word + "'", kForms);
        add(keyword->part, {words.begin() + 1, words.end()});
    }

    // A name that is also a word of the language is meant as a name: "chain B", "resn ALL".
    static bool begins_condition(const std::string& word) {
        constexpr std::size_t kLongestChain = 2;
        return word.size() > kLongestChain && word == lower_case(word) && is_known(word);
    }

    void add(Part part, const std::vector<std::string>& values) {
        const bool compares = part == Part::BFactor || part == Part::Occupancy;
        const std::string text = compares ? comparison(values) : part == Part::Numbers ? range(values) : names(values);
        if (!parts_.try_emplace(part, text).second) refuse("the same condition stands there twice", kForms);
    }

    // "<50"
    std::string comparison(const std::vector<std::string>& values) const {
        const bool is_one = values.size() == 2 && (values[0] == "<" || values[0] == ">" || values[0] == "=");
        if (!is_one || !finite_number(values[1]))
            refuse("a value is compared with one number by <, > or =", "write for instance b > 50");
        return values[0] + values[1];
    }

    std::string names(const std::vector<std::string>& values) const {
        std::string list = listed(values);
        if (list.empty()) refuse("an empty name", "gemmi's syntax has none; name what is to be kept instead");
        const bool is_plain = std::all_of(list.begin(), list.end(), [](unsigned char c) {
            return std::isalnum(c) != 0 || c == ',' || c == '\'' || c == '_';
        });
        const bool has_gap = list.front() == ',' || list.back() == ',' || list.find(",,") != std::string::npos;
        const bool may_be_copy = list.find('-') != std::string::npos;
        if (!is_plain || has_gap)
            refuse("'" + printable(list, kOfWord) + "' is not a list of names",
                   may_be_copy ? "copies of chains are named by the option 'chains', as in A-2" : kForms);
        return list;
    }

    // "10-50", "10:50" and "10 to 50" as "10-50.Z", with the insertion codes of its last number; "10" as "10-10" and
    // "10A" as "10.A-10.A", residues of their own.
    std::string range(const std::vector<std::string>& values) const {
        std::string text = values.front();
        if (values.size() == 3 && lower_case(values[1]) == "to")
            text += "-" + values[2];
        else if (values.size() != 1)
            refuse("several ranges or residues cannot be named", kOneRange);
        if (text.find_first_of("+,") != std::string::npos)
            refuse("several ranges or residues cannot be named", kOneRange);
        std::replace(text.begin(), text.end(), ':', '-');
        const std::size_t dash = text.find('-');
        if (dash == std::string::npos) return numbered(text) + "-" + numbered(text);
        const std::string first = text.substr(0, dash);
        const std::string last = text.substr(dash + 1);
        if (!is_number(first) || !is_number(last)) refuse_numbers(text);
        check_size(first);
        check_size(last);
        return first + "-" + last + ".Z";
    }

    // "10", or "10.A" for "10A".
    std::string numbered(const std::string& text) const {
        const std::string number = is_number(text) ? text : text.substr(0, text.size() - 1);
        check_size(number);
        if (is_number(text)) return text;
        if (!is_number(number) || std::isalpha(static_cast<unsigned char>(text.back())) == 0) refuse_numbers(text);
        return number + "." + text.back();
    }

    void check_size(const std::string& number) const {
        if (is_number(number) && !integer(number))
            refuse(printable(number, kOfWord) + " is larger than a residue number may be", "correct it");
    }

    [[noreturn]] void refuse_numbers(const std::string& text) const {
        if (text.starts_with('-'))
            refuse("gemmi's syntax has no negative residue numbers",
                   "write a range up to a positive one, as in //A/-50");
        refuse("'" + printable(text, kOfWord) + "' is neither a residue number nor a range of them",
               std::string(kOneRange) + "; with insertion codes, //A/10.A-50.C");
    }

    std::string part(Part which, const std::string& otherwise) const {
        const auto found = parts_.find(which);
        return found == parts_.end() ? otherwise : found->second;
    }

    bool has(Part which) const { return parts_.contains(which); }

    // "10(HEM)-50" is how gemmi writes names and numbers of residues together.
    std::string residues() const {
        std::string names = has(Part::Residue) ? "(" + part(Part::Residue, "") + ")" : "";
        if (!has(Part::Numbers)) return names;
        const std::string numbers = part(Part::Numbers, "");
        const std::size_t dash = numbers.find('-');
        return numbers.substr(0, dash) + names + numbers.substr(dash);
    }

    std::string atoms() const {
        std::string text = part(Part::Atom, "");
        if (has(Part::Element)) text += "[" + part(Part::Element, "") + "]";
        if (has(Part::AltLoc)) text += ":" + part(Part::AltLoc, "");
        return text;
    }

    std::string composed() const {
        std::string behind = kinds_;
        if (has(Part::BFactor)) behind += ";b" + part(Part::BFactor, "");
        if (has(Part::Occupancy)) behind += ";q" + part(Part::Occupancy, "");
        const std::string residue_part = residues();
        const std::string atom_part = atoms();
        if (residue_part.empty() && atom_part.empty() && !has(Part::Chain)) return behind.empty() ? "*" : behind;
        std::string text = "//" + part(Part::Chain, "*");
        if (!residue_part.empty() || !atom_part.empty()) text += "/" + (residue_part.empty() ? "*" : residue_part);
        if (!atom_part.empty()) text += "/" + atom_part;
        return text + behind;
    }

    const std::string& expression_;
    const std::string& option_;
    std::map<Part, std::string> parts_;
    std::string kinds_;
};

}  // namespace

bool is_in_words(const std::string& expression) {
    const std::vector<std::string> words = split_words(expression);
    if (words.empty() || expression.front() == ';') return false;
    const std::string first = lower_case(words.front());
    // Alone, "b" is a chain; "chain" lacks its value, and saying so helps.
    constexpr std::size_t kLongestOfChains = 3;
    if (words.size() == 1)
        return is_known(first) && (first.size() > kLongestOfChains || find_word(kKeywords, first) == kKeywords.end());
    // Words between blanks are no selection of gemmi's, which has slashes or semicolons between its parts.
    const bool has_words = trimmed(expression).find(' ') != std::string_view::npos;
    if (is_known(first) || (has_words && expression.find_first_of("/;") == std::string::npos)) return true;
    return std::any_of(words.begin(), words.end(), [](const std::string& word) {
        const std::string lower = lower_case(word);
        return is_and(lower) || lower == "or" || lower == "not";
    });
}

std::string in_gemmi_syntax(const std::string& expression, const std::string& option) {
    return Translation(expression, option)();
}

}  // namespace meniscus::reading

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "meniscus/structure.h"
#include "reading/lower_case.h"
#include "reading/numbers.h"

namespace meniscus {
namespace {

using reading::is_digit;
using reading::is_letter;

bool all_of(std::string_view text, bool (*holds)(char)) { return std::all_of(text.begin(), text.end(), holds); }

bool is_letter_or_digit(char c) { return is_digit(c) || is_letter(c); }

// "1ubq" for "1ubq" and "pdb_00001ubq"; empty for what is no identifier of the PDB.
std::string_view pdb_code(std::string_view word) {
    constexpr std::string_view kExtended = "pdb_0000";
    if (word.starts_with(kExtended)) word.remove_prefix(kExtended.size());
    const bool is_code = word.size() == 4 && is_digit(word[0]) && word[0] != '0' && all_of(word, is_letter_or_digit) &&
                         std::any_of(word.begin(), word.end(), is_letter);
    return is_code ? word : std::string_view();
}

// A letter, a digit, and one or two times three letters or digits and a digit, as in p0dtc2 and a0a024r1r8.
// source   https://www.uniprot.org/help/accession_numbers
bool is_accession(std::string_view word) {
    if (word.size() != 6 && word.size() != 10) return false;
    if (!is_letter(word[0]) || !all_of(word, is_letter_or_digit)) return false;
    const bool is_old = std::string_view("opq").find(word[0]) != std::string_view::npos;
    if (is_old) return word.size() == 6 && is_digit(word[1]) && is_digit(word[5]);
    for (std::size_t block = 1; block < word.size(); block += 4)
        if (!is_digit(word[block]) || (block + 4 < word.size() && !is_letter(word[block + 1]))) return false;
    return is_digit(word.back());
}

// "p12345" for "p12345" and "af-p12345-f1-model_v4"; empty for what names no protein of UniProt.
std::string_view accession(std::string_view word) {
    if (word.starts_with("af-")) word = word.substr(3, word.find('-', 3) - 3);
    return is_accession(word) ? word : std::string_view();
}

std::string upper_case(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return is_letter(c) ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

// A file of the folder that has the word for its name and a suffix.
std::string file_beside(const std::string& word) {
    std::error_code ignored;
    for (const char* suffix : {".cif", ".pdb", ".cif.gz", ".pdb.gz", ".ent", ".pqr"})
        for (const std::string& name : {word + suffix, lower_case(word) + suffix})
            if (std::filesystem::is_regular_file(name, ignored)) return name;
    return "";
}

}  // namespace

std::string explain_identifier(const std::string& path) {
    std::error_code ignored;
    const std::string word = lower_case(path);
    const std::string code(pdb_code(word));
    const std::string protein = upper_case(accession(word));
    if ((code.empty() && protein.empty()) || std::filesystem::exists(path, ignored)) return "";
    if (const std::string file = file_beside(path); !file.empty())
        return path + " is not a file; did you mean " + file + "?";
    const std::string start = path + " is not a file; Meniscus does not download: get ";
    if (!code.empty()) return start + code + ".cif from the PDB (https://files.rcsb.org/download/" + code + ".cif)";
    return start + "the model of this protein from AlphaFold DB (https://alphafold.ebi.ac.uk/entry/" + protein + ")";
}

}  // namespace meniscus

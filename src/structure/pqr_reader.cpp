// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pqr_reader.h"

#include <algorithm>

#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"
#include "structure/pqr_words.h"
#include "structure/residue_list.h"
#include "structure/residue_number.h"

namespace meniscus::reading {
namespace {

constexpr const char* kAdvice =
    "; put blanks between them (PDB2PQR does with its option --whitespace), or write PDB2PQR's columns";

bool is_residue_number(std::string_view word) {
    RawResidue ignored;
    return set_number(word, ignored);
}

// "A1000": a chain and the number behind it.
bool is_chain_and_number(std::string_view word) {
    return word.size() > 1 && word[0] > '9' && is_residue_number(word.substr(1));
}

// Where the words of an atom are: a chain moves those behind it by one.
struct Layout {
    bool has_chain = false;

    std::size_t number() const { return has_chain ? 5 : 4; }
    std::size_t centre() const { return number() + 1; }
    std::size_t charge() const { return number() + 4; }
    std::size_t radius() const { return number() + 5; }
};

bool fits(const WordLine& line, const Layout& layout) {
    if (line.size() <= layout.radius()) return false;
    const std::string_view number = line[layout.number()];
    if (!is_residue_number(number) && (layout.has_chain || !is_chain_and_number(number))) return false;
    for (std::size_t i = layout.centre(); i <= layout.radius(); ++i)
        if (!finite_number(line[i])) return false;
    return true;
}

[[noreturn]] void fail_grown(const WordLine& line, std::size_t i) {
    line.fail(i, shown(line[i]) + " is several words grown together" + kAdvice);
}

// The layout that a line with an error is meant to have: a word behind the radius is an element, no number.
Layout likely_layout(const WordLine& line) {
    const bool has_element = line.size() == 11 && is_residue_number(line[4]) && !finite_number(line[10]);
    return {line.size() >= 11 && !has_element};
}

Layout layout_of(const WordLine& line, const std::vector<Word>& words) {
    if (has_grown_name(words)) fail_grown(line, 2);
    for (const Layout layout : {Layout{true}, Layout{false}})
        if (fits(line, layout)) return layout;
    if (const Word* grown = find_grown_numbers(words)) fail_grown(line, static_cast<std::size_t>(grown - words.data()));
    if (line.size() < 10) {
        line.fail(line.size(), "a PQR atom has 10 words, or 11 with a chain; this line has " +
                                   std::to_string(line.size()) + ": words are missing, or have grown together" +
                                   kAdvice);
    }
    return likely_layout(line);
}

RawResidue residue_of(const WordLine& line, const Layout& layout) {
    RawResidue residue;
    residue.name = upper_case(line.name(3));
    if (layout.has_chain) residue.chain = line.name(4);
    const std::string_view number = line.name(layout.number());
    if (set_number(number, residue)) return residue;
    if (layout.has_chain || !is_chain_and_number(number))
        line.fail(layout.number(), "residue number " + shown(number) + " is not an integer; correct it");
    set_number(number.substr(1), residue);
    residue.chain = std::string(1, number[0]);
    return residue;
}

// The word behind the radius if it is a symbol that the name bears out; it may as well be a segment.
std::string element_word(const WordLine& line, const Layout& layout, const std::string& name) {
    if (line.size() <= layout.radius() + 1) return {};
    std::string symbol = element_symbol(line[layout.radius() + 1]);
    const std::size_t letters = std::min(name.find_first_not_of("0123456789"), name.size());
    return name.compare(letters, symbol.size(), symbol) == 0 ? symbol : std::string();
}

RawAtom atom_of(const WordLine& line, const Layout& layout, const RawResidue& residue) {
    RawAtom atom;
    atom.centre = line.centre(layout.centre());
    atom.charge = line.number(layout.charge(), "charge");
    atom.radius = line.radius(layout.radius());
    atom.name = upper_case(line.name(2));
    atom.element = element_word(line, layout, atom.name);
    if (atom.element.empty()) atom.element = element_from_name(atom.name, residue.name);
    atom.hetatm = upper_case(line[0]) == "HETATM";
    atom.serial = integer(line[1]).value_or(0);
    return atom;
}

// Takes the lines of a model one by one.
class PqrReader {
public:
    PqrReader(RawModel& model, const std::string& file) : model_(model), file_(file), residues_(model.residues) {}

    void take(std::string_view line, std::size_t number) {
        const PqrLine kind = kind_of_pqr_line(line);
        if (kind == PqrLine::Atom) take_atom(line, number);
        if (kind == PqrLine::Unknown) pass_over(line, number);
    }

    void finish() {
        if (unknown_ == 0) return;
        model_.notes.push_back(std::to_string(unknown_) + (unknown_ == 1 ? " line" : " lines") +
                               " of no known record passed over, the first is line " + std::to_string(first_unknown_));
    }

private:
    void take_atom(std::string_view text, std::size_t number) {
        const std::vector<Word> words = pqr_words(text);
        const WordLine line(file_, number, words);
        const Layout layout = layout_of(line, words);
        const RawResidue residue = residue_of(line, layout);
        model_.atoms.push_back(atom_of(line, layout, residue));
        model_.atoms.back().residue = residues_.index_of(residue);
    }

    void pass_over(std::string_view text, std::size_t number) {
        const WordLine line(file_, number, words_of(text));
        if (may_be_atom(text)) {
            line.fail(0, shown(line[0]) +
                             " is no record, but the line may be meant as an atom; begin it with ATOM or "
                             "HETATM, or with REMARK if it is a comment");
        }
        if (unknown_++ == 0) first_unknown_ = number;
    }

    RawModel& model_;
    const std::string& file_;
    ResidueList residues_;
    std::size_t unknown_ = 0;
    std::size_t first_unknown_ = 0;
};

bool is_model_record(std::string_view line) {
    const std::string word = upper_case(Words(line).next());
    return word == "MODEL";
}

}  // namespace

RawModel parse_pqr(std::string_view text, const PdbModelSpan& part, const std::string& file) {
    RawModel model;
    model.has_radii = true;
    PqrReader reader(model, file);
    Lines lines(text.substr(part.begin, part.end - part.begin));
    while (lines.next()) reader.take(lines.line(), part.first_line + lines.number() - 1);
    reader.finish();
    return model;
}

RawModel parse_pqr(std::string_view text, const std::string& file) {
    return parse_pqr(text, {.begin = 0, .end = text.size()}, file);
}

PdbModels find_pqr_models(std::string_view text) {
    PdbModels models;
    PdbModelSpan next{.begin = 0, .end = text.size()};
    Lines lines(text);
    while (lines.next()) {
        if (kind_of_pqr_line(lines.line()) == PqrLine::Atom) ++next.atoms;
        if (!is_model_record(lines.line())) continue;
        next.end = lines.begin();
        models.spans.push_back(next);
        next = {.begin = lines.begin(), .end = text.size(), .first_line = lines.number()};
    }
    models.spans.push_back(next);
    if (models.spans.size() < 3) {
        models.spans = {{.begin = 0, .end = text.size()}};
        return models;
    }
    if (models.spans.front().atoms > 0)
        models.warnings.emplace_back("line 1: atoms outside MODEL and ENDMDL; taken as a model of their own");
    else
        models.spans.erase(models.spans.begin());
    return models;
}

}  // namespace meniscus::reading

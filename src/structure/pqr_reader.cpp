// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pqr_reader.h"

#include <algorithm>

#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"
#include "structure/odd_lines.h"
#include "structure/pdb_columns.h"
#include "structure/pdb_records.h"
#include "structure/pqr_layout.h"
#include "structure/pqr_words.h"
#include "structure/residue_list.h"
#include "structure/residue_number.h"

namespace meniscus::reading {
namespace {

RawResidue residue_of(const WordLine& line, const PqrLayout& layout) {
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
std::string element_word(const WordLine& line, const PqrLayout& layout, const std::string& name) {
    if (line.size() <= layout.radius() + 1) return {};
    std::string symbol = element_symbol(line[layout.radius() + 1]);
    const std::size_t letters = std::min(name.find_first_not_of("0123456789"), name.size());
    return name.compare(letters, symbol.size(), symbol) == 0 ? symbol : std::string();
}

RawAtom atom_of(const WordLine& line, const PqrLayout& layout, const RawResidue& residue) {
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

// Behind the radius there may be an element, but no second atom.
void check_end(const WordLine& line, const PqrLayout& layout, const std::vector<Word>& words, std::string_view text) {
    const std::size_t next = layout.radius() + 1;
    if (words.size() <= next || !has_coordinates(text.substr(words[next].column - 1))) return;
    line.fail(next, "another atom begins within the line; put it on a line of its own");
}

// "#ATOM      1  N ..." or "# ATOM ...".
bool is_atom_in_comment(std::string_view line) {
    const std::string_view text = trimmed(line);
    if (!text.starts_with('#')) return false;
    const std::string_view rest = text.substr(std::min(text.find_first_not_of("# \t"), text.size()));
    return kind_of_pqr_line(rest) == PqrLine::Atom && has_coordinates(rest);
}

// Takes the lines of a model one by one.
class PqrReader {
public:
    PqrReader(RawModel& model, const std::string& file) : model_(model), file_(file), residues_(model.residues) {}

    void take(std::string_view line, std::size_t number) {
        const PqrLine kind = kind_of_pqr_line(line);
        if (kind == PqrLine::Atom) return take_atom(line, number);
        check_joined_record(line, number, file_);
        if (kind == PqrLine::Unknown) pass_over(line, number);
        if (is_atom_in_comment(line)) in_comments_.add(number, Words(line).next());
    }

    void finish() {
        in_comments_.tell("", " begins a comment, but the line has coordinates as an atom has; left out",
                          model_.warnings);
        if (unknown_ == 0) return;
        model_.notes.push_back(std::to_string(unknown_) + (unknown_ == 1 ? " line" : " lines") +
                               " of no known record passed over, the first is line " + std::to_string(first_unknown_));
    }

private:
    void take_atom(std::string_view text, std::size_t number) {
        const std::vector<Word> words = pqr_words(text);
        const WordLine line(file_, number, words);
        const PqrLayout layout = layout_of(line, words);
        check_end(line, layout, words, text);
        const RawResidue residue = residue_of(line, layout);
        model_.atoms.push_back(atom_of(line, layout, residue));
        model_.atoms.back().residue = residues_.index_of(residue);
    }

    void pass_over(std::string_view text, std::size_t number) {
        const WordLine line(file_, number, words_of(text));
        if (may_be_atom(text)) {
            line.fail(0, shown(line[0]) +
                             " is not a record, but the line may be meant as an atom; begin it with ATOM or "
                             "HETATM, or with REMARK if it is a comment");
        }
        if (unknown_++ == 0) first_unknown_ = number;
    }

    RawModel& model_;
    const std::string& file_;
    ResidueList residues_;
    OddLines in_comments_;
    std::size_t unknown_ = 0;
    std::size_t first_unknown_ = 0;
};

ModelLine kind_in_pqr(std::string_view line) {
    if (kind_of_pqr_line(line) == PqrLine::Atom) return ModelLine::Atom;
    const std::string word = upper_case(Words(line).next());
    if (word.starts_with("ENDMDL")) return ModelLine::Endmdl;
    return word.starts_with("MODEL") && word.find_first_not_of("0123456789", 5) == word.npos ? ModelLine::Model
                                                                                             : ModelLine::Other;
}

// ENDMDL goes to the model that it ends, other lines between two models to the one behind, so that none is passed over
// unseen.
void cover_text(std::string_view text, std::vector<PdbModelSpan>& spans) {
    if (spans.empty()) spans.push_back({});
    spans.back().end = text.size();
    std::size_t begin = 0;
    std::size_t first_line = 1;
    for (PdbModelSpan& span : spans) {
        const std::string_view last = text.substr(span.end, text.find('\n', span.end) - span.end);
        if (kind_in_pqr(last) == ModelLine::Endmdl) span.end = std::min(span.end + last.size() + 1, text.size());
        span.begin = begin;
        span.first_line = first_line;
        const std::string_view own = text.substr(begin, span.end - begin);
        first_line += static_cast<std::size_t>(std::count(own.begin(), own.end(), '\n'));
        begin = span.end;
    }
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
    PdbModels models = find_models(text, kind_in_pqr);
    cover_text(text, models.spans);
    return models;
}

}  // namespace meniscus::reading

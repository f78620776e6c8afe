// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/sphere_readers.h"

#include <cmath>
#include <vector>

#include "core/largest_length.h"
#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"
#include "structure/residue_list.h"

namespace meniscus::reading {
namespace {

struct Word {
    std::string_view text;
    std::size_t column = 1;
};

// A line as words that know their columns.
class WordLine {
public:
    WordLine(const std::string& file, std::size_t number, std::string_view text) : file_(file), number_(number) {
        Words words(text.substr(0, text.find('#')));
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            words_.push_back({word, words.column()});
        }
        end_column_ = words.column();
    }

    std::size_t size() const { return words_.size(); }
    std::string_view operator[](std::size_t i) const { return words_[i].text; }

    // Names go into messages, tables and pages.
    std::string_view name(std::size_t i) const {
        if (find_unprintable(words_[i].text) != std::string_view::npos)
            fail(i, "a byte that is not a printable character in the name " + shown(words_[i].text) + "; correct it");
        return words_[i].text;
    }

    [[noreturn]] void fail(std::size_t i, const std::string& message) const {
        fail_at(file_, {number_, i < words_.size() ? words_[i].column : end_column_}, message);
    }

    double number(std::size_t i, const char* what) const {
        if (i >= words_.size()) fail(i, std::string("the ") + what + " is missing; the line ends too early");
        const auto value = finite_number(words_[i].text);
        if (!value) fail(i, std::string(what) + " " + shown(words_[i].text) + " is not a finite number; correct it");
        return *value;
    }

    double length(std::size_t i, const char* what) const {
        const double value = number(i, what);
        if (std::abs(value) > kLargestLength)
            fail(i, std::string(what) + " " + shown(words_[i].text) + " is more than 1e12 Å; correct it");
        return value;
    }

    double radius(std::size_t i) const {
        const double value = length(i, "radius");
        if (value < 0.0) fail(i, "radius " + shown(words_[i].text) + " is negative; 0 leaves an atom out");
        return value;
    }

    Vec3 centre(std::size_t i) const {
        return {length(i, "x coordinate"), length(i + 1, "y coordinate"), length(i + 2, "z coordinate")};
    }

private:
    const std::string& file_;
    std::size_t number_;
    std::vector<Word> words_;
    std::size_t end_column_ = 1;
};

RawModel sphere_model(bool has_names) {
    RawModel model;
    model.has_names = has_names;
    model.has_radii = true;
    return model;
}

// "27", "-5", "27A"; false if it is no residue number.
bool set_number(std::string_view digits, RawResidue& residue) {
    const bool has_code = !integer(digits) && digits.size() > 1;
    const auto value = integer(digits.substr(0, digits.size() - static_cast<std::size_t>(has_code)));
    if (!value) return false;
    residue.number = *value;
    if (has_code) residue.insertion_code = digits.back();
    return true;
}

// Ten words without a chain, eleven with one; a chain and a number may have grown together (A1000).
RawResidue pqr_residue(const WordLine& line) {
    RawResidue residue;
    residue.name = upper_case(line.name(3));
    const bool has_chain = line.size() >= 11;
    const std::string_view number = line.name(has_chain ? 5 : 4);
    if (has_chain) residue.chain = line.name(4);
    if (set_number(number, residue)) return residue;
    const bool grown_together = !has_chain && number[0] > '9' && set_number(number.substr(1), residue);
    if (!grown_together)
        line.fail(has_chain ? 5 : 4, "residue number " + shown(number) + " is not an integer; correct it");
    residue.chain = std::string(1, number[0]);
    return residue;
}

RawAtom pqr_atom(const WordLine& line, const RawResidue& residue) {
    const std::size_t first = line.size() >= 11 ? 6 : 5;
    RawAtom atom;
    atom.centre = line.centre(first);
    atom.charge = line.number(first + 3, "charge");
    atom.radius = line.radius(first + 4);
    atom.name = upper_case(line.name(2));
    atom.element = element_from_name(atom.name, residue.name);
    atom.hetatm = line[0] == "HETATM";
    atom.serial = integer(line[1]).value_or(0);
    return atom;
}

// "CA_ALA_12", as MSMS writes names, and "CA_ALA_12B_A" with insertion code and chain; else a name alone.
RawResidue xyzrn_residue(const WordLine& line, RawAtom& atom) {
    constexpr std::size_t kName = 5;
    RawResidue residue;
    if (line.size() <= kName) return residue;
    std::vector<std::string_view> parts;
    for (std::string_view rest = line.name(kName); parts.size() < 3; rest.remove_prefix(parts.back().size() + 1)) {
        parts.push_back(rest.substr(0, rest.find('_')));
        if (parts.back().size() == rest.size()) break;
    }
    atom.name = upper_case(parts[0]);
    if (parts.size() < 3 || !set_number(parts[2], residue)) return residue;
    residue.name = upper_case(parts[1]);
    const std::size_t used = static_cast<std::size_t>(parts[2].data() + parts[2].size() - line[kName].data());
    if (used < line[kName].size()) residue.chain = std::string(line[kName].substr(used + 1));
    return residue;
}

// Calls read(line) for every line that has words.
template <class Read>
void for_each_line(std::string_view text, const std::string& file, Read read) {
    Lines lines(text);
    while (lines.next()) {
        const WordLine line(file, lines.number(), lines.line());
        if (line.size() > 0) read(line);
    }
}

RawAtom sphere(const WordLine& line) {
    RawAtom atom;
    atom.centre = line.centre(0);
    atom.radius = line.radius(3);
    return atom;
}

}  // namespace

RawModel parse_pqr(std::string_view text, const std::string& file) {
    RawModel model = sphere_model(true);
    ResidueList residues(model.residues);
    for_each_line(text, file, [&](const WordLine& line) {
        if (line[0] != "ATOM" && line[0] != "HETATM") return;
        if (line.size() < 10) {
            line.fail(line.size(),
                      "a PQR atom has 10 words, or 11 with a chain; this line has " + std::to_string(line.size()));
        }
        const RawResidue residue = pqr_residue(line);
        model.atoms.push_back(pqr_atom(line, residue));
        model.atoms.back().residue = residues.index_of(residue);
    });
    return model;
}

RawModel parse_xyzr(std::string_view text, const std::string& file) {
    RawModel model = sphere_model(false);
    for_each_line(text, file, [&](const WordLine& line) {
        model.atoms.push_back(sphere(line));
        model.atoms.back().serial = static_cast<int>(model.atoms.size());
    });
    if (!model.atoms.empty()) model.residues.emplace_back();
    return model;
}

RawModel parse_xyzrn(std::string_view text, const std::string& file) {
    RawModel model = sphere_model(true);
    ResidueList residues(model.residues);
    for_each_line(text, file, [&](const WordLine& line) {
        RawAtom atom = sphere(line);
        const RawResidue residue = xyzrn_residue(line, atom);
        atom.element = element_from_name(atom.name, residue.name);
        atom.serial = static_cast<int>(model.atoms.size() + 1);
        atom.residue = residues.index_of(residue);
        model.atoms.push_back(std::move(atom));
    });
    return model;
}

}  // namespace meniscus::reading

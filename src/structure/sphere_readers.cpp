// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/sphere_readers.h"

#include <vector>

#include "reading/text.h"
#include "structure/element.h"
#include "structure/residue_list.h"
#include "structure/residue_number.h"
#include "structure/word_line.h"

namespace meniscus::reading {
namespace {

RawModel sphere_model(bool has_names) {
    RawModel model;
    model.has_names = has_names;
    model.has_radii = true;
    return model;
}

// "CA_ALA_12", as MSMS writes names, and "CA_ALA_12B_A" with insertion code and chain; else a name alone.
RawResidue xyzrn_residue(const WordLine& line, RawAtom& atom) {
    constexpr std::size_t kLabelWord = 5;
    RawResidue residue;
    if (line.size() <= kLabelWord) return residue;
    std::vector<std::string_view> parts;
    for (std::string_view rest = line.name(kLabelWord); parts.size() < 3; rest.remove_prefix(parts.back().size() + 1)) {
        parts.push_back(rest.substr(0, rest.find('_')));
        if (parts.back().size() == rest.size()) break;
    }
    atom.name = upper_case(parts[0]);
    if (parts.size() < 3 || !set_number(parts[2], residue)) return residue;
    residue.name = upper_case(parts[1]);
    const std::size_t used = static_cast<std::size_t>(parts[2].data() + parts[2].size() - line[kLabelWord].data());
    if (used < line[kLabelWord].size()) residue.chain = std::string(line[kLabelWord].substr(used + 1));
    return residue;
}

// Calls read(line) for every line that has words.
template <class Read>
void for_each_line(std::string_view text, const std::string& file, Read read) {
    Lines lines(text);
    while (lines.next()) {
        const WordLine line(file, lines.number(), words_of(lines.line()));
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

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/sphere_names.h"

#include <algorithm>
#include <cctype>

#include "io/labels.h"

namespace meniscus {
namespace {

std::string word_of(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::isgraph(c) == 0; }, '_');
    return text.empty() ? "-" : text;
}

}  // namespace

std::string sphere_name(const Structure& structure, std::size_t atom) {
    const Residue& residue = residue_of(structure, atom);
    std::string number = std::to_string(residue.number);
    if (residue.insertion_code != ' ') number += residue.insertion_code;
    return word_of(structure.labels[atom].name) + '_' + word_of(residue.name) + '_' + word_of(number) + '_' +
           word_of(residue.chain);
}

std::vector<std::string> sphere_names(const Structure& structure) {
    check_labels(structure);
    std::vector<std::string> names;
    if (std::all_of(structure.labels.begin(), structure.labels.end(),
                    [](const AtomLabel& l) { return l.name.empty(); }))
        return names;
    names.reserve(structure.labels.size());
    for (std::size_t atom = 0; atom < structure.labels.size(); ++atom) names.push_back(sphere_name(structure, atom));
    return names;
}

}  // namespace meniscus

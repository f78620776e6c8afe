// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <string>

#include "io/atomic_file.h"
#include "io/labels.h"
#include "meniscus/errors.h"
#include "meniscus/write.h"

namespace meniscus {
namespace {

std::string word_of(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::isgraph(c) == 0; }, '_');
    return text.empty() ? "-" : text;
}

// ATOM_RESIDUE_NUMBER_CHAIN without blanks, "CA_GLY_35_A".
std::string name_of(const Structure& structure, std::size_t atom) {
    const Residue& residue = residue_of(structure, atom);
    std::string number = std::to_string(residue.number);
    if (residue.insertion_code != ' ') number += residue.insertion_code;
    return word_of(structure.labels[atom].name) + '_' + word_of(residue.name) + '_' + word_of(number) + '_' +
           word_of(residue.chain);
}

}  // namespace

void write_spheres(const std::string& path, const Structure& structure) {
    const bool with_names = path.ends_with(".xyzrn");
    if (!with_names && !path.ends_with(".xyzr"))
        throw UsageError(path + ": unknown suffix for spheres; choose .xyzr or .xyzrn");
    check_labels(structure);
    AtomicFile file(path);
    for (std::size_t i = 0; i < structure.atoms.size(); ++i) {
        const Vec3& centre = structure.atoms.centres[i];
        for (const double value : {centre.x, centre.y, centre.z}) {
            file.number(value);
            file.write(' ');
        }
        file.number(structure.atoms.radii[i]);
        if (with_names) file.write(" 1 " + name_of(structure, i));
        file.write('\n');
    }
    file.commit();
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The keys of reports that are about a structure, described as meniscus/describe_results.h describes the others.
#pragma once

#include <string>
#include <vector>

#include "meniscus/describe_results.h"
#include "meniscus/file_name.h"
#include "meniscus/structure.h"
#include "meniscus/tables.h"

namespace meniscus {

/// Where a structure comes from.
template <class Visitor>
void describe_file(const Structure& s, Visitor& visit) {
    visit({"file", "", "file name without folders, as for all files in the report; `-` for standard input"},
          file_name(s.file));
    visit({"sha256", "", "SHA-256 of the bytes of the file as found, hexadecimal"}, s.sha256);
}

/// What was kept of it.
template <class Visitor>
void describe_kept(const Structure& s, double probe, Visitor& visit) {
    visit({"atoms", "", "number of kept atoms"}, s.atoms.size());
    visit({"residues", "", "number of residues with at least one kept atom"}, s.residues.size());
    visit({"radii", "", "the radius set in use; `file` for radii from the input itself"}, file_name(s.radii_set));
    visit({"probe", "Å", "probe radius"}, probe);
    visit({"dropped", "", "number of atoms left out, by reason"}, s.dropped);
    visit({"notes", "",
           "what happens with every ordinary file, such as waters left out; also written to standard error, not with "
           "`--quiet`"},
          s.notes);
    visit({"warnings", "", "what may make a number wrong; also written to standard error"}, s.warnings);
}

inline std::string joined_names(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text.append(text.empty() ? "" : ",").append(name);
    return text;
}

template <class Visitor>
void describe(const ChainInterface& i, Visitor& visit) {
    visit({"a", "", "the first group, chains separated by commas"}, joined_names(i.chains.a));
    visit({"b", "", "the second group"}, joined_names(i.chains.b));
    describe(i.areas, visit);
}

}  // namespace meniscus

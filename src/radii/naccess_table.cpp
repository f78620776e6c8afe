// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Set `naccess`: the radii of NACCESS, after C. Chothia, "The nature of the accessible and buried surfaces in
// proteins", J. Mol. Biol. 105, 1-12 (1976); nucleic acids and atom types as in naccess.config of FreeSASA 2.1.2
// (whose "SER SE" is read as SEC SE).
#include <array>

#include "radii/tables.h"

namespace meniscus {
namespace {

constexpr auto kNaccessTable = std::to_array<RadiusRule>({
    // clang-format off
    // CA@C: not calcium
    {"*", "C", 1.76},
    {"*", "O,OXT,OP1,OP2,OP3,O5',O4',O3',O2'", 1.40},
    {"*", "CA@C,CB@C", 1.87},
    {"*", "N", 1.65},
    {"*", "P", 1.90},
    {"*", "C5',C4',C3',C2',C1'", 1.80},
    {"ARG", "CG,CD", 1.87},
    {"ARG", "NE,NH1,NH2", 1.65},
    {"ARG", "CZ", 1.76},
    {"ASN", "CG", 1.76},
    {"ASN", "OD1", 1.40},
    {"ASN", "ND2", 1.65},
    {"ASP", "CG", 1.76},
    {"ASP", "OD1,OD2", 1.40},
    {"CYS", "SG", 1.85},
    {"GLN", "CG", 1.87},
    {"GLN", "CD", 1.76},
    {"GLN", "OE1", 1.40},
    {"GLN", "NE2", 1.65},
    {"GLU", "CG", 1.87},
    {"GLU", "CD", 1.76},
    {"GLU", "OE1,OE2", 1.40},
    {"HIS", "CG,CD2,CE1", 1.76},
    {"HIS", "ND1,NE2", 1.65},
    {"ILE", "CG1,CG2,CD1", 1.87},
    {"LEU", "CG,CD1,CD2", 1.87},
    {"LYS", "CG,CD,CE", 1.87},
    {"LYS", "NZ", 1.50},
    {"MET", "CG,CE", 1.87},
    {"MET", "SD", 1.85},
    {"PHE", "CG,CD1,CD2,CE1,CE2,CZ", 1.76},
    {"PRO", "CG,CD", 1.87},
    {"SEC,MSE", "SE", 1.80},
    {"SER", "OG", 1.40},
    {"THR", "OG1", 1.40},
    {"THR", "CG2", 1.87},
    {"TRP", "CG,CD1,CD2,CE2,CE3,CZ2,CZ3,CH2", 1.76},
    {"TRP", "NE1", 1.65},
    {"TYR", "CG,CD1,CD2,CE1,CE2,CZ", 1.76},
    {"TYR", "OH", 1.40},
    {"VAL", "CG1,CG2", 1.87},
    {"A,DA", "N9,N7,N6,N1,N3", 1.60},
    {"A,DA", "C8,C5,C6,C2,C4", 1.80},
    {"C,DC", "N1,N3,N4", 1.60},
    {"C,DC", "C2,C4,C5,C6", 1.80},
    {"C,DC", "O2", 1.40},
    {"G,DG", "N9,N7,N1,N2,N3", 1.60},
    {"G,DG", "C8,C5,C6,C2,C4", 1.80},
    {"G,DG", "O6", 1.40},
    {"I,DI", "N9,N7,N1,N3", 1.60},
    {"I,DI", "C8,C5,C6,C2,C4", 1.80},
    {"I,DI", "O6", 1.40},
    {"T,DT", "N1,N3", 1.60},
    {"T,DT", "C2,C4,C5,C7,C6", 1.80},
    {"T,DT", "O2,O4", 1.40},
    {"U,DU", "N1,N3", 1.60},
    {"U,DU", "C2,C4,C5,C6", 1.80},
    {"U,DU", "O2,O4", 1.40},
    // clang-format on
});

}  // namespace

const std::span<const RadiusRule> kNaccessRules = kNaccessTable;

}  // namespace meniscus

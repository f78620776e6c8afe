// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A structure of three chains made in code: two that touch, a third far away, one atom buried.
#pragma once

#include "meniscus/structure.h"

namespace meniscus::testing {

inline void add_atom(Structure& s, const Vec3& centre, double radius, std::uint32_t residue, const char* name) {
    s.atoms.centres.push_back(centre);
    s.atoms.radii.push_back(radius);
    s.labels.push_back({.residue = residue,
                        .name = name,
                        .element = "C",
                        .altloc = ' ',
                        .serial = static_cast<int>(s.labels.size()) + 1});
}

/// Chain A: ALA 1 (two atoms), MSE 2B (an atom, and a small one inside it); chain B: GLY 1; chain LONG: HIE 7, away.
inline Structure small_complex() {
    Structure s;
    s.file = "small.pdb";
    s.name = "small";
    s.residues = {{.chain = "A", .name = "ALA", .number = 1, .insertion_code = ' '},
                  {.chain = "A", .name = "MSE", .number = 2, .insertion_code = 'B'},
                  {.chain = "B", .name = "GLY", .number = 1, .insertion_code = ' '},
                  {.chain = "LONG", .name = "HIE", .number = 7, .insertion_code = ' '}};
    add_atom(s, {0.0, 0.0, 0.0}, 1.7, 0, "CA");
    add_atom(s, {1.5, 0.2, 0.0}, 1.8, 0, "CB");
    add_atom(s, {3.0, 0.0, 0.3}, 1.6, 1, "SE");
    add_atom(s, {3.1, 0.0, 0.3}, 0.5, 1, "H");
    add_atom(s, {3.0, 4.0, 0.0}, 1.7, 2, "CA");
    add_atom(s, {30.0, 0.0, 0.0}, 2.0, 3, "NE2");
    return s;
}

}  // namespace meniscus::testing

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Structures made in code, for tests.
#pragma once

#include "meniscus/structure.h"

namespace meniscus::testing {

/// Two atoms: one with everything set, one with defaults.
inline Structure two_atoms() {
    Structure s;
    s.name = "two";
    s.atoms.centres = {{1.5, -2.25, 0.1}, {1000.001, 0.0, -3.0}};
    s.atoms.radii = {1.7, 1.52};
    s.residues = {{.chain = "A", .name = "GLY", .number = -3, .insertion_code = 'B'},
                  {.chain = "A-2", .name = "HOH", .number = 101, .insertion_code = ' '}};
    s.labels = {{.residue = 0,
                 .name = "CA",
                 .element = "C",
                 .altloc = 'A',
                 .serial = 17,
                 .b_factor = 12.5,
                 .occupancy = 0.5,
                 .charge = -0.25},
                {.residue = 1, .name = "O5'", .element = "", .altloc = ' ', .serial = 18}};
    return s;
}

}  // namespace meniscus::testing

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Arrangements of spheres as rapidcheck makes them: of whole numbers, so that a failing one shrinks to few and round
// ones.
#pragma once

#include <rapidcheck/Gen.h>

#include <iosfwd>
#include <utility>

#include "support/arrangements.h"

namespace meniscus::testing {

/// As code that can be pasted into a test: every digit.
std::ostream& operator<<(std::ostream& out, const Arrangement& arrangement);

/// Of all kinds, 1 to some 75 spheres, with a probe that is mostly 1.4 Å, else from 0 to 10 Å.
rc::Gen<Arrangement> any_arrangement();

/// And a grid spacing from 0.25 to 2.5 Å, half of them at most 0.5 Å.
rc::Gen<std::pair<Arrangement, double>> arrangements_with_spacings();

/// A closed wall of spheres round a void that the probe of 1.4 Å fits into, perhaps with a ball in the middle that
/// touches nothing; walls and void are thick against the spacing.
struct Vessel {
    Atoms atoms;
    bool island = false;
    double spacing = 0.5;
};
std::ostream& operator<<(std::ostream& out, const Vessel& vessel);
rc::Gen<Vessel> any_vessel();

}  // namespace meniscus::testing

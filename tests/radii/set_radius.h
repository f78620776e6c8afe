// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Looks a radius up in a built-in set, for the tests of the tables.
#pragma once

#include <gtest/gtest.h>

#include "radii/radius_set.h"

namespace meniscus::test {

/// The radius, or -1 if the set knows no such atom.
inline double radius_in(std::string_view set, const AtomType& type) {
    return RadiusTyper(find_radius_set(set).value()).find(type).value_or(-1.0);
}

}  // namespace meniscus::test

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What must be true of every surface, whatever the atoms are: each check says what is wrong, or nothing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/accessible_surface.h"
#include "meniscus/measures.h"
#include "meniscus/surface.h"

namespace meniscus::testing {

/// Closed, oriented, manifold; every number finite; no triangle without area; labels that exist; the checks of the
/// program itself, but for those that a grid coarser than the atoms cannot pass.
std::string what_is_wrong_with_mesh(const Surface& surface, std::size_t atoms);

/// Every vertex on the exact surface (Method::Direct) or within a spacing of it (Method::Flow): no false inner layer;
/// and facing the solvent there.
std::string what_is_wrong_with_places(const Surface& surface, const AccessibleSurface& exact);

/// Volume and area against those of the exact bodies parallel to the molecule at distances up to `reach` spacings: the
/// volume between that of the inner and that of the outer one, the area between the least and the largest area of
/// all, with `slack` times the exact area to spare (docs/design/torture.md).
std::string what_is_wrong_with_size(const Surface& surface, const Atoms& atoms, double reach, double slack);

/// Points whose side is asked for.
struct SignCount {
    std::size_t asked = 0;      ///< farther than a tenth of a spacing from the exact surface
    std::size_t wrong = 0;      ///< of these
    std::size_t far_wrong = 0;  ///< farther than a spacing
    std::string first_far;      ///< where that is
};
SignCount& operator+=(SignCount& sum, const SignCount& more);

/// Asks the level set at random points, most of them near the surface, which side they are on.
SignCount count_signs(const Surface& surface, const Atoms& atoms, const AccessibleSurface& exact, std::size_t points);

/// The same with the winding number of the mesh. cost: points · triangles
SignCount count_windings(const Surface& surface, const Atoms& atoms, const AccessibleSurface& exact,
                         std::size_t points);

}  // namespace meniscus::testing

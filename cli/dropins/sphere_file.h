// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The input of MSMS and NanoShaper: spheres, whatever the file is called, with names that are handed through untouched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "meniscus/atoms.h"

namespace meniscus::dropins {

struct SphereFile {
    Atoms atoms;                     ///< every sphere of the file; radii may be 0
    std::vector<std::string> names;  ///< of all of them, or none
    std::size_t collision_only = 0;  ///< whose flag is 0

    /// The spheres of positive radius, which have a surface, and their places in the file.
    Atoms solid() const;
    std::vector<std::uint32_t> solid_places() const;
};

/// Reads "x y z radius [flag] [name]" per line; blank lines and those that begin with # are passed over, words behind
/// the name, too.
///
/// throws   InputError "FILE:LINE:COLUMN: ..." for what is no finite number, a negative radius, no sphere of positive
///          radius
SphereFile read_sphere_file(const std::string& path);

/// Without the spheres of exactly this radius: MSMS takes 1.2 for hydrogens. What follows moves up.
SphereFile without_radius(const SphereFile& spheres, double radius);

}  // namespace meniscus::dropins

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The file of parameters that NanoShaper reads.
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace meniscus::dropins {

struct NanoShaperRequest {
    double grid_scale = 2.0;  ///< cells per Å
    double probe = 1.4;       ///< Å
    std::string input = "temp.xyzr";
    std::string root;  ///< what names of files begin with, folder included
    bool triangulated = true;
    bool msms_format = false;   ///< .vert and .face instead of .off
    bool with_normals = false;  ///< in .off
    bool with_atoms = false;    ///< in .off; .vert always has them
    bool fill_cavities = false;
    double fill_below = 11.4;  ///< Å³
    int threads = 0;           ///< 0: all cores
    std::vector<std::string> warnings;
};

/// Reads lines "Key = value"; # begins a comment.
///
/// Keys that steer NanoShaper's own way of computing are passed over. Keys that are unknown, and outputs that are not
/// written here, are warned of.
/// path     for messages
/// throws   InputError "FILE:LINE:COLUMN: ..." for values that cannot be read, and for surfaces and modes other
///          than the solvent-excluded surface (skin, blobby, pockets)
NanoShaperRequest read_nanoshaper(std::istream& stream, const std::string& path);

}  // namespace meniscus::dropins

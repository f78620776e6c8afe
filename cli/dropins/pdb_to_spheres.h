// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The programs that make spheres of PDB files.
#pragma once

#include <string>

namespace meniscus::dropins {

/// The programs pdb_to_xyzr and pdb_to_xyzrn: [-h] [FILE ...], standard input without a file.
int run_pdb_to_spheres(const std::string& name, bool with_names, int argc, char** argv);

}  // namespace meniscus::dropins

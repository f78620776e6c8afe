// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The program `pdb_to_xyzrn`.
#include "dropins/pdb_to_spheres.h"

int main(int argc, char** argv) { return meniscus::dropins::run_pdb_to_spheres("pdb_to_xyzrn", true, argc, argv); }

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which files this process runs: to start the program again, and to find what lies beside it.
#pragma once

#include <string>

namespace meniscus {

/// The path of the running program; empty if the system does not tell.
std::string program_file();

/// The path of the program or library that holds this function or constant, as the loader knows it; empty if it knows
/// none.
std::string file_that_holds(const void* code);

}  // namespace meniscus

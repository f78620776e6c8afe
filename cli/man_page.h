// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Manual pages, in the language of troff's package man.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace meniscus::cli {

/// The page of the program, or that of a subcommand, with every option in full.
///
/// subcommand   its name, or empty
/// throws       UsageError for a name that is none
std::string man_page(const CLI::App& program, const std::string& subcommand);

}  // namespace meniscus::cli

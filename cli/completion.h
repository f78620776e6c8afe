// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What makes a shell complete the command line: scripts for bash and zsh.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace meniscus::cli {

/// A script that completes subcommands, options and their words, and else names of files.
///
/// shell    bash or zsh
/// throws   UsageError for another one
std::string completion_script(const CLI::App& program, const std::string& shell);

}  // namespace meniscus::cli

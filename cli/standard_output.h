// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Outputs that go to standard output: `-o -` and `--format`.
#pragma once

#include <string>
#include <vector>

#include "common_request.h"

namespace meniscus::cli {

/// Puts in the place of the output "-" the path under which writers know standard output and its format
/// ("/dev/stdout.ply"). --format alone asks for "-o -".
///
/// as_text   formats that can be binary or text will be text
/// throws    UsageError for two outputs to standard output, a format that is missing or has nothing to apply to,
/// several
///           structures, files that come in pairs, and bytes for a terminal
void resolve_standard_output(CommonRequest& request, bool as_text = false);

/// Whether one of these goes to standard output, which the summary then must not.
bool use_standard_output(const std::vector<std::string>& outputs);

/// Prints the summary where it belongs: to standard output, or beside an output that goes there to standard error.
void print_summary(const CommonRequest& request, const std::string& text);

/// How messages and the summary call an output: its path, or "standard output".
std::string output_label(const std::string& path);

/// What on the command line asks for an output: "-o a.ply", or "--format ply" for standard output.
std::string spell_output(const std::string& path);

}  // namespace meniscus::cli

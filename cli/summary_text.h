// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the summaries of all subcommands say in the same words.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "output_plan.h"
#include "report.h"

namespace meniscus::cli {

/// "  label       text", ended.
std::string summary_line(const char* label, const std::string& text);

/// "1 atom", "2 atoms".
std::string counted(std::size_t n, const char* one, const char* many);

/// "3892.2387 ± 8.1e-07 Å²", the number right-aligned.
std::string exact_value(double value, double error, const char* unit, int width = 0);

/// "radii united", "radii of the file".
std::string describe_radii(const std::string& set);

/// "1 HEP, 2 PO4": the ligands that were left out, on one line.
std::string list_ligands(const Structure& structure);

/// Which checks the result has passed and which it has not, as a line; empty if there are none.
std::string describe_checks(std::span<const Check> checks);

/// "exact_agreement (patches of atom 3 by 0.1 Å², ...)", or empty if the evaluations agree.
std::string disputed_patches(bool agreed, std::span<const std::string> disputed);

/// Time, threads and memory, as a line.
std::string describe_run(const RunFacts& facts);

/// The names of the files written, as a line; empty if there are none.
std::string describe_files(const std::vector<Output>& written);

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "summary_text.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "meniscus/list_of_counts.h"
#include "messages.h"
#include "standard_output.h"

namespace meniscus::cli {

std::string summary_line(const char* label, const std::string& text) {
    return fmt::format("  {:<11} {}\n", label, text);
}

std::string counted(std::size_t n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string exact_value(double value, double error, const char* unit, int width) {
    return fmt::format("{:>{}.4f} ± {:<7.1e} {}", value, width, error, unit);
}

std::string describe_radii(const std::string& set) {
    return set == "file" ? "radii of the file" : "radii " + one_line(set);
}

std::string list_ligands(const Structure& structure) { return one_line(list_of_counts(structure.left_out_ligands)); }

std::string describe_checks(std::span<const Check> checks) {
    std::string failed;
    std::string passed;
    for (const Check& check : checks) {
        std::string& list = check.passed ? passed : failed;
        list.append(list.empty() ? "" : ", ").append(check.name);
    }
    if (checks.empty()) return "";
    if (failed.empty()) return summary_line("checks", "passed: " + passed);
    return summary_line("checks", "FAILED: " + failed + (passed.empty() ? "" : "; passed: " + passed));
}

std::string disputed_patches(bool agreed, std::span<const std::string> disputed) {
    if (agreed) return "";
    return fmt::format("exact_agreement ({})", fmt::join(disputed, "; "));
}

std::string describe_run(const RunFacts& facts) {
    return summary_line("time", fmt::format("{:.2f} s on {}, {:.0f} MB", facts.seconds.total,
                                            counted(static_cast<std::size_t>(facts.threads), "thread", "threads"),
                                            facts.peak_memory_mb));
}

std::string describe_files(const std::vector<Output>& written) {
    std::string list;
    for (const Output& output : written)
        for (const std::string& file : files_of(output.path))
            list.append(list.empty() ? "" : ", ").append(one_line(output_label(file)));
    return list.empty() ? "" : summary_line("written", list);
}

}  // namespace meniscus::cli

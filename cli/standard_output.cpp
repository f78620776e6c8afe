// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "standard_output.h"

#include <fmt/core.h>
#include <unistd.h>

#include <CLI/StringTools.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "meniscus/errors.h"
#include "platform/files/atomic_file.h"
#include "report.h"

namespace meniscus::cli {

namespace {

constexpr std::array kUnreadableFormats{"glb", "vtp", "npz", "png", "mrc", "html"};
constexpr std::array kEitherFormats{"ply", "stl"};

template <class List>
bool holds(const List& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

bool is_asked_for(const std::string& path) { return path == "-" || path == "/dev/stdout"; }

/// "ply" for "PLY" and ".ply".
std::string plain_format(const std::string& text) {
    const std::string lower = CLI::detail::to_lower(text);
    return lower.starts_with('.') ? lower.substr(1) : lower;
}

void check_format(const std::string& format) {
    if (format == "vert")
        throw UsageError("--format vert: an MSMS surface is a pair of files; name them with -o FILE.vert");
    if (format == "vdb") throw UsageError("--format vdb: is written to files only; name one with -o FILE.vdb");
}

void check_terminal(const std::string& format, bool as_text) {
    const bool is_text = !holds(kUnreadableFormats, format) && (as_text || !holds(kEitherFormats, format));
    if (is_text || ::isatty(STDOUT_FILENO) == 0) return;
    throw UsageError(fmt::format(
        "-o -: standard output is a terminal, which cannot show {0}; redirect it with > FILE.{0}, or write -o FILE.{0}",
        format));
}

void check_alone(const CommonRequest& request) {
    if (std::count_if(request.outputs.begin(), request.outputs.end(), is_asked_for) > 1)
        throw UsageError("-o -: two outputs would go to standard output; name files for the others");
    if (request.report == "-")
        throw UsageError("-o - and --report -: both would go to standard output; name a file for one of them");
    if (request.all_models)
        throw UsageError("-o -: --model all has an output for every model; name files with -o FILE.SUFFIX");
    if (request.per_chain)
        throw UsageError("-o -: --per-chain has an output for every chain; name files with -o FILE.SUFFIX");
}

}  // namespace

void resolve_standard_output(CommonRequest& request, bool as_text) {
    std::vector<std::string>& outputs = request.outputs;
    if (outputs.empty() && !request.format.empty()) outputs = {"-"};
    const auto place = std::find_if(outputs.begin(), outputs.end(), is_asked_for);
    if (place == outputs.end()) {
        if (request.format.empty()) return;
        throw UsageError("--format: applies to standard output, -o -; the suffix of a file is its format");
    }
    check_alone(request);
    if (request.format.empty())
        throw UsageError(
            "-o -: standard output has no suffix that tells the format; add --format, a suffix without its point");
    const std::string format = plain_format(request.format);
    check_format(format);
    *place = standard_output_as(format);
    check_terminal(format, as_text);
}

bool use_standard_output(const std::vector<std::string>& outputs) {
    return std::any_of(outputs.begin(), outputs.end(), is_standard_output);
}

void print_summary(const CommonRequest& request, const std::string& text) {
    if (request.quiet || request.report == "-") return;
    if (use_standard_output(request.outputs))
        std::cerr << text << std::flush;
    else
        print(text);
}

std::string output_label(const std::string& path) { return is_standard_output(path) ? "standard output" : path; }

std::string spell_output(const std::string& path) {
    if (!is_standard_output(path)) return "-o " + path;
    const std::string suffix = std::filesystem::path(path).extension().string();
    return "--format " + (suffix.empty() ? suffix : suffix.substr(1));
}

}  // namespace meniscus::cli

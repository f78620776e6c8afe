// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "parse_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "common_request.h"

namespace meniscus::cli {

void parse_options(const std::vector<std::string>& words, const std::function<void(CLI::App&)>& add) {
    CLI::App command;
    add(command);
    std::vector<std::string> arguments = join_negative_values(words);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    command.parse(arguments);
}

}  // namespace meniscus::cli

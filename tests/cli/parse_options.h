// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Words of a command line, parsed with some of the options.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace meniscus::cli {

/// Parses what follows a command's name, as the program does, with the options that `add` gives the command.
void parse_options(const std::vector<std::string>& words, const std::function<void(CLI::App&)>& add);

/// The request that the options of `add` make of these words.
template <class Request>
Request request_of(const std::vector<std::string>& words, void (*add)(CLI::App&, Request&)) {
    Request request;
    parse_options(words, [&](CLI::App& command) { add(command, request); });
    return request;
}

}  // namespace meniscus::cli

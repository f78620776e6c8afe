// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the programs that stand in for others have in common: how they end and what they say on standard error.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "meniscus/surface.h"

namespace meniscus::dropins {

/// Outputs are written, but the surface failed its own checks.
struct ChecksFailed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// throws   ChecksFailed naming those that have not passed
void require_passed(const Surface& surface);

/// Runs the body of a program and turns what it throws into one line on standard error and an exit code: 0 done, 2 to 6
/// as those of `meniscus`, 1 anything else.
/// name   of the program, for the message
int run_guarded(const std::string& name, int argc, char** argv,
                const std::function<void(const std::vector<std::string>&)>& body);

/// "NAME: warning: TEXT" on standard error.
void warn(const std::string& name, const std::string& text);

/// To standard output.
/// throws   OutputError if it cannot be written
void print(const std::string& text);

}  // namespace meniscus::dropins

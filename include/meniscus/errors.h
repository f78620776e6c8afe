// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Exceptions for errors in the caller's input; numerical outcomes are part of results instead.
//
// The command line maps these to exit codes in one place (cli/main.cpp): UsageError 2, InputError 3,
// OutputError 4, LimitError 5.
#pragma once

#include <stdexcept>

namespace meniscus {

/// An option or argument that makes no sense (unknown name, value out of range).
struct UsageError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// A file that cannot be read or whose content is not valid.
/// The message already has the form "FILE:LINE:COLUMN: what is wrong; what to do".
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file that cannot be written; nothing half-written is left behind.
struct OutputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A computation that would exceed memory or index limits; the message names the option to change.
struct LimitError : std::length_error {
    using std::length_error::length_error;
};

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Progress on standard error: a bar that rewrites itself, or one line of JSON per update.
#pragma once

#include <chrono>
#include <ostream>
#include <string>
#include <string_view>

namespace meniscus::cli {

enum class ProgressMode {
    Auto,  ///< a bar if standard error is a terminal, else nothing
    On,
    Off,
    Json,
};

/// Auto becomes On or Off; the other modes stay.
ProgressMode resolve(ProgressMode mode, bool quiet);

/// Shows how far a computation is. The bar disappears when the reporter does.
class ProgressReport {
public:
    ProgressReport(ProgressMode mode, std::ostream& out);
    ~ProgressReport();
    ProgressReport(const ProgressReport&) = delete;
    ProgressReport& operator=(const ProgressReport&) = delete;

    bool is_on() const { return mode_ == ProgressMode::On || mode_ == ProgressMode::Json; }

    /// How long all stages are expected to take together, s: shown from now on.
    void expect(double seconds) { expected_ = seconds; }

    /// Shows a stage's fraction, 0 to 1. Repeats of the same stage and whole percent are left out.
    void update(std::string_view stage, double fraction);

    /// Takes the bar off the screen, so that a message can be printed.
    void clear();

private:
    void draw(int percent);
    void print_json(double fraction);

    ProgressMode mode_;
    std::ostream& out_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::string stage_;
    int percent_ = -1;
    double expected_ = 0.0;  // s; 0 where nothing is known
    bool drawn_ = false;
};

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How far a batch is, in one line on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ostream>

#include "progress_report.h"

namespace meniscus::cli::batch {

/// Inputs of a batch, and what they take.
struct Amount {
    std::size_t inputs = 0;
    std::uint64_t weight = 0;  ///< see Task
};

/// Shows inputs done and failed, their rate, and the time left, which goes by the sizes of the inputs. The line
/// disappears when the reporter does.
class Progress {
public:
    /// all   that is to be done
    Progress(ProgressMode mode, std::ostream& out, const Amount& all);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void count(bool succeeded, std::uint64_t weight);

    /// Shows the line again, at most twice a second.
    void show();
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    ProgressMode mode_;
    std::ostream& out_;
    Amount all_;
    Amount done_;
    std::size_t failed_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_{};
    bool drawn_ = false;
};

}  // namespace meniscus::cli::batch

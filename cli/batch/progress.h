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

/// Shows inputs done and failed, their rate, and the time left, which goes by the sizes of the inputs. The line
/// disappears when the reporter does.
class Progress {
public:
    /// inputs, weight   of all that is to be done
    Progress(ProgressMode mode, std::ostream& out, std::size_t inputs, std::uint64_t weight);
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
    std::size_t inputs_;
    std::uint64_t weight_;
    std::size_t done_ = 0;
    std::size_t failed_ = 0;
    std::uint64_t done_weight_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_{};
    bool drawn_ = false;
};

}  // namespace meniscus::cli::batch

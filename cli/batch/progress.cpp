// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/progress.h"

#include <fmt/core.h>

#include <string>

namespace meniscus::cli::batch {

namespace {

/// "48 s", "12 min", "3.1 h"
std::string duration(double seconds) {
    if (seconds < 120.0) return fmt::format("{:.0f} s", seconds);
    if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
    return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

Progress::Progress(ProgressMode mode, std::ostream& out, const Amount& all) : mode_(mode), out_(out), all_(all) {}

Progress::~Progress() { clear(); }

void Progress::count(bool succeeded, std::uint64_t weight) {
    ++done_.inputs;
    done_.weight += weight;
    failed_ += succeeded ? 0 : 1;
}

void Progress::show() {
    const Clock::time_point now = Clock::now();
    if (mode_ == ProgressMode::Off || now - shown_ < std::chrono::milliseconds(500)) return;
    shown_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double rate = static_cast<double>(done_.inputs) / seconds;
    const double left = done_.weight == 0
                            ? 0.0
                            : seconds * (static_cast<double>(all_.weight) / static_cast<double>(done_.weight) - 1.0);
    if (mode_ == ProgressMode::Json) {
        out_ << fmt::format(
                    "{{\"done\": {}, \"failed\": {}, \"inputs\": {}, \"time_s\": {:.3f}, \"left_s\": {:.3f}}}\n",
                    done_.inputs, failed_, all_.inputs, seconds, left)
             << std::flush;
        return;
    }
    out_ << fmt::format("\r{} of {} done, {} failed", done_.inputs, all_.inputs, failed_);
    if (done_.inputs > 0) out_ << fmt::format(", {:.3g} per second, {} left", rate, duration(left));
    out_ << "\033[K" << std::flush;
    drawn_ = true;
}

void Progress::clear() {
    if (!drawn_) return;
    out_ << "\r\033[K" << std::flush;
    drawn_ = false;
}

}  // namespace meniscus::cli::batch

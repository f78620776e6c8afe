// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "progress_report.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace meniscus::cli {

namespace {

constexpr int kBarWidth = 40;

/// True where a line can be rewritten.
bool is_terminal() {
    const char* kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

}  // namespace

ProgressMode resolve(ProgressMode mode, bool quiet) {
    if (mode != ProgressMode::Auto) return mode;
    return is_terminal() && !quiet ? ProgressMode::On : ProgressMode::Off;
}

ProgressReport::ProgressReport(ProgressMode mode, std::ostream& out) : mode_(mode), out_(out) {}

ProgressReport::~ProgressReport() { clear(); }

void ProgressReport::update(std::string_view stage, double fraction) {
    if (!is_on()) return;
    const double part = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
    const int percent = static_cast<int>(100.0 * part);
    if (stage == stage_ && percent == percent_) return;
    stage_ = stage;
    percent_ = percent;
    if (mode_ == ProgressMode::Json) {
        print_json(part);
    } else {
        draw(percent);
    }
    out_.flush();
}

void ProgressReport::draw(int percent) {
    const int full = percent * kBarWidth / 100;
    out_ << fmt::format("\r{:<9} [{:<{}}] {:3} %", stage_, std::string(static_cast<std::size_t>(full), '#'), kBarWidth,
                        percent);
    if (expected_ >= 1.0) out_ << fmt::format(", about {:.0f} s in all", expected_);
    drawn_ = true;
}

void ProgressReport::print_json(double fraction) {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start_;
    const std::string expected = expected_ > 0.0 ? fmt::format(", \"expected_s\": {:.3f}", expected_) : "";
    out_ << fmt::format("{{\"stage\": \"{}\", \"fraction\": {:.4f}, \"time_s\": {:.3f}{}}}\n", stage_, fraction,
                        time.count(), expected);
}

void ProgressReport::clear() {
    if (!drawn_) return;
    out_ << "\r\033[K" << std::flush;
    drawn_ = false;
    percent_ = -1;
}

}  // namespace meniscus::cli

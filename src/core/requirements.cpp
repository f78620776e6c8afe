// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/requirements.h"

#include <cmath>

#include "core/number_text.h"
#include "meniscus/errors.h"

namespace meniscus {

void require(bool holds, std::string_view option, double value, std::string_view wanted) {
    if (!holds) throw UsageError(joined(option, " ", in_short(value), ": must be ", wanted));
}

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

void require_positive(std::string_view option, double value) {
    require(is_positive(value), option, value, "finite and positive");
}

void require_not_negative(std::string_view option, double value) {
    require(std::isfinite(value) && value >= 0.0, option, value, "finite and not negative");
}

void check_threads(int threads) { require(threads >= 0, "threads", threads, "0 (all cores) or more"); }

}  // namespace meniscus

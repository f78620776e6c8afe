// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/memory_limit.h"

#include "platform/memory.h"

namespace meniscus {

double limit_mb(std::size_t memory_limit_mb) {
    return memory_limit_mb > 0 ? static_cast<double>(memory_limit_mb)
                               : static_cast<double>(available_memory()) / kMegabyte;
}

}  // namespace meniscus

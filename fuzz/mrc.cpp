// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Volumes as .mrc.
#include "fuzzed_volume.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
    static const meniscus::fuzz::FuzzedFile file("a.mrc");
    return meniscus::fuzz::run_volume(file, data, size);
}

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// GROMACS files.
#include "fuzzed_structure.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const meniscus::fuzz::FuzzedFile file("a.gro");
    meniscus::fuzz::read_in_every_way(file, meniscus::fuzz::text_of(data, size));
    return 0;
}

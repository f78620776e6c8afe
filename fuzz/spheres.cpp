// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The same bytes as PQR, xyzr and xyzrn files.
#include <array>

#include "fuzzed_structure.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using meniscus::fuzz::FuzzedFile;
    static const std::array<FuzzedFile, 3> files{FuzzedFile("a.pqr"), FuzzedFile("a.xyzr"), FuzzedFile("a.xyzrn")};
    for (const FuzzedFile& file : files) meniscus::fuzz::read_in_every_way(file, meniscus::fuzz::text_of(data, size));
    return 0;
}

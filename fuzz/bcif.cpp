// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// BinaryCIF files: MessagePack, encodings, and what they hold as mmCIF.
#include "fuzzed_structure.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const meniscus::fuzz::FuzzedFile file("a.bcif");
    meniscus::fuzz::read_in_every_way(file, meniscus::fuzz::text_of(data, size));
    return 0;
}

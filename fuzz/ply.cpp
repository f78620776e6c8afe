// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Meshes as .ply.
#include "fuzzed_mesh.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const meniscus::fuzz::FuzzedFile file("a.ply");
    return meniscus::fuzz::run_mesh(file, data, size);
}

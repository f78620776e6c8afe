// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Meshes as .ply.
#include "fuzzed_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
    static const meniscus::fuzz::FuzzedFile file("a.ply");
    return meniscus::fuzz::run_mesh(file, data, size);
}

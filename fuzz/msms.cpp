// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Meshes as pairs of .vert and .face files: the bytes up to the first zero, and those behind it.
#include <algorithm>

#include "fuzzed_mesh.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace meniscus::fuzz;
    static const FuzzedFile vertices("a.vert");
    static const FuzzedFile faces("a.face");
    const std::string_view bytes = text_of(data, size);
    const std::size_t end = std::min(bytes.find('\0'), size);
    vertices.write(bytes.substr(0, end));
    faces.write(end < size ? bytes.substr(end + 1) : std::string_view());
    read_mesh_or_refuse(vertices.path(), vertices.path().substr(0, vertices.path().size() - 4));
    return 0;
}

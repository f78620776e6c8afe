// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where the reference data are, and how to read sphere files without the program's own reader.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "meniscus/atoms.h"

namespace meniscus::testing {

/// The folder named by MENISCUS_TEST_DATA, if it is set and exists.
inline std::optional<std::filesystem::path> test_data() {
    const char* folder = std::getenv("MENISCUS_TEST_DATA");
    if (folder == nullptr || !std::filesystem::is_directory(folder)) return std::nullopt;
    return std::filesystem::path(folder);
}

/// Skips the running test, and says so, where the reference data are absent.
#define MENISCUS_NEED_TEST_DATA() \
    if (!meniscus::testing::test_data()) GTEST_SKIP() << "set MENISCUS_TEST_DATA to the folder of reference data"

/// "x y z r" per line.
inline Atoms read_spheres(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot open " + path.string());
    Atoms atoms;
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        Vec3 centre;
        double radius = 0.0;
        if (!(fields >> centre.x >> centre.y >> centre.z >> radius)) continue;
        atoms.centres.push_back(centre);
        atoms.radii.push_back(radius);
    }
    return atoms;
}

}  // namespace meniscus::testing

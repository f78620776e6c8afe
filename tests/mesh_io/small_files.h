// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Mesh files made in tests, and what reading them says.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "meniscus/errors.h"
#include "meniscus/read_mesh.h"
#include "support/scratch_folder.h"

namespace meniscus::testing {

/// The mesh in a file with this name and content.
inline Mesh mesh_of(const std::string& content, const std::string& name) {
    const ScratchFolder folder;
    write_file(folder / name, content);
    return read_mesh(folder / name);
}

/// What is wrong with such a file, from its name on; empty if nothing is.
inline std::string mesh_error_of(const std::string& content, const std::string& name) {
    const ScratchFolder folder;
    write_file(folder / name, content);
    try {
        read_mesh(folder / name);
    } catch (const InputError& error) {
        const std::string text = error.what();
        const std::string path = folder / name;
        EXPECT_TRUE(text.starts_with(path)) << text;
        return text.substr(std::min(text.size(), path.size() - name.size()));
    }
    return "";
}

inline void expect_error(const std::string& content, const std::string& name, const std::string& part) {
    EXPECT_NE(mesh_error_of(content, name).find(part), std::string::npos)
        << mesh_error_of(content, name) << "\nlacks " << part;
}

/// The bytes of numbers, one after the other, last byte first if `turned`.
template <class T>
std::string bytes_of(const std::vector<T>& numbers, bool turned = false) {
    std::string bytes;
    for (const T& number : numbers) {
        std::string one(reinterpret_cast<const char*>(&number), sizeof number);
        if (turned) one.assign(one.rbegin(), one.rend());
        bytes += one;
    }
    return bytes;
}

/// A square in the plane z = 0 as two triangles round its first corner.
inline const std::vector<Vec3> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
inline const std::vector<Triangle> kSquareFan{{0, 1, 2}, {0, 2, 3}};

inline void expect_square(const Mesh& mesh) {
    EXPECT_EQ(mesh.vertices, kSquare);
    EXPECT_EQ(mesh.triangles, kSquareFan);
}

}  // namespace meniscus::testing

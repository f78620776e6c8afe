// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "io/precision.h"
#include "meniscus/errors.h"
#include "meniscus/version.h"

namespace meniscus {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are written as the numbers are in memory");

// A facet's normal and corners.
std::array<Vec3, 4> facet_of(const Mesh& mesh, const Triangle& triangle) {
    const Vec3& a = mesh.vertices[triangle[0]];
    const Vec3& b = mesh.vertices[triangle[1]];
    const Vec3& c = mesh.vertices[triangle[2]];
    const Vec3 normal = cross(b - a, c - a);
    return {squared_norm(normal) > 0.0 ? normalised(normal) : Vec3{}, a, b, c};
}

constexpr std::size_t kFacetSize = 50;  // bytes

void write_binary(AtomicFile& file, const Mesh& mesh) {
    if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
        throw LimitError("STL cannot hold more than 2^32 - 1 triangles; choose a larger spacing or write PLY");
    std::array<char, 80> header{};  // must not begin with "solid"
    const std::string text = std::string("meniscus ") + kVersion + ", lengths in angstrom";
    std::copy(text.begin(), text.end(), header.begin());
    file.reserve(sizeof header + sizeof(std::uint32_t) + mesh.triangles.size() * kFacetSize);
    file.bytes(header);
    file.bytes(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const Triangle& t : mesh.triangles) {
        for (const Vec3& p : facet_of(mesh, t))
            file.bytes(std::array{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        file.bytes(std::uint16_t{0});
    }
}

void write_text(AtomicFile& file, const Mesh& mesh) {
    const Precision precision = precision_needed(mesh);
    file.write("solid meniscus\n");
    for (const Triangle& t : mesh.triangles) {
        const auto facet = facet_of(mesh, t);
        file.write("facet normal ");
        write_point(file, facet[0], Precision::Single);
        file.write("\nouter loop\n");
        for (std::size_t i = 1; i < facet.size(); ++i) {
            file.write("vertex ");
            write_point(file, facet[i], precision);
            file.write('\n');
        }
        file.write("endloop\nendfacet\n");
    }
    file.write("endsolid meniscus\n");
}

}  // namespace

void write_stl(AtomicFile& file, const Mesh& mesh, Encoding encoding) {
    if (encoding == Encoding::Binary)
        write_binary(file, mesh);
    else
        write_text(file, mesh);
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/stl_reader.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh/merge_vertices.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFacetSize = 50;

void add_triangle(Mesh& mesh, const std::array<Vec3, 3>& corners) {
    const auto first = static_cast<VertexId>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
}

float coordinate(BinaryCursor& cursor) {
    const auto value = cursor.take<float>("a coordinate");
    if (!std::isfinite(value)) cursor.fail("the coordinate before it is not a finite number; write the file again");
    return value;
}

Mesh read_binary(const MeshFile& file) {
    BinaryCursor cursor(file.path, file.bytes, kHeaderSize);
    const std::uint64_t facets = cursor.take<std::uint32_t>("the number of triangles");
    if (cursor.bytes_left() != facets * kFacetSize)
        cursor.fail("the header says " + std::to_string(facets) + " triangles, but " +
                    std::to_string(cursor.bytes_left()) + " bytes follow instead of " +
                    std::to_string(facets * kFacetSize) + "; fetch or write the file again");
    check_vertex_count(file.path, 3 * facets);
    Mesh mesh;
    for (std::uint64_t f = 0; f < facets; ++f) {
        cursor.skip(3 * sizeof(float), "a normal");
        std::array<Vec3, 3> corners;
        for (Vec3& p : corners) {
            p.x = double{coordinate(cursor)};
            p.y = double{coordinate(cursor)};
            p.z = double{coordinate(cursor)};
        }
        cursor.skip(sizeof(std::uint16_t), "a triangle");
        add_triangle(mesh, corners);
    }
    return mesh;
}

void expect(TextCursor& cursor, const char* word) {
    const std::string_view found = cursor.word(word);
    if (found != word) cursor.fail(shown(found) + " where " + word + " should be; correct it");
}

void read_facet(TextCursor& cursor, Mesh& mesh) {
    expect(cursor, "normal");
    for (int i = 0; i < 3; ++i) cursor.word("a normal");  // nobody needs it, and it may be nan
    expect(cursor, "outer");
    expect(cursor, "loop");
    std::array<Vec3, 3> corners;
    for (Vec3& p : corners) {
        expect(cursor, "vertex");
        p = cursor.point();
    }
    expect(cursor, "endloop");
    expect(cursor, "endfacet");
    check_vertex_count(cursor.file(), mesh.vertices.size() + 3);
    add_triangle(mesh, corners);
}

// Solids one after the other, each with a name that may be missing.
Mesh read_text(const MeshFile& file) {
    TextCursor cursor(file.path, file.bytes);
    Mesh mesh;
    for (std::string_view word = cursor.next(); !word.empty(); word = cursor.next()) {
        if (word != "solid") cursor.fail(shown(word) + " where solid should be; correct it");
        cursor.skip_line();
        for (word = cursor.word("endsolid"); word == "facet"; word = cursor.word("endsolid")) read_facet(cursor, mesh);
        if (word != "endsolid") cursor.fail(shown(word) + " where facet or endsolid should be; correct it");
        cursor.skip_line();
    }
    return mesh;
}

// Binary files may begin with "solid", too, but then have the size that their header says.
bool is_binary(const std::string& bytes) {
    if (!bytes.starts_with("solid")) return true;
    if (bytes.size() < kHeaderSize + sizeof(std::uint32_t)) return false;
    std::uint32_t facets = 0;
    std::memcpy(&facets, bytes.data() + kHeaderSize, sizeof facets);
    return bytes.size() == kHeaderSize + sizeof facets + std::uint64_t{facets} * kFacetSize;
}

}  // namespace

Mesh read_stl(const MeshFile& file) {
    Mesh mesh = is_binary(file.bytes) ? read_binary(file) : read_text(file);
    merge_vertices(mesh);
    return mesh;
}

}  // namespace meniscus::reading

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/off_reader.h"

#include <string>
#include <string_view>
#include <vector>

#include "reading/text.h"

namespace meniscus::reading {
namespace {

// "OFF" with the letters before it that say what vertices have beside a position.
void check_keyword(TextCursor& cursor) {
    std::string_view keyword = cursor.word("OFF");
    for (const std::string_view letters : {"ST", "C", "N"})
        if (keyword.starts_with(letters)) keyword.remove_prefix(letters.size());
    if (keyword != "OFF")
        cursor.fail("the file does not begin with OFF, COFF or NOFF; give it the suffix of its format");
}

// A number of things that take up so many bytes each at least.
std::size_t plausible_count(TextCursor& cursor, const char* what, std::size_t bytes_each) {
    const std::uint64_t count = cursor.count(what);
    if (count > cursor.bytes_left() / bytes_each + 1)
        cursor.fail(std::string(what) + ": " + std::to_string(count) + " do not fit into this file; is it cut off?");
    return count;
}

}  // namespace

Mesh read_off(const MeshFile& file) {
    TextCursor cursor(file.path, file.bytes);
    check_keyword(cursor);
    Mesh mesh;
    mesh.vertices.resize(plausible_count(cursor, "the number of vertices", sizeof("0 0 0")));
    check_vertex_count(file.path, mesh.vertices.size());
    const std::size_t faces = plausible_count(cursor, "the number of faces", sizeof("1 0"));
    mesh.triangles.reserve(faces);
    cursor.skip_line();  // the number of edges, which may be missing
    for (Vec3& vertex : mesh.vertices) {
        vertex = cursor.point();
        cursor.skip_line();
    }
    std::vector<VertexId> corners;
    for (std::size_t f = 0; f < faces; ++f) {
        corners.resize(plausible_count(cursor, "the corners of a face", sizeof("0")));
        for (VertexId& corner : corners) corner = cursor.corner(mesh.vertices.size());
        if (corners.size() < 3) cursor.fail("a face with fewer than three corners; leave it out");
        add_polygon(mesh, corners);
        cursor.skip_line();
    }
    if (const std::string_view more = cursor.next(); !more.empty())
        cursor.fail(shown(more) + " after the last face; correct the numbers in the header");
    return mesh;
}

}  // namespace meniscus::reading

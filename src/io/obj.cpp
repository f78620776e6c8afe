// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/obj.h"

#include <cstdint>
#include <span>
#include <string>

#include "io/open_mark.h"
#include "io/precision.h"
#include "meniscus/version.h"

namespace meniscus {
namespace {

template <class T>
void write_points(AtomicFile& file, std::string_view keyword, const std::vector<T>& points, Precision precision) {
    for (const T& p : points) {
        file.write(keyword);
        write_point(file, p, precision);
        file.write('\n');
    }
}

void write_corner(AtomicFile& file, VertexId vertex, bool with_normal) {
    const std::uint64_t number = std::uint64_t{vertex} + 1;
    file.write(' ');
    file.number(number);
    if (!with_normal) return;
    file.write("//");
    file.number(number);
}

}  // namespace

void write_obj(AtomicFile& file, const Mesh& mesh, bool open) {
    file.write(std::string("# meniscus ") + kVersion + "\n# lengths in angstrom\n");
    if (open) file.write(std::string("# ") + kOpenMark + '\n');
    write_points(file, "v ", mesh.vertices, precision_needed(mesh));
    write_points(file, "vn ", mesh.normals, Precision::Single);
    for (const Triangle& t : mesh.triangles) {
        file.write('f');
        for (const VertexId v : t) write_corner(file, v, !mesh.normals.empty());
        file.write('\n');
    }
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/off.h"

#include <string>

#include "io/open_mark.h"
#include "io/precision.h"
#include "meniscus/version.h"

namespace meniscus {

void write_off(AtomicFile& file, const Mesh& mesh, bool open) {
    const Precision precision = precision_needed(mesh);
    file.write("OFF\n# meniscus " + std::string(kVersion) + ", lengths in angstrom\n");
    if (open) file.write(std::string("# ") + kOpenMark + '\n');
    file.write(std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.triangles.size()) + " 0\n");
    for (const Vec3& p : mesh.vertices) {
        write_point(file, p, precision);
        file.write('\n');
    }
    for (const Triangle& t : mesh.triangles) {
        file.write('3');
        for (const VertexId v : t) {
            file.write(' ');
            file.number(std::uint64_t{v});
        }
        file.write('\n');
    }
}

}  // namespace meniscus

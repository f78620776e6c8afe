// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "io/labels.h"
#include "io/sphere_names.h"
#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "platform/files/atomic_file.h"
#include "reading/lower_case.h"

namespace meniscus {

void write_spheres(const std::string& path, const Structure& structure) {
    const bool with_names = lower_case(path).ends_with(".xyzrn");
    if (!with_names && !lower_case(path).ends_with(".xyzr"))
        throw UsageError(path + ": unknown suffix for spheres; choose .xyzr or .xyzrn");
    check_labels(structure);
    AtomicFile file(path);
    for (std::size_t i = 0; i < structure.atoms.size(); ++i) {
        const Vec3& centre = structure.atoms.centres[i];
        for (const double value : {centre.x, centre.y, centre.z}) {
            file.number(value);
            file.write(' ');
        }
        file.number(structure.atoms.radii[i]);
        if (with_names) file.write(" 1 " + sphere_name(structure, i));
        file.write('\n');
    }
    file.commit();
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Spheres for the programs in the place of MSMS and NanoShaper.
#include <cmath>

#include "dropins/sphere_file.h"
#include "fuzzed_file.h"

namespace {

using namespace meniscus;

void require_sound(const dropins::SphereFile& spheres) {
    const Atoms& atoms = spheres.atoms;
    fuzz::require(atoms.radii.size() == atoms.centres.size(), "a radius for each sphere");
    fuzz::require(spheres.names.empty() || spheres.names.size() == atoms.size(), "a name for each sphere, or none");
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const auto& [x, y, z] = atoms.centres[i];
        fuzz::require(std::isfinite(x) && std::isfinite(y) && std::isfinite(z), "coordinates are finite");
        fuzz::require(std::isfinite(atoms.radii[i]) && atoms.radii[i] >= 0.0, "radii are not negative");
    }
    fuzz::require(!spheres.solid().radii.empty(), "one sphere is solid");
    fuzz::require(dropins::without_radius(spheres, atoms.radii.front()).atoms.size() < atoms.size(),
                  "spheres of a radius are left out");
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::FuzzedFile file("a.xyzrn");
    file.write(fuzz::text_of(data, size));
    fuzz::read_or_refuse(file.path(), [] { require_sound(dropins::read_sphere_file(file.path())); });
    return 0;
}

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzzed_structure.h"

#include <algorithm>
#include <cmath>

namespace meniscus::fuzz {
namespace {

constexpr std::string_view kSmall =
    "ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00 10.00           N  \n"
    "ATOM      2  CA AALA A   1       1.450   0.000   0.000  0.60 11.00           C  \n"
    "ATOM      3  CA BALA A   1       1.450   0.200   0.000  0.40 12.00           C  \n"
    "ATOM      4  C   GLY A   1A      2.000   1.400   0.000  1.00 13.00           C  \n"
    "ATOM      5  O   GLY A   1A      1.300   2.400   0.000  1.00 14.00           O  \n"
    "ATOM      6  SG  CYS B  -5       5.000   0.000   3.000  1.00 15.00           S  \n"
    "ATOM      7  P    DA B  10       8.000   1.000   3.000  1.00 16.00           P  \n"
    "HETATM    8 ZN    ZN B  20       9.000   4.000   1.000  1.00 17.00          ZN  \n"
    "HETATM    9  O   HOH B  21       4.000   9.000   1.000  1.00 18.00           O  \n"
    "END\n";

bool is_finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

void read_once(const FuzzedFile& file, const ReadOptions& options) {
    // A radius set is refused for files that have radii.
    use_or_refuse([&] { read_or_refuse(file.path(), [&] { require_sound(read_structure(file.path(), options)); }); });
}

}  // namespace

void require_sound(const Structure& structure) {
    const Atoms& atoms = structure.atoms;
    require(!atoms.centres.empty() && atoms.radii.size() == atoms.centres.size(), "a radius for each of some atoms");
    require(std::all_of(atoms.centres.begin(), atoms.centres.end(), is_finite), "coordinates are finite");
    require(std::all_of(atoms.radii.begin(), atoms.radii.end(), [](double r) { return std::isfinite(r) && r > 0.0; }),
            "radii are positive");
    require(structure.labels.size() == atoms.centres.size(), "a label for each atom");
    for (const AtomLabel& label : structure.labels)
        require(label.residue < structure.residues.size(), "an atom's residue exists");
    for (const std::string& note : structure.notes) require_clear(note);
    for (const std::string& warning : structure.warnings) require_clear(warning);
}

void read_in_every_way(const FuzzedFile& file, std::string_view bytes) {
    file.write(bytes);
    const bool is_sound = read_or_refuse(file.path(), [&] { require_sound(read_structure(file.path())); });
    if (!is_sound) return;
    read_once(file, {.hydrogens = HydrogenPolicy::Keep, .hetero = HeteroPolicy::All, .keep_waters = true});
    read_once(file, {.hetero = HeteroPolicy::None, .keep_waters = false});
    read_once(file, {.radii = "united", .assembly = "1", .altloc = "B"});
    read_once(file, {.join_models = true});
    read_or_refuse(file.path(), [&] {
        for (const Structure& model : read_all_models(file.path())) require_sound(model);
    });
}

std::string_view small_file() { return kSmall; }

}  // namespace meniscus::fuzz

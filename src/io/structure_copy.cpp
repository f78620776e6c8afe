// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>
#include <vector>

#include "io/gemmi/gemmi_writer.h"
#include "io/labels.h"
#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "platform/files/atomic_file.h"
#include "reading/lower_case.h"

namespace meniscus {
namespace {

// Hybrid-36: decimal, then letters. http://cci.lbl.gov/hybrid_36/
constexpr std::size_t kMostAtoms = 99999U + std::size_t{2} * 26 * 36 * 36 * 36 * 36;
constexpr int kLowestResidueNumber = -999;
constexpr int kHighestResidueNumber = 9999 + 2 * 26 * 36 * 36 * 36;

void require(bool fits, const std::string& path, const std::string& what) {
    if (!fits) throw OutputError(path + ": " + what + " does not fit into the PDB format; write .cif instead");
}

// The numbers that %8.3f and %6.2f print in 8 and 6 columns.
bool fits_coordinate(double x) { return x > -999.9995 && x < 9999.9995 - 1e-6; }
bool fits_value(double v) { return v > -99.995 && v < 999.995 - 1e-5; }

void check_atom(const std::string& path, const Structure& structure, std::size_t i, double value) {
    const AtomLabel& label = structure.labels[i];
    const Vec3& centre = structure.atoms.centres[i];
    require(label.name.size() <= 4, path, "the atom name '" + label.name + "'");
    require(fits_coordinate(centre.x) && fits_coordinate(centre.y) && fits_coordinate(centre.z), path,
            "a coordinate of atom " + std::to_string(i));
    require(fits_value(value), path, "the value of atom " + std::to_string(i) + ", " + std::to_string(value));
}

void check_residue(const std::string& path, const Residue& residue) {
    require(residue.chain.size() <= 1, path, "the chain name '" + residue.chain + "'");
    require(residue.name.size() <= 3, path, "the residue name '" + residue.name + "'");
    require(residue.number >= kLowestResidueNumber && residue.number <= kHighestResidueNumber, path,
            "the residue number " + std::to_string(residue.number));
}

void check_pdb(const std::string& path, const Structure& structure, std::span<const double> values) {
    require(structure.atoms.size() <= kMostAtoms, path,
            "a structure of " + std::to_string(structure.atoms.size()) + " atoms");
    for (const Residue& residue : structure.residues) check_residue(path, residue);
    for (std::size_t i = 0; i < values.size(); ++i) check_atom(path, structure, i, values[i]);
}

}  // namespace

void write_structure_copy(const std::string& path, const Structure& structure, std::span<const double> values) {
    const bool pdb = lower_case(path).ends_with(".pdb");
    if (!pdb && !lower_case(path).ends_with(".cif"))
        throw UsageError(path + ": unknown suffix for a structure; choose .pdb or .cif");
    check_labels(structure);
    if (values.size() != structure.atoms.size()) throw UsageError(path + ": one value per atom is needed");
    if (pdb) check_pdb(path, structure, values);
    const std::vector<double> copied(values.begin(), values.end());
    AtomicFile file(path);
    file.write(pdb ? pdb_text(structure, copied) : mmcif_text(structure, copied));
    file.commit();
}

}  // namespace meniscus

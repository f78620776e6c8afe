// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "io/atomic_file.h"
#include "io/csv.h"
#include "io/labels.h"
#include "meniscus/write.h"

namespace meniscus {
namespace {

// One-letter fields are empty where there is nothing to tell.
std::string letter_of(char c) { return c == ' ' || c == '\0' ? "" : csv_field({&c, 1}); }

void write_row(AtomicFile& file, const Structure& structure, std::size_t i) {
    const AtomLabel& label = structure.labels[i];
    const Residue& residue = residue_of(structure, i);
    const Vec3& centre = structure.atoms.centres[i];
    file.write(std::to_string(i) + ',' + csv_field(residue.chain) + ',' + csv_field(residue.name) + ',' +
               std::to_string(residue.number) + ',' + letter_of(residue.insertion_code) + ',' + csv_field(label.name) +
               ',' + csv_field(label.element) + ',' + letter_of(label.altloc) + ',' + std::to_string(label.serial));
    for (const double value :
         {centre.x, centre.y, centre.z, structure.atoms.radii[i], label.b_factor, label.occupancy, label.charge}) {
        file.write(',');
        file.number(value);
    }
    file.write('\n');
}

}  // namespace

void write_atom_table(const std::string& path, const Structure& structure) {
    check_labels(structure);
    AtomicFile file(path);
    file.write("index,chain,resname,resnum,icode,name,element,altloc,serial,x,y,z,radius,b_factor,occupancy,charge\n");
    for (std::size_t i = 0; i < structure.atoms.size(); ++i) write_row(file, structure, i);
    file.commit();
}

}  // namespace meniscus

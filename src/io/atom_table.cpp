// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>
#include <string_view>

#include "io/atomic_file.h"
#include "io/csv.h"
#include "io/labels.h"
#include "meniscus/write.h"

namespace meniscus {
namespace {

void write_field(AtomicFile& file, std::string_view text) {
    file.write(',');
    write_csv_field(file, text);
}

void write_number_field(AtomicFile& file, std::int64_t number) {
    file.write(',');
    file.number(number);
}

// One-letter fields are empty where there is nothing to tell.
void write_letter(AtomicFile& file, char c) { write_field(file, c == ' ' || c == '\0' ? "" : std::string_view(&c, 1)); }

void write_row(AtomicFile& file, const Structure& structure, std::size_t i) {
    const AtomLabel& label = structure.labels[i];
    const Residue& residue = residue_of(structure, i);
    const Vec3& centre = structure.atoms.centres[i];
    file.number(i);
    write_field(file, residue.chain);
    write_field(file, residue.name);
    write_number_field(file, residue.number);
    write_letter(file, residue.insertion_code);
    write_field(file, label.name);
    write_field(file, label.element);
    write_letter(file, label.altloc);
    write_number_field(file, label.serial);
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

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/parallel.h"
#include "io/csv.h"
#include "io/labels.h"
#include "io/text_buffer.h"
#include "meniscus/write.h"
#include "platform/files/atomic_file.h"

namespace meniscus {
namespace {

void write_field(TextBuffer& row, std::string_view field) {
    row.write(',');
    write_csv_field(row, field);
}

void write_number_field(TextBuffer& row, std::int64_t number) {
    row.write(',');
    row.number(number);
}

// One-letter fields are empty where there is nothing to tell.
void write_letter(TextBuffer& row, char c) { write_field(row, c == ' ' || c == '\0' ? "" : std::string_view(&c, 1)); }

void write_row(TextBuffer& row, const Structure& structure, std::size_t i) {
    const AtomLabel& label = structure.labels[i];
    const Residue& residue = residue_of(structure, i);
    const Vec3& centre = structure.atoms.centres[i];
    row.number(i);
    write_field(row, residue.chain);
    write_field(row, residue.name);
    write_number_field(row, residue.number);
    write_letter(row, residue.insertion_code);
    write_field(row, label.name);
    write_field(row, label.element);
    write_letter(row, label.altloc);
    write_number_field(row, label.serial);
    for (const double value :
         {centre.x, centre.y, centre.z, structure.atoms.radii[i], label.b_factor, label.occupancy, label.charge}) {
        row.write(',');
        row.number(value);
    }
    row.write('\n');
}

}  // namespace

void write_atom_table(const std::string& path, const Structure& structure) {
    constexpr std::size_t kRowsPerTask = 512;
    constexpr std::size_t kTasks = 16;  // texts that are held at once
    check_labels(structure);
    AtomicFile file(path);
    file.write("index,chain,resname,resnum,icode,name,element,altloc,serial,x,y,z,radius,b_factor,occupancy,charge\n");
    std::array<TextBuffer, kTasks> texts;
    const std::size_t rows = structure.atoms.size();
    for (std::size_t first = 0; first < rows; first += kTasks * kRowsPerTask) {
        const std::size_t some = std::min(rows - first, kTasks * kRowsPerTask);
        parallel_chunks(some, kRowsPerTask, [&](std::size_t begin, std::size_t end) {
            TextBuffer& text = texts[begin / kRowsPerTask];
            for (std::size_t i = begin; i < end; ++i) write_row(text, structure, first + i);
        });
        for (TextBuffer& text : texts) {
            file.write(text.text());
            text.clear();
        }
    }
    file.commit();
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Tables of values for atoms, residues and chains.
#include "fuzzed_structure.h"
#include "meniscus/vertex_values.h"

namespace {

using namespace meniscus;

void read(const std::string& path, const Structure& structure) {
    const ValueTable table = read_value_table(path, structure);
    fuzz::require(table.strange_rows <= table.rows, "strange rows are rows");
    for (const AtomValues& column : table.columns) {
        fuzz::require(is_value_name(column.name), "a column's name can be one of an array");
        fuzz::require(column.of_atom.size() == structure.atoms.centres.size(), "a value for each atom");
    }
    refuse_strange_table(table, path, structure);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::FuzzedFile file("a.csv");
    static const fuzz::FuzzedFile small("a.pdb", fuzz::small_file());
    static const Structure structure = read_structure(small.path(), {.hetero = HeteroPolicy::All});
    file.write(fuzz::text_of(data, size));
    fuzz::read_or_refuse(file.path(), [&] { read(file.path(), structure); });
    return 0;
}

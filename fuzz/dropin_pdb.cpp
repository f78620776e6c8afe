// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// PDB files for pdb_to_xyzr and pdb_to_xyzrn.
#include <cmath>
#include <sstream>

#include "dropins/pdb_spheres.h"
#include "fuzzed_file.h"
#include "meniscus/radii.h"

namespace {

using namespace meniscus;

void read(std::string_view bytes) {
    std::istringstream stream{std::string(bytes)};
    std::vector<AtomNames> names;
    for (const dropins::PdbRecord& record : dropins::read_pdb_records(stream, "a.pdb")) {
        fuzz::require(
            std::isfinite(record.centre.x) && std::isfinite(record.centre.y) && std::isfinite(record.centre.z),
            "coordinates are finite");
        fuzz::require(dropins::xyzrn_line(record, 1.5).ends_with('\n'), "a line for each record");
        names.push_back(record.names);
    }
    // There are elements without a radius.
    fuzz::use_or_refuse(
        [&] { fuzz::require(radii_of(names, "united").size() == names.size(), "a radius for each record"); });
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::read_or_refuse("a.pdb", [&] { read(fuzz::text_of(data, size)); });
    return 0;
}

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A user's own file of radius rules, and the radii that a structure gets from it.
#include "fuzzed_structure.h"
#include "radii/rule_file.h"

namespace {

using namespace meniscus;

void read(const fuzz::FuzzedFile& structure, const std::string& rules) {
    try {
        fuzz::require_sound(read_structure(structure.path(), {.radii = rules, .hetero = HeteroPolicy::All}));
    } catch (const InputError& error) {
        fuzz::require_clear(error.what());  // about the structure if the rules leave nothing of it
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::FuzzedFile rules("a.radii");
    static const fuzz::FuzzedFile structure("a.pdb", fuzz::small_file());
    rules.write(fuzz::text_of(data, size));
    if (fuzz::read_or_refuse(rules.path(), [&] { read_radius_rules(rules.path()); })) read(structure, rules.path());
    return 0;
}

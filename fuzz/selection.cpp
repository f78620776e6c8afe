// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Selections: of what is read, and by the names of what was.
#include "fuzzed_structure.h"

namespace {

using namespace meniscus;

template <class Select>
void select_or_refuse(const Select& select) {
    try {
        fuzz::use_or_refuse(select);
    } catch (const InputError& error) {
        fuzz::require_clear(error.what());  // nothing is left
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::FuzzedFile file("a.pdb", fuzz::small_file());
    static const Structure structure = read_structure(file.path());
    const std::string expression(fuzz::text_of(data, size));
    select_or_refuse([&] {
        const std::vector<bool> chosen = select_atoms(structure, expression);
        fuzz::require(chosen.size() == structure.atoms.centres.size(), "an answer for each atom");
    });
    if (!expression.empty())
        select_or_refuse([&] { fuzz::require_sound(read_structure(file.path(), {.select = expression})); });
    return 0;
}

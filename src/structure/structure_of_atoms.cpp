// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "meniscus/errors.h"
#include "meniscus/named_atoms.h"
#include "reading/numbers.h"
#include "structure/element.h"
#include "structure/make_structure.h"
#include "structure/residue_list.h"
#include "structure/simulated_atoms.h"

namespace meniscus {
namespace {

using namespace reading;

RawResidue residue_of_named(const NamedAtom& atom) {
    RawResidue residue;
    residue.chain = atom.chain;
    residue.name = upper_case(trimmed(atom.residue));
    residue.number = atom.residue_number;
    residue.insertion_code = atom.insertion_code;
    residue.in_sequence = atom.in_polymer;
    return residue;
}

void set_element(const NamedAtom& given, const std::string& residue, RawAtom& atom) {
    atom.element = element_symbol(given.element);
    atom.guessed_element = atom.element.empty();
    if (atom.guessed_element) atom.element = element_from_name(atom.name, residue);
}

RawAtom raw_atom(const NamedAtom& given, const std::string& residue) {
    RawAtom atom;
    atom.centre = given.centre;
    atom.name = upper_case(trimmed(given.name));
    set_element(given, residue, atom);
    atom.altloc = given.altloc;
    atom.hetatm = given.is_hetero.value_or(!is_standard_name(residue));
    atom.serial = given.serial;
    atom.occupancy = given.occupancy;
    atom.b_factor = given.b_factor;
    atom.charge = given.charge;
    atom.radius = given.radius.value_or(0.0);
    return atom;
}

bool is_virtual_site(const NamedAtom& atom) {
    return atom.element == "VS" ||
           (element_symbol(atom.element).empty() &&
            is_site_of_water(upper_case(trimmed(atom.name)), upper_case(trimmed(atom.residue))));
}

// A model of the atoms, and the place of each of them among those given.
struct NamedModel {
    RawModel model;
    std::vector<std::size_t> indices;
};

NamedModel model_of(std::span<const NamedAtom> atoms) {
    NamedModel named;
    ResidueList residues(named.model.residues);
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        if (is_virtual_site(atoms[i])) continue;
        const std::uint32_t residue = residues.index_of(residue_of_named(atoms[i]));
        named.model.atoms.push_back(raw_atom(atoms[i], named.model.residues[residue].name));
        named.model.atoms.back().residue = residue;
        named.indices.push_back(i);
    }
    return named;
}

void tell_what_is_not_known(std::span<const NamedAtom> atoms, const std::string& source, NamedModel& named) {
    RawModel& model = named.model;
    tell_virtual_sites(atoms.size() - named.indices.size(), model);
    const auto by_name = [](const NamedAtom& atom) { return !atom.is_hetero; };
    if (std::any_of(atoms.begin(), atoms.end(), by_name)) tell_hetero_by_name(source + " does", model);
    model.why_guessed = source + " does not know the elements";
    model.has_radii = !atoms.empty() && std::all_of(atoms.begin(), atoms.end(),
                                                    [](const NamedAtom& atom) { return atom.radius.has_value(); });
}

}  // namespace

StructureOfAtoms structure_of_atoms(std::span<const NamedAtom> atoms, const std::string& source,
                                    const ReadOptions& options) {
    check_options(options);
    NamedModel named = model_of(atoms);
    if (named.indices.empty()) throw InputError(source + ": no atoms; choose some");
    tell_what_is_not_known(atoms, source, named);
    complete_model(named.model);
    InputFile file;
    file.path = source;
    MadeStructure made = make_structure(file, named.model, options);
    made.structure.file.clear();
    StructureOfAtoms result{std::move(made.structure), {}};
    for (const std::uint32_t atom : made.atoms) result.indices.push_back(named.indices[atom]);
    return result;
}

}  // namespace meniscus

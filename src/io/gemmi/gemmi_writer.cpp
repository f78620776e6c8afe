// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/gemmi/gemmi_writer.h"

// Debian's gemmi leaves out the printing library that it bundles; nothing here prints through it but numbers.
#define USE_STD_SNPRINTF
#define GEMMI_WRITE_IMPLEMENTATION
// gemmi is not written for our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <gemmi/to_cif.hpp>
#include <gemmi/to_mmcif.hpp>
#include <gemmi/to_pdb.hpp>
#pragma GCC diagnostic pop

#include <cmath>
#include <sstream>

#include "io/labels.h"

namespace meniscus {
namespace {

gemmi::Residue to_residue(const Residue& residue) {
    gemmi::Residue result;
    result.name = residue.name.empty() ? "UNK" : residue.name;
    result.seqid.num = residue.number;
    result.seqid.icode = residue.insertion_code;
    result.het_flag = gemmi::find_tabulated_residue(residue.name).is_standard() ? 'A' : 'H';
    return result;
}

gemmi::Atom to_atom(const Structure& structure, std::size_t i, double value) {
    const AtomLabel& label = structure.labels[i];
    const Vec3& centre = structure.atoms.centres[i];
    gemmi::Atom atom;
    atom.name = label.name.empty() ? "X" : label.name;
    atom.element = gemmi::Element(label.element);
    atom.altloc = label.altloc == ' ' ? '\0' : label.altloc;
    atom.serial = label.serial;
    atom.pos = gemmi::Position(centre.x, centre.y, centre.z);
    atom.occ = static_cast<float>(label.occupancy);
    atom.b_iso = static_cast<float>(value);
    // Formal charges; the partial charges of a PQR file are none.
    if (label.charge == std::round(label.charge) && std::abs(label.charge) < 10.0)
        atom.charge = static_cast<signed char>(label.charge);
    return atom;
}

// Chains and residues in file order: a new one starts where the name or the residue changes.
gemmi::Structure to_gemmi(const Structure& structure, const std::vector<double>& values) {
    gemmi::Structure result;
    result.name = structure.name.empty() ? "meniscus" : structure.name;
    result.models.emplace_back("1");
    gemmi::Model& model = result.models.back();
    const Residue* last = nullptr;
    for (std::size_t i = 0; i < structure.atoms.size(); ++i) {
        const Residue& residue = residue_of(structure, i);
        if (last == nullptr || residue.chain != last->chain) model.chains.emplace_back(residue.chain);
        if (last != &residue) model.chains.back().residues.push_back(to_residue(residue));
        model.chains.back().residues.back().atoms.push_back(to_atom(structure, i, values[i]));
        last = &residue;
    }
    return result;
}

}  // namespace

std::string pdb_text(const Structure& structure, const std::vector<double>& values) {
    gemmi::Structure copy = to_gemmi(structure, values);
    gemmi::PdbWriteOptions options;
    options.ter_ignores_type = true;
    options.numbered_ter = false;
    std::ostringstream text;
    gemmi::write_minimal_pdb(copy, text, options);
    text << "END" << std::string(77, ' ') << '\n';
    return text.str();
}

std::string mmcif_text(const Structure& structure, const std::vector<double>& values) {
    gemmi::Structure copy = to_gemmi(structure, values);
    gemmi::MmcifOutputGroups groups(false);
    groups.block_name = true;
    groups.entry = true;
    groups.atoms = true;
    groups.group_pdb = true;
    gemmi::cif::Document document = gemmi::make_mmcif_document(copy, groups);
    std::ostringstream text;
    gemmi::cif::write_cif_to_stream(text, document, gemmi::cif::Style::Aligned);
    return text.str();
}

}  // namespace meniscus

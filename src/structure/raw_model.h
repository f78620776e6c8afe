// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a file says, before anything is chosen or left out: the one form that all readers produce.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meniscus/vec3.h"

namespace meniscus::reading {

/// What a residue is to the defaults of reading; set by classify_residues (residue_kinds.h).
enum class ResidueKind {
    Polymer,  ///< ATOM record, or linked to or listed with a polymer
    Ligand,   ///< hetero group of two or more atoms
    Ion,      ///< hetero group of one atom
    Water,    ///< by name, whatever the record
};

/// A residue as a run of atoms of the file with the same name, number and chain.
struct RawResidue {
    std::string chain;        ///< author name
    std::string label_chain;  ///< mmCIF label name; empty in other formats
    std::string segment;      ///< columns 73-76 of a PDB file; the same for all residues of a site (join_residues.h)
    std::string name;         ///< upper case
    int number = 0;
    char insertion_code = ' ';
    bool in_sequence = false;  ///< the file's entities or SEQRES records name it as part of a polymer
    ResidueKind kind = ResidueKind::Polymer;
};

struct RawAtom {
    Vec3 centre;
    std::uint32_t residue = 0;  ///< index into RawModel::residues
    std::string name;           ///< upper case
    std::string element;        ///< upper case; empty if the file and the name do not tell
    char altloc = ' ';
    bool hetatm = false;
    bool guessed_element = false;  ///< the name tells it, where the file could have told it itself, or all but tells it
    int serial = 0;
    double occupancy = 1.0;
    double b_factor = 0.0;
    double charge = 0.0;
    double radius = 0.0;  ///< of formats that give radii
};

/// A rotation and a translation: row by row, 3 x 4.
struct RawOperator {
    std::array<double, 12> rows{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    Vec3 apply(const Vec3& p) const {
        const auto coordinate = [&](std::size_t i) {
            return rows[i] * p.x + rows[i + 1] * p.y + rows[i + 2] * p.z + rows[i + 3];
        };
        return {coordinate(0), coordinate(4), coordinate(8)};
    }
    bool operator==(const RawOperator&) const = default;
};

/// Some chains, each copied by every operator.
struct RawGenerator {
    std::vector<std::string> chains;
    bool label_names = false;  ///< chains are mmCIF label names
    std::vector<RawOperator> operators;
};

struct RawAssembly {
    std::string name;
    std::vector<RawGenerator> generators;
};

/// One model of a file, atoms in file order.
struct RawModel {
    std::vector<RawAtom> atoms;
    std::vector<RawResidue> residues;
    std::vector<RawAssembly> assemblies;
    int model_count = 1;                ///< models in the file
    bool has_names = true;              ///< false for bare spheres
    bool has_radii = false;             ///< PQR, xyzr: radii are the file's own; see choose_atoms()
    std::string why_guessed = {};       ///< why elements are guessed, if not for the usual reason
    std::string left_out = {};          ///< what other models have, with the way to take it
    std::vector<std::string> notes;     ///< see Structure::notes
    std::vector<std::string> warnings;  ///< see Structure::warnings

    const RawResidue& residue_of(const RawAtom& atom) const { return residues[atom.residue]; }
};

}  // namespace meniscus::reading

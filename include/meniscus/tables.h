// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Measures per atom, residue, chain and cavity, with the names that a structure gives them.
//
// Areas are in Å², volumes in Å³, lengths in Å. What an atom's share of a patch is, and when something is buried, is
// said in docs/conventions.md. Every table of areas sums to the totals (to rounding).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "meniscus/flow.h"
#include "meniscus/interfaces.h"
#include "meniscus/measures.h"
#include "meniscus/structure.h"

namespace meniscus {

/// An atom, residue or chain whose solvent-accessible area is below this has none; Å². The perturbation that decides
/// degenerate arrangements can open gaps of 1e-8 Å² in a surface that is closed.
inline constexpr double kBuriedArea = 1e-6;

/// Sums over the atoms of a residue or chain.
struct GroupMeasure {
    std::size_t atoms = 0;
    double sas_area = 0.0;
    double contact_area = 0.0;
    double toroidal_area = 0.0;
    double reentrant_area = 0.0;
    double mean_depth = 0.0;  ///< of the atoms; 0 unless measured with depth
    double max_depth = 0.0;

    double ses_area() const { return contact_area + toroidal_area + reentrant_area; }
    bool buried() const { return sas_area < kBuriedArea; }
};

/// One entry per residue of the structure, in its order.
///
/// throws   UsageError where measures and structure differ in the number of atoms, here and below
/// cost     O(n)
std::vector<GroupMeasure> residue_measures(const Structure& structure, const Measures& measures);

/// Author names of the chains, each once, in the order of their first atom; of each atom, its chain's place among them.
struct Chains {
    std::vector<std::string> names;
    std::vector<std::uint32_t> of_atom;
};
Chains chains_of(const Structure& structure);

/// One entry per chain, in the order of chains_of().
std::vector<GroupMeasure> chain_measures(const Structure& structure, const Measures& measures);

/// SAS area of a residue relative to the largest that its kind can have in a chain Gly-X-Gly.
///
/// Nothing for residues other than the 20 amino acids (under any common name of their protonation states). May exceed
/// 1, at the ends of chains and for radii larger than those of the source.
/// source   Tien et al. 2013, PLoS ONE 8, e80635, theoretical maxima
std::optional<double> relative_accessibility(std::string_view residue_name, double sas_area);

/// What can be written in the place of the B factor.
enum class AtomValue {
    Sas,    ///< the atom's SAS area
    Ses,    ///< the atom's SES area
    Rsa,    ///< of the atom's residue; -1 where there is none
    Depth,  ///< the atom's depth; the measures must have been made with depth
};

/// One value per atom.
std::vector<double> atom_values(const Structure& structure, const Measures& measures, AtomValue value);

/// Two groups of chains and ligands: "A" is a chain by its author name, "(HEM)" all residues of that name, "(HEM,NAG)"
/// of several, and "A(HEM)" those in chain A. What one side names as a residue does not belong to a chain of the other.
struct ChainPair {
    std::vector<std::string> a;
    std::vector<std::string> b;
};

/// The names of a group as it is written: "A,(HEM,NAG)" is A and (HEM,NAG), and so is PyMOL's "chain A+C" A and C.
/// Names may be empty, as in "A,".
std::vector<std::string> split_group(const std::string& text);

/// The interface of two groups of chains and ligands.
struct ChainInterface {
    ChainPair chains;
    AtomGroup group_a;
    AtomGroup group_b;
    Interface areas;
};

/// Every pair of chains that touch (touching_groups), in the order of chains_of().
std::vector<ChainPair> touching_chains(const Structure& structure, double probe);

/// The interfaces of pairs of groups of chains and ligands.
///
/// spelling  of options in messages; nullptr: as members of ReadOptions
/// throws    UsageError for a chain or ligand that has no kept atom, with the option that keeps it, or is on both sides
/// of
///           a pair
/// cost      that of measure_interfaces()
std::vector<ChainInterface> chain_interfaces(const Structure& structure, std::span<const ChainPair> pairs,
                                             const MeasureOptions& options = {}, OptionSpelling spelling = nullptr);

/// An entry of a table: nothing, a truth value, a whole number, a number or a text.
using Cell = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// Rows of as many cells as there are columns.
struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows;
};

/// What a table has one row for.
enum class RowsPer { Atom, Residue, Chain, Cavity };

/// The measures of every atom, residue, chain or cavity, buried ones included; the columns are in docs/conventions.md.
/// throws   UsageError where measures and structure differ in the number of atoms
Table measures_table(const Structure& structure, const Measures& measures, RowsPer per);

/// The areas without and with the other side, of every atom, residue or chain of every interface.
/// throws   UsageError for RowsPer::Cavity
Table interface_table(const Structure& structure, std::span<const ChainInterface> interfaces, RowsPer per);

/// A row per step of a flow; the columns are the members of FlowStep.
Table history_table(std::span<const FlowStep> history);

/// "A:LEU12": chain, name, number and insertion code of a residue, as people write them; empty for one without name.
std::string residue_label(const Residue& residue);

/// The residues that line a component, in the structure's order: those with an atom that touches it.
std::vector<std::uint32_t> lining_residues(const Structure& structure, const SurfaceComponent& component);

}  // namespace meniscus

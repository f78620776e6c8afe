// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Measures per atom, residue, chain and cavity, with the names that a structure gives them.
//
// Areas are in Å², volumes in Å³, lengths in Å. docs/conventions.md says which share of a patch an atom has, and what
// is buried. The areas of every table sum to the totals, up to rounding.
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
#include "meniscus/mesh.h"
#include "meniscus/structure.h"

namespace meniscus {

/// An atom, residue or chain with less solvent-accessible area than this is buried, Å²: the perturbation that resolves
/// degenerate arrangements can open gaps of 1e-8 Å² in a closed surface.
inline constexpr double kBuriedArea = 1e-6;

/// Sums of areas, Å², over the atoms of a residue or chain, and depths of these atoms, Å.
struct GroupMeasure {
    std::size_t atoms = 0;
    double sas_area = 0.0;
    double contact_area = 0.0;
    double toroidal_area = 0.0;
    double reentrant_area = 0.0;
    double mean_depth = 0.0;  ///< 0 without MeasureOptions::depth
    double max_depth = 0.0;   ///< 0 without MeasureOptions::depth

    double ses_area() const { return contact_area + toroidal_area + reentrant_area; }
    bool buried() const { return sas_area < kBuriedArea; }
};

/// Sums the measures of every residue, in the order of Structure::residues; of all atoms if there are no residues.
///
/// throws   UsageError if measures and structure differ in the number of atoms
/// cost     O(n)
std::vector<GroupMeasure> residue_measures(const Structure& structure, const Measures& measures);

/// The chains of a structure, and which chain each atom belongs to.
struct Chains {
    std::vector<std::string> names;      ///< author names, each once, in the order of their first atoms
    std::vector<std::uint32_t> of_atom;  ///< index into `names` for every atom
};
Chains chains_of(const Structure& structure);

/// Sums the measures of every chain, in the order of chains_of().
/// throws   as residue_measures()
std::vector<GroupMeasure> chain_measures(const Structure& structure, const Measures& measures);

/// Relative solvent accessibility: the SAS area of a residue X, Å², divided by the largest possible in Gly-X-Gly.
///
/// Nothing for residues other than the 20 amino acids (under any common name of their protonation states). Can exceed 1
/// at the ends of chains, and with radii larger than those of the source.
///
/// source   Tien et al. 2013, PLoS ONE 8, e80635, theoretical maxima
std::optional<double> relative_accessibility(std::string_view residue_name, double sas_area);

/// Values of atoms, which can replace the B factors of a structure.
enum class AtomValue {
    Sas,    ///< SAS area of the atom, Å²
    Ses,    ///< SES area of the atom, Å²
    Rsa,    ///< relative_accessibility() of the atom's residue; -1 if there is none
    Depth,  ///< depth of the atom, Å; needs MeasureOptions::depth
};

/// One value per atom, in the order of the structure.
/// throws   as residue_measures()
std::vector<double> atom_values(const Structure& structure, const Measures& measures, AtomValue value);

/// Two groups of chains and ligands. "A" is the chain of that author name, "(HEM)" all residues of that name,
/// "(HEM,NAG)" of both names, "A(HEM)" those in chain A. Residues that one group names are not part of the other's
/// chains.
struct ChainPair {
    std::vector<std::string> a;
    std::vector<std::string> b;
};

/// Splits the text for a group into names: "A,(HEM,NAG)" into A and (HEM,NAG), PyMOL's "chain A+C" into A and C. Names
/// may be empty, as in "A,".
std::vector<std::string> split_group(const std::string& text);

/// Splits "A,C:B" at its colon into two groups, as split_group() splits these; nothing for a text without exactly one
/// colon, or with an empty name.
std::optional<ChainPair> split_pair(const std::string& text);

/// The interface of two groups of chains and ligands.
struct ChainInterface {
    ChainPair chains;
    AtomGroup group_a;  ///< atoms of chains.a, ascending
    AtomGroup group_b;  ///< atoms of chains.b, ascending
    Interface areas;
};

/// Every pair of chains that touch, as touching_groups() finds them, in the order of chains_of().
/// probe    probe radius, Å
std::vector<ChainPair> touching_chains(const Structure& structure, double probe);

/// Measures the interfaces of pairs of groups of chains and ligands, in the order of the pairs.
///
/// spelling  how messages name options; nullptr: as members of ReadOptions
/// throws    UsageError for a chain or ligand without kept atoms (the message names the option that keeps them), or on
///           both sides of a pair
/// cost      that of measure_interfaces()
std::vector<ChainInterface> chain_interfaces(const Structure& structure, std::span<const ChainPair> pairs,
                                             const MeasureOptions& options = {}, OptionSpelling spelling = nullptr);

/// A cell of a table: nothing, a truth value, a whole number, a number or a text.
using Cell = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// A table; every row has one cell per column.
struct Table {
    std::vector<std::string> columns;  ///< names
    std::vector<std::vector<Cell>> rows;
};

/// What each row of a table is about.
enum class RowsPer { Atom, Residue, Chain, Cavity };

/// The measures of every atom, residue, chain or cavity, also of what is buried. docs/conventions.md has the columns.
/// throws   as residue_measures()
Table measures_table(const Structure& structure, const Measures& measures, RowsPer per);

/// The areas of every atom, residue or chain of every interface, without and with the other side.
/// throws   UsageError for RowsPer::Cavity
Table interface_table(const Structure& structure, std::span<const ChainInterface> interfaces, RowsPer per);

/// A row per step of a flow; the columns are the members of FlowStep.
Table history_table(std::span<const FlowStep> history);

/// Chain, name, number and insertion code of a residue: "A:LEU12"; empty for a residue without a name.
std::string residue_label(const Residue& residue);

/// The same as reports of pockets have it: "A:LEU 12".
std::string spaced_label(const Residue& residue);

/// The residues that line a component: ascending indices of those with an atom that touches the component.
std::vector<std::uint32_t> lining_residues(const Structure& structure, const SurfaceComponent& component);

/// A cavity with the piece of a mesh that is its wall.
struct ListedCavity {
    double area = 0.0;            ///< Å²
    double volume = 0.0;          ///< Å³, positive
    Vec3 centre;                  ///< centroid of its wall, Å
    double radius = 0.0;          ///< of a ball around the centre that holds its wall, Å
    std::uint32_t component = 0;  ///< number of its wall in Mesh::components; kNone if the mesh has no such piece
    std::string lining{};  ///< labels of the residues around it, "A:LEU12, A:VAL30"; empty if taken from the mesh
};

/// The cavities of a surface by falling volume.
///
/// components  exact pieces of the surface; if there are none, cavities are those of the mesh, with plain sums over its
///             triangles
/// cost        O(vertices)
std::vector<ListedCavity> list_cavities(const Mesh& mesh, const Structure& structure,
                                        std::span<const SurfaceComponent> components = {});

}  // namespace meniscus

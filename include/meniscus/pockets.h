// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pockets: where a molecule leaves room for a ligand, with volumes and areas that add up to exact ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "meniscus/exact_surface.h"
#include "meniscus/mesh.h"
#include "meniscus/surface.h"
#include "meniscus/vec3.h"
#include "meniscus/volume.h"

namespace meniscus {

/// What an atom of a protein offers to a ligand, as the ranking of pockets tells atoms apart.
enum class AtomClass : std::uint8_t {
    BackboneCarbon,
    AliphaticCarbon,
    AromaticCarbon,
    PolarCarbon,  ///< a side chain's carbon that is bound to its polar atoms
    BackboneNitrogen,
    AmideNitrogen,     ///< and every other side chain's nitrogen not named below
    CationicNitrogen,  ///< of arginine and lysine
    HistidineNitrogen,
    BackboneOxygen,
    AmideOxygen,  ///< and every other side chain's oxygen not named below
    HydroxylOxygen,
    AnionicOxygen,  ///< of aspartate and glutamate
    Sulfur,         ///< and selenium
    Other,
};
inline constexpr std::size_t kAtomClasses = 13;  ///< without Other

/// By what pockets are sorted.
enum class PocketRank {
    Score,  ///< how much room there is that resembles the places of ligands
    Volume,
    Depth,
};

/// A place at which a pocket is asked for, whatever it resembles: where a ligand lies, beside residues, at a point.
struct PocketPlace {
    std::vector<Vec3> points;  ///< centres of atoms, or one point, Å
    double reach = 4.0;        ///< the pocket is pocket space that is no farther from one of the points, Å
};

/// The coarsest grid that shows pockets, and the finest one that is allowed, which takes 125 times the memory of the
/// usual one, Å.
inline constexpr double kMostPocketSpacing = 2.0;
inline constexpr double kLeastPocketSpacing = 0.2;
/// The largest probe that closes pockets off, Å.
inline constexpr double kMostLargeProbe = 100.0;

/// Which pockets are looked for, and how. Lengths in Å.
struct PocketOptions {
    double probe = 1.4;         ///< radius of the probe that reaches into pockets
    double large_probe = 10.0;  ///< radius of the probe that does not; larger than `probe`
    double spacing = 1.0;       ///< of the grid; the ranking was fitted at 1.0
    int count = 10;             ///< pockets looked for, beside closed cavities
    PocketRank rank = PocketRank::Score;
    /// If there are any, the pockets are those at these places, one for each, in this order. A place without pocket
    /// space has a pocket with a volume of 0. One in a closed cavity has the whole cavity.
    std::vector<PocketPlace> places{};
};

/// Where a pocket is open.
struct PocketMouth {
    double area = 0.0;    ///< Å²
    double radius = 0.0;  ///< of a disc of that area, Å
    Vec3 centre;          ///< Å
};

/// An atom of a pocket's wall.
struct WallAtom {
    std::uint32_t atom = 0;  ///< the caller's index
    double area = 0.0;       ///< of its share of the SES that lines the pocket, Å²
};

/// A pocket: a place between the molecule and a large probe that rolls over it.
struct Pocket {
    std::size_t rank = 0;      ///< from 1
    double score = 0.0;        ///< an amount of ligand-like space, without a unit; not a probability
    double probability = 0.0;  ///< the largest probability of a point, from 0 to 1; not calibrated
    /// Ranks of pockets whose scores differ so little from this one's that another orientation may swap them.
    std::vector<std::size_t> tied_with;
    /// At a given place: the rank of the first site found without places whose centre is within 4 Å of one of the
    /// place's points; 0 for none, and where no places are given.
    std::size_t site = 0;
    std::size_t points_inside = 0;      ///< of the place's points, those inside the SES of the large probe
    bool cavity = false;                ///< a closed cavity, whose volume is exact
    double volume = 0.0;                ///< Å³
    double wall_area = 0.0;             ///< Å², the sum over `wall`
    double depth = 0.0;                 ///< the largest depth below the surface of the large probe, Å
    Vec3 centre;                        ///< of the ligand-like space, Å
    Vec3 deepest;                       ///< the grid point at that depth, Å
    std::vector<PocketMouth> mouths;    ///< where it meets the bulk, largest first
    std::vector<PocketMouth> openings;  ///< where it goes on in other pocket space, largest first
    std::vector<WallAtom> wall;         ///< by atom
    std::vector<std::uint32_t> voxels;  ///< indices into Pockets::voxels
};

/// A point of the grid whose cube lies in pocket space, at least in part.
struct PocketVoxel {
    Vec3 position;                 ///< Å
    float share = 0.0F;            ///< of its cube, 0 to 1
    float depth = 0.0F;            ///< below the surface of the large probe, Å
    float probability = 0.0F;      ///< of a ligand's atom, not calibrated; 0 where an atom is closer than 1 Å
    std::uint32_t pocket = kNone;  ///< index into Pockets::pockets
};

/// What the ranking knows of a point, see pocket_feature_names().
inline constexpr std::size_t kPocketFeatures = 43;
using PocketFeatures = std::array<float, kPocketFeatures>;

/// The names of the features; docs/reference/pockets.md says what they are.
std::array<std::string_view, kPocketFeatures> pocket_feature_names();

/// The pocket space of a molecule: what lies inside the SES of the large probe and outside that of the small one.
struct Pockets {
    PocketOptions options;
    double volume = 0.0;       ///< of all pocket space, exact, Å³
    double rest_volume = 0.0;  ///< of pocket space in no pocket, Å³: with the volumes of pockets it adds up to `volume`
    double scale = 1.0;        ///< what volumes from the grid were multiplied by for that
    double wall_area = 0.0;    ///< of the SES of the small probe, exact, Å²
    double mouth_area = 0.0;  ///< of the free part of the SES of the large probe (not in contact with atoms), exact, Å²
    std::vector<Pocket> pockets;           ///< by rank; closed cavities that resemble no ligand's place at the end
    std::vector<PocketVoxel> voxels;       ///< in an order that does not depend on the atoms' order
    std::vector<std::uint32_t> points;     ///< indices of the voxels that have a place in the ranking, ascending
    std::vector<PocketFeatures> features;  ///< of these points
};

/// Finds pockets, ranks them, and measures them.
///
/// exact     the SES of the small probe; that of the large one is made from its atoms
/// classes   one per atom, for the ranking; empty: all are AtomClass::Other, and only shapes are ranked
/// returns   no pockets where there is no pocket space
/// throws    UsageError for options out of range; LimitError where the grid would not fit into memory; as accessible()
/// cost      some 0.1 ms per atom at a spacing of 1 Å
/// source    docs/design/pockets.md
Pockets find_pockets(const ExactSurface& exact, std::span<const AtomClass> classes, const PocketOptions& options = {},
                     const RunOptions& run = {});

/// Self-checks: "scale" (the volume from the grid is within 2 % or 5 Å³ of the exact one) and "pocket_volumes" (those
/// of all pockets and of the rest add up to `volume`).
std::vector<Check> pocket_checks(const Pockets& pockets);

/// Pockets as values on a grid that holds them all.
///
/// content   VolumeContent::Probability or VolumeContent::Pockets
Volume pocket_volume(const Pockets& pockets, VolumeContent content);

/// Every pocket as a closed body: smooth, with the pocket's volume to some per cent, its normals pointing out of it.
/// `components` are indices into Pockets::pockets, the values kPocketValues their ranks. Bodies of neighbours meet and
/// may overlap by a part of the spacing. A pocket without voxels has no body.
///
/// cost     O(voxels)
Mesh pocket_bodies(const Pockets& pockets);

/// Which pocket each vertex of a surface lies beside, as kPocketValues.
///
/// mesh     of a surface of the same atoms, with normals
VertexValues pocket_values(const Pockets& pockets, const Mesh& mesh);

}  // namespace meniscus

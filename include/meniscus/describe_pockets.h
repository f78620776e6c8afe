// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The options and the results of pockets, described as describe_options.h and describe_results.h describe the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "meniscus/describe_options.h"
#include "meniscus/describe_results.h"
#include "meniscus/pocket_chemistry.h"
#include "meniscus/pocket_places.h"
#include "meniscus/pocket_tracks.h"
#include "meniscus/pockets.h"
#include "meniscus/structure.h"
#include "meniscus/tables.h"

namespace meniscus {

inline constexpr Words<PocketRank, 3> kPocketRankWords{
    {{"score", PocketRank::Score}, {"volume", PocketRank::Volume}, {"depth", PocketRank::Depth}}};

/// What a volume of pockets holds.
inline constexpr Words<VolumeContent, 2> kPocketFieldWords{
    {{"pockets", VolumeContent::Pockets}, {"probability", VolumeContent::Probability}}};

/// All options of pockets.
template <MaybeConst<PocketOptions> Options, class Visitor>
void describe(Options& o, Visitor&& visit) {
    visit(Option{.name = "probe",
                 .brief = "Radius of the probe that reaches into pockets, Å",
                 .meaning = "Radius of the probe that reaches into pockets, Å",
                 .example = "--probe 1.5",
                 .symbol = "R",
                 .range = NumberRange::Positive},
          o.probe);
    visit(Option{.name = "large_probe",
                 .brief = "Radius of the probe that does not, Å",
                 .meaning =
                     "Radius of the probe that closes pockets off from the bulk, Å; larger than `--probe`, at most 100",
                 .example = "--large-probe 8",
                 .symbol = "R",
                 .range = NumberRange::Positive},
          o.large_probe);
    visit(Option{.name = "spacing",
                 .brief = "Grid spacing, Å",
                 .meaning = "Grid spacing, Å, 0.2 to 2; the ranking was fitted at 1",
                 .example = "--spacing 0.5",
                 .symbol = "H",
                 .range = NumberRange::Positive},
          o.spacing);
    visit(Option{.name = "count",
                 .brief = "Number of pockets looked for",
                 .meaning = "Number of pockets looked for; closed cavities come in addition",
                 .example = "--count 3",
                 .symbol = "N",
                 .standard = "10"},
          o.count);
    visit(Option{.name = "rank",
                 .brief = "What pockets are sorted by",
                 .meaning = "What pockets are sorted by: how much room there is that resembles the places of ligands, "
                            "volume, or depth",
                 .example = "--rank volume"},
          o.rank, kPocketRankWords);
}

template <class Visitor>
void describe(const PocketMouth& m, Visitor& visit) {
    visit({"area", "Å²", "area"}, m.area);
    visit({"radius", "Å", "radius of a disc of that area"}, m.radius);
    visit({"centre", "Å", "centroid, `[x, y, z]`"}, m.centre);
}

/// A pocket with what lines it.
struct DescribedPocket {
    Pocket pocket;
    PocketChemistry chemistry;
    std::vector<std::string> residues{};  ///< labels of the lining residues, "A:SER 195"
    std::string at{};                     ///< the name of its place, where places are given
    std::optional<LigandFit> ligand{};    ///< the one that lies at its place
    std::size_t track = 0;                ///< where models are compared: its number, from 1
};

template <class Visitor>
void describe(const LigandFit& l, Visitor& visit) {
    visit({"atoms", "", "number of its atoms"}, l.atoms);
    visit({"inside", "", "number of those whose centres lie inside the SES of the large probe"}, l.inside);
    visit({"sas_area", "Å²", "exact SAS of the ligand alone"}, l.area);
    visit({"buried_area", "Å²", "the part of it that the molecule's atoms bury"}, l.buried_area);
}

template <class Visitor>
void describe(const DescribedPocket& d, Visitor& visit) {
    const Pocket& p = d.pocket;
    visit({"rank", "", "place in this list, from 1"}, p.rank);
    visit({"at", "", "place that was asked for; empty for pockets that were found"}, d.at);
    visit({"score", "", "amount of space that resembles the places of ligands; not a probability"}, p.score);
    visit({"probability", "", "largest probability of a point in it to be one of a ligand's, 0 to 1; not calibrated"},
          p.probability);
    visit({"tied_with", "", "ranks of pockets whose scores are within 10 %"}, p.tied_with);
    visit({"site", "",
           "at a place: rank that the pocket would have among those found, judged by the first site whose "
           "centre is within 4 Å of the place; 0 for none"},
          p.site);
    visit({"track", "", "with `--model all`: number of the pocket over all models; 0 otherwise"}, d.track);
    visit.optional_block({"ligand", "", "ligand that lies at the place; null where there is none"}, d.ligand,
                         [](auto& inner, const LigandFit& ligand) { describe(ligand, inner); });
    visit({"cavity", "", "whether it is a closed cavity, whose volume is exact"}, p.cavity);
    visit({"volume", "Å³", "volume of its region"}, p.volume);
    visit({"wall_area", "Å²", "area of the SES that lines it"}, p.wall_area);
    visit({"depth", "Å", "largest depth below the surface of the large probe"}, p.depth);
    visit({"centre", "Å", "centre of the space that resembles the places of ligands, `[x, y, z]`"}, p.centre);
    visit.list({"mouths", "", "where it meets the bulk, largest first"}, p.mouths,
               [](auto& inner, const PocketMouth& mouth) { describe(mouth, inner); });
    visit.list({"openings", "", "where it goes on in other pocket space, largest first"}, p.openings,
               [](auto& inner, const PocketMouth& mouth) { describe(mouth, inner); });
    visit({"hydrophobicity", "", "mean of Kyte and Doolittle's scale over its wall, -4.5 to 4.5"},
          d.chemistry.hydrophobicity);
    visit({"charge", "e", "lining ARG and LYS less lining ASP and GLU"}, d.chemistry.charge);
    visit({"donors", "", "number of lining atoms that give hydrogen bonds"}, d.chemistry.donors);
    visit({"acceptors", "", "number of lining atoms that take hydrogen bonds"}, d.chemistry.acceptors);
    visit({"residues", "", "residues that line it with more than 1 Å² of an atom, as `A:SER 195`"}, d.residues);
    visit({"atoms", "", "atoms that line it with more than 1 Å², as indices of kept atoms"}, d.chemistry.atoms);
}

/// The totals of pocket space.
template <class Visitor>
void describe(const Pockets& p, Visitor& visit) {
    visit({"volume", "Å³",
           "exact volume of pocket space: inside the SES of the large probe, outside that of the small one"},
          p.volume);
    visit({"large_probe", "Å", "radius of the large probe"}, p.options.large_probe);
    visit({"rest_volume", "Å³", "volume of pocket space in no pocket; with all volumes below it adds up to `volume`"},
          p.rest_volume);
    visit({"scale", "", "factor by which volumes from the grid were multiplied for that; near 1"}, p.scale);
    visit({"wall_area", "Å²", "exact area of the SES of the small probe"}, p.wall_area);
    visit({"mouth_area", "Å²", "exact area of the SES of the large probe where it touches no atom"}, p.mouth_area);
}

/// Every pocket with what lines it.
///
/// places   those of PocketOptions::places, if there are any
std::vector<DescribedPocket> describe_pockets(const Pockets& pockets, const Structure& structure,
                                              std::span<const NamedPlace> places = {});

/// A row per pocket; the columns are the keys of a described pocket, with sums over its mouths and openings.
Table pockets_table(const std::vector<DescribedPocket>& pockets);

/// A pocket over all models, and the residues that line it in them.
struct DescribedTrack {
    PocketTrack track;
    std::size_t number = 0;  ///< from 1, DescribedPocket::track
    std::vector<std::string> residues;
};

/// Pockets over models of one molecule. Atoms of different models are the same if their chains, residues and names are;
/// of several with one name, or without, the first is the first of the other model, and so on.
class FollowedPockets {
public:
    /// structure     the atoms of the model, with a label for each
    /// bottlenecks   as for PocketTracks::add()
    /// returns       for each pocket the number of its track, from 1
    std::vector<std::size_t> add(const Pockets& pockets, const Structure& structure,
                                 std::span<const double> bottlenecks = {});

    /// Those that look most like the places of ligands first, by the sum of their scores over the models.
    std::vector<DescribedTrack> described() const;

    std::size_t models() const { return tracks_.models(); }

private:
    std::vector<std::uint32_t> numbers_of(const Structure& structure);

    PocketTracks tracks_;
    std::unordered_map<std::string, std::uint32_t> numbers_;  // of atoms, the same in all models, by their names
    std::vector<Residue> residues_;                           // of each number
};

/// A row per pocket over all models.
///
/// models         how many there are
/// with_tunnels   whether tunnels were looked for; else nothing is said of them
Table tracks_table(const std::vector<DescribedTrack>& tracks, std::size_t models, bool with_tunnels);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pockets over several models of one molecule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/pockets.h"

namespace meniscus {

/// Mean and standard deviation of a number over models.
struct Spread {
    double mean = 0.0;
    double deviation = 0.0;  ///< of the sample; 0 for less than two values
    std::size_t values = 0;  ///< how many there are
};

/// A pocket as it comes and goes.
struct PocketTrack {
    std::size_t models = 0;        ///< in which it was found
    std::size_t open = 0;          ///< of these, those in which it is not a closed cavity
    std::size_t best_rank = 0;     ///< in any model
    Spread score{};                ///< over the models in which it was found, as all that follow
    Spread volume{};               ///< Å³
    Spread depth{};                ///< Å
    Spread mouth_radius{};         ///< of the largest mouth or opening, Å; over the models in which it is open
    std::size_t ways = 0;          ///< models in which a bottleneck was given
    Spread bottleneck{};           ///< over these, Å
    std::vector<WallAtom> wall{};  ///< mean areas over these models, by atom
};

/// Tells which pockets of different models are the same, by the atoms that line them: two pockets are alike by the area
/// of wall that they share over the area that either has, and each pocket joins the track whose mean wall it is most
/// like, at least by an eighth. Tracks are numbered as they appear.
class PocketTracks {
public:
    /// ids           for each atom of the model a number that is the same in all models; empty: its index
    /// bottlenecks   for each pocket the radius of the bottleneck of its widest tunnel, Å, 0 where it has none; empty:
    ///               none has
    /// returns       for each pocket the number of its track, from 0
    std::vector<std::size_t> add(const Pockets& pockets, std::span<const std::uint32_t> ids = {},
                                 std::span<const double> bottlenecks = {});

    /// All tracks so far.
    std::vector<PocketTrack> tracks() const;

    std::size_t models() const { return models_; }

private:
    struct Record {
        PocketTrack track;  // its wall holds sums
        std::vector<double> scores{};
        std::vector<double> volumes{};
        std::vector<double> depths{};
        std::vector<double> mouths{};
        std::vector<double> bottlenecks{};
    };

    std::vector<Record> records_;
    std::size_t models_ = 0;
};

}  // namespace meniscus

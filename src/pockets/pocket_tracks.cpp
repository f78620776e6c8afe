// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/pocket_tracks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meniscus {
namespace {

constexpr double kAlike = 0.125;

std::vector<WallAtom> renumbered(std::vector<WallAtom> wall, std::span<const std::uint32_t> ids) {
    if (ids.empty()) return wall;
    for (WallAtom& atom : wall) atom.atom = ids[atom.atom];
    std::sort(wall.begin(), wall.end(), [](const WallAtom& a, const WallAtom& b) { return a.atom < b.atom; });
    return wall;
}

// Calls visit(atom, area in a, area in b) for the atoms of either.
template <class Visit>
void for_each_atom(const std::vector<WallAtom>& a, const std::vector<WallAtom>& b, const Visit& visit) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
        const bool in_a = i < a.size() && (j == b.size() || a[i].atom <= b[j].atom);
        const bool in_b = j < b.size() && (i == a.size() || b[j].atom <= a[i].atom);
        visit(in_a ? a[i].atom : b[j].atom, in_a ? a[i].area : 0.0, in_b ? b[j].area : 0.0);
        i += static_cast<std::size_t>(in_a);
        j += static_cast<std::size_t>(in_b);
    }
}

// How alike a wall and the mean of some walls are, from 0 to 1.
double likeness(const std::vector<WallAtom>& wall, const std::vector<WallAtom>& sums, std::size_t count) {
    double both = 0.0;
    double either = 0.0;
    for_each_atom(wall, sums, [&](std::uint32_t, double a, double sum) {
        const double b = sum / static_cast<double>(count);
        both += std::min(a, b);
        either += std::max(a, b);
    });
    return either > 0.0 ? both / either : 0.0;
}

std::vector<WallAtom> added(const std::vector<WallAtom>& a, const std::vector<WallAtom>& b) {
    std::vector<WallAtom> sum;
    for_each_atom(a, b, [&](std::uint32_t atom, double one, double other) { sum.push_back({atom, one + other}); });
    return sum;
}

double widest(const Pocket& pocket) {
    double radius = 0.0;
    for (const PocketMouth& mouth : pocket.mouths) radius = std::max(radius, mouth.radius);
    for (const PocketMouth& opening : pocket.openings) radius = std::max(radius, opening.radius);
    return radius;
}

Spread spread_of(const std::vector<double>& values) {
    Spread spread{.values = values.size()};
    const auto count = static_cast<double>(values.size());
    for (const double value : values) spread.mean += value / count;
    if (values.size() < 2) return spread;
    double squares = 0.0;
    for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
    spread.deviation = std::sqrt(squares / (count - 1.0));
    return spread;
}

struct Match {
    double likeness = 0.0;
    std::size_t pocket = 0;
    std::size_t track = 0;
};

}  // namespace

std::vector<std::size_t> PocketTracks::add(const Pockets& pockets, std::span<const std::uint32_t> ids,
                                           std::span<const double> bottlenecks) {
    ++models_;
    std::vector<std::vector<WallAtom>> walls;
    std::vector<Match> matches;
    for (std::size_t p = 0; p < pockets.pockets.size(); ++p) {
        walls.push_back(renumbered(pockets.pockets[p].wall, ids));
        for (std::size_t t = 0; t < records_.size(); ++t) {
            const double alike = likeness(walls[p], records_[t].track.wall, records_[t].track.models);
            if (alike >= kAlike) matches.push_back({alike, p, t});
        }
    }
    std::stable_sort(matches.begin(), matches.end(),
                     [](const Match& a, const Match& b) { return a.likeness > b.likeness; });
    constexpr std::size_t kNoTrack = ~std::size_t{0};
    std::vector<std::size_t> track_of(walls.size(), kNoTrack);
    std::vector<std::uint8_t> taken(records_.size());
    for (const Match& match : matches) {
        if (track_of[match.pocket] != kNoTrack || taken[match.track] != 0) continue;
        track_of[match.pocket] = match.track;
        taken[match.track] = 1;
    }
    for (std::size_t p = 0; p < walls.size(); ++p) {
        const Pocket& pocket = pockets.pockets[p];
        if (track_of[p] == kNoTrack) {
            track_of[p] = records_.size();
            records_.push_back({.track = {.best_rank = pocket.rank}});
        }
        Record& record = records_[track_of[p]];
        ++record.track.models;
        record.track.open += static_cast<std::size_t>(!pocket.cavity);
        record.track.best_rank = std::min(record.track.best_rank, pocket.rank);
        record.track.wall = added(record.track.wall, walls[p]);
        record.scores.push_back(pocket.score);
        record.volumes.push_back(pocket.volume);
        record.depths.push_back(pocket.depth);
        if (!pocket.cavity) record.mouths.push_back(widest(pocket));
        if (!bottlenecks.empty() && bottlenecks[p] > 0.0) record.bottlenecks.push_back(bottlenecks[p]);
    }
    return track_of;
}

std::vector<PocketTrack> PocketTracks::tracks() const {
    std::vector<PocketTrack> result;
    for (const Record& record : records_) {
        PocketTrack track = record.track;
        track.score = spread_of(record.scores);
        track.volume = spread_of(record.volumes);
        track.depth = spread_of(record.depths);
        track.mouth_radius = spread_of(record.mouths);
        track.ways = record.bottlenecks.size();
        track.bottleneck = spread_of(record.bottlenecks);
        for (WallAtom& atom : track.wall) atom.area /= static_cast<double>(track.models);
        result.push_back(std::move(track));
    }
    return result;
}

}  // namespace meniscus

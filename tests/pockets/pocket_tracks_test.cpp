// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "meniscus/pocket_tracks.h"

namespace meniscus::testing {
namespace {

Pocket pocket(std::vector<WallAtom> wall, double volume, bool cavity = false) {
    Pocket result;
    result.rank = 1;
    result.volume = volume;
    result.cavity = cavity;
    result.wall = std::move(wall);
    return result;
}

Pockets model(std::vector<Pocket> pockets) {
    Pockets result;
    result.pockets = std::move(pockets);
    for (std::size_t i = 0; i < result.pockets.size(); ++i) result.pockets[i].rank = i + 1;
    return result;
}

using Numbers = std::vector<std::size_t>;

TEST(PocketTracks, PocketsWithTheSameWallAreTheSame) {
    PocketTracks tracks;
    const Pocket a = pocket({{1, 10.0}, {2, 5.0}}, 100.0);
    const Pocket b = pocket({{7, 10.0}, {9, 5.0}}, 50.0);
    EXPECT_EQ(tracks.add(model({a, b})), (Numbers{0, 1}));
    EXPECT_EQ(tracks.add(model({b, a})), (Numbers{1, 0}));
    EXPECT_EQ(tracks.models(), 2u);
    const std::vector<PocketTrack> found = tracks.tracks();
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1].models, 2u);
    EXPECT_EQ(found[1].best_rank, 1u);
    EXPECT_EQ(found[1].volume.mean, 50.0);
    EXPECT_EQ(found[1].volume.deviation, 0.0);
}

TEST(PocketTracks, MeanAndDeviationAreThoseOfTheSample) {
    PocketTracks tracks;
    for (const double volume : {10.0, 20.0, 60.0}) tracks.add(model({pocket({{1, 4.0}}, volume, volume > 50.0)}));
    const PocketTrack track = tracks.tracks()[0];
    EXPECT_DOUBLE_EQ(track.volume.mean, 30.0);
    EXPECT_DOUBLE_EQ(track.volume.deviation, std::sqrt((400.0 + 100.0 + 900.0) / 2.0));
    EXPECT_EQ(track.open, 2u);
}

TEST(PocketTracks, EachJoinsTheOneThatItIsMostLike) {
    PocketTracks tracks;
    tracks.add(model({pocket({{1, 10.0}, {2, 10.0}}, 1.0), pocket({{2, 10.0}, {3, 10.0}}, 2.0)}));
    EXPECT_EQ(tracks.add(model({pocket({{2, 10.0}, {3, 8.0}}, 3.0), pocket({{1, 9.0}, {2, 9.0}}, 4.0)})),
              (Numbers{1, 0}));
    EXPECT_EQ(tracks.add(model({pocket({{5, 10.0}, {1, 2.0}}, 5.0)})), (Numbers{2}));
}

TEST(PocketTracks, AtomsAreKnownByTheirNumbers) {
    PocketTracks tracks;
    const Pocket a = pocket({{0, 10.0}, {1, 1.0}}, 1.0);
    tracks.add(model({a}), std::vector<std::uint32_t>{5, 6});
    EXPECT_EQ(tracks.add(model({pocket({{0, 1.0}, {1, 10.0}}, 1.0)}), std::vector<std::uint32_t>{6, 5}), (Numbers{0}));
    const PocketTrack track = tracks.tracks()[0];
    ASSERT_EQ(track.wall.size(), 2u);
    EXPECT_EQ(track.wall[0].atom, 5u);
    EXPECT_EQ(track.wall[0].area, 10.0);
}

TEST(PocketTracks, BottlenecksCountWhereThereAreSome) {
    PocketTracks tracks;
    const Pocket a = pocket({{0, 10.0}}, 1.0);
    for (const double radius : {1.0, 0.0, 2.0}) tracks.add(model({a}), {}, std::vector<double>{radius});
    const PocketTrack track = tracks.tracks()[0];
    EXPECT_EQ(track.ways, 2u);
    EXPECT_DOUBLE_EQ(track.bottleneck.mean, 1.5);
}

}  // namespace
}  // namespace meniscus::testing

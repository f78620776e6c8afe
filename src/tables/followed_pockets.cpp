// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meniscus/describe_pockets.h"
#include "tables/identity_cells.h"

namespace meniscus {

std::vector<std::uint32_t> FollowedPockets::numbers_of(const Structure& structure) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(structure.labels.size());
    std::unordered_map<std::string, std::size_t> times;
    for (std::size_t i = 0; i < structure.labels.size(); ++i) {
        const Residue& residue = residue_at(structure, i);
        std::string key = residue_label(residue) + " " + structure.labels[i].name;
        key += " " + std::to_string(times[key]++);
        const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(residues_.size()));
        if (is_new) residues_.push_back(residue);
        numbers.push_back(found->second);
    }
    return numbers;
}

std::vector<std::size_t> FollowedPockets::add(const Pockets& pockets, const Structure& structure,
                                              std::span<const double> bottlenecks) {
    std::vector<std::size_t> tracks = tracks_.add(pockets, numbers_of(structure), bottlenecks);
    for (std::size_t& track : tracks) ++track;
    return tracks;
}

std::vector<DescribedTrack> FollowedPockets::described() const {
    std::vector<DescribedTrack> tracks;
    for (PocketTrack& track : tracks_.tracks()) {
        std::vector<std::string> residues;
        for (const WallAtom& atom : track.wall) {
            if (atom.area <= kLiningArea) continue;
            const std::string label = spaced_label(residues_[atom.atom]);
            if (!label.empty() && std::find(residues.begin(), residues.end(), label) == residues.end())
                residues.push_back(label);
        }
        tracks.push_back({std::move(track), tracks.size() + 1, std::move(residues)});
    }
    std::stable_sort(tracks.begin(), tracks.end(), [](const DescribedTrack& a, const DescribedTrack& b) {
        const auto key = [](const DescribedTrack& t) {
            return t.track.score.mean * static_cast<double>(t.track.models);
        };
        return key(a) != key(b) ? key(a) > key(b) : a.track.models > b.track.models;
    });
    return tracks;
}

}  // namespace meniscus

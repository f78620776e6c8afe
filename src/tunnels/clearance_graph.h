// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The graph of all widest ways: maxima of clearance, joined by saddles.
//
// Where clearance exceeds some number, space falls into pieces, which join only at saddles when the number is lowered.
// Hence the widest way between two maxima leads over saddles, and through each along the ways up on both of its sides.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "meniscus/vec3.h"
#include "tunnels/clearance.h"
#include "tunnels/saddles.h"

namespace meniscus {

/// Where a point is with regard to the region whose ways are looked for: a way ends where it reaches one of both ends,
/// and may not leave otherwise.
enum class Place : std::uint8_t { Inside, First, Second, Outside };
using PlaceOf = std::function<Place(const Vec3&)>;

/// Number of a node: the two ends first, then maxima.
using NodeId = std::uint32_t;
inline constexpr NodeId kFirstEnd = 0;
inline constexpr NodeId kSecondEnd = 1;
inline constexpr NodeId kNoNode = 0xffffffffU;

/// A way up to a node.
struct Leg {
    NodeId node = kNoNode;
    double cost = 0.0;  ///< integral of 1/clearance² along it, 1/Å
};

/// A saddle with its ways up on both sides: along the normal, and against it.
struct Pass {
    Saddle saddle;
    std::array<Leg, 2> legs;
};

/// A pass that a way takes, and on which side of it the way begins.
struct Step {
    std::uint32_t pass = 0;
    std::size_t side = 0;
};

class ClearanceGraph {
public:
    /// Finds the maxima to which the ways up from saddles and starts lead.
    ClearanceGraph(const Clearance& clearance, PlaceOf place, std::vector<Saddle> saddles,
                   std::span<const Vec3> starts);

    const std::vector<Pass>& passes() const { return passes_; }
    NodeId node_of_start(std::size_t start) const { return starts_[start]; }

    /// The polyline from a point up to its node; with the first point.
    std::vector<Vec3> way_up(const Vec3& start) const;
    /// The polyline from the node of one side of a pass, through the saddle, to that of the other.
    std::vector<Vec3> way_through(const Step& step) const;

    /// The passes of the cheapest among the widest ways; nothing where there is none. Without steps where both nodes
    /// are the same.
    ///
    /// closed   one per pass: those that may not be taken
    struct Route {
        bool found = false;
        std::vector<Step> steps;
    };
    Route widest(NodeId from, NodeId to, const std::vector<bool>& closed) const;

private:
    struct Foot;  // where a way up ends

    std::vector<Vec3> leg(const Saddle& saddle, std::size_t side) const;
    double width(NodeId from, NodeId to, const std::vector<bool>& closed) const;
    void name_nodes(const std::vector<Foot>& feet);

    const Clearance& clearance_;
    PlaceOf place_;
    std::vector<Pass> passes_;
    std::vector<std::uint32_t> by_radius_;  // passes, widest first
    std::vector<NodeId> starts_;
    std::size_t nodes_ = 0;
};

}  // namespace meniscus

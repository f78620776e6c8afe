// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A mesh taken apart into its closed pieces, each with the exact component that it is a mesh of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/measures.h"
#include "meniscus/mesh.h"

namespace meniscus::dropins {

/// The vertices and triangles of one component of the mesh, with the arrays that MSMS files need.
Mesh piece_of(const Mesh& mesh, std::uint32_t component);

/// For every component of a mesh the exact one it stands for: of the same kind, nearest in place and size.
/// returns  places in `exact`, or kNone where no component of that kind is left
std::vector<std::uint32_t> match_components(const Mesh& mesh, const MeshMeasures& measured,
                                            std::span<const SurfaceComponent> exact);

/// The component that all these atoms touch: a cavity if there is one, the larger one of several.
/// returns  its place, or kNone
std::uint32_t component_touching(std::span<const SurfaceComponent> components, std::span<const std::uint32_t> atoms);

/// Areas of one atom in one component, Å².
struct AtomShare {
    double ses = 0.0;
    double sas = 0.0;
};

/// Of every atom, what it has of one component; together they sum to the component's areas.
std::vector<AtomShare> shares_of_atoms(const Measures& measures, std::uint32_t component);

}  // namespace meniscus::dropins

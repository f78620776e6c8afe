// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The Gaussian density map that the flow starts from (Pan & Tai 2009, eq. 3.1), in a form near a distance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "band/surface_blocks.h"
#include "geometry/accessible_surface_data.h"
#include "grid/block_grid.h"
#include "meniscus/node_field.h"
#include "nearest/local_features.h"

namespace meniscus {

/// Φ0(x) = ln(Σ exp(C(|x - x_i|² - r_i²))) / (2 C r̄), r̄ the mean radius: the zero set of the paper's
/// G(x) = Σ exp(C(|x - x_i|² - r_i²)) - 1, negative inside, with a slope near 1 there.
class GaussianDensity {
public:
    /// C in Å^-2, negative: close to 0 inflates, far below hugs the van der Waals surface.
    GaussianDensity(const AccessibleSurface& surface, double c);

    /// Blocks that may hold a node with |Φ0| < margin, ascending.
    /// throws   LimitError when more than max_blocks are found
    std::vector<BlockCoord> blocks_near_surface(const Lattice& lattice, double margin, std::size_t max_blocks) const;

    /// Φ0 at every node of the grid, clamped to ±margin.
    NodeField sample(const BlockGrid& grid, double margin) const;

private:
    enum class Where : std::uint8_t { Inside, Outside, Near };

    class AtomsAround;

    /// The nodes of a block: the position of the first, and the spacing, Å.
    struct BlockNodes {
        Vec3 corner;
        double spacing;
    };

    void evaluate(const BlockNodes& block, double margin, const SphereList& atoms,
                  std::span<float, kBlockNodes> values) const;
    double largest_exponent(const BlockNodes& block, int node, const SphereList& atoms) const;
    /// The exponent of an atom's term at squared distance d2 from its centre.
    double exponent(const SphereList& atoms, std::size_t i, double d2) const {
        const double radius = atoms.column(3)[i];
        return c_ * (d2 - radius * radius);
    }

    const AccessibleSurface::Data* data_;
    double c_;
    double mean_radius_;
    double reach_;  // Å; farther terms are below e^-12
};

}  // namespace meniscus

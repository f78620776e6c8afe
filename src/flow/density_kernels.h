// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Exponentials of the Gaussian density, many side by side, for several instruction sets: all give the same bits.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "grid/block_kernels.h"
#include "nearest/local_features.h"

namespace meniscus {

/// From sums of terms to Φ0 at the nodes of a block.
struct DensityLimits {
    double unit = 0.0;        ///< sums are divided by exp(unit)
    double per_length = 1.0;  ///< logarithm of the sum per Å of Φ0: -2 C times the mean radius, Å^-1
    double margin = 0.0;      ///< Å, of |Φ0|
    double most = 0.0;        ///< the sum from which on Φ0 is -margin
    double least = 0.0;       ///< the sum down from which it is margin; a normal number
};

/// Terms exp(C (d² - r²)) of the density (Pan & Tai 2009, eq. 3.1), C in Å^-2, lengths in Å; atoms are spheres with
/// their radii. Within 3 units in the last place of the rounded exponent's exponential; 0 below e^-700, e^700 above it.
struct DensityKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"

    /// Finds every atom's largest and least term in the box, and whether the atom is within `reach` of the box: if not,
    /// both are 0. within: a bit for each (core/bits.h); the others have room for atoms.padded_size() numbers.
    void (*bound_terms)(const SphereList& atoms, const Box& box, double c, double reach, std::uint64_t* within,
                        double* largest, double* least);

    /// The terms of one atom at the nodes of a block, divided by exp(unit). `from` leads from the atom's centre to the
    /// first node. No table overflows where unit is at least the exponent at the nearest node.
    void (*find_terms)(double c, double radius, const Vec3& from, double spacing, double unit, AxisProduct& terms);

    /// Φ0 = -(unit + ln sum) / per_length at the kBlockNodes nodes of a block, Å, in single precision, of a logarithm
    /// within 2 units in the last place of double precision (of the larger of it and 1).
    void (*find_values)(const DensityLimits& limits, const double* sums, float* values);
};

/// The kernels that this machine can run, the plainest first.
std::vector<DensityKernels> supported_density_kernels();

/// The ones that are used, as in nearest_kernels().
const DensityKernels& density_kernels();

}  // namespace meniscus

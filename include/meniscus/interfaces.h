// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Interfaces: the surface that two groups of atoms bury between them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/measures.h"

namespace meniscus {

/// Indices of atoms, each once, in any order.
using AtomGroup = std::vector<std::uint32_t>;

/// An atom's areas without and with the other group, Å².
struct InterfaceAtom {
    double sas_alone = 0.0;
    double sas_complex = 0.0;
    double ses_alone = 0.0;
    double ses_complex = 0.0;

    double buried_sas() const { return sas_alone - sas_complex; }  ///< never negative beyond rounding
    double buried_ses() const { return ses_alone - ses_complex; }  ///< may be negative near the rim of the interface

    InterfaceAtom& operator+=(const InterfaceAtom& other) {
        sas_alone += other.sas_alone;
        sas_complex += other.sas_complex;
        ses_alone += other.ses_alone;
        ses_complex += other.ses_complex;
        return *this;
    }
};

/// SAS and SES areas of group A, of group B and of both together, all other atoms left out, Å².
struct Interface {
    double sas_a = 0.0;
    double sas_b = 0.0;
    double sas_ab = 0.0;
    double ses_a = 0.0;
    double ses_b = 0.0;
    double ses_ab = 0.0;
    double sas_error = 0.0;              ///< absolute error estimate of buried_sas(), the sum over the three areas
    double ses_error = 0.0;              ///< absolute error estimate of buried_ses()
    std::vector<InterfaceAtom> atoms_a;  ///< in the order of group A
    std::vector<InterfaceAtom> atoms_b;  ///< in the order of group B
    bool agreed = true;                  ///< whether Measures::agreed holds for A, B and both
    std::vector<std::string> disputed;   ///< patches on which evaluations differ, unless agreed

    double buried_sas() const { return sas_a + sas_b - sas_ab; }
    double interface_area() const { return 0.5 * buried_sas(); }  ///< per side, as usually quoted
    double buried_ses() const { return ses_a + ses_b - ses_ab; }
};

/// Measures the interfaces of pairs of groups; each group alone is measured only once.
///
/// pairs    indices into `groups`
/// options  `cavities` and `depth` are not used
/// returns  one interface per pair, in the order of the pairs
/// throws   UsageError for a group of a pair that is empty, an index out of range, an atom named twice in a pair;
///          and whatever measure() throws
/// cost     that of measure() for the groups and for each pair
std::vector<Interface> measure_interfaces(const Atoms& atoms, std::span<const AtomGroup> groups,
                                          std::span<const std::array<std::uint32_t, 2>> pairs,
                                          const MeasureOptions& options = {});

/// Measures the interface of two groups, as measure_interfaces() does.
Interface measure_interface(const Atoms& atoms, const AtomGroup& a, const AtomGroup& b,
                            const MeasureOptions& options = {});

/// The pairs of groups that touch: an atom of one lies within the sum of both radii plus the probe's diameter of an
/// atom of the other, so that their solvent-accessible spheres meet.
///
/// group    the group of each atom, from 0; kNone for an atom without a group
/// groups   number of groups
/// probe    probe radius, Å
/// returns  pairs {i, j}, i < j, ascending
/// throws   UsageError for arrays of different sizes or a group that does not exist; std::invalid_argument and
///          LimitError as ExactSurface::accessible()
/// cost     O(n log n) at protein density
std::vector<std::array<std::uint32_t, 2>> touching_groups(const Atoms& atoms, std::span<const std::uint32_t> group,
                                                          std::size_t groups, double probe);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The words by which users choose what is read, drawn and written; words.h has the words for the surface itself.
#pragma once

#include "meniscus/colours.h"
#include "meniscus/field.h"
#include "meniscus/structure.h"
#include "meniscus/tables.h"
#include "meniscus/volume.h"
#include "meniscus/words.h"

namespace meniscus {

inline constexpr Words<HydrogenPolicy, 3> kHydrogenWords{
    {{"auto", HydrogenPolicy::Auto}, {"keep", HydrogenPolicy::Keep}, {"drop", HydrogenPolicy::Drop}}};
inline constexpr Words<HeteroPolicy, 3> kHeteroWords{
    {{"none", HeteroPolicy::None}, {"ligands", HeteroPolicy::Ligands}, {"all", HeteroPolicy::All}}};

inline constexpr Words<VolumeContent, 4> kFieldWords{{{"distance", VolumeContent::Distance},
                                                      {"mask", VolumeContent::Mask},
                                                      {"dielectric", VolumeContent::Dielectric},
                                                      {"ions", VolumeContent::Ions}}};

inline constexpr Words<ApbsMap, 4> kApbsMapWords{{{"dielx", ApbsMap::DielectricX},
                                                  {"diely", ApbsMap::DielectricY},
                                                  {"dielz", ApbsMap::DielectricZ},
                                                  {"kappa", ApbsMap::Kappa}}};

inline constexpr Words<RowsPer, 4> kRowsPerWords{
    {{"residue", RowsPer::Residue}, {"atom", RowsPer::Atom}, {"chain", RowsPer::Chain}, {"cavity", RowsPer::Cavity}}};
inline constexpr Words<AtomValue, 4> kAtomValueWords{
    {{"sas", AtomValue::Sas}, {"ses", AtomValue::Ses}, {"rsa", AtomValue::Rsa}, {"depth", AtomValue::Depth}}};
inline constexpr Words<Interpolation, 2> kInterpolationWords{
    {{"linear", Interpolation::Linear}, {"cubic", Interpolation::Cubic}}};
/// ColourScheme::Value has no word: users give the name of the values.
inline constexpr Words<ColourScheme, 14> kColourSchemeWords{{{"auto", ColourScheme::Automatic},
                                                             {"single", ColourScheme::Single},
                                                             {"patch", ColourScheme::Patch},
                                                             {"element", ColourScheme::Element},
                                                             {"chain", ColourScheme::Chain},
                                                             {"residue", ColourScheme::Residue},
                                                             {"residue-patch", ColourScheme::ResiduePatch},
                                                             {"hydrophobicity", ColourScheme::Hydrophobicity},
                                                             {"curvature", ColourScheme::Curvature},
                                                             {"component", ColourScheme::Component},
                                                             {"depth", ColourScheme::Depth},
                                                             {"bfactor", ColourScheme::BFactor},
                                                             {"pocket", ColourScheme::Pocket},
                                                             {"plddt", ColourScheme::Plddt}}};

}  // namespace meniscus

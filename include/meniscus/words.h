// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The words by which people choose: the same on the command line, in reports and in Python.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "meniscus/colours.h"
#include "meniscus/errors.h"
#include "meniscus/field.h"
#include "meniscus/flow.h"
#include "meniscus/remesh.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "meniscus/tables.h"
#include "meniscus/volume.h"

namespace meniscus {

/// Words and what they stand for, the default first.
template <class T, std::size_t N>
using Words = std::array<std::pair<const char*, T>, N>;

/// The word for one of the values that have one.
template <class T, std::size_t N>
const char* word_for(const Words<T, N>& words, T value) {
    return std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.second == value; })->first;
}

/// Whether a text is one of the words.
template <class T, std::size_t N>
bool is_word_of(const Words<T, N>& words, const std::string& text) {
    return std::any_of(words.begin(), words.end(), [&](const auto& w) { return text == w.first; });
}

/// All words in their order.
template <class T, std::size_t N>
std::string join(const Words<T, N>& words, const char* separator) {
    std::string list;
    for (const auto& word : words) list.append(list.empty() ? "" : separator).append(word.first);
    return list;
}

/// What a word stands for.
///
/// option   named in the message
/// throws   UsageError for a text that is none of the words
template <class T, std::size_t N>
T parse_word(const std::string& option, const std::string& text, const Words<T, N>& words) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& w) { return text == w.first; });
    if (found == words.end())
        throw UsageError(option + ": unknown value '" + text + "'; choose one of " + join(words, ", "));
    return found->second;
}

inline constexpr Words<HydrogenPolicy, 3> kHydrogenWords{
    {{"auto", HydrogenPolicy::Auto}, {"keep", HydrogenPolicy::Keep}, {"drop", HydrogenPolicy::Drop}}};
inline constexpr Words<HeteroPolicy, 3> kHeteroWords{
    {{"none", HeteroPolicy::None}, {"ligands", HeteroPolicy::Ligands}, {"all", HeteroPolicy::All}}};

inline constexpr Words<Method, 3> kMethodWords{
    {{"flow", Method::Flow}, {"direct", Method::Direct}, {"gaussian", Method::Gaussian}}};
inline constexpr Words<SurfaceKind, 3> kSurfaceWords{
    {{"ses", SurfaceKind::Ses}, {"sas", SurfaceKind::Sas}, {"vdw", SurfaceKind::Vdw}}};
inline constexpr Words<Pieces, 3> kPiecesWords{
    {{"all", Pieces::All}, {"outer", Pieces::Outer}, {"cavities", Pieces::Cavities}}};
inline constexpr Words<Corners, 3> kCornersWords{
    {{"near", Corners::Near}, {"on-surface", Corners::OnSurface}, {"balanced", Corners::Balanced}}};
inline constexpr Words<CurvatureField, 4> kCurvatureWords{{{"parallel", CurvatureField::Parallel},
                                                           {"sharp", CurvatureField::Sharp},
                                                           {"paper", CurvatureField::Paper},
                                                           {"paper-literal", CurvatureField::PaperLiteral}}};
inline constexpr Words<Reinitialiser, 5> kReinitialiserWords{{{"none", Reinitialiser::None},
                                                              {"closest-point", Reinitialiser::ClosestPoint},
                                                              {"paper", Reinitialiser::Paper},
                                                              {"paper-literal", Reinitialiser::PaperLiteral},
                                                              {"godunov", Reinitialiser::Godunov}}};
inline constexpr Words<Solver, 3> kSolverWords{
    {{"richardson", Solver::Richardson}, {"cg", Solver::Cg}, {"gmres", Solver::Gmres}}};
inline constexpr Words<Slope, 2> kSlopeWords{{{"unit", Slope::Unit}, {"computed", Slope::Computed}}};
inline constexpr Words<FlowEnd, 5> kFlowEndWords{{{"converged", FlowEnd::Converged},
                                                  {"steps-used-up", FlowEnd::StepsUsedUp},
                                                  {"stalled", FlowEnd::Stalled},
                                                  {"vanished", FlowEnd::Vanished},
                                                  {"left-band", FlowEnd::LeftBand}}};

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
/// All but ColourScheme::Value, for which the name of the values stands.
inline constexpr Words<ColourScheme, 13> kColourSchemeWords{{{"auto", ColourScheme::Automatic},
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
                                                             {"plddt", ColourScheme::Plddt}}};

}  // namespace meniscus

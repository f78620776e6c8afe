// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The words by which users choose: the same on the command line, in reports and in Python.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "meniscus/errors.h"
#include "meniscus/flow.h"
#include "meniscus/remesh.h"
#include "meniscus/surface.h"

namespace meniscus {

/// A list of words and the values they stand for, the default first.
template <class T, std::size_t N>
using Words = std::array<std::pair<const char*, T>, N>;

/// The word for a value, which must be in the list.
template <class T, std::size_t N>
const char* word_for(const Words<T, N>& words, T value) {
    return std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.second == value; })->first;
}

/// Whether a text is one of the words of a list.
template <class T, std::size_t N>
bool is_word_of(const Words<T, N>& words, const std::string& text) {
    return std::any_of(words.begin(), words.end(), [&](const auto& w) { return text == w.first; });
}

/// All words of a list in their order, with a separator between them.
template <class T, std::size_t N>
std::string join(const Words<T, N>& words, const char* separator) {
    std::string list;
    for (const auto& word : words) list.append(list.empty() ? "" : separator).append(word.first);
    return list;
}

/// The value that a word stands for.
///
/// option   what the error message calls the option
/// throws   UsageError for a text that is none of the words
template <class T, std::size_t N>
T parse_word(const std::string& option, const std::string& text, const Words<T, N>& words) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& w) { return text == w.first; });
    if (found == words.end())
        throw UsageError(option + ": unknown value '" + text + "'; choose one of " + join(words, ", "));
    return found->second;
}

inline constexpr Words<Method, 3> kMethodWords{
    {{"flow", Method::Flow}, {"direct", Method::Direct}, {"gaussian", Method::Gaussian}}};
inline constexpr Words<SurfaceKind, 3> kSurfaceWords{
    {{"ses", SurfaceKind::Ses}, {"sas", SurfaceKind::Sas}, {"vdw", SurfaceKind::Vdw}}};
inline constexpr Words<Pieces, 3> kPiecesWords{
    {{"all", Pieces::All}, {"outer", Pieces::Outer}, {"cavities", Pieces::Cavities}}};
inline constexpr Words<Corners, 3> kCornersWords{
    {{"near", Corners::Near}, {"on-surface", Corners::OnSurface}, {"balanced", Corners::Balanced}}};
inline constexpr Words<FlowName, 3> kFlowWords{
    {{"anchored", FlowName::Anchored}, {"parallel", FlowName::Parallel}, {"paper", FlowName::Paper}}};
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

}  // namespace meniscus

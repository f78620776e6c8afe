// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// All models of a file as one, and which chains models have.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "structure/raw_model.h"

namespace meniscus::reading {

/// Puts models together in their order. A chain that occurs in several of them is a chain of its own in each: A, A-2,
/// A-3 ..., leaving out names that the file itself gives to a chain. Notes, warnings and assemblies are those of the
/// first model. Models that lie on each other, as in an NMR ensemble, are a warning.
///
/// throws   LimitError if there would be more atoms than an index can count
RawModel join_models(std::vector<RawModel> models, const std::string& file);

/// True if most of the points are near those of the same index, as in the models of an ensemble; copies of a biological
/// unit and the partners of a complex are side by side. False if there are more of one than of the other.
bool lie_on_each_other(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// The same of the atoms that both have by their number: where one is missing its neighbours are near enough.
bool lie_on_each_other(const RawModel& a, const RawModel& b);

/// Chains of a file with several models that are partners of the first model and not copies of it, such as the ligand
/// that a docking program writes behind the receptor's END.
struct Partners {
    std::set<std::string> taken;      ///< chains of the first model
    std::set<std::string> others;     ///< chains that only other models have
    std::set<std::string> namesakes;  ///< chains with names of the first model's, but of other residues or elsewhere
    std::size_t end_record = 0;       ///< number of the line with END that ends the first model, 0 if there is none

    bool exist() const { return !others.empty() || !namesakes.empty(); }
};

/// Names of the chains of every model -> those taken with the first and those that only others have.
Partners find_partners(const std::vector<std::set<std::string>>& chains);

/// "chain A taken, before END in line 69; chain B follows it".
/// Precondition: there are partners.
std::string describe(const Partners& partners);

}  // namespace meniscus::reading

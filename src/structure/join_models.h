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
/// A-3 ..., leaving out names that the file itself gives to a chain. Notes, warnings and assemblies are the first
/// one's.
///
/// throws   LimitError if there would be more atoms than an index can count
RawModel join_models(std::vector<RawModel> models, const std::string& file);

/// Names of chains in the models of a file.
using ChainsOfModels = std::vector<std::set<std::string>>;

/// The chains of other models that the first model lacks: partners, such as the ligand that a docking program writes
/// behind END, and not copies.
std::set<std::string> partners_of_first(const ChainsOfModels& chains);

/// "chain A taken, before END in line 69; chain B follows it".
///
/// end_record   number of the line with END that ends the first model, 0 if there is none
/// Precondition: there are partners.
std::string tell_partners(const ChainsOfModels& chains, std::size_t end_record);

}  // namespace meniscus::reading

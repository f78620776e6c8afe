// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where `meniscus pockets --at` asks for pockets.
#pragma once

#include <string>
#include <vector>

#include "meniscus/pocket_places.h"
#include "pockets_request.h"

namespace meniscus::cli {

struct PlacesOfRun {
    std::vector<NamedPlace> places;
    std::vector<std::string> warnings;  ///< of reading ligands
};

/// The places of all --at, in order.
///
/// model    as Job::model
/// throws   UsageError for a selection of nothing, and for one of a structure from standard input; as read_structure()
PlacesOfRun read_places(const PocketsRequest& request, const Structure& molecule, int model);

}  // namespace meniscus::cli

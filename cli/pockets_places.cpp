// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets_places.h"

#include <algorithm>
#include <optional>

#include "option_words.h"

namespace meniscus::cli {

namespace {

constexpr double kReachOfAtom = 4.0;   // Å: where a ligand's atoms lie that touch the wall
constexpr double kReachOfPoint = 8.0;  // Å: as far as a site's own points

// With the hetero atoms that pockets leave out, of all chains.
Structure read_whole(const PocketsRequest& request, int model) {
    if (request.input == "-")
        throw UsageError(
            "--at: a selection needs a file, because the structure is read twice; write X,Y,Z, or a file's "
            "name instead of -");
    ReadOptions options = options_of_model(request, model);
    options.hetero = HeteroPolicy::All;
    options.chains.clear();
    options.select.clear();
    options.strict_radii = false;
    return read_structure(request.input, options);
}

}  // namespace

PlacesOfRun read_places(const PocketsRequest& request, const Structure& molecule, int model) {
    PlacesOfRun run;
    std::optional<Structure> whole;
    for (const std::string& text : request.at) {
        if (const std::optional<Vec3> point = point_in("--at", text)) {
            run.places.push_back({text, {{*point}, request.at_reach.value_or(kReachOfPoint)}, {}});
            continue;
        }
        if (!whole) whole = read_whole(request, model);
        const double reach = request.at_reach.value_or(kReachOfAtom);
        for (NamedPlace& place : places_of_selection(molecule, *whole, text, reach, "--at"))
            run.places.push_back(std::move(place));
    }
    if (whole)
        for (const std::string& line : whole->warnings)
            if (std::find(molecule.warnings.begin(), molecule.warnings.end(), line) == molecule.warnings.end())
                run.warnings.push_back(line);
    return run;
}

}  // namespace meniscus::cli

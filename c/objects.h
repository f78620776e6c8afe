// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What is behind the handles of the C interface, and how exceptions become statuses.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meniscus/colour.h"
#include "meniscus/exact_surface.h"
#include "meniscus/meniscus.h"
#include "meniscus/option.h"
#include "meniscus/pockets.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"

namespace meniscus::c {

/// How messages name an option and its value: "hetero = ligands".
std::string spell(std::string_view option, std::string_view value);

/// Every option that meniscus_options_set() knows.
struct Options {
    SurfaceOptions surface{};
    RunOptions run{};
    PocketOptions pockets{};
    ReadOptions read{.spelling = spell};
    std::string between{};        ///< interfaces that reports have: "A,B:C" or "all"; empty: none
    std::vector<Option> given{};  ///< options of the surface that do not have their default values
};

/// Notes an error for meniscus_last_error().
meniscus_status failed(meniscus_status status, const char* message);

/// The status for the exception that is being handled.
meniscus_status status_of_exception();

/// Runs what may throw.
template <class Work>
meniscus_status guarded(const Work& work) {
    try {
        work();
        return MENISCUS_OK;
    } catch (...) {
        return status_of_exception();
    }
}

/// throws   UsageError if an argument that is needed is NULL
void need(const void* argument, const char* name);

/// throws   LimitError for a number of items that no memory can hold
void need_room(std::size_t items, const char* name);

/// Areas and volumes of the SES, whichever surface of the atoms this is.
const Measures& ses_measures(const ExactSurface& exact);

/// Thrown where the caller's progress function asks to stop.
struct Stopped {};

/// Writes a mesh with all that is known of it; colours: one per vertex, or none.
void write_to(const std::string& path, const meniscus_surface& surface, std::span<const Colour> colours);

std::string report_of(const Structure& structure);
std::string report_of(const Structure& structure, const ExactSurface& exact, const Options& options);
std::string report_of(const Structure& structure, const Surface& surface);
std::string report_of(const Structure& structure, const ExactSurface& exact, const Pockets& pockets);

}  // namespace meniscus::c

struct meniscus_options : meniscus::c::Options {};

struct meniscus_structure {
    std::shared_ptr<const meniscus::Structure> structure;
    std::string report{};
};

struct meniscus_exact {
    std::shared_ptr<const meniscus::Structure> structure;
    meniscus::ExactSurface exact;
    int threads = 0;
    std::string report{};
};

struct meniscus_surface {
    std::shared_ptr<const meniscus::Structure> structure;
    meniscus::Surface surface;
    std::string report{};
};

namespace meniscus::c {

/// The options behind a handle; the defaults for NULL.
inline const Options& options_of(const meniscus_options* given) {
    static const Options defaults;
    return given != nullptr ? *given : defaults;
}

}  // namespace meniscus::c

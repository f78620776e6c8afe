// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The report: everything a program may want to know about a run, as JSON (docs/report.schema.json).
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "measure_request.h"
#include "meniscus/describe_pockets.h"
#include "meniscus/measures.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "meniscus/tables.h"
#include "pockets_request.h"
#include "surface_request.h"
#include "value_options.h"

namespace meniscus::cli {

/// The part of a surface that is written.
struct ShownPart {
    std::string select;
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    double area = 0.0;  ///< Å², plain sum
    bool open = false;
};

/// Wall-clock seconds beside those that the library counts itself.
struct RunSeconds {
    double read = 0.0;     ///< with the start of the program; with all models: counted with the first
    double exact = 0.0;    ///< exact measures beside those that the surface counts
    double tunnels = 0.0;  ///< tunnels and the pore
    double picture = 0.0;  ///< colours and pictures, without writing them
    double page = 0.0;     ///< pages, without writing them
    double volume = 0.0;   ///< volumes, without writing them
    double write = 0.0;    ///< the files of -o, and making the report
    double total = 0.0;
};

/// What the program itself knows about a run, beside the library's results.
struct RunFacts {
    int model = 1;                ///< position in the file, from 1, or kJoinedModels
    int threads = 1;              ///< in use
    double peak_memory_mb = 0.0;  ///< of the process so far, in units of 2^20 bytes
    RunSeconds seconds{};
    std::string chain{};                                      ///< the only one, with --per-chain
    std::optional<ShownPart> shown{};                         ///< with --show
    std::vector<Check> checks{};                              ///< all that the result was held against
    std::vector<ArrayNumbers> values{};                       ///< at the vertices
    std::shared_ptr<const Measures> excluded{};               ///< of the SES, where the surface is another
    std::map<std::string, std::size_t> drawn{};               ///< ligands beside or within the surface, by name
    std::optional<std::vector<ChainInterface>> interfaces{};  ///< with --between
};

/// The report of one surface. Numbers that are not finite become null, and so do blocks and deviations that need exact
/// measures where the surface has none.
nlohmann::ordered_json make_report(const SurfaceRequest& request, const Structure& structure, const Surface& surface,
                                   const RunFacts& facts);

/// The report of exact measures alone.
nlohmann::ordered_json make_report(const MeasureRequest& request, const Structure& structure, const Measures& exact,
                                   const RunFacts& facts);

/// What `pockets` finds.
struct FoundPockets {
    const Pockets& pockets;
    const std::vector<DescribedPocket>& described;
    const FoundTunnels& ways;
};

/// The report of pockets, and its JSON schema.
nlohmann::ordered_json make_report(const PocketsRequest& request, const Structure& structure, const FoundPockets& found,
                                   const RunFacts& facts);
nlohmann::ordered_json pockets_schema();

/// The JSON schema of both, without `$defs/options`.
nlohmann::ordered_json report_schema();

/// Writes a report, whole or not at all; "-" is standard output.
/// throws   OutputError
void write_report(const std::string& path, const nlohmann::ordered_json& report);

/// Writes to standard output, at once.
/// throws   OutputError
void print(const std::string& text);

/// Threads in use when `asked` (0: all cores) are asked for.
int threads_in_use(int asked);

/// Largest resident size of this process so far, MB (2^20 bytes).
double peak_memory_mb();

}  // namespace meniscus::cli

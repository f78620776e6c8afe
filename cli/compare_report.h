// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What `meniscus compare` prints: the summary, and the report (docs/compare.schema.json).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare_request.h"
#include "meniscus/compare.h"
#include "meniscus/structure.h"

namespace meniscus::cli {

/// One of the two surfaces and where it comes from.
struct ComparedInput {
    std::string file;
    std::optional<Structure> structure;  ///< none for a mesh
    ComparedSurface surface;
};

struct CompareFacts {
    ComparedInput a;
    ComparedInput b;
    Comparison comparison;
    ValueRange range{};  ///< of the colours
    int threads = 1;     ///< in use
    double read_seconds = 0.0;
    double compare_seconds = 0.0;
    double write_seconds = 0.0;
    double peak_memory_mb = 0.0;

    double total_seconds() const { return read_seconds + compare_seconds + write_seconds; }
};

/// What may make the numbers wrong: what was assumed about a structure, a mesh that is open or inside out.
std::vector<std::string> warnings_of(const ComparedInput& input);

/// What happens with ordinary structures: see Structure::notes.
std::vector<std::string> notes_of(const ComparedInput& input);

std::string make_summary(const CompareRequest& request, const CompareFacts& facts);

/// Numbers that are not finite become null.
nlohmann::ordered_json make_report(const CompareRequest& request, const CompareFacts& facts);

/// The JSON schema of that.
nlohmann::ordered_json compare_schema();

}  // namespace meniscus::cli

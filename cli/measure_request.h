// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What `meniscus measure` is asked to do, and the options that ask it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common_request.h"
#include "meniscus/measures.h"
#include "meniscus/tables.h"

namespace meniscus::cli {

/// Without -o nothing is written beside the report.
struct MeasureRequest : CommonRequest {
    MeasureOptions measure;
    std::vector<RowsPer> per;          ///< --per, in order: of the first table, the second ...
    std::vector<AtomValue> values;     ///< --value, in order: of the first structure copy, the second ...
    std::vector<std::string> between;  ///< --between, as given
};

/// Gives a subcommand its options; parsing fills `request`, which must outlive the parser.
/// throws   as add_surface_options
void add_measure_options(CLI::App& command, MeasureRequest& request);

/// The word behind `--per` and `--value`.

/// Which of `asked` the file number `place` of its kind takes: its own, the last one given, or `otherwise`.
template <class T>
T choice_at(const std::vector<T>& asked, std::size_t place, T otherwise) {
    if (asked.empty()) return otherwise;
    return place < asked.size() ? asked[place] : asked.back();
}

/// Refuses combinations of options that make no sense: more --per than tables, a table per cavity with --between ...
/// throws   UsageError
void check_request(const MeasureRequest& request);

/// "A,C:B" for "chain A+C:chain B", as PyMOL calls chains; empty for what is taken as it stands.
std::string restate_between(const std::string& text);

/// The pair of groups of chains that "A,C:B" names, or the same in the words above; nothing for "all".
/// throws   UsageError for a text of another form
std::optional<ChainPair> parse_between(const std::string& given);

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The options that bring values of maps and tables to the surface.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "meniscus/colours.h"
#include "meniscus/exact_surface.h"
#include "meniscus/vertex_values.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace meniscus::cli {

/// --sample NAME=FILE
struct SampledMap {
    std::string name;
    std::string path;
};

struct ValueRequest {
    std::vector<SampledMap> maps;
    SampleVolumeOptions sampling;
    std::string sampled_by{};         ///< an option that was given and that only maps heed; empty if there is none
    std::vector<std::string> tables;  ///< paths
    bool depth = false;               ///< --arrays depth
};

/// An array of values at vertices; numbers are nan where no vertex has a value.
struct ArrayNumbers {
    std::string name;
    std::string file;  ///< where the values come from
    double min = 0.0;
    double max = 0.0;
    double mean = 0.0;  ///< weighted by area
    std::size_t missing = 0;
};

/// --sample, --offset, --interpolation, --values, --arrays. `request` must outlive the parser. While parsing,
/// UsageError is thrown for values that make no sense.
void add_value_options(CLI::App& command, ValueRequest& request);

/// What depends on several of these options and on --color.
/// throws   UsageError for options that do not go together
void check_values(const ValueRequest& request, const ColourOptions& colours);

/// The options as the report has them.
nlohmann::ordered_json report_values(const ValueRequest& request);

/// The files of a request, read: what is wrong with them is known before anything is computed.
class ValueSources {
public:
    ValueSources() = default;
    /// Also the B factors and depths, where they are what the surface shows.
    /// structure   must outlive the sources
    /// one_chain   of several: rows of tables may be about the others
    /// Depths of the surface go before a column of that name in a table that has others, as tables of `measure` have.
    /// throws      InputError; UsageError for two arrays of one name, and for a name that --color gives but no file has
    ValueSources(const ValueRequest& request, const ColourOptions& colours, const Structure& structure, bool one_chain);

    /// What may be worth knowing of the files, one line each.
    const std::vector<std::string>& warnings() const { return warnings_; }
    const std::vector<std::string>& notes() const { return notes_; }

    /// exact   of the structure's atoms, for depths
    std::vector<VertexValues> at_vertices(const Mesh& mesh, const ExactSurface& exact) const;

    /// What of these a user should know, one line each.
    /// throws   InputError for a map that no vertex lies in
    std::vector<std::string> judge(const std::vector<VertexValues>& values) const;

    /// What the arrays of values at the vertices of a mesh look like.
    std::vector<ArrayNumbers> numbers(const Mesh& mesh) const;

private:
    struct Map {
        SampledMap asked;
        Volume volume;
    };
    struct Column {
        AtomValues values;
        std::string path;
    };

    void add_table(const std::string& path, const Structure& structure, bool one_chain);
    void leave_to_depth(ValueTable& table, const std::string& path);
    void check_names(const ColourOptions& colours) const;
    void check_duplicates() const;
    void check_colour(const ColourOptions& colours) const;
    std::vector<std::string> names() const;
    const std::string& path_of(const std::string& name) const;

    SampleVolumeOptions sampling_;
    std::vector<Map> maps_;
    std::vector<Column> columns_;
    std::vector<std::string> warnings_;
    std::vector<std::string> notes_;
    const Structure* depth_of_ = nullptr;  // where depths are asked for
    std::string file_;                     // of the structure
};

}  // namespace meniscus::cli

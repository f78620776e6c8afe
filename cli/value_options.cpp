// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "value_options.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "help.h"
#include "meniscus/file_name.h"
#include "meniscus/file_words.h"
#include "meniscus/volume_file.h"
#include "option_words.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

SampledMap parse_sample(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size())
        throw UsageError(fmt::format("--sample: '{}' is not NAME=FILE, such as phi=pot.dx", text));
    SampledMap map{text.substr(0, equals), text.substr(equals + 1)};
    if (!is_value_name(map.name))
        throw UsageError(
            fmt::format("--sample: '{}' cannot be the name of values; write letters, digits and '_', not "
                        "the name of another vertex array",
                        map.name));
    if (is_word_of(kColourSchemeWords, map.name))
        throw UsageError(fmt::format("--sample: '{}' is a scheme of --color; choose another name", map.name));
    return map;
}

bool wants_depth(const std::string& text) {
    if (text != "depth") throw UsageError(fmt::format("--arrays: unknown value '{}'; choose one of depth", text));
    return true;
}

std::size_t count_missing(const VertexValues& values) {
    return static_cast<std::size_t>(
        std::count_if(values.values.begin(), values.values.end(), [](float v) { return std::isnan(v); }));
}

ArrayNumbers numbers_of(const VertexValues& values, const std::string& file, const Mesh& mesh) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    ArrayNumbers numbers{values.name, file, kNone, kNone, 0.0, count_missing(values)};
    double sum = 0.0;
    double area = 0.0;
    for (std::size_t v = 0; v < values.values.size(); ++v) {
        const double value = values.values[v];
        if (std::isnan(value)) continue;
        numbers.min = std::fmin(numbers.min, value);
        numbers.max = std::fmax(numbers.max, value);
        sum += double{mesh.areas[v]} * value;
        area += double{mesh.areas[v]};
    }
    numbers.mean = sum / area;
    return numbers;
}

}  // namespace

void add_value_options(CLI::App& command, ValueRequest& request) {
    const auto sample = [&request](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) request.maps.push_back(parse_sample(text));
    };
    command
        .add_option_function<std::vector<std::string>>(
            "--sample", sample, "Values of a map (.dx .mrc), as phi=pot.dx\n; repeatable: one vertex array each")
        ->type_name("NAME=FILE")
        ->allow_extra_args(false);
    add_word(
        command,
        {"--offset", rarely("Sample maps D Å away from the surface, along its normal; negative: inside"), "D", "0"},
        [&request](const std::string& text) {
            request.sampling.offset = parse_number("--offset", text, NumberRange::Any);
            request.sampled_by = "--offset";
        });
    add_word(command,
             {"--interpolation", rarely("Interpolation between the nodes of maps: trilinear or tricubic"),
              join(kInterpolationWords, "|"), kInterpolationWords.front().first},
             [&request](const std::string& text) {
                 request.sampling.interpolation = parse_word("--interpolation", text, kInterpolationWords);
                 request.sampled_by = "--interpolation";
             });
    command
        .add_option("--values", request.tables,
                    "Values by atom, residue or chain\n"
                    ", comma-separated with a header line; every column that does not identify atoms, residues or "
                    "chains becomes a vertex array; repeatable")
        ->type_name("FILE.csv")
        ->allow_extra_args(false);
    add_word(command,
             {"--arrays", rarely("Further vertex arrays: depth, how deep in pockets and cavities the surface lies, Å"),
              "depth"},
             [&request](const std::string& text) { request.depth = wants_depth(text); });
}

void check_values(const ValueRequest& request, const ColourOptions& colours) {
    if (!request.sampled_by.empty() && request.maps.empty())
        throw UsageError(request.sampled_by + " applies to maps; name one with --sample NAME=FILE");
    const auto is_named = [&](const SampledMap& map) { return map.name == colours.value; };
    if (colours.scheme != ColourScheme::Value || !request.tables.empty()) return;
    if (std::none_of(request.maps.begin(), request.maps.end(), is_named))
        throw UsageError(
            fmt::format("--color: unknown value '{}'; choose one of {}, the name of values from --sample or "
                        "--values, or a colour such as tomato or '#ff6347'",
                        colours.value, join(kColourSchemeWords, ", ")));
}

ordered_json report_values(const ValueRequest& request) {
    ordered_json options;
    ordered_json maps = ordered_json::object();
    for (const SampledMap& map : request.maps) maps[map.name] = file_name(map.path);
    const bool sampled = !request.maps.empty();
    options["sample"] = std::move(maps);
    options["offset"] = sampled ? ordered_json(request.sampling.offset) : ordered_json();
    options["interpolation"] =
        sampled ? ordered_json(word_for(kInterpolationWords, request.sampling.interpolation)) : ordered_json();
    ordered_json tables = ordered_json::array();
    for (const std::string& path : request.tables) tables.push_back(file_name(path));
    options["values"] = std::move(tables);
    options["arrays"] = request.depth ? ordered_json::array({"depth"}) : ordered_json::array();
    return options;
}

ValueSources::ValueSources(const ValueRequest& request, const ColourOptions& colours, const Structure& structure,
                           bool one_chain)
    : sampling_(request.sampling), file_(structure.file) {
    if (request.depth || colours.scheme == ColourScheme::Depth) depth_of_ = &structure;
    for (const std::string& path : request.tables) add_table(path, structure, one_chain);
    for (const SampledMap& map : request.maps) maps_.push_back({map, read_volume(map.path)});
    check_names(colours);
    if (auto more = values_of_scheme(colours.scheme, structure)) columns_.push_back({std::move(*more), structure.file});
}

void ValueSources::add_table(const std::string& path, const Structure& structure, bool one_chain) {
    ValueTable table = read_value_table(path, structure);
    if (!one_chain) refuse_strange_table(table, path, structure);
    if (table.strange_rows > 0 && !one_chain)
        warnings_.push_back(fmt::format("{}: {} of {} rows match nothing that is kept of {}", path, table.strange_rows,
                                        table.rows, structure.file));
    if (!table.texts.empty())
        notes_.push_back(fmt::format("{}: left alone, since no cell is a number: {} {}", path,
                                     table.texts.size() == 1 ? "column" : "columns", fmt::join(table.texts, ", ")));
    if (depth_of_ != nullptr && table.columns.size() > 1) leave_to_depth(table, path);
    for (AtomValues& column : table.columns) columns_.push_back({std::move(column), path});
}

void ValueSources::leave_to_depth(ValueTable& table, const std::string& path) {
    const auto is_depth = [](const AtomValues& column) { return CLI::detail::to_lower(column.name) == "depth"; };
    if (std::erase_if(table.columns, is_depth) > 0)
        notes_.push_back(path +
                         ": column 'depth' left alone, since the depths of the surface are asked for; rename the "
                         "column to have it, too");
}

std::vector<std::string> ValueSources::names() const {
    std::vector<std::string> all;
    for (const Column& column : columns_) all.push_back(column.values.name);
    for (const Map& map : maps_) all.push_back(map.asked.name);
    return all;
}

/// No two arrays may have one name.
void ValueSources::check_duplicates() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const Column& column : columns_) all.emplace_back(column.values.name, column.path);
    for (const Map& map : maps_) all.emplace_back(map.asked.name, map.asked.path);
    std::map<std::string, std::string> paths;
    for (const auto& [name, path] : all)
        if (const auto [other, is_new] = paths.emplace(CLI::detail::to_lower(name), path); !is_new)
            throw UsageError(fmt::format(
                "two arrays of values have the name '{}', one of {} and one of {}; rename one of them, that "
                "of a table in its first line",
                name, other->second, path));
}

void ValueSources::check_names(const ColourOptions& colours) const {
    check_duplicates();
    std::set<std::string> seen;
    for (const std::string& name : names()) seen.insert(CLI::detail::to_lower(name));
    if (depth_of_ != nullptr && colours.scheme != ColourScheme::Depth && seen.contains("depth"))
        throw UsageError(
            fmt::format("--arrays: 'depth' is also the name of values of {}; rename the values", path_of("depth")));
    if (colours.scheme == ColourScheme::Value) {
        if (!seen.contains(CLI::detail::to_lower(colours.value)))
            throw UsageError(fmt::format("--color: there are no values '{}'; choose one of {}", colours.value,
                                         fmt::join(names(), ", ")));
    } else if (const std::string word = word_for(kColourSchemeWords, colours.scheme); seen.contains(word)) {
        throw UsageError(fmt::format("--color: '{}' is a scheme and also the name of values of {}; rename the values",
                                     word, path_of(word)));
    }
    check_colour(colours);
}

/// Values named as the colour that is asked for may be meant as well.
void ValueSources::check_colour(const ColourOptions& colours) const {
    if (!colours.colour) return;
    for (const std::string& name : names())
        if (colour_of_text(name) == colours.colour)
            throw UsageError(fmt::format(
                "--color: '{}' is a colour and also the name of values of {}; rename the values", name, path_of(name)));
}

const std::string& ValueSources::path_of(const std::string& name) const {
    const std::string word = CLI::detail::to_lower(name);
    for (const Map& map : maps_)
        if (CLI::detail::to_lower(map.asked.name) == word) return map.asked.path;
    for (const Column& column : columns_)
        if (CLI::detail::to_lower(column.values.name) == word) return column.path;
    return file_;  // what follows from the structure
}

std::vector<VertexValues> ValueSources::at_vertices(const Mesh& mesh, const ExactSurface& exact) const {
    std::vector<VertexValues> all;
    for (const Column& column : columns_) all.push_back(values_at_vertices(mesh, column.values));
    for (const Map& map : maps_) all.push_back(sample_volume(mesh, map.asked.name, map.volume, sampling_));
    if (depth_of_ != nullptr) all.push_back(depth_values(mesh, exact));
    return all;
}

std::vector<std::string> ValueSources::judge(const std::vector<VertexValues>& values) const {
    std::vector<std::string> lines;
    std::map<std::pair<std::string, std::size_t>, std::vector<std::string>> of_tables;  // by path and vertices without
    for (const VertexValues& array : values) {
        const std::size_t missing = count_missing(array);
        if (missing == 0) continue;
        const std::string& path = path_of(array.name);
        const bool of_map =
            std::any_of(maps_.begin(), maps_.end(), [&](const Map& m) { return m.asked.name == array.name; });
        if (of_map && missing == array.values.size())
            throw InputError(path +
                             ": the whole surface lies outside this map; do both have the same coordinate frame?");
        if (of_map)
            lines.push_back(fmt::format("{}: {} of {} vertices have no value '{}': they lie outside the map", path,
                                        missing, array.values.size(), array.name));
        else
            of_tables[{path, missing}].push_back(array.name);
    }
    // The columns of a table lack the same rows.
    for (const auto& [table, names] : of_tables)
        lines.push_back(fmt::format("{}: {} of {} vertices have no value '{}'{}", table.first, table.second,
                                    values.front().values.size(), names.front(),
                                    names.size() > 1 ? fmt::format(", nor of {} more", names.size() - 1) : ""));
    return lines;
}

std::vector<ArrayNumbers> ValueSources::numbers(const Mesh& mesh) const {
    std::vector<ArrayNumbers> all;
    for (const VertexValues& array : mesh.values)
        all.push_back(numbers_of(array, file_name(path_of(array.name)), mesh));
    return all;
}

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "volume_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "help.h"
#include "meniscus/errors.h"
#include "meniscus/file_name.h"
#include "meniscus/file_words.h"
#include "meniscus/volume_file.h"
#include "option_words.h"
#include "platform/files/atomic_file.h"

namespace meniscus::cli {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

constexpr const char* kGridWords = "a .dx, .mrc, .map or .ccp4 file, or NX,NY,NZ,H,CX,CY,CZ";

/// Counts, spacing and centre: what APBS calls dime, grid and gcent.
VolumeGrid parse_numbers(const std::vector<std::string>& parts) {
    std::array<std::size_t, 3> counts{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        counts[axis] = static_cast<std::size_t>(parse_count("--grid", parts[axis]));
    const auto number = [&](std::size_t i) { return parse_number("--grid", parts[i], NumberRange::Any); };
    return centred_grid(counts, parse_number("--grid", parts[3], NumberRange::Positive),
                        {number(4), number(5), number(6)});
}

/// "_dielx.dx"
std::string map_suffix(const char* word) { return fmt::format("_{}.dx", word); }

void set_grid(VolumeRequest& request, const std::string& text) {
    request.grid_text = text;
    request.grid.reset();
    request.grid_file.clear();
    const std::vector<std::string> parts = CLI::detail::split(text, ',');
    const bool is_numbers = text.find_first_not_of("0123456789.+-eE,") == std::string::npos;
    if (is_numbers ? parts.size() != 7 : !fs::path(text).has_extension())
        throw UsageError(fmt::format("--grid: '{}' is not a grid; give {}", text, kGridWords));
    if (is_numbers)
        request.grid = parse_numbers(parts);
    else
        request.grid_file = text;
}

void set_dielectrics(FieldOptions& field, const std::string& text) {
    const std::vector<std::string> parts = CLI::detail::split(text, ',');
    if (parts.size() != 2) throw UsageError(fmt::format("--eps: '{}' must be IN,OUT, as in 2,78.54", text));
    field.inner_dielectric = parse_number("--eps", parts[0], NumberRange::Positive);
    field.outer_dielectric = parse_number("--eps", parts[1], NumberRange::Positive);
}

/// An option that only volumes heed.
template <class Set>
void add(CLI::App& command, VolumeRequest& request, OptionHelp help, const Set& set) {
    help.text = rarely(help.text);
    add_word(command, help, [&request, name = help.name, set](const std::string& value) {
        request.given.push_back(name);
        set(value);
    });
}

bool is_given(const VolumeRequest& request, const char* name) {
    return std::find(request.given.begin(), request.given.end(), name) != request.given.end();
}

bool is_volume(const Output& output) { return output.kind == OutputKind::Volume; }

std::string suffix_of(const Output& output) { return cli::suffix_of(output.path); }

void check_together(const VolumeRequest& request, const std::vector<Output>& outputs) {
    if (!request.given.empty() && std::none_of(outputs.begin(), outputs.end(), is_volume))
        throw UsageError(request.given.front() +
                         " applies to volumes; ask for one with -o FILE.dx, FILE.mrc or FILE.vdb");
    const VolumeContent content = request.field.content;
    if (is_given(request, "--eps") && content != VolumeContent::Dielectric && !request.apbs_maps)
        throw UsageError("--eps sets dielectric constants; ask for them with --field dielectric or --maps apbs");
    if (is_given(request, "--ion-radius") && content != VolumeContent::Ions && !request.apbs_maps)
        throw UsageError("--ion-radius applies to the ion accessibility; ask for it with --field ions or --maps apbs");
    if (request.apbs_maps && is_given(request, "--field"))
        throw UsageError("--maps decides what is written; leave --field out");
    if (request.apbs_maps && request.grid_text.empty())
        throw UsageError(fmt::format("--maps apbs needs the grid of APBS; give --grid with {}", kGridWords));
}

void check_format(const VolumeRequest& request, const Output& output) {
    const std::string suffix = suffix_of(output);
    check_vdb(output.path);
    if (request.apbs_maps && is_standard_output(output.path))
        throw UsageError("-o -: --maps apbs writes several files; name them with -o NAME.dx");
    if (request.apbs_maps && suffix != ".dx")
        throw UsageError(output.path + ": APBS reads its maps as .dx; name a file with that suffix");
}

}  // namespace

void add_volume_options(CLI::App& command, VolumeRequest& request) {
    FieldOptions& field = request.field;
    add(command, request,
        {"--grid",
         "Grid of the volumes: that of a .dx, .mrc, .map or .ccp4 file, or NX x NY x NZ nodes H Å apart, centred at "
         "CX,CY,CZ; by default it has the --spacing and encloses the atoms",
         "FILE|NX,NY,NZ,H,CX,CY,CZ"},
        [&request](const std::string& text) { set_grid(request, text); });
    add(command, request,
        {"--field",
         "Values of the volumes. distance: signed, in Å, inside positive; mask: 1 inside, 0 outside; dielectric: the "
         "constants of --eps; ions: 0 in the atoms enlarged by --ion-radius, else 1",
         join(kFieldWords, "|"), kFieldWords.front().first},
        [&field](const std::string& text) { field.content = parse_word("--field", text, kFieldWords); });
    add(command, request,
        {"--eps", "Dielectric constants inside and outside", "IN,OUT",
         fmt::format("{},{}", field.inner_dielectric, field.outer_dielectric)},
        [&field](const std::string& text) { set_dielectrics(field, text); });
    add(command, request, {"--ion-radius", "Radius of ions, Å", "R", fmt::format("{}", field.ion_radius)},
        [&field](const std::string& text) {
            field.ion_radius = parse_number("--ion-radius", text, NumberRange::NotNegative);
        });
    add(command, request,
        {"--maps",
         "With -o NAME.dx: NAME_dielx.dx, NAME_diely.dx, NAME_dielz.dx and NAME_kappa.dx are written instead, for APBS",
         "apbs"},
        [&request](const std::string& text) {
            if (text != "apbs") throw UsageError(fmt::format("--maps: unknown value '{}'; choose one of apbs", text));
            request.apbs_maps = true;
        });
}

std::vector<Output> plan_volumes(const VolumeRequest& request, std::vector<Output> outputs) {
    check_together(request, outputs);
    std::vector<Output> plan;
    for (Output& output : outputs) {
        if (is_volume(output)) check_format(request, output);
        if (!is_volume(output) || !request.apbs_maps) {
            plan.push_back(std::move(output));
            continue;
        }
        const std::string stem = output.path.substr(0, output.path.size() - suffix_of(output).size());
        for (const auto& word : kApbsMapWords) plan.push_back({stem + map_suffix(word.first), OutputKind::Volume});
    }
    return plan;
}

VolumeGrid find_grid(const VolumeRequest& request, const ExactSurface& exact, double spacing,
                     const std::vector<Output>& outputs) {
    VolumeGrid grid;
    if (!request.grid_file.empty())
        grid = read_volume_grid(request.grid_file);
    else
        grid = request.grid ? *request.grid : enclosing_grid(exact, spacing);
    for (const Output& output : outputs) {
        if (suffix_of(output) == ".vdb" && (grid.spacing.x != grid.spacing.y || grid.spacing.x != grid.spacing.z))
            throw UsageError(output.path +
                             ": a level set has a single spacing, but the --grid has several; ask for .dx or .mrc");
    }
    return grid;
}

std::size_t volumes_of(const VolumeRequest& request) { return request.apbs_maps ? kApbsMapWords.size() : 1; }

Volumes::Volumes(const VolumeRequest& request, const VolumeGrid& grid, const Surface& surface, int threads)
    : content_(request.field.content) {
    FieldOptions options = request.field;
    options.threads = threads;
    if (!request.apbs_maps)
        volumes_.push_back(surface_field(surface, grid, options));
    else
        for (const auto& word : kApbsMapWords) volumes_.push_back(apbs_map(surface, grid, word.second, options));
}

void Volumes::write(const std::string& path) const {
    if (volumes_.size() == 1) return write_volume(path, volumes_.front(), content_);
    for (std::size_t i = 0; i < kApbsMapWords.size(); ++i)
        if (path.ends_with(map_suffix(kApbsMapWords[i].first)))
            write_volume(path, volumes_[i], content_of(kApbsMapWords[i].second));
}

ordered_json report_volumes(const VolumeRequest& request, bool written) {
    ordered_json options;
    for (const char* name : {"grid", "field", "eps", "ion_radius", "maps"}) options[name] = nullptr;
    if (!written) return options;
    const VolumeContent content = request.field.content;
    const bool maps = request.apbs_maps;
    if (!request.grid_text.empty()) options["grid"] = file_name(request.grid_text);
    if (!maps) options["field"] = word_for(kFieldWords, content);
    if (maps || content == VolumeContent::Dielectric)
        options["eps"] = {request.field.inner_dielectric, request.field.outer_dielectric};
    if (maps || content == VolumeContent::Ions) options["ion_radius"] = request.field.ion_radius;
    if (maps) options["maps"] = "apbs";
    return options;
}

void check_vdb(const std::string& path) {
    if (suffix_of(path) == ".vdb" && !vdb_supported())
        throw UsageError(
            path + ": this build cannot write .vdb; install libopenvdb-dev and build again, or ask for .dx or .mrc");
}

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/nanoshaper_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <string_view>

#include "dropins/strict_number.h"
#include "meniscus/errors.h"
#include "next_line.h"
#include "reading/text.h"

namespace meniscus::dropins {
namespace {

using reading::kOfWord;
using reading::printable;
using reading::shown;

std::string trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return "";
    return std::string(text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1));
}

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// A key with its value, and where it stands.
struct Entry {
    std::string place;  ///< "FILE:LINE:COLUMN"
    std::string key;
    std::string value;

    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(fmt::format("{}: {}", place, message));
    }

    double number(double least) const {
        const auto parsed = strict_number(value);
        if (!parsed || *parsed < least)
            fail(fmt::format("{}: {} is not a number of at least {}", key, shown(value), least));
        return *parsed;
    }

    double positive() const {
        const double parsed = number(0.0);
        if (parsed == 0.0) fail(key + ": must be greater than 0");
        return parsed;
    }

    bool truth() const {
        const std::string word = lower_case(value);
        if (word == "true" || word == "t" || word == "yes" || word == "y" || word == "1") return true;
        if (word == "false" || word == "f" || word == "no" || word == "n" || word == "0") return false;
        fail(fmt::format("{}: {} is neither true nor false", key, shown(value)));
    }
};

using EntryAction = void (*)(NanoShaperRequest&, const Entry&);

void set_surface(NanoShaperRequest& /*request*/, const Entry& entry) {
    if (lower_case(entry.value) != "ses")
        entry.fail("Surface: only ses, the solvent-excluded surface, is computed here, not " +
                   printable(entry.value, kOfWord));
}

void set_mode(NanoShaperRequest& /*request*/, const Entry& entry) {
    if (lower_case(entry.value) != "normal")
        entry.fail("Operative_Mode: only normal is supported here, not " + printable(entry.value, kOfWord));
}

void set_folder(NanoShaperRequest& request, const Entry& entry) {
    const std::string folder = entry.value.empty() || entry.value.ends_with('/') ? entry.value : entry.value + "/";
    request.root = folder + request.root;
}

void set_threads(NanoShaperRequest& request, const Entry& entry) {
    const auto count = strict_number(entry.value);
    if (!count || *count != std::floor(*count) || *count > 1e6) entry.fail("Number_thread: must be a whole number");
    request.threads = *count > 0.0 ? static_cast<int>(*count) : 0;
}

const std::map<std::string_view, EntryAction>& actions() {
    static const std::map<std::string_view, EntryAction> kActions{
        {"Grid_scale", [](auto& request, const auto& entry) { request.grid_scale = entry.positive(); }},
        {"Probe_Radius", [](auto& request, const auto& entry) { request.probe = entry.number(0.0); }},
        {"XYZR_FileName", [](auto& request, const auto& entry) { request.input = entry.value; }},
        {"Surface", &set_surface},
        {"Operative_Mode", &set_mode},
        {"Triangulation", [](auto& request, const auto& entry) { request.triangulated = entry.truth(); }},
        {"Save_Mesh_MSMS_Format", [](auto& request, const auto& entry) { request.msms_format = entry.truth(); }},
        {"Compute_Vertex_Normals", [](auto& request, const auto& entry) { request.with_normals = entry.truth(); }},
        {"Vertex_Atom_Info", [](auto& request, const auto& entry) { request.with_atoms = entry.truth(); }},
        {"Cavity_Detection_Filling", [](auto& request, const auto& entry) { request.fill_cavities = entry.truth(); }},
        {"Conditional_Volume_Filling_Value",
         [](auto& request, const auto& entry) { request.fill_below = entry.number(0.0); }},
        {"Root_FileName", [](auto& request, const auto& entry) { request.root += entry.value; }},
        {"Output_Folder", &set_folder},
        {"Number_thread", &set_threads},
    };
    return kActions;
}

/// How NanoShaper computes, or what belongs to its other surfaces and modes: nothing here depends on it.
bool makes_no_difference(std::string_view key) {
    constexpr std::array<std::string_view, 41> kKeys{
        "Grid_perfil",
        "Build_epsilon_maps",
        "Build_status_map",
        "Smooth_Mesh",
        "Accurate_Triangulation",
        "Check_duplicated_vertices",
        "Skin_Surface_Parameter",
        "Skin_Fast_Projection",
        "Blobbyness",
        "Pocket_Radius_Big",
        "Pocket_Radius_Small",
        "Pocket_Radius_Link",
        "Pockets_And_Cavities",
        "Link_Pockets",
        "Num_Wat_Pocket",
        "Load_Balancing",
        "Print_Available_Surfaces",
        "Seed",
        "Sys_Name",
        "Debug_Internals",
        "Skip_Mem_CleanUp",
        "Patch_Based_Algorithm",
        "Analytical_Ray_Vs_Torus_Intersection",
        "Collect_Face_Intersections",
        "Parallel_Buildup_Halo_Thickness",
        "Force_Serial_Build",
        "Max_Num_Atoms",
        "Domain_Shrinkage",
        "Optimize_Grids",
        "Max_Probes_Self_Intersections",
        "Self_Intersections_Grid_Coefficient",
        "Max_Atoms_Multi_Grid",
        "Surface_File_Name",
        "Project_boundary_grid_points",
        "Input_Surface",
        "Memb_Height",
        "Memb_Shift",
        "Parallel_Marching_Cubes",
        "PB_grid_mode",
        "PB_aligned_grid_mode",
        "Cavity_Atoms",
    };
    return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end() || key.starts_with("Max_ses_patches") ||
           key.starts_with("Max_skin_patches") || key.starts_with("Max_mesh_");
}

/// What NanoShaper would do beyond a triangulated surface, if it is switched on.
bool is_not_done_here(std::string_view key) {
    constexpr std::array<std::string_view, 11> kKeys{
        "Save_eps_maps",       "Save_bgps", "Save_Cavities", "Save_Status_map",  "Save_ideb_map",
        "Save_PovRay",         "Tri2Balls", "Stern_layer",   "Multi_Dielectric", "Keep_Water_Shaped_Cavities",
        "Save_Mesh_PLY_Format"};
    return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

bool is_switched_off(const Entry& entry) {
    const auto number = strict_number(entry.value);
    return number ? *number <= 0.0 : !entry.truth();
}

void apply(const Entry& entry, NanoShaperRequest& request) {
    const auto action = actions().find(entry.key);
    if (action != actions().end())
        action->second(request, entry);
    else if (is_not_done_here(entry.key)) {
        if (!is_switched_off(entry)) request.warnings.push_back(entry.key + " is not supported here and is ignored");
    } else if (!makes_no_difference(entry.key))
        request.warnings.push_back(
            fmt::format("{}: {} is unknown and is ignored", entry.place, printable(entry.key, kOfWord)));
}

}  // namespace

NanoShaperRequest read_nanoshaper(std::istream& stream, const std::string& path) {
    NanoShaperRequest request;
    std::size_t number = 0;
    for (std::string line; cli::next_line(stream, line, path, number + 1);) {
        ++number;
        const std::string text = line.substr(0, line.find('#'));
        if (trimmed(text).empty()) continue;
        const std::size_t equals = text.find('=');
        const std::string place = fmt::format("{}:{}:{}", path, number, text.find_first_not_of(" \t\r") + 1);
        if (equals == std::string::npos) throw InputError(place + ": no '=' in this line; write Key = value");
        apply({place, trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))}, request);
    }
    return request;
}

}  // namespace meniscus::dropins

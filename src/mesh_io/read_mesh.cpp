// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/read_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "meniscus/errors.h"
#include "mesh_io/glb_reader.h"
#include "mesh_io/mesh_file.h"
#include "mesh_io/msms_reader.h"
#include "mesh_io/obj_reader.h"
#include "mesh_io/off_reader.h"
#include "mesh_io/ply_reader.h"
#include "mesh_io/stl_reader.h"
#include "reading/lower_case.h"

namespace meniscus {
namespace {

constexpr std::array<std::string_view, 7> kSuffixes{".ply", ".obj", ".stl", ".off", ".glb", ".vert", ".face"};

// Where the suffix begins: ".off" of "dir/a.OFF.gz". Empty if the name has none that is known.
std::string_view suffix_of(const std::string& path) {
    std::string name = lower_case(path.substr(path.find_last_of('/') + 1));
    if (name.ends_with(".gz")) name.resize(name.size() - 3);
    const auto* found =
        std::find_if(kSuffixes.begin(), kSuffixes.end(), [&](std::string_view s) { return name.ends_with(s); });
    return found == kSuffixes.end() ? std::string_view() : *found;
}

// "a.vert.gz" -> "a.face.gz" and back.
std::string other_of_pair(const std::string& path, std::string_view suffix) {
    const std::size_t end = path.size() - (lower_case(path).ends_with(".gz") ? 3 : 0);
    std::string other = path;
    return other.replace(end - suffix.size(), suffix.size(), suffix == ".vert" ? ".face" : ".vert");
}

Mesh read_pair(const std::string& path, std::string_view suffix) {
    const reading::MeshFile one = reading::load_mesh_file(path);
    const reading::MeshFile other = reading::load_mesh_file(other_of_pair(path, suffix));
    return suffix == ".vert" ? reading::read_msms(one, other) : reading::read_msms(other, one);
}

Mesh read_by_suffix(const std::string& path, std::string_view suffix) {
    if (suffix == ".vert" || suffix == ".face") return read_pair(path, suffix);
    const reading::MeshFile file = reading::load_mesh_file(path);
    if (suffix == ".ply") return reading::read_ply(file);
    if (suffix == ".obj") return reading::read_obj(file);
    if (suffix == ".stl") return reading::read_stl(file);
    if (suffix == ".off") return reading::read_off(file);
    return reading::read_glb(file);
}

// Also of what is no number, which transformations can make.
bool is_too_far(const Vec3& p) {
    const auto is_near = [](double x) { return std::abs(x) <= kFarthestCoordinate; };
    return !(is_near(p.x) && is_near(p.y) && is_near(p.z));
}

}  // namespace

bool is_mesh_file(const std::string& path) { return !suffix_of(path).empty(); }

Mesh read_mesh(const std::string& path) {
    const std::string_view suffix = suffix_of(path);
    if (suffix.empty())
        throw UsageError(
            path +
            ": unknown suffix for a mesh; supported formats are .ply .obj .stl .off .glb .vert .face, each "
            "also .gz");
    Mesh mesh = read_by_suffix(path, suffix);
    if (std::any_of(mesh.vertices.begin(), mesh.vertices.end(), is_too_far))
        throw InputError(path + ": a coordinate beyond 1e9 Å; is this a molecule?");
    return mesh;
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include "core/parallel.h"
#include "io/atomic_file.h"
#include "io/glb.h"
#include "io/measured_arrays.h"
#include "io/obj.h"
#include "io/off.h"
#include "io/ply.h"
#include "io/stl.h"
#include "io/vtp.h"
#include "meniscus/errors.h"
#include "meniscus/write.h"

namespace meniscus {
namespace {

// ".ply" of "dir.x/NAME.PLY"; empty if the last part of the path has no suffix.
std::string suffix_of(const std::string& path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string::npos || path[dot] == '/') return "";
    std::string suffix = path.substr(dot);
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return suffix;
}

bool is_word(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isgraph(c) != 0; });
}

void check_size(std::string_view name, std::size_t size, std::size_t vertices) {
    if (size != vertices)
        throw UsageError("vertex array '" + std::string(name) + "' has " + std::to_string(size) + " values for " +
                         std::to_string(vertices) + " vertices");
}

void check(const Mesh& mesh, const WriteOptions& options) {
    const std::size_t n = mesh.vertices.size();
    if (!mesh.normals.empty()) check_size("normals", mesh.normals.size(), n);
    if (!mesh.atoms.empty()) check_size("atom", mesh.atoms.size(), n);
    if (!mesh.patches.empty()) check_size("patch", mesh.patches.size(), n);
    if (!mesh.components.empty()) check_size("component", mesh.components.size(), n);
    for (const auto& [name, values] : measured_arrays(mesh)) check_size(name, values.size(), n);
    if (!options.colours.empty()) check_size("colours", options.colours.size(), n);
    for (const VertexArray& array : options.extra) {
        if (!is_word(array.name)) throw UsageError("'" + array.name + "' cannot be the name of a vertex array");
        std::visit([&](auto values) { check_size(array.name, values.size(), n); }, array.values);
    }
}

}  // namespace

void write_mesh(const std::string& path, const Mesh& mesh, const WriteOptions& options) {
    const std::string suffix = suffix_of(path);
    constexpr std::array kSuffixes{".ply", ".obj", ".stl", ".off", ".glb", ".vtp"};
    if (std::find(kSuffixes.begin(), kSuffixes.end(), suffix) == kSuffixes.end())
        throw UsageError(path + ": unknown suffix for a mesh; choose .ply, .obj, .stl, .off, .glb or .vtp");
    check(mesh, options);
    const ThreadLimit limit(options.threads);
    AtomicFile file(path);
    if (suffix == ".ply") write_ply(file, mesh, options);
    if (suffix == ".obj") write_obj(file, mesh);
    if (suffix == ".stl") write_stl(file, mesh, options.encoding);
    if (suffix == ".off") write_off(file, mesh);
    if (suffix == ".glb") write_glb(file, mesh, options);
    if (suffix == ".vtp") write_vtp(file, mesh, options);
    file.commit();
}

}  // namespace meniscus

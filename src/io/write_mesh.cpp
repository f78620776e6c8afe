// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/parallel.h"
#include "io/glb.h"
#include "io/measured_arrays.h"
#include "io/msms_pair.h"
#include "io/npz.h"
#include "io/obj.h"
#include "io/off.h"
#include "io/ply.h"
#include "io/precision.h"
#include "io/stl.h"
#include "io/vtp.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "meniscus/write.h"
#include "platform/files/atomic_file.h"
#include "platform/fresh_memory.h"
#include "reading/lower_case.h"

namespace meniscus {
namespace {

// ".ply" of "dir.x/NAME.PLY"; empty if the last part of the path has no suffix.
std::string suffix_of(const std::string& path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string::npos || path[dot] == '/') return "";
    return lower_case(path.substr(dot));
}

bool is_word(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isgraph(c) != 0; });
}

void check_size(std::string_view name, std::size_t size, std::size_t vertices) {
    if (size != vertices)
        throw UsageError("vertex array '" + std::string(name) + "' has " + std::to_string(size) + " values for " +
                         std::to_string(vertices) + " vertices");
}

// Every array needs a name of its own; GLB tells no upper from lower case.
void check_names(const Mesh& mesh, const WriteOptions& options) {
    std::set<std::string> names{"x",     "y",         "z",   "nx",    "ny",   "nz",   "atom",
                                "patch", "component", "red", "green", "blue", "alpha"};
    const auto add = [&names](const std::string& name) {
        if (!is_word(name)) throw UsageError("'" + name + "' cannot be the name of a vertex array");
        if (!names.insert(lower_case(name)).second) throw UsageError("two vertex arrays have the name '" + name + "'");
    };
    for (const MeasuredArray& array : measured_arrays(mesh)) add(array.name);
    for (const VertexArray& array : options.extra) add(array.name);
}

void check(const Mesh& mesh, const WriteOptions& options) {
    check_names(mesh, options);
    const std::size_t n = mesh.vertices.size();
    if (!mesh.normals.empty()) check_size("normals", mesh.normals.size(), n);
    if (!mesh.atoms.empty()) check_size("atom", mesh.atoms.size(), n);
    if (!mesh.patches.empty()) check_size("patch", mesh.patches.size(), n);
    if (!mesh.components.empty()) check_size("component", mesh.components.size(), n);
    for (const auto& [name, values] : measured_arrays(mesh)) check_size(name, values.size(), n);
    if (!options.colours.empty()) check_size("colours", options.colours.size(), n);
    for (const VertexArray& array : options.extra)
        std::visit([&](auto values) { check_size(array.name, values.size(), n); }, array.values);
}

std::vector<std::uint32_t> residues_of_vertices(const Mesh& mesh, const Structure& structure) {
    constexpr std::size_t kGrain = 1 << 14;  // vertices per task: some tens of microseconds
    const std::size_t atoms = structure.labels.size();
    const auto is_beyond = [&](std::uint32_t a) { return a >= atoms; };
    if (parallel_any_of(mesh.atoms, is_beyond))
        throw UsageError("vertex array 'atom' names atom " +
                         std::to_string(*std::find_if(mesh.atoms.begin(), mesh.atoms.end(), is_beyond)) +
                         " of a structure with " + std::to_string(atoms));
    std::vector<std::uint32_t> residues;
    resize_touched(residues, mesh.atoms.size());
    parallel_for(residues.size(), kGrain,
                 [&](std::size_t v) { residues[v] = structure.labels[mesh.atoms[v]].residue; });
    return residues;
}

}  // namespace

void write_mesh(const std::string& path, const Mesh& mesh, const WriteOptions& given) {
    const std::string suffix = suffix_of(path);
    constexpr std::array kSuffixes{".ply", ".obj", ".stl", ".off", ".glb", ".vtp", ".npz", ".vert"};
    if (std::find(kSuffixes.begin(), kSuffixes.end(), suffix) == kSuffixes.end())
        throw UsageError(path +
                         ": unknown suffix for a mesh; choose .ply, .obj, .stl, .off, .glb, .vtp, .npz or .vert");
    WriteOptions options = given;
    const ThreadLimit limit(options.threads);
    std::vector<std::uint32_t> residues;
    if (options.structure != nullptr && !mesh.atoms.empty()) {
        residues = residues_of_vertices(mesh, *options.structure);
        options.extra.insert(options.extra.begin(), {"residue", residues});
    }
    check(mesh, options);
    if (suffix == ".vert") return write_msms_pair(path, mesh, options.structure, options.probe.value_or(0.0));
    if (suffix == ".stl" || suffix == ".glb") require_single_precision(mesh, path);
    AtomicFile file(path);
    if (suffix == ".ply") write_ply(file, mesh, options);
    if (suffix == ".obj") write_obj(file, mesh, options.open);
    if (suffix == ".stl") write_stl(file, mesh, options.encoding);
    if (suffix == ".off") write_off(file, mesh, options.open);
    if (suffix == ".glb") write_glb(file, mesh, options);
    if (suffix == ".vtp") write_vtp(file, mesh, options);
    if (suffix == ".npz") write_npz(file, mesh, options);
    file.commit();
}

}  // namespace meniscus

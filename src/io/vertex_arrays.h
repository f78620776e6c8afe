// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Everything that is known of a mesh's vertices, array by array, for formats that name them.
#pragma once

#include <span>
#include <string>
#include <variant>

#include "io/measured_arrays.h"
#include "meniscus/write.h"

namespace meniscus {

/// Calls take(name, values) for each array that the mesh and the options have, in the order in which formats write
/// them: "normals" (SmallVec3), "atom" (std::uint32_t), "patch" (PatchKind), "component" (std::uint32_t), the measured
/// ones (float), options.extra, "colors" (Colour). Positions are not among them.
template <class Take>
void for_each_vertex_array(const Mesh& mesh, const WriteOptions& options, const Take& take) {
    const auto take_some = [&take](const std::string& name, auto values) {
        if (!values.empty()) take(name, values);
    };
    take_some("normals", std::span<const SmallVec3>(mesh.normals));
    take_some("atom", std::span<const std::uint32_t>(mesh.atoms));
    take_some("patch", std::span<const PatchKind>(mesh.patches));
    take_some("component", std::span<const std::uint32_t>(mesh.components));
    for (const auto& [name, values] : measured_arrays(mesh)) take_some(name, values);
    for (const VertexArray& array : options.extra)
        std::visit([&, &name = array.name](auto values) { take_some(name, values); }, array.values);
    take_some("colors", options.colours);
}

}  // namespace meniscus

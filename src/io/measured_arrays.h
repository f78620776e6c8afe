// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What was measured at the vertices of a mesh or brought there, under the names that formats with named values use.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

struct MeasuredArray {
    std::string name;
    std::span<const float> values;
};

/// Those that the mesh has, in the order in which they are written.
inline std::vector<MeasuredArray> measured_arrays(const Mesh& mesh) {
    std::vector<MeasuredArray> arrays{{"area", mesh.areas},
                                      {"mean_curvature", mesh.mean_curvatures},
                                      {"gaussian_curvature", mesh.gaussian_curvatures},
                                      {"shape_index", mesh.shape_indices}};
    for (const VertexValues& more : mesh.values) arrays.push_back({more.name, more.values});
    std::erase_if(arrays, [](const MeasuredArray& array) { return array.values.empty(); });
    return arrays;
}

}  // namespace meniscus

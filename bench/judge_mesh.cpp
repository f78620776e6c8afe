// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a mesh is like and how far it is from the exact SES, whoever made it: a line of JSON. `bench/meshes` calls it
// for every program.
//
// usage: judge_mesh SPHERES.xyzr PROBE MESH.off
//
// Both ways: from the mesh to the SES as the report's two_sided_distance.to_exact; from the SES to the mesh by the
// vertices of a mesh of 0.25 Å that lie on the SES, so that what a mesh leaves out counts.
#include <fmt/core.h>

#include <cmath>
#include <exception>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "measure/weighted_distances.h"
#include "meniscus/mesh_quality.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "remesh/self_intersections.h"
#include "space/triangle_tree.h"
#include "support/mesh_readers.h"

namespace {

using namespace meniscus;

constexpr double kFine = 0.25;  // Å

Mesh read_mesh(const std::string& path) {
    const std::ifstream in(path);
    std::ostringstream content;
    content << in.rdbuf();
    return testing::read_off(content.str());
}

// Weighted by the area round each vertex, which is nearly the same everywhere.
DistanceSummary from_exact(const Mesh& mesh, const Atoms& atoms, double probe) {
    const Mesh exact = compute_surface(atoms, {.method = Method::Direct, .probe = probe, .spacing = kFine}).mesh;
    const TriangleTree tree(mesh);
    WeightedDistances found(exact.vertices.size());
    parallel_for(exact.vertices.size(), 256,
                 [&](std::size_t v) { found.set(v, tree.distance(mesh, exact.vertices[v]), exact.areas[v]); });
    return std::move(found).summarise();
}

void judge(const std::string& spheres, double probe, const std::string& path) {
    const Atoms atoms = read_structure(spheres).atoms;
    const Mesh mesh = read_mesh(path);
    const MeshMeasures measures = measure_mesh(mesh);
    const MeshQuality quality = measure_quality(mesh);
    const DistanceSummary to = measure_distance(mesh, ExactSurface(atoms, {.probe = probe})).to_exact;
    const DistanceSummary from = from_exact(mesh, atoms, probe);
    fmt::print(R"({{"vertices": {}, "triangles": {}, "pieces": {}, "euler_characteristic": {}, "closed": {}, )"
               R"("manifold": {}, "self_intersections": {}, "smallest_angle": {:.3f}, "median_angle": {:.3f}, )"
               R"("to_mean": {:.5f}, "to_p99": {:.5f}, "from_mean": {:.5f}, "from_p99": {:.5f}}})"
               "\n",
               mesh.vertices.size(), mesh.triangles.size(), measures.components.size(), measures.euler_characteristic,
               measures.closed, measures.manifold, places_of_self_intersections(mesh).size(),
               quality.smallest_angles.min, quality.smallest_angles.p50, to.mean, to.p99, from.mean, from.p99);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        fmt::print(stderr, "usage: judge_mesh SPHERES.xyzr PROBE MESH.off\n");
        return 2;
    }
    try {
        judge(argv[1], std::stod(argv[2]), argv[3]);
    } catch (const std::exception& error) {
        fmt::print(stderr, "judge_mesh: {}\n", error.what());
        return 1;
    }
}

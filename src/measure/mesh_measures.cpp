// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "core/fetch_corners.h"
#include "core/parallel.h"
#include "measure/creases.h"
#include "measure/surface_measures.h"
#include "measure/topology.h"
#include "measure/triangle_lanes.h"
#include "meniscus/errors.h"
#include "meniscus/mesh.h"
#include "mesh/components.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 8192;  // triangles or vertices per task: some tens of microseconds

std::uint32_t largest_of(std::uint32_t i) { return i; }
std::uint32_t largest_of(const Triangle& t) { return std::max({t[0], t[1], t[2]}); }

template <class T>
bool all_below(const std::vector<T>& indices, std::size_t limit) {
    const auto count_others = [&](std::size_t begin, std::size_t end) {
        std::size_t others = 0;
        for (std::size_t i = begin; i < end; ++i) others += largest_of(indices[i]) < limit ? 0 : 1;
        return others;
    };
    return parallel_sum<std::size_t>(indices.size(), kChunk, count_others) == 0;
}

void check(const Mesh& mesh) {
    const std::size_t n = mesh.vertices.size();
    if (!mesh.components.empty() && mesh.components.size() != n)
        throw UsageError("a mesh needs one component number per vertex, or none at all");
    if (!all_below(mesh.components, n)) throw UsageError("a component number is larger than the mesh has vertices");
    if (!all_below(mesh.triangles, n)) throw UsageError("a triangle names a vertex that the mesh does not have");
}

// Square of the tangent of an angle below 90 degrees, as a fraction: compared without dividing.
struct SquaredTangent {
    double opposite = 3.0;  // of 60 degrees: no triangle has a larger smallest corner
    double adjacent = 1.0;

    bool operator<(const SquaredTangent& b) const { return opposite * b.adjacent < b.opposite * adjacent; }
    // The smaller of both.
    SquaredTangent& operator+=(const SquaredTangent& b) { return *this = b < *this ? b : *this; }
};

// What one run of triangles of the same piece measures.
struct RunSums {
    std::uint32_t piece = 0;
    std::size_t triangles = 0;
    double two_areas = 0.0;
    double six_volumes = 0.0;
};

struct TriangleSums {
    std::vector<RunSums> runs;
    double parts_two_areas = 0.0;
    double parts_six_volumes = 0.0;
    SquaredTangent smallest;

    TriangleSums& operator+=(const TriangleSums& b) {
        runs.insert(runs.end(), b.runs.begin(), b.runs.end());
        parts_two_areas += b.parts_two_areas;
        parts_six_volumes += b.parts_six_volumes;
        smallest += b.smallest;
        return *this;
    }
};

// One pass over the triangles, in which every one is looked at while its corners are at hand.
class TrianglePass {
public:
    TrianglePass(const Mesh& mesh, std::span<const std::uint32_t> of_vertex, Creases creases = Creases::Rounded)
        : mesh_(mesh), of_vertex_(of_vertex), follows_creases_(creases == Creases::Sharp && knows_creases(mesh)) {
        const PieceVertices vertices = vertices_of_pieces(of_vertex);
        for (std::size_t p = 0; p < vertices.counts.size(); ++p) {
            pieces_.emplace_back().vertices = vertices.counts[p];
            origins_.push_back(mesh.vertices[vertices.first[p]]);
        }
    }

    // thirds: empty, or where a third of every triangle's area goes. Only then are the parts measured.
    MeshMeasures run(std::span<float> thirds) {
        sums_ = parallel_sum<TriangleSums>(mesh_.triangles.size(), kChunk, [&](std::size_t begin, std::size_t end) {
            return sums_of(begin, end, thirds);
        });
        for (const RunSums& run : sums_.runs) {
            pieces_[run.piece].triangles += run.triangles;
            pieces_[run.piece].area += run.two_areas / 2.0;
            pieces_[run.piece].volume += run.six_volumes / 6.0;
        }
        MeshMeasures measures;
        for (const MeshComponent& piece : pieces_) {
            measures.area += piece.area;
            measures.volume += piece.volume;
        }
        measures.components = std::move(pieces_);
        const double tangent = std::sqrt(sums_.smallest.opposite / sums_.smallest.adjacent);
        if (!mesh_.triangles.empty()) measures.smallest_angle_deg = std::atan(tangent) * 180.0 / std::numbers::pi;
        return measures;
    }

    // After run with thirds.
    CorrectedMeasures parts() const { return {sums_.parts_two_areas / 2.0, sums_.parts_six_volumes / 6.0}; }

private:
    TriangleSums sums_of(std::size_t begin, std::size_t end, std::span<float> thirds) const {
        TriangleLanes lanes;
        TriangleSums sums;
        for (std::size_t first = begin; first < end; first += kLanes) {
            const std::size_t count = std::min(kLanes, end - first);
            load(first, count, !thirds.empty(), lanes);
            if (thirds.empty()) {
                triangle_kernels().measure(lanes);
            } else {
                triangle_kernels().measure_with_parts(lanes);
                if (follows_creases_) measure_over_creases(first, count, lanes);
                add_parts(lanes, thirds.subspan(first, count), sums);
            }
            add_to_runs(first, count, lanes, sums);
        }
        return sums;
    }

    std::uint32_t piece_of(std::size_t t) const { return of_vertex_[mesh_.triangles[t][0]]; }

    void load(std::size_t first, std::size_t count, bool with_normals, TriangleLanes& lanes) const {
        for (std::size_t lane = 0; lane < count; ++lane) {
            const Triangle& ahead = mesh_.triangles[std::min(first + lane + kFetchAhead, mesh_.triangles.size() - 1)];
            fetch_corners(mesh_.vertices, ahead);
            if (with_normals) fetch_corners(mesh_.normals, ahead);
            const Triangle& triangle = mesh_.triangles[first + lane];
            lanes.set_points(lane, mesh_, triangle, origins_[piece_of(first + lane)]);
            if (with_normals) lanes.set_normals(lane, mesh_, triangle);
        }
    }

    // What crosses a crease is measured by parts that follow it, and is not extrapolated.
    void measure_over_creases(std::size_t first, std::size_t count, TriangleLanes& lanes) const {
        for (std::size_t lane = 0; lane < count; ++lane) {
            if (!(lanes.creased[lane] > 0.0)) continue;
            const Triangle& triangle = mesh_.triangles[first + lane];
            const auto parts = parts_over_crease(mesh_, triangle, origins_[piece_of(first + lane)]);
            if (!parts) continue;
            lanes.parts_two_areas[lane] = parts_of(lanes.two_areas[lane], parts->two_areas);
            lanes.parts_six_volumes[lane] = parts_of(lanes.six_volumes[lane], parts->six_volumes);
        }
    }

    // Sums are kept in variables of their own while they grow: what may lie where something else is written would go
    // through memory every time.
    static void add_parts(const TriangleLanes& lanes, std::span<float> thirds, TriangleSums& sums) {
        double two_areas = sums.parts_two_areas;
        double six_volumes = sums.parts_six_volumes;
        for (std::size_t lane = 0; lane < thirds.size(); ++lane) {
            thirds[lane] = static_cast<float>(lanes.two_areas[lane] / 6.0);
            two_areas += lanes.parts_two_areas[lane];
            six_volumes += lanes.parts_six_volumes[lane];
        }
        sums.parts_two_areas = two_areas;
        sums.parts_six_volumes = six_volumes;
    }

    void add_to_runs(std::size_t first, std::size_t count, const TriangleLanes& lanes, TriangleSums& sums) const {
        for (std::size_t lane = 0; lane < count;) {
            const std::uint32_t piece = piece_of(first + lane);
            if (sums.runs.empty() || sums.runs.back().piece != piece) sums.runs.push_back({.piece = piece});
            RunSums run = sums.runs.back();
            SquaredTangent smallest = sums.smallest;
            for (; lane < count && piece_of(first + lane) == piece; ++lane) {
                ++run.triangles;
                run.two_areas += lanes.two_areas[lane];
                run.six_volumes += lanes.six_volumes[lane];
                smallest += {lanes.opposite[lane], lanes.adjacent[lane]};
            }
            sums.runs.back() = run;
            sums.smallest = smallest;
        }
    }

    const Mesh& mesh_;
    std::span<const std::uint32_t> of_vertex_;
    std::vector<MeshComponent> pieces_;
    bool follows_creases_;
    std::vector<Vec3> origins_;  // first vertex of each piece: volumes taken from there keep their digits
    TriangleSums sums_;
};

void add_topology(const Mesh& mesh, MeshMeasures& measures, const CornerSums& sums = {}) {
    const MeshTopology topology = examine_topology(mesh.vertices.size(), mesh.triangles, sums);
    measures.closed = topology.closed;
    measures.manifold = topology.manifold;
    measures.euler_characteristic = static_cast<std::int64_t>(mesh.vertices.size()) -
                                    static_cast<std::int64_t>(topology.edges) +
                                    static_cast<std::int64_t>(mesh.triangles.size());
}

}  // namespace

MeshMeasures measure_mesh(const Mesh& mesh) {
    check(mesh);
    const std::vector<std::uint32_t> found =
        mesh.components.empty() ? find_components(mesh).of_vertex : std::vector<std::uint32_t>();
    MeshMeasures measures = TrianglePass(mesh, mesh.components.empty() ? found : mesh.components).run({});
    add_topology(mesh, measures);
    return measures;
}

SurfaceMeasures measure_surface(Mesh& mesh, Creases creases) {
    check(mesh);
    if (mesh.normals.size() != mesh.vertices.size() || mesh.components.size() != mesh.vertices.size())
        throw UsageError("measures of a surface need one normal and one component number per vertex");
    const auto memory = std::make_unique_for_overwrite<float[]>(mesh.triangles.size());
    const std::span thirds(memory.get(), mesh.triangles.size());
    TrianglePass pass(mesh, mesh.components, creases);
    SurfaceMeasures measures{.mesh = pass.run(thirds), .corrected = {}, .areas = {}};
    measures.corrected = extrapolate({measures.mesh.area, measures.mesh.volume}, pass.parts());
    renumber(measures.mesh.components, mesh.components);
    measures.areas.resize(mesh.vertices.size());
    add_topology(mesh, measures.mesh, {thirds, measures.areas});
    return measures;
}

double flat_area(const Mesh& mesh) {
    return parallel_sum<double>(mesh.triangles.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t t = begin; t < end; ++t) {
            const auto [a, b, c] = mesh.triangles[t];
            sum += 0.5 * norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
        }
        return sum;
    });
}

}  // namespace meniscus

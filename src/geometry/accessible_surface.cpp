// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/accessible_surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/perpendicular.h"
#include "core/requirements.h"
#include "core/workspaces.h"
#include "geometry/accessible_surface_data.h"
#include "geometry/neighbour_caps.h"
#include "platform/fresh_memory.h"
#include "space/cell_list.h"

namespace meniscus {
namespace {

// Far above the rounding of the predicates (1e-15 relative) and far below any length that matters.
constexpr double kPerturbation = 1e-10;
constexpr double kPerturbationOfRadius = 1e-14;  // relative, so that spheres of more than 10,000 Å are perturbed at all
constexpr int kMaxAttempts = 6;                  // each ten times the perturbation of the one before

constexpr std::size_t kChunk = 512;  // atoms, vertices or arcs per task, where each takes little

// Atoms per task: small molecules have work for all threads to the end, and the lists of large ones' tasks, which come
// and go, leave the memory in few pieces.
std::size_t atoms_per_task(std::size_t atoms) { return std::clamp<std::size_t>(atoms / 64, 64, 256); }

// One end of an arc on the contour of atom[0]: the contour passes from the circle with atom[1] to that with
// atom[2]. The same vertex on the contours of the other two atoms is a cyclic permutation.
using VertexKey = std::array<std::uint32_t, 3>;

// Where the smallest of a key's atoms stands; without a branch, as any would be taken by chance.
std::size_t place_of_smallest(const VertexKey& key) {
    const std::size_t of_two = key[1] < key[0] ? 1 : 0;
    return key[2] < std::min(key[0], key[1]) ? 2 : of_two;
}

VertexKey rotated(const VertexKey& key, std::size_t first) {
    const std::array<std::uint32_t, 5> twice{key[0], key[1], key[2], key[0], key[1]};
    return {twice[first], twice[first + 1], twice[first + 2]};
}

// An arc as the contour of one of its atoms sees it.
struct ArcView {
    std::uint32_t other;  // the other atom
    std::uint32_t from;   // atoms of the vertices' third circles, or kWholeCircle
    std::uint32_t to;
    double sweep;  // pseudo-angle
};

ArcView view_of(const AccessibleSurface::Data& data, std::uint32_t atom, const ContourArc& arc) {
    const std::span<const std::uint32_t> cover = data.cover_of(atom);
    const auto atom_of = [&](std::uint32_t k) { return k == kWholeCircle ? kWholeCircle : cover[k]; };
    return {cover[arc.cap], atom_of(arc.from), atom_of(arc.to), arc.sweep};
}

struct ChunkResult {
    bool consistent = true;
    std::vector<ContourArc> arcs;
    std::vector<CapPlane> caps;
    std::vector<std::uint32_t> cover;
};

// What builds the contours of one atom after the other; `caps` are those of the last one.
struct ContourWorkspace {
    NeighbourCaps neighbours;
    ContourBuilder builder;
    CapList caps;
};

struct AtomRange {
    std::size_t begin;
    std::size_t end;
};

enum class Contour { Exposed, Buried, Inconsistent };

// Builds the contour of atom i. `cover` names neighbours that buried most of it under another perturbation: an
// atom that they bury again needs no look at the others, and on any other they leave little for these to cut.
Contour build_contour(const AccessibleSurface::Data& data, std::uint32_t i, std::span<const std::uint32_t> cover,
                      ContourWorkspace& workspace) {
    auto& [neighbours, builder, caps] = workspace;
    caps.clear();
    for (const std::uint32_t j : cover) {
        const Cap cap = cap_between(data, i, j);
        if (!(std::abs(cap.t) < 1.0)) return build_contour(data, i, {}, workspace);
        caps.add(cap);
    }
    if (!builder.build_in_order(caps.planes)) return Contour::Inconsistent;
    if (!builder.exposed()) return Contour::Buried;
    if (!neighbours.gather(i, cover, caps)) return Contour::Buried;
    const bool consistent = cover.empty() ? builder.build(caps.planes) : builder.extend(caps.planes);
    if (!consistent) return Contour::Inconsistent;
    return builder.exposed() ? Contour::Exposed : Contour::Buried;
}

// Room for what these atoms had under another perturbation, which changes little, or else for what they usually have:
// lists that grow from nothing leave holes behind that later ones do not fit into.
void reserve(const AccessibleSurface::Data* before, const AtomRange& atoms, ChunkResult& result) {
    constexpr std::size_t kUsualArcs = 5;  // per atom; half as many again as proteins have
    constexpr std::size_t kUsualCaps = 8;
    constexpr std::size_t kUsualCover = 15;
    const auto count = [&](const auto& begins, std::size_t usual) {
        return before == nullptr ? (atoms.end - atoms.begin) * usual
                                 : (before->*begins)[atoms.end] - (before->*begins)[atoms.begin];
    };
    using Data = AccessibleSurface::Data;
    result.arcs.reserve(count(&Data::contour_begin, kUsualArcs));
    result.caps.reserve(count(&Data::cap_begin, kUsualCaps));
    result.cover.reserve(count(&Data::cover_begin, kUsualCover));
}

// Of some atoms one after the other; gives up at the first that comes out inconsistent.
ChunkResult build_contours(AccessibleSurface::Data& data, const AtomRange& atoms, const AccessibleSurface::Data* before,
                           ContourWorkspace& workspace) {
    const ContourBuilder& builder = workspace.builder;
    ChunkResult result;
    reserve(before, atoms, result);
    for (std::size_t i = atoms.begin; i < atoms.end; ++i) {
        const auto atom = static_cast<std::uint32_t>(i);
        const auto cover = before == nullptr ? std::span<const std::uint32_t>{} : before->cover_of(atom);
        const Contour contour = build_contour(data, atom, cover, workspace);
        result.consistent = contour != Contour::Inconsistent;
        if (!result.consistent) break;
        for (const std::uint32_t k : builder.kept()) result.cover.push_back(workspace.caps.atoms[k]);
        data.cover_begin[i + 1] = builder.kept().size();
        if (contour == Contour::Buried) continue;
        data.exposed[i] = 1;
        result.arcs.insert(result.arcs.end(), builder.arcs().begin(), builder.arcs().end());
        result.caps.insert(result.caps.end(), builder.kept_caps().begin(), builder.kept_caps().end());
        data.contour_begin[i + 1] = builder.arcs().size();
        data.cap_begin[i + 1] = builder.kept().size();
    }
    return result;
}

// Fills exposed, cover, caps and contours; false if the arrangement came out inconsistent on some sphere.
bool build_contours(AccessibleSurface::Data& data, const CellList& cells, const AccessibleSurface::Data* before) {
    const std::size_t n = data.atoms.size();
    const std::size_t per_task = atoms_per_task(n);
    std::vector<ChunkResult> chunks((n + per_task - 1) / per_task);
    data.contour_begin.assign(n + 1, 0);
    data.cap_begin.assign(n + 1, 0);
    data.cover_begin.assign(n + 1, 0);
    data.exposed.assign(n, 0);
    parallel_chunks_with(
        n, per_task,
        [&] {
            return std::make_unique<ContourWorkspace>(ContourWorkspace{{data, cells}, {}, {}});
        },
        [&](std::size_t begin, std::size_t end, ContourWorkspace& workspace) {
            chunks[begin / per_task] = build_contours(data, {begin, end}, before, workspace);
        });
    for (auto* begin : {&data.contour_begin, &data.cap_begin, &data.cover_begin})
        std::partial_sum(begin->begin(), begin->end(), begin->begin());
    const auto is_consistent = [](const ChunkResult& chunk) { return chunk.consistent; };
    if (!std::all_of(chunks.begin(), chunks.end(), is_consistent)) return false;
    const auto join = [&](auto ChunkResult::*part, auto& whole, std::size_t size) {
        whole.clear();
        reserve_touched(whole, size);
        for (const ChunkResult& chunk : chunks) whole.insert(whole.end(), (chunk.*part).begin(), (chunk.*part).end());
    };
    parallel_both([&] { join(&ChunkResult::caps, data.caps, data.cap_begin.back()); },
                  [&] {
                      join(&ChunkResult::arcs, data.contour, data.contour_begin.back());
                      join(&ChunkResult::cover, data.cover, data.cover_begin.back());
                  });
    return true;
}

std::uint64_t hash_of(const VertexKey& key) {
    std::uint64_t h = 0;
    for (const std::uint32_t part : key) {
        h = (h ^ part) * 0x9E3779B97F4A7C15ULL;
        h ^= h >> 29U;
    }
    return h * 0xBF58476D1CE4E5B9ULL;
}

// Order-free sums of hashes: of vertices by which of their atoms finds them, and of arcs.
struct HashSums {
    std::array<std::uint64_t, 3> vertices{};
    std::array<std::uint64_t, 2> arcs{};

    void add(std::uint32_t i, const ArcView& arc) {
        const bool smaller = i < arc.other;
        const VertexKey ends{smaller ? arc.from : arc.to, smaller ? arc.to : arc.from, 0};
        const VertexKey pair{std::min(i, arc.other), std::max(i, arc.other), 1};
        arcs[smaller ? 0 : 1] += hash_of(pair) * (hash_of(ends) | 1U);
        if (arc.to == kWholeCircle) return;
        const VertexKey key{i, arc.other, arc.to};
        const std::size_t first = place_of_smallest(key);
        vertices[first] += hash_of(rotated(key, first));
    }
    HashSums& operator+=(const HashSums& b) {
        for (std::size_t k = 0; k < vertices.size(); ++k) vertices[k] += b.vertices[k];
        for (std::size_t k = 0; k < arcs.size(); ++k) arcs[k] += b.arcs[k];
        return *this;
    }
    bool agree() const { return vertices[0] == vertices[1] && vertices[1] == vertices[2] && arcs[0] == arcs[1]; }
};

// Every vertex must be found by its three atoms and every arc by its two.
bool contours_agree(const AccessibleSurface::Data& data) {
    const HashSums sums = parallel_sum<HashSums>(data.atoms.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        HashSums of_these;
        for (std::size_t atom = begin; atom < end; ++atom) {
            const auto i = static_cast<std::uint32_t>(atom);
            for (const ContourArc& contour_arc : data.contour_of(i)) of_these.add(i, view_of(data, i, contour_arc));
        }
        return of_these;
    });
    return sums.agree();
}

// Numbers the vertices: each belongs to the smallest of its atoms.
class VertexTable {
public:
    explicit VertexTable(const AccessibleSurface::Data& data) : begin_(data.atoms.size() + 1, 0) {
        keys_.reserve(data.contour.size() / 3);
        for (std::uint32_t i = 0; i < data.atoms.size(); ++i) {
            for (const ContourArc& contour_arc : data.contour_of(i))
                if (const ArcView arc = view_of(data, i, contour_arc);
                    arc.to != kWholeCircle && i < arc.other && i < arc.to)
                    keys_.push_back({i, arc.other, arc.to});
            begin_[i + 1] = keys_.size();
        }
    }
    const std::vector<VertexKey>& keys() const { return keys_; }
    std::uint32_t find(const VertexKey& any_order) const {
        const VertexKey key = rotated(any_order, place_of_smallest(any_order));
        for (std::size_t v = begin_[key[0]]; v < begin_[key[0] + 1]; ++v)
            if (((keys_[v][1] ^ key[1]) | (keys_[v][2] ^ key[2])) == 0) return static_cast<std::uint32_t>(v);
        return kNoVertex;
    }

private:
    std::vector<std::uint64_t> begin_;
    std::vector<VertexKey> keys_;
};

void place_vertices(AccessibleSurface::Data& data, const VertexTable& table) {
    resize_touched(data.vertices, table.keys().size());
    parallel_for(data.vertices.size(), kChunk, [&](std::size_t v) {
        const auto& [i, j, k] = table.keys()[v];
        const Vec3 n = rim_crossing(cap_between(data, i, j), cap_between(data, i, k));
        data.vertices[v] = {.atoms = {i, j, k}, .position = data.atoms.centres[i] + data.rho[i] * n};
    });
}

struct InPlane {
    double x;
    double y;
};

// Angle swept from `start` to `end` around the circle that both lie on; `pseudo` (of period 4) tells 0 from a full
// turn.
double swept_angle(const InPlane& start, const InPlane& end, double pseudo) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    double sweep = elementary::atan2(start.x * end.y - start.y * end.x, start.x * end.x + start.y * end.y);
    if (sweep < 0.0) sweep += kTurn;
    if (pseudo < 1.0 && sweep > 0.75 * kTurn) return 0.0;
    if (pseudo > 3.0 && sweep < 0.25 * kTurn) return kTurn;
    return sweep;
}

SasArc make_arc(const AccessibleSurface::Data& data, const VertexTable& table, std::uint32_t i, const ArcView& view) {
    const Cap cap = cap_between(data, i, view.other);
    const double rho = data.rho[i];
    SasArc arc;
    arc.atoms = {i, view.other};
    arc.axis = cap.axis;
    arc.height0 = cap.t * rho;
    arc.height1 = norm(data.atoms.centres[view.other] - data.atoms.centres[i]) - arc.height0;
    arc.centre = data.atoms.centres[i] + arc.height0 * cap.axis;
    arc.radius = rho * std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t));
    const Vec3 e1 = perpendicular(cap.axis);
    const Vec3 e2 = cross(e1, cap.axis);  // the contour runs clockwise around the cap
    arc.middle = e1;
    arc.angle = 2.0 * std::numbers::pi;
    if (view.from == kWholeCircle) return arc;
    arc.start = table.find({i, view.from, view.other});
    arc.end = table.find({i, view.other, view.to});
    const auto in_plane = [&](std::uint32_t vertex) {
        const Vec3 q = data.vertices[vertex].position - arc.centre;
        return InPlane{dot(q, e1), dot(q, e2)};
    };
    const InPlane start = in_plane(arc.start);
    arc.angle = swept_angle(start, in_plane(arc.end), view.sweep);
    const double half = 0.5 * arc.angle;
    arc.cos_half = elementary::cos(half);
    const double length = std::sqrt(start.x * start.x + start.y * start.y);
    if (length > 0.0) {
        const double sine = elementary::sin(half) / length;
        const double cosine = arc.cos_half / length;
        arc.middle = (cosine * start.x - sine * start.y) * e1 + (sine * start.x + cosine * start.y) * e2;
    }
    return arc;
}

// The arcs in their order, each by the smaller of its atoms and its position in `contour`.
struct OwnedArcs {
    struct Owned {
        std::uint32_t atom;
        std::size_t contour;
    };
    std::vector<Owned> all;
    std::vector<std::uint64_t> begin;  // per atom, and the end
};

// Fills contour_arc as far as the smaller atoms see the arcs.
OwnedArcs number_arcs(AccessibleSurface::Data& data) {
    OwnedArcs owned;
    owned.all.reserve(data.contour.size() / 2);
    owned.begin.assign(data.atoms.size() + 1, 0);
    data.contour_arc.assign(data.contour.size(), 0);
    for (std::uint32_t i = 0; i < data.atoms.size(); ++i) {
        for (std::size_t c = data.contour_begin[i]; c < data.contour_begin[i + 1]; ++c) {
            if (i > data.cover_of(i)[data.contour[c].cap]) continue;
            data.contour_arc[c] = static_cast<std::uint32_t>(owned.all.size());
            owned.all.push_back({i, c});
        }
        owned.begin[i + 1] = owned.all.size();
    }
    return owned;
}

void place_arcs(AccessibleSurface::Data& data, const VertexTable& table, const OwnedArcs& owned) {
    resize_touched(data.arcs, owned.all.size());
    parallel_for(owned.all.size(), kChunk, [&](std::size_t a) {
        const auto& [atom, contour] = owned.all[a];
        data.arcs[a] = make_arc(data, table, atom, view_of(data, atom, data.contour[contour]));
    });
    // The larger atom sees the same arc from its other end.
    parallel_for(data.atoms.size(), kChunk, [&](std::size_t atom) {
        const auto j = static_cast<std::uint32_t>(atom);
        for (std::size_t c = data.contour_begin[j]; c < data.contour_begin[j + 1]; ++c) {
            const ArcView view = view_of(data, j, data.contour[c]);
            const std::uint32_t i = view.other;
            if (j < i) continue;
            for (std::size_t a = owned.begin[i]; a < owned.begin[i + 1]; ++a) {
                if (data.arcs[a].atoms[1] != j) continue;
                const ArcView own = view_of(data, i, data.contour[owned.all[a].contour]);
                if (own.from == view.to && own.to == view.from) data.contour_arc[c] = static_cast<std::uint32_t>(a);
            }
        }
    });
}

// From features to those that touch them.
void link_features(AccessibleSurface::Data& data) {
    data.cap_arc.assign(data.caps.size(), kNoArc);
    parallel_for(data.atoms.size(), kChunk, [&](std::size_t i) {
        for (std::size_t c = data.contour_begin[i]; c < data.contour_begin[i + 1]; ++c)
            data.cap_arc[data.cap_begin[i] + data.contour[c].cap] = data.contour_arc[c];
    });
    // The three arcs that end at a vertex have places of their own.
    parallel_for(data.arcs.size(), kChunk, [&](std::size_t a) {
        const SasArc& arc = data.arcs[a];
        if (arc.whole_circle()) return;
        const auto [i, j] = arc.atoms;
        for (const std::uint32_t v : {arc.start, arc.end}) {
            const auto& [first, second, third] = data.vertices[v].atoms;
            const std::size_t other = first != i && first != j ? 0 : second != i && second != j ? 1 : 2;
            data.vertices[v].arcs[other] = static_cast<std::uint32_t>(a);
        }
    });
}

// Box of an arc: its ends, its midpoint, and the extreme points of the circle that lie on it.
Box box_of(const AccessibleSurface::Data& data, const SasArc& arc) {
    Box box;
    if (!arc.whole_circle()) {
        box.include(data.vertices[arc.start].position);
        box.include(data.vertices[arc.end].position);
    }
    box.include(arc.centre + arc.radius * arc.middle);
    for (const Vec3 unit : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const Vec3 direction = unit - dot(unit, arc.axis) * arc.axis;
        const double length = norm(direction);
        if (length < 1e-9) continue;  // the axis is parallel to this coordinate: the circle is flat in it
        const Vec3 radial = (1.0 / length) * direction;
        const double along = dot(radial, arc.middle);
        if (along >= arc.cos_half) box.include(arc.centre + arc.radius * radial);
        if (-along >= arc.cos_half) box.include(arc.centre - arc.radius * radial);
    }
    return box.grown(1e-9);  // rounding
}

// Boxes are kept for one tree at a time: memory that is taken for the first time costs more than to fill it.
void build_trees(AccessibleSurface::Data& data) {
    const auto of_arcs = [&] {
        std::vector<Box> boxes(data.arcs.size());
        parallel_for(boxes.size(), kChunk, [&](std::size_t a) { boxes[a] = box_of(data, data.arcs[a]); });
        data.arc_tree = BoxTree(boxes);
        parallel_for(boxes.size(), kChunk, [&](std::size_t a) {
            const SasArc& arc = data.arcs[a];
            for (const std::uint32_t i : arc.atoms) boxes[a].include(data.atoms.centres[i]);
            if (arc.is_a_point()) boxes[a] = {};  // nothing is nearest to it
        });
        data.arc_cell_tree = BoxTree(boxes);
    };
    const auto of_points = [&] {
        std::vector<Box> boxes(data.vertices.size());
        for (std::size_t v = 0; v < boxes.size(); ++v) boxes[v].include(data.vertices[v].position);
        data.vertex_tree = BoxTree(boxes);
        boxes.assign(data.atoms.size(), {});
        for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i].include(data.atoms.centres[i]);
        data.atom_tree = BoxTree(boxes);
    };
    parallel_both(of_arcs, of_points);
}

// Sets the enlarged radii; each attempt perturbs them ten times as much as the one before.
void enlarge_radii(AccessibleSurface::Data& data, std::uint64_t seed, int attempt) {
    data.rho.resize(data.atoms.size());
    data.perturbation = std::max(kPerturbation, kPerturbationOfRadius * data.rho_max) * elementary::pow(10.0, attempt);
    for (std::size_t i = 0; i < data.atoms.size(); ++i)
        data.rho[i] =
            data.atoms.radii[i] + data.probe +
            data.perturbation * symmetry_breaking_offset(data.atoms.centres[i], data.atoms.radii[i],
                                                         seed * kMaxAttempts + static_cast<std::uint64_t>(attempt));
}

// Returns false if the arrangement of the enlarged spheres came out inconsistent. `before` holds the same atoms under
// another perturbation, or is null.
bool try_build(AccessibleSurface::Data& data, const CellList& cells, const AccessibleSurface::Data* before) {
    if (!build_contours(data, cells, before) || !contours_agree(data)) return false;
    std::optional<VertexTable> table;
    OwnedArcs owned;
    parallel_both([&] { table.emplace(data); }, [&] { owned = number_arcs(data); });
    place_vertices(data, *table);
    place_arcs(data, *table, owned);
    link_features(data);
    build_trees(data);
    return true;
}

std::atomic<std::size_t> built{0};

void build(AccessibleSurface::Data& data, std::uint64_t seed, const AccessibleSurface::Data* before) {
    const CellList cells(data.atoms);
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
        enlarge_radii(data, seed, attempt);
        if (try_build(data, cells, before)) return;
    }
    throw std::runtime_error("the arrangement of atoms could not be resolved by perturbing their radii");
}

}  // namespace

AccessibleSurface::AccessibleSurface(const Atoms& atoms, double probe, std::uint64_t seed) {
    require_not_negative("probe", probe);
    auto data = std::make_unique<Data>();
    data->probe = probe;
    const double r_max = atoms.radii.empty() ? 1.0 : *std::max_element(atoms.radii.begin(), atoms.radii.end());
    data->rho_max = r_max + probe + 1e-3;
    data->atoms = canonical_atoms(atoms, 2.0 * data->rho_max);
    build(*data, seed, nullptr);
    data_ = std::move(data);
    ++built;
}

AccessibleSurface::AccessibleSurface(std::unique_ptr<Data> data) : data_(std::move(data)) {}

AccessibleSurface AccessibleSurface::perturbed(std::uint64_t seed) const {
    auto data = std::make_unique<Data>();
    data->probe = data_->probe;
    data->rho_max = data_->rho_max;
    data->atoms = data_->atoms;
    build(*data, seed, data_.get());
    return AccessibleSurface(std::move(data));
}

AccessibleSurface::~AccessibleSurface() = default;
AccessibleSurface::AccessibleSurface(AccessibleSurface&&) noexcept = default;
AccessibleSurface& AccessibleSurface::operator=(AccessibleSurface&&) noexcept = default;

std::size_t accessible_surfaces_built() { return built; }

double AccessibleSurface::probe() const { return data_->probe; }
std::size_t AccessibleSurface::atom_count() const { return data_->atoms.size(); }
std::size_t AccessibleSurface::exposed_atom_count() const {
    return static_cast<std::size_t>(std::count(data_->exposed.begin(), data_->exposed.end(), std::uint8_t{1}));
}
std::size_t AccessibleSurface::arc_count() const { return data_->arcs.size(); }
std::size_t AccessibleSurface::vertex_count() const { return data_->vertices.size(); }

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/components.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/parallel.h"
#include "core/parallel_list.h"
#include "meniscus/errors.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 8192;  // vertices or triangles per task: some tens of microseconds

std::size_t place_among(std::span<const std::uint32_t> rising, std::uint32_t value) {
    return static_cast<std::size_t>(std::lower_bound(rising.begin(), rising.end(), value) - rising.begin());
}

// Union-find that several threads can join in at once. What hangs together in the end, and that the root of a set is
// its smallest member, does not depend on who comes first: members point to smaller ones of their set, only roots get
// another parent that matters, by a compare-and-swap, and a shortcut that is written over another one leads to the same
// root.
class SharedSets {
public:
    explicit SharedSets(std::size_t size) {
        resize_touched(parent_, size);
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    // Joins the corners of every second triangle by moves alone, which nothing has to foresee, before anything else is
    // done. What others have joined may come apart, for parents are written over.
    void link(std::span<const Triangle> triangles) {
        const Parents parents = parents_of_all();
        for (std::size_t t = 0; t < triangles.size(); t += 2) {
            const auto& [a, b, c] = triangles[t];
            const std::uint32_t of_a = parents.load(a);
            const std::uint32_t of_b = parents.load(b);
            const std::uint32_t of_c = parents.load(c);
            const std::uint32_t parent = parents.load(std::min(std::min(of_a, of_b), of_c));
            parents.store(std::max(std::max(of_a, of_b), of_c), parent);
            parents.store(a, parent);
            parents.store(b, parent);
            parents.store(c, parent);
        }
    }

    // Makes all members point to their roots, and nobody writes over that; returns the roots, rising.
    std::vector<std::uint32_t> flatten() {
        const auto flatten_some = [this](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& roots) {
            const Parents parents = parents_of_all();
            for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                std::uint32_t top = parents.load(i);
                if (top == i) roots.push_back(i);
                for (std::uint32_t above = parents.load(top); above != top; above = parents.load(top)) top = above;
                parents.store(i, top);
            }
        };
        return parallel_list<std::uint32_t>(parent_.size(), kChunk, flatten_some);
    }

    // Joins the corners of triangles for good.
    void join(std::span<const Triangle> triangles) {
        const Parents parents = parents_of_all();
        for (const auto& [a, b, c] : triangles) {
            const std::uint32_t parent = parents.load(a);
            if (parent == parents.load(b) && parent == parents.load(c)) continue;
            join(a, b);
            join(a, c);
        }
    }

    std::uint32_t root(std::uint32_t i) { return parents_of_all().root(i); }

    // What every member points to; nothing of the sets is left behind.
    std::vector<std::uint32_t> parents() && { return std::move(parent_); }

private:
    // By value: compilers load what is behind a reference again after every store.
    struct Parents {
        std::uint32_t* first;
        // What std::atomic_ref would do, which not every C++20 library has.
        std::uint32_t load(std::uint32_t i) const { return __atomic_load_n(&first[i], __ATOMIC_RELAXED); }
        void store(std::uint32_t i, std::uint32_t parent) const {
            __atomic_store_n(&first[i], parent, __ATOMIC_RELAXED);
        }
        bool replace(std::uint32_t i, std::uint32_t old, std::uint32_t parent) const {
            return __atomic_compare_exchange_n(&first[i], &old, parent, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
        }
        std::uint32_t root(std::uint32_t i) const {
            for (std::uint32_t parent = load(i); parent != i; parent = load(i)) {
                const std::uint32_t above = load(parent);
                if (above == parent) return parent;
                store(i, above);
                i = above;
            }
            return i;
        }
    };
    Parents parents_of_all() { return {parent_.data()}; }

    void join(std::uint32_t a, std::uint32_t b) {
        const Parents parents = parents_of_all();
        for (a = parents.root(a), b = parents.root(b); a != b; a = parents.root(a), b = parents.root(b)) {
            if (a < b) std::swap(a, b);
            if (alone_) {
                parents.store(a, b);
                return;
            }
            if (parents.replace(a, a, b)) return;
        }
    }

    std::vector<std::uint32_t> parent_;
    bool alone_ = is_alone();  // a compare-and-swap takes as long as all the rest
};

// The numbers of the sets that some rising members belong to, in the order of their smallest ones.
std::vector<std::uint32_t> numbers_of_sets(SharedSets& sets, std::span<const std::uint32_t> members) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(members.size());
    std::uint32_t next = 0;
    for (const std::uint32_t member : members) {
        const std::uint32_t root = sets.root(member);
        numbers.push_back(root == member ? next++ : numbers[place_among(members, root)]);
    }
    return numbers;
}

// How many vertices from the first one on belong to its piece.
std::size_t length_of_run(std::span<const std::uint32_t> of_vertex) {
    constexpr std::size_t kTogether = 16;  // compared as vectors
    const std::uint32_t piece = of_vertex[0];
    std::size_t length = 1;
    for (std::uint32_t others = 0; length + kTogether <= of_vertex.size(); length += kTogether) {
        for (std::size_t i = 0; i < kTogether; ++i) others |= of_vertex[length + i] ^ piece;
        if (others != 0) break;
    }
    while (length < of_vertex.size() && of_vertex[length] == piece) ++length;
    return length;
}

// Vertices of one piece in a row.
struct PieceRun {
    std::uint32_t piece = 0;
    VertexId first = 0;
    std::size_t vertices = 0;
};

}  // namespace

// Vertices are linked by every second triangle, which leaves hardly anything apart. The other look at all triangles
// finds what is: where all corners point to the same vertex nothing is left to do.
std::vector<std::uint32_t> pieces_by_first_vertex(const Mesh& mesh) {
    const std::span<const Triangle> triangles = mesh.triangles;
    SharedSets sets(mesh.vertices.size());
    parallel_chunks(triangles.size(), kChunk,
                    [&](std::size_t begin, std::size_t end) { sets.link(triangles.subspan(begin, end - begin)); });
    const std::vector<std::uint32_t> heads = sets.flatten();
    parallel_chunks(triangles.size(), kChunk,
                    [&](std::size_t begin, std::size_t end) { sets.join(triangles.subspan(begin, end - begin)); });
    const std::vector<std::uint32_t> numbers = numbers_of_sets(sets, heads);
    std::vector<std::uint32_t> piece = std::move(sets).parents();  // still heads, all of them
    parallel_chunks(piece.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        std::uint32_t head = piece[begin];
        std::uint32_t number = numbers[place_among(heads, head)];
        for (std::size_t v = begin; v < end; ++v) {
            if (piece[v] != head) {
                head = piece[v];
                number = numbers[place_among(heads, head)];
            }
            piece[v] = number;
        }
    });
    return piece;
}

PieceVertices vertices_of_pieces(std::span<const std::uint32_t> of_vertex) {
    const auto runs =
        parallel_list<PieceRun>(of_vertex.size(), kChunk, [&](std::size_t begin, std::size_t end, auto& list) {
            for (std::size_t v = begin; v < end; v += list.back().vertices)
                list.push_back({of_vertex[v], static_cast<VertexId>(v), length_of_run(of_vertex.subspan(v, end - v))});
        });
    PieceVertices pieces;
    for (const PieceRun& run : runs) {
        const std::size_t p = run.piece;
        if (p >= of_vertex.size()) throw UsageError("a component number is larger than the mesh has vertices");
        if (p >= pieces.counts.size()) {
            pieces.counts.resize(p + 1);
            pieces.first.resize(p + 1);
        }
        if (pieces.counts[p] == 0) pieces.first[p] = run.first;
        pieces.counts[p] += run.vertices;
    }
    return pieces;
}

std::vector<std::uint32_t> final_order(const std::vector<MeshComponent>& pieces) {
    std::vector<std::uint32_t> order(pieces.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::abs(pieces[a].volume) > std::abs(pieces[b].volume);
    });
    const auto outer =
        std::find_if(order.begin(), order.end(), [&](std::uint32_t p) { return pieces[p].volume > 0.0; });
    if (outer != order.end()) std::rotate(order.begin(), outer, outer + 1);
    return order;
}

std::vector<MeshComponent> measure_components(const Mesh& mesh, std::span<const std::uint32_t> of_vertex) {
    const PieceVertices vertices = vertices_of_pieces(of_vertex);
    std::vector<MeshComponent> pieces(vertices.counts.size());
    for (std::size_t p = 0; p < pieces.size(); ++p) pieces[p].vertices = vertices.counts[p];
    for (std::size_t t = 0; t < mesh.triangles.size();) {
        // One run of triangles of the same piece at a time, summed in registers.
        const std::uint32_t p = of_vertex[mesh.triangles[t][0]];
        const Vec3 origin = mesh.vertices[vertices.first[p]];
        MeshComponent run;
        for (; t < mesh.triangles.size() && of_vertex[mesh.triangles[t][0]] == p; ++t) {
            const auto& [i, j, k] = mesh.triangles[t];
            const Vec3 a = mesh.vertices[i] - origin;
            const Vec3 normal = cross(mesh.vertices[j] - mesh.vertices[i], mesh.vertices[k] - mesh.vertices[i]);
            ++run.triangles;
            run.area += 0.5 * norm(normal);
            run.volume += dot(a, normal);
        }
        pieces[p].triangles += run.triangles;
        pieces[p].area += run.area;
        pieces[p].volume += run.volume / 6.0;
    }
    return pieces;
}

void renumber(std::vector<MeshComponent>& pieces, std::vector<std::uint32_t>& of_vertex) {
    const std::vector<std::uint32_t> order = final_order(pieces);
    if (std::is_sorted(order.begin(), order.end())) return;
    std::vector<std::uint32_t> number(pieces.size());
    std::vector<MeshComponent> ordered;
    ordered.reserve(pieces.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        number[order[i]] = i;
        ordered.push_back(pieces[order[i]]);
    }
    pieces = std::move(ordered);
    parallel_for(of_vertex.size(), kChunk, [&](std::size_t v) { of_vertex[v] = number[of_vertex[v]]; });
}

Components find_components(const Mesh& mesh) {
    Components found{.of_vertex = pieces_by_first_vertex(mesh), .pieces = {}};
    found.pieces = measure_components(mesh, found.of_vertex);
    renumber(found.pieces, found.of_vertex);
    return found;
}

std::vector<MeshComponent> label_components(Mesh& mesh) {
    Components found = find_components(mesh);
    mesh.components = std::move(found.of_vertex);
    return std::move(found.pieces);
}

void keep_components(Mesh& mesh, const std::vector<bool>& keep) {
    const auto kept = [&](VertexId v) { return keep[mesh.components[v]]; };
    std::vector<VertexId> number(mesh.vertices.size());
    VertexId next = 0;
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
        if (!kept(v)) continue;
        mesh.vertices[next] = mesh.vertices[v];
        number[v] = next++;
    }
    const auto gone =
        std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) { return !kept(t[0]); });
    mesh.triangles.erase(gone, mesh.triangles.end());
    for (Triangle& t : mesh.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
    mesh.vertices.resize(next);
    label_components(mesh);
}

}  // namespace meniscus

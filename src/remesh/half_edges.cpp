// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/half_edges.h"

#include <stdexcept>
#include <utility>

#include "meniscus/errors.h"

namespace meniscus {
namespace {

[[noreturn]] void refuse_more() {
    throw LimitError("meshes of more than 1.4e9 triangles cannot be remeshed; choose a larger spacing or longer edges");
}

}  // namespace

HalfEdges::HalfEdges(std::size_t vertices, std::span<const Triangle> triangles) {
    if (triangles.size() >= kNoHalfEdge / 3) refuse_more();
    origin_.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) origin_.insert(origin_.end(), t.begin(), t.end());
    find_twins(vertices);
}

// Half-edges are sorted into lists by their origin; the twin of a -> b is in the list of b.
void HalfEdges::find_twins(std::size_t vertices) {
    twin_.assign(origin_.size(), kNoHalfEdge);
    leaving_.assign(vertices, kNoHalfEdge);
    std::vector<HalfEdge> following(origin_.size(), kNoHalfEdge);  // in the list
    for (HalfEdge h = 0; h < origin_.size(); ++h) following[h] = std::exchange(leaving_[origin_[h]], h);
    for (HalfEdge h = 0; h < origin_.size(); ++h) {
        if (twin_[h] != kNoHalfEdge) continue;
        HalfEdge other = leaving_[target(h)];
        while (other != kNoHalfEdge && (target(other) != origin_[h] || twin_[other] != kNoHalfEdge))
            other = following[other];
        if (other == kNoHalfEdge) throw std::invalid_argument("the mesh is not a closed oriented 2-manifold");
        pair(h, other);
    }
}

std::size_t HalfEdges::valence(VertexId v) const {
    std::size_t count = 0;
    for_each_leaving(v, [&count](HalfEdge) { ++count; });
    return count;
}

bool HalfEdges::are_neighbours(VertexId a, VertexId b) const {
    bool found = false;
    for_each_leaving(a, [&](HalfEdge h) { found = found || target(h) == b; });
    return found;
}

HalfEdge HalfEdges::between(VertexId a, VertexId b) const {
    HalfEdge found = kNoHalfEdge;
    for_each_leaving(a, [&](HalfEdge h) { found = target(h) == b ? h : found; });
    return found;
}

bool HalfEdges::can_flip(HalfEdge h) const {
    const VertexId c = opposite(h);
    const VertexId d = opposite(twin_[h]);
    return c != d && valence(origin(h)) > 3 && valence(target(h)) > 3 && !are_neighbours(c, d);
}

// The edge a b of the triangles a b c and b a d becomes d c.
void HalfEdges::flip(HalfEdge h) {
    const HalfEdge g = twin_[h];
    const HalfEdge bc = next(h);
    const HalfEdge ca = previous(h);
    const HalfEdge ad = next(g);
    const HalfEdge db = previous(g);
    const VertexId a = origin_[h];
    const VertexId b = origin_[g];
    const VertexId c = origin_[ca];
    const VertexId d = origin_[db];
    const HalfEdge outer_bc = twin_[bc];
    const HalfEdge outer_ca = twin_[ca];
    const HalfEdge outer_ad = twin_[ad];
    const HalfEdge outer_db = twin_[db];
    // d c a in the place of a b c, c d b in that of b a d
    origin_[h] = d;
    origin_[bc] = c;
    origin_[ca] = a;
    origin_[g] = c;
    origin_[ad] = d;
    origin_[db] = b;
    pair(bc, outer_ca);
    pair(ca, outer_ad);
    pair(ad, outer_db);
    pair(db, outer_bc);
    leaving_[a] = ca;
    leaving_[b] = db;
    leaving_[c] = g;
    leaving_[d] = h;
}

HalfEdge HalfEdges::add_triangle(VertexId a, VertexId b, VertexId c) {
    if (origin_.size() >= kNoHalfEdge - 3) refuse_more();
    const auto first = static_cast<HalfEdge>(origin_.size());
    origin_.insert(origin_.end(), {a, b, c});
    twin_.resize(origin_.size(), kNoHalfEdge);
    return first;
}

// a b c becomes a m c and m b c; b a d becomes m a d and b m d.
VertexId HalfEdges::split(HalfEdge h) {
    const HalfEdge g = twin_[h];
    const HalfEdge bc = next(h);
    const HalfEdge db = previous(g);
    const HalfEdge outer_bc = twin_[bc];
    const HalfEdge outer_db = twin_[db];
    const VertexId b = origin_[g];
    const VertexId c = opposite(h);
    const VertexId d = opposite(g);
    const auto m = static_cast<VertexId>(leaving_.size());
    const HalfEdge mb = add_triangle(m, b, c);
    const HalfEdge bm = add_triangle(b, m, d);
    origin_[bc] = m;
    origin_[g] = m;
    pair(bc, previous(mb));
    pair(next(mb), outer_bc);
    pair(mb, bm);
    pair(previous(g), next(bm));
    pair(previous(bm), outer_db);
    leaving_.push_back(mb);
    leaving_[b] = bm;
    leaving_[c] = previous(h);
    leaving_[d] = previous(g);
    return m;
}

bool HalfEdges::can_collapse(HalfEdge h) const {
    const VertexId a = origin(h);
    const VertexId b = target(h);
    const VertexId c = opposite(h);
    const VertexId d = opposite(twin_[h]);
    if (c == d || valence(c) <= 3 || valence(d) <= 3) return false;
    bool shared = false;  // a neighbour besides c and d
    for_each_leaving(a, [&](HalfEdge out) {
        const VertexId v = target(out);
        shared = shared || (v != b && v != c && v != d && are_neighbours(v, b));
    });
    return !shared;
}

void HalfEdges::collapse(HalfEdge h) {
    const HalfEdge g = twin_[h];
    const VertexId a = origin_[h];
    const VertexId b = origin_[g];
    const VertexId c = opposite(h);
    const VertexId d = opposite(g);
    const HalfEdge cb = twin_[next(h)];
    const HalfEdge ac = twin_[previous(h)];
    const HalfEdge da = twin_[next(g)];
    const HalfEdge bd = twin_[previous(g)];
    for_each_leaving(a, [&](HalfEdge out) { origin_[out] = b; });
    pair(cb, ac);
    pair(da, bd);
    remove_triangle_of(h);
    remove_triangle_of(g);
    leaving_[a] = kNoHalfEdge;
    leaving_[b] = bd;
    leaving_[c] = cb;
    leaving_[d] = da;
}

void HalfEdges::remove_triangle_of(HalfEdge h) { twin_[h] = twin_[next(h)] = twin_[previous(h)] = kNoHalfEdge; }

std::vector<VertexId> HalfEdges::vertices() const {
    std::vector<VertexId> left;
    left.reserve(leaving_.size());
    for (VertexId v = 0; v < leaving_.size(); ++v)
        if (has_vertex(v)) left.push_back(v);
    return left;
}

std::vector<Triangle> HalfEdges::triangles(std::span<const VertexId> order) const {
    std::vector<VertexId> number(leaving_.size());
    for (std::size_t i = 0; i < order.size(); ++i) number[order[i]] = static_cast<VertexId>(i);
    std::vector<Triangle> triangles;
    triangles.reserve(2 * order.size());
    for (const VertexId v : order)
        for_each_leaving(v, [&](HalfEdge h) {
            const Triangle t{number[v], number[target(h)], number[opposite(h)]};
            if (t[0] < t[1] && t[0] < t[2]) triangles.push_back(t);
        });
    return triangles;
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/ses_patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/disjoint_sets.h"
#include "core/elementary.h"
#include "core/parallel_list.h"
#include "nearest/nearest_feature.h"

namespace meniscus {
namespace {

// Stretches of border shorter than this (radian) may owe themselves to a perturbation: they connect nothing.
constexpr double kShortestBorder = 1e-6;
// Features of two evaluations this close (Å) are the same one, perturbed.
constexpr double kSameFeature = 1e-3;

// The place of the feature most like another one: almost always the same place. Features are in order of their first
// atom.
template <class Feature, class Same>
std::uint32_t find_like(const std::vector<Feature>& features, std::uint32_t place, const Feature& like,
                        const Same& same) {
    if (place < features.size() && same(features[place])) return place;
    const std::uint32_t atom = like.atoms[0];
    const auto first = std::partition_point(features.begin(), features.end(),
                                            [&](const Feature& feature) { return feature.atoms[0] < atom; });
    for (auto found = first; found != features.end() && found->atoms[0] == atom; ++found)
        if (same(*found)) return static_cast<std::uint32_t>(found - features.begin());
    return kNone;
}

// The arc beside an edge of a vertex's triangle, which runs from atom `edge` to the next one: the arc of these two is
// opposite to the third atom, as SasVertex::arcs[k] is to atom k.
std::uint32_t arc_beside(const SasVertex& vertex, std::uint32_t edge) { return vertex.arcs[(edge + 2) % 3]; }

}  // namespace

SesPatches::SesPatches(const AccessibleSurface& surface, std::uint64_t seed)
    : surface_(&surface), seed_(seed), origins_(data()), degenerate_(has_coincident_probes(data())) {
    const ContactsBeside beside = add_contact_patches();
    add_toroidal_patches();
    const std::vector<ReentrantPatch> trimmed = trim_reentrant_patches(surface, seed);
    add_reentrant_patches(trimmed);
    number_components(beside, trimmed);
    number_sas_components(beside);
}

SesPatches::ContactsBeside SesPatches::add_contact_patches() {
    const AccessibleSurface::Data& data = this->data();
    const std::size_t atoms = data.atoms.size();
    ContactsBeside beside(data.contour.size());  // at first the region of the atom
    first_.contact.assign(atoms + 1, 0);
    patches_ =
        parallel_list<SesPatch>(atoms, 128, [&](std::size_t begin, std::size_t end, std::vector<SesPatch>& list) {
            SphericalRegions regions;
            for (std::size_t i = begin; i < end; ++i) {
                const auto atom = static_cast<std::uint32_t>(i);
                if (data.exposed[i] == 0) continue;
                regions.measure(data.caps_of(atom), data.contour_of(atom));
                const Vec3 centre = data.atoms.centres[i] - origins_.of(atom);
                const double rho = data.rho[i];
                for (std::uint32_t r = 0; r < regions.regions().size(); ++r)
                    list.push_back({.feature = atom,
                                    .part = r,
                                    .ses = sphere_patch(centre, rho - data.probe, regions.regions()[r], 1),
                                    .sas = sphere_patch(centre, rho, regions.regions()[r], 1)});
                first_.contact[i + 1] = static_cast<std::uint32_t>(regions.regions().size());
                for (std::size_t a = 0; a < regions.arcs().size(); ++a)
                    beside[data.contour_begin[i] + a] = regions.arcs()[a].region;
            }
        });
    patches_.reserve(atoms + data.arcs.size() + data.vertices.size());  // about: few fall apart
    std::partial_sum(first_.contact.begin(), first_.contact.end(), first_.contact.begin());
    for (std::size_t i = 0; i < atoms; ++i)
        for (std::size_t c = data.contour_begin[i]; c < data.contour_begin[i + 1]; ++c) beside[c] += first_.contact[i];
    return beside;
}

void SesPatches::add_toroidal_patches() {
    const AccessibleSurface::Data& data = this->data();
    first_.torus.assign(1, static_cast<std::uint32_t>(patches_.size()));
    for (std::uint32_t a = 0; a < data.arcs.size(); ++a) {
        const SasArc& arc = data.arcs[a];
        const ToroidalPatch torus = toroidal_patch(arc, data.probe);
        for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(torus.count); ++k)
            patches_.push_back(
                {.kind = PatchKind::Toroidal,
                 .feature = a,
                 .part = k,
                 .ses = toroidal_piece(arc, data.probe, torus.pieces[k], arc.centre - origins_.of(arc.atoms[0])),
                 .sas = {},
                 .area_at_first = toroidal_area_at_first(arc, data.probe, torus.pieces[k])});
        first_.torus.push_back(static_cast<std::uint32_t>(patches_.size()));
    }
}

void SesPatches::add_reentrant_patches(const std::vector<ReentrantPatch>& trimmed) {
    first_.reentrant.assign(1, static_cast<std::uint32_t>(patches_.size()));
    for (std::uint32_t v = 0; v < trimmed.size(); ++v) {
        const ReentrantPatch& patch = trimmed[v];
        const Vec3 centre = data().vertices[v].position - origins_.of(data().vertices[v].atoms[0]);
        degenerate_ = degenerate_ || patch.degenerate;
        if (!patch.consistent) unresolved_.push_back(v);
        for (std::uint32_t r = 0; r < patch.regions.size(); ++r)
            patches_.push_back({.kind = PatchKind::Reentrant,
                                .feature = v,
                                .part = r,
                                .ses = sphere_patch(centre, data().probe, patch.regions[r], -1),
                                .sas = {}});
        first_.reentrant.push_back(static_cast<std::uint32_t>(patches_.size()));
    }
}

const Vec3& SesPatches::origin_of(const SesPatch& patch) const {
    if (patch.kind == PatchKind::Contact) return origins_.of(patch.feature);
    if (patch.kind == PatchKind::Toroidal) return origins_.of(data().arcs[patch.feature].atoms[0]);
    return origins_.of(data().vertices[patch.feature].atoms[0]);
}

// The toroidal patch on an atom's side of an arc.
std::uint32_t SesPatches::torus_patch(std::uint32_t arc, std::uint32_t atom) const {
    const bool cut = first_.torus[arc + 1] - first_.torus[arc] == 2;
    return first_.torus[arc] + (cut && data().arcs[arc].atoms[1] == atom ? 1 : 0);
}

// The toroidal patch of an arc on the side of its plane where a point is.
std::uint32_t SesPatches::torus_patch_at(std::uint32_t arc, const Vec3& point) const {
    const SasArc& at = data().arcs[arc];
    return torus_patch(arc, dot(at.axis, point - at.centre) > 0.0 ? at.atoms[1] : at.atoms[0]);
}

// The patch on the other side of a stretch of a reentrant patch's border.
std::uint32_t SesPatches::patch_across(const std::vector<ReentrantPatch>& trimmed, std::uint32_t vertex,
                                       const TrimmedArc& arc) const {
    const Vec3& centre = data().vertices[vertex].position;
    const Vec3 point = centre + data().probe * arc.middle;
    if (arc.probe == TrimmedArc::kNoProbe) {
        const std::uint32_t beside = arc_beside(data().vertices[vertex], arc.edge);
        return beside == kNoArc ? kNone : torus_patch_at(beside, point);
    }
    // The other probe's border along the same circle: the stretch that reaches nearest to the middle of ours.
    const std::uint32_t w = arc.probe;
    std::uint32_t best = kNone;
    double least = 1e-3;  // radian beyond its ends
    for (const TrimmedArc& other : trimmed[w].arcs) {
        if (other.probe != vertex || other.angle < kShortestBorder) continue;
        const Vec3 to_point = point - data().vertices[w].position;
        const Vec3 from_axis = to_point - dot(to_point, other.axis) * other.axis;
        const Vec3 middle = other.middle - dot(other.middle, other.axis) * other.axis;
        const double angle = elementary::atan2(norm(cross(from_axis, middle)), dot(from_axis, middle));
        const double beyond = angle - 0.5 * other.angle;
        if (beyond >= least) continue;
        least = beyond;
        best = first_.reentrant[w] + other.region;
    }
    return best;
}

// Patches that share a stretch of border belong to one component.
void SesPatches::number_components(const ContactsBeside& beside, const std::vector<ReentrantPatch>& trimmed) {
    const AccessibleSurface::Data& data = this->data();
    DisjointSets sets(patches_.size());
    for (std::uint32_t i = 0; i < data.atoms.size(); ++i)
        for (std::size_t c = data.contour_begin[i]; c < data.contour_begin[i + 1]; ++c)
            sets.join(beside[c], torus_patch(data.contour_arc[c], i));
    for (std::uint32_t v = 0; v < trimmed.size(); ++v)
        for (const TrimmedArc& arc : trimmed[v].arcs) {
            if (arc.angle < kShortestBorder) continue;
            const std::uint32_t across = patch_across(trimmed, v, arc);
            if (across != kNone) sets.join(first_.reentrant[v] + arc.region, across);
        }
    const std::vector<std::uint32_t> component = sets.numbers();
    pieces_.ses = set_count(component);
    for (std::size_t p = 0; p < component.size(); ++p) patches_[p].component = component[p];
}

// Contact patches on both sides of an arc belong to one piece of the SAS. A torus belongs to the piece that its arc
// lies on, a reentrant patch to that of any of its vertex's arcs, which meet.
void SesPatches::number_sas_components(const ContactsBeside& beside) {
    const AccessibleSurface::Data& data = this->data();
    DisjointSets sets(first_.torus.front());
    std::vector<std::uint32_t> contact_of(data.arcs.size(), kNone);
    for (std::size_t c = 0; c < beside.size(); ++c) {
        std::uint32_t& contact = contact_of[data.contour_arc[c]];
        if (contact == kNone)
            contact = beside[c];
        else
            sets.join(beside[c], contact);
    }
    const std::vector<std::uint32_t> piece = sets.numbers();
    pieces_.sas = set_count(piece);
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        SesPatch& patch = patches_[p];
        if (patch.kind == PatchKind::Contact) {
            patch.sas_component = piece[p];
            continue;
        }
        const std::uint32_t arc =
            patch.kind == PatchKind::Toroidal ? patch.feature : data.vertices[patch.feature].arcs.back();
        if (arc != kNoArc) patch.sas_component = piece[contact_of[arc]];
    }
}

std::uint32_t SesPatches::component_of_nearest_area(std::uint32_t begin, std::uint32_t end, double area) const {
    const auto off = [&](const SesPatch& patch) { return std::abs(patch.ses.area - area); };
    const auto nearest = std::min_element(patches_.begin() + begin, patches_.begin() + end,
                                          [&](const SesPatch& a, const SesPatch& b) { return off(a) < off(b); });
    return begin == end ? kNone : nearest->component;
}

std::uint32_t SesPatches::component_like_contact(std::uint32_t atom, double area) const {
    return component_of_nearest_area(first_.contact[atom], first_.contact[atom + 1], area);
}

std::uint32_t SesPatches::component_like_torus(std::uint32_t arc, const SasArc& like, std::uint32_t part) const {
    const Vec3 middle = like.centre + like.radius * like.middle;
    const std::uint32_t found = find_like(data().arcs, arc, like, [&](const SasArc& own) {
        return own.atoms == like.atoms && ((own.whole_circle() && like.whole_circle()) ||
                                           norm(own.centre + own.radius * own.middle - middle) < kSameFeature);
    });
    if (found == kNone) return kNone;
    const std::uint32_t parts = first_.torus[found + 1] - first_.torus[found];
    return parts == 0 ? kNone : patches_[first_.torus[found] + std::min(part, parts - 1)].component;
}

std::uint32_t SesPatches::component_like_reentrant(std::uint32_t vertex, const SasVertex& like, double area) const {
    const std::uint32_t found = find_like(data().vertices, vertex, like, [&](const SasVertex& own) {
        return own.atoms == like.atoms && norm(own.position - like.position) < kSameFeature;
    });
    if (found != kNone) return component_of_nearest_area(first_.reentrant[found], first_.reentrant[found + 1], area);
    // Where a probe touches more than three atoms, their triangles depend on the perturbation.
    Box here;
    here.include(like.position);
    std::uint32_t component = kNone;
    data().vertex_tree.for_each_overlapping(here.grown(kSameFeature), [&](std::uint32_t v) {
        if (component == kNone)
            component = component_of_nearest_area(first_.reentrant[v], first_.reentrant[v + 1], area);
    });
    return component;
}

std::array<std::uint32_t, 3> SesPatches::atoms_of(const SesPatch& patch) const {
    if (patch.kind == PatchKind::Contact) return {patch.feature, kNone, kNone};
    if (patch.kind == PatchKind::Reentrant) return data().vertices[patch.feature].atoms;
    const auto& atoms = data().arcs[patch.feature].atoms;
    return {atoms[0], atoms[1], kNone};
}

std::uint32_t SesPatches::component_at(const Vec3& point) const {
    const NearestHit hit = nearest_hit(data(), point);
    if (hit.by_ball) {
        SphericalRegions regions;
        regions.measure(data().caps_of(hit.ball.atom), data().contour_of(hit.ball.atom));
        const Vec3 q = point - data().atoms.centres[hit.ball.atom];
        return patches_[first_.contact[hit.ball.atom] + regions.region_of(normalised(q))].component;
    }
    if (hit.edge.vertex == kNoVertex) return patches_[torus_patch_at(hit.edge.arc, point)].component;
    const std::uint32_t v = hit.edge.vertex;
    if (first_.reentrant[v] == first_.reentrant[v + 1]) return kNone;
    const std::uint32_t part =
        reentrant_region_of(*surface_, seed_, v, normalised(point - data().vertices[v].position));
    return patches_[first_.reentrant[v] + part].component;
}

}  // namespace meniscus

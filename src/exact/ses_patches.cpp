// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/ses_patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
    : surface_(&surface), data_(&surface.data()), seed_(seed), origins_(*data_) {
    degenerate_ = has_coincident_probes(*data_);
    add_contact_patches();
    add_toroidal_patches();
    reentrant_ = trim_reentrant_patches(surface, seed);
    add_reentrant_patches();
    number_components();
}

void SesPatches::add_contact_patches() {
    const std::size_t atoms = data_->atoms.size();
    std::vector<std::uint32_t> arc_region(data_->contour.size());  // of each arc of a contour: region beside it
    first_contact_.assign(atoms + 1, 0);
    patches_ =
        parallel_list<SesPatch>(atoms, 128, [&](std::size_t begin, std::size_t end, std::vector<SesPatch>& list) {
            SphericalRegions regions;
            for (std::size_t i = begin; i < end; ++i) {
                const auto atom = static_cast<std::uint32_t>(i);
                if (data_->exposed[i] == 0) continue;
                regions.measure(data_->caps_of(atom), data_->contour_of(atom));
                const Vec3 centre = data_->atoms.centres[i] - origins_.of(atom);
                const double rho = data_->rho[i];
                for (std::uint32_t r = 0; r < regions.regions().size(); ++r)
                    list.push_back({.feature = atom,
                                    .part = r,
                                    .ses = sphere_patch(centre, rho - data_->probe, regions.regions()[r], 1),
                                    .sas = sphere_patch(centre, rho, regions.regions()[r], 1)});
                first_contact_[i + 1] = static_cast<std::uint32_t>(regions.regions().size());
                for (std::size_t a = 0; a < regions.arcs().size(); ++a)
                    arc_region[data_->contour_begin[i] + a] = regions.arcs()[a].region;
            }
        });
    patches_.reserve(atoms + data_->arcs.size() + data_->vertices.size());  // about: few fall apart
    std::partial_sum(first_contact_.begin(), first_contact_.end(), first_contact_.begin());
    // Contact patches on both sides of an arc belong to one piece of the SAS.
    sas_sets_.grow(patches_.size());
    std::vector<std::uint32_t> beside(data_->arcs.size(), kNone);
    for (std::size_t i = 0; i < atoms; ++i)
        for (std::size_t c = data_->contour_begin[i]; c < data_->contour_begin[i + 1]; ++c) {
            const std::uint32_t patch = first_contact_[i] + arc_region[c];
            std::uint32_t& other = beside[data_->contour_arc[c]];
            if (other == kNone)
                other = patch;
            else
                sas_sets_.join(patch, other);
        }
    contact_beside_arc_ = std::move(arc_region);
}

void SesPatches::add_toroidal_patches() {
    first_torus_.assign(1, static_cast<std::uint32_t>(patches_.size()));
    for (std::uint32_t a = 0; a < data_->arcs.size(); ++a) {
        const SasArc& arc = data_->arcs[a];
        const ToroidalPatch torus = toroidal_patch(arc, data_->probe);
        for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(torus.count); ++k)
            patches_.push_back(
                {.kind = PatchKind::Toroidal,
                 .feature = a,
                 .part = k,
                 .ses = toroidal_piece(arc, data_->probe, torus.pieces[k], arc.centre - origins_.of(arc.atoms[0])),
                 .sas = {},
                 .area_at_first = toroidal_area_at_first(arc, data_->probe, torus.pieces[k])});
        first_torus_.push_back(static_cast<std::uint32_t>(patches_.size()));
    }
    sets_.grow(patches_.size());
    for (std::uint32_t i = 0; i < data_->atoms.size(); ++i)
        for (std::size_t c = data_->contour_begin[i]; c < data_->contour_begin[i + 1]; ++c)
            sets_.join(first_contact_[i] + contact_beside_arc_[c], torus_patch(data_->contour_arc[c], i));
}

void SesPatches::add_reentrant_patches() {
    first_reentrant_.assign(1, static_cast<std::uint32_t>(patches_.size()));
    for (std::uint32_t v = 0; v < reentrant_.size(); ++v) {
        const ReentrantPatch& patch = reentrant_[v];
        const Vec3 centre = data_->vertices[v].position - origins_.of(data_->vertices[v].atoms[0]);
        degenerate_ = degenerate_ || patch.degenerate;
        if (!patch.consistent) unresolved_.push_back(v);
        for (std::uint32_t r = 0; r < patch.regions.size(); ++r)
            patches_.push_back({.kind = PatchKind::Reentrant,
                                .feature = v,
                                .part = r,
                                .ses = sphere_patch(centre, data_->probe, patch.regions[r], -1),
                                .sas = {}});
        first_reentrant_.push_back(static_cast<std::uint32_t>(patches_.size()));
    }
    sets_.grow(patches_.size());
    for (std::uint32_t v = 0; v < reentrant_.size(); ++v)
        for (const TrimmedArc& arc : reentrant_[v].arcs) {
            if (arc.angle < kShortestBorder) continue;
            const std::uint32_t across = patch_across(v, arc);
            if (across != kNone) sets_.join(first_reentrant_[v] + arc.region, across);
        }
}

const Vec3& SesPatches::origin_of(const SesPatch& patch) const {
    if (patch.kind == PatchKind::Contact) return origins_.of(patch.feature);
    if (patch.kind == PatchKind::Toroidal) return origins_.of(data_->arcs[patch.feature].atoms[0]);
    return origins_.of(data_->vertices[patch.feature].atoms[0]);
}

// The toroidal patch on an atom's side of an arc.
std::uint32_t SesPatches::torus_patch(std::uint32_t arc, std::uint32_t atom) const {
    const bool cut = first_torus_[arc + 1] - first_torus_[arc] == 2;
    return first_torus_[arc] + (cut && data_->arcs[arc].atoms[1] == atom ? 1 : 0);
}

// The toroidal patch of an arc on the side of its plane where a point is.
std::uint32_t SesPatches::torus_patch_at(std::uint32_t arc, const Vec3& point) const {
    const SasArc& at = data_->arcs[arc];
    return torus_patch(arc, dot(at.axis, point - at.centre) > 0.0 ? at.atoms[1] : at.atoms[0]);
}

// The patch on the other side of a stretch of a reentrant patch's border.
std::uint32_t SesPatches::patch_across(std::uint32_t vertex, const TrimmedArc& arc) const {
    const Vec3& centre = data_->vertices[vertex].position;
    const Vec3 point = centre + data_->probe * arc.middle;
    if (arc.probe == TrimmedArc::kNoProbe) {
        const std::uint32_t beside = arc_beside(data_->vertices[vertex], arc.edge);
        return beside == kNoArc ? kNone : torus_patch_at(beside, point);
    }
    // The other probe's border along the same circle: the stretch that reaches nearest to the middle of ours.
    const std::uint32_t w = arc.probe;
    std::uint32_t best = kNone;
    double least = 1e-3;  // radian beyond its ends
    for (const TrimmedArc& other : reentrant_[w].arcs) {
        if (other.probe != vertex || other.angle < kShortestBorder) continue;
        const Vec3 to_point = point - data_->vertices[w].position;
        const Vec3 from_axis = to_point - dot(to_point, other.axis) * other.axis;
        const Vec3 middle = other.middle - dot(other.middle, other.axis) * other.axis;
        const double angle = elementary::atan2(norm(cross(from_axis, middle)), dot(from_axis, middle));
        const double beyond = angle - 0.5 * other.angle;
        if (beyond >= least) continue;
        least = beyond;
        best = first_reentrant_[w] + other.region;
    }
    return best;
}

void SesPatches::number_components() {
    const std::vector<std::uint32_t> piece = sets_.numbers();
    const std::vector<std::uint32_t> sas_piece = sas_sets_.numbers();
    components_ = set_count(piece);
    sas_components_ = set_count(sas_piece);
    for (std::size_t p = 0; p < piece.size(); ++p) patches_[p].component = piece[p];
    for (std::size_t p = 0; p < sas_piece.size(); ++p) patches_[p].sas_component = sas_piece[p];
    hand_on_sas_components();
}

// A torus has the piece of the SAS that its arc lies on, a reentrant patch that of any of its vertex's arcs: they meet.
void SesPatches::hand_on_sas_components() {
    std::vector<std::uint32_t> of_arc(data_->arcs.size(), kNone);
    for (std::uint32_t i = 0; i < data_->atoms.size(); ++i)
        for (std::size_t c = data_->contour_begin[i]; c < data_->contour_begin[i + 1]; ++c)
            of_arc[data_->contour_arc[c]] = patches_[first_contact_[i] + contact_beside_arc_[c]].sas_component;
    for (std::size_t p = first_torus_.front(); p < patches_.size(); ++p) {
        SesPatch& patch = patches_[p];
        const std::uint32_t arc =
            patch.kind == PatchKind::Toroidal ? patch.feature : data_->vertices[patch.feature].arcs.back();
        if (arc != kNoArc) patch.sas_component = of_arc[arc];
    }
}

std::uint32_t SesPatches::component_of_nearest_area(std::uint32_t begin, std::uint32_t end, double area) const {
    const auto off = [&](const SesPatch& patch) { return std::abs(patch.ses.area - area); };
    const auto nearest = std::min_element(patches_.begin() + begin, patches_.begin() + end,
                                          [&](const SesPatch& a, const SesPatch& b) { return off(a) < off(b); });
    return begin == end ? kNone : nearest->component;
}

std::uint32_t SesPatches::component_like_contact(std::uint32_t atom, double area) const {
    return component_of_nearest_area(first_contact_[atom], first_contact_[atom + 1], area);
}

std::uint32_t SesPatches::component_like_torus(std::uint32_t arc, const SasArc& like, std::uint32_t part) const {
    const Vec3 middle = like.centre + like.radius * like.middle;
    const std::uint32_t found = find_like(data_->arcs, arc, like, [&](const SasArc& own) {
        return own.atoms == like.atoms && ((own.whole_circle() && like.whole_circle()) ||
                                           norm(own.centre + own.radius * own.middle - middle) < kSameFeature);
    });
    if (found == kNone) return kNone;
    const std::uint32_t parts = first_torus_[found + 1] - first_torus_[found];
    return parts == 0 ? kNone : patches_[first_torus_[found] + std::min(part, parts - 1)].component;
}

std::uint32_t SesPatches::component_like_reentrant(std::uint32_t vertex, const SasVertex& like, double area) const {
    const std::uint32_t found = find_like(data_->vertices, vertex, like, [&](const SasVertex& own) {
        return own.atoms == like.atoms && norm(own.position - like.position) < kSameFeature;
    });
    if (found != kNone) return component_of_nearest_area(first_reentrant_[found], first_reentrant_[found + 1], area);
    // Where a probe touches more than three atoms, their triangles depend on the perturbation.
    Box here;
    here.include(like.position);
    std::uint32_t component = kNone;
    data_->vertex_tree.for_each_overlapping(here.grown(kSameFeature), [&](std::uint32_t v) {
        if (component == kNone)
            component = component_of_nearest_area(first_reentrant_[v], first_reentrant_[v + 1], area);
    });
    return component;
}

std::array<std::uint32_t, 3> SesPatches::atoms_of(const SesPatch& patch) const {
    if (patch.kind == PatchKind::Contact) return {patch.feature, kNone, kNone};
    if (patch.kind == PatchKind::Reentrant) return data_->vertices[patch.feature].atoms;
    const auto& atoms = data_->arcs[patch.feature].atoms;
    return {atoms[0], atoms[1], kNone};
}

std::uint32_t SesPatches::component_at(const Vec3& point) const {
    const NearestHit hit = nearest_hit(*data_, point);
    if (hit.by_ball) {
        SphericalRegions regions;
        regions.measure(data_->caps_of(hit.ball.atom), data_->contour_of(hit.ball.atom));
        const Vec3 q = point - data_->atoms.centres[hit.ball.atom];
        const std::uint32_t part = regions.regions().size() > 1 ? regions.region_of(normalised(q)) : 0;
        return patches_[first_contact_[hit.ball.atom] + part].component;
    }
    if (hit.edge.vertex == kNoVertex) return patches_[torus_patch_at(hit.edge.arc, point)].component;
    const std::uint32_t v = hit.edge.vertex;
    const std::size_t parts = first_reentrant_[v + 1] - first_reentrant_[v];
    if (parts == 0) return kNone;
    const std::uint32_t part =
        parts > 1 ? reentrant_region_of(*surface_, seed_, v, normalised(point - data_->vertices[v].position)) : 0;
    return patches_[first_reentrant_[v] + part].component;
}

}  // namespace meniscus

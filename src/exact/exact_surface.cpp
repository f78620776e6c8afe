// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/exact_surface.h"

#include <list>
#include <mutex>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "core/requirements.h"
#include "exact/measure_surface.h"
#include "geometry/accessible_surface.h"

namespace meniscus {

struct ExactSurface::Member {
    Member(const Atoms& atoms, const ExactOptions& of) : options(of) {
        if (of.kind != SurfaceKind::Sas) return;
        enlarged = atoms;
        for (double& radius : enlarged.radii)
            if (radius > 0.0) radius += of.probe;  // atoms without a size are refused when the surface is asked for
    }

    ExactOptions options;
    Atoms enlarged;  // of a SAS
    std::mutex mutex;
    std::optional<AccessibleSurface> accessible;
    std::shared_ptr<const Measures> measures;
};

struct ExactSurface::Family {
    explicit Family(Atoms of) : atoms(std::move(of)) {}

    Atoms atoms;
    std::mutex mutex;
    std::list<Member> members;
};

ExactSurface::ExactSurface() : ExactSurface(Atoms{}) {}

ExactSurface::ExactSurface(Atoms atoms, const ExactOptions& options)
    : family_(std::make_shared<Family>(std::move(atoms))), member_(nullptr) {
    *this = of_same_atoms(options);
}

ExactSurface::ExactSurface(std::shared_ptr<Family> family, Member* member)
    : family_(std::move(family)), member_(member) {}

const Atoms& ExactSurface::atoms() const { return family_->atoms; }
const ExactOptions& ExactSurface::options() const { return member_->options; }

const Atoms& ExactSurface::balls() const {
    return member_->options.kind == SurfaceKind::Sas ? member_->enlarged : family_->atoms;
}

double ExactSurface::probe_of_balls() const {
    return member_->options.kind == SurfaceKind::Ses ? member_->options.probe : 0.0;
}

ExactSurface ExactSurface::of_same_atoms(const ExactOptions& options) const {
    require_not_negative("probe", options.probe);
    const std::lock_guard lock(family_->mutex);
    for (Member& member : family_->members)
        if (member.options == options) return {family_, &member};
    return {family_, &family_->members.emplace_back(family_->atoms, options)};
}

const AccessibleSurface& ExactSurface::accessible() const {
    const std::lock_guard lock(member_->mutex);
    if (!member_->accessible) isolated([&] { member_->accessible.emplace(balls(), probe_of_balls()); });
    return *member_->accessible;
}

std::shared_ptr<const Measures> ExactSurface::shared_measures() const {
    const AccessibleSurface& surface = accessible();
    const std::lock_guard lock(member_->mutex);
    if (!member_->measures)
        isolated([&] { member_->measures = std::make_shared<const Measures>(measure(surface, balls())); });
    return member_->measures;
}

const Measures& ExactSurface::measures() const { return *shared_measures(); }

std::vector<double> ExactSurface::signed_distance(std::span<const Vec3> points) const {
    return meniscus::signed_distance(accessible(), points);
}

std::vector<NearestFeature> ExactSurface::nearest_features(std::span<const Vec3> points) const {
    return meniscus::nearest_features(accessible(), points);
}

}  // namespace meniscus

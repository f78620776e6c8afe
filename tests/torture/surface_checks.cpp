// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "torture/surface_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "support/mesh_checks.h"

namespace meniscus::testing {
namespace {

constexpr double kLeastTriangle = 1e-6;  // spacings²

bool is_finite_normal(const Vec3& n) { return std::abs(norm(n) - 1.0) < 1e-5; }

std::string text_of(const Vec3& p) { return fmt::format("({:.17g}, {:.17g}, {:.17g})", p.x, p.y, p.z); }

// Distances and volumes of spheres that the grid does not show have bounds of their own: what_is_wrong_with_size().
std::string failed_checks(const Surface& surface) {
    std::string failed;
    for (const Check& check : surface.checks)
        if (!check.passed && check.name != "not_empty" && check.name != "mean_distance" && check.name != "volume")
            failed += check.name + " ";
    return failed;
}

// The atoms with radii larger by `distance` and a probe smaller by it, or the other way round: K stays where it is, and
// the molecule ends at that distance from its surface.
SurfaceTotals totals_of_parallel_body(const Atoms& atoms, double probe, double distance) {
    constexpr double kHair = 1e-6;  // for what is on the brink between two surfaces
    Atoms other;
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const double radius = atoms.radii[i] + distance + std::copysign(kHair, distance);
        if (radius <= 0.0) continue;
        other.centres.push_back(atoms.centres[i]);
        other.radii.push_back(radius);
    }
    if (other.empty()) return {};
    return measure(other, {.probe = std::max(0.0, probe - distance), .cavities = false}).totals;
}

SignCount count_sides(const Surface& surface, const Atoms& atoms, const AccessibleSurface& exact, std::size_t points,
                      const std::function<bool(const Vec3&)>& is_inside) {
    const double h = surface.options.spacing;
    const Mesh& mesh = surface.mesh;
    std::mt19937_64 random(points);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    SignCount count;
    for (std::size_t i = 0; i < points; ++i) {
        const std::size_t atom = random() % atoms.size();
        const bool at_mesh = i % 2 == 0 && !mesh.vertices.empty();
        const Vec3 base = at_mesh ? mesh.vertices[random() % mesh.vertices.size()] : atoms.centres[atom];
        const double reach = at_mesh ? 4.0 * h : atoms.radii[atom] + exact.probe() + 3.0 * h;
        const Vec3 p = base + reach * Vec3{unit(random), unit(random), unit(random)};
        const double distance = exact.nearest(p).signed_distance;
        if (std::abs(distance) <= 0.1 * h) continue;
        ++count.asked;
        if (is_inside(p) == (distance < 0.0)) continue;
        ++count.wrong;
        if (std::abs(distance) <= h) continue;
        if (count.far_wrong++ == 0)
            count.first_far = fmt::format("{:.3g} Å from the surface at {}", distance, text_of(p));
    }
    return count;
}

// By the value there, or beyond the band by how a ray first crosses the surface.
bool is_inside(const LevelSet& level_set, const Vec3& point) {
    const double value = level_set.value(point);
    if (!std::isnan(value)) return value < 0.0;
    const Vec3 direction = normalised({0.5377, 0.6181, 0.5737});  // no symmetry axis of anything
    const double distance = level_set.intersect(point, direction);
    return std::isfinite(distance) && dot(level_set.sample(point + distance * direction).gradient, direction) > 0.0;
}

double winding_number(const Mesh& mesh, const Vec3& p) {
    double angle = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[0]] - p;
        const Vec3 b = mesh.vertices[t[1]] - p;
        const Vec3 c = mesh.vertices[t[2]] - p;
        const double below =
            norm(a) * norm(b) * norm(c) + dot(a, b) * norm(c) + dot(b, c) * norm(a) + dot(c, a) * norm(b);
        angle += 2.0 * std::atan2(dot(a, cross(b, c)), below);
    }
    return angle / (4.0 * std::numbers::pi);
}

}  // namespace

std::string what_is_wrong_with_mesh(const Surface& surface, std::size_t atoms) {
    const Mesh& mesh = surface.mesh;
    const double h = surface.options.spacing;
    if (std::string failed = failed_checks(surface); !failed.empty()) return "failed " + failed;
    if (mesh.triangles.empty()) return "";
    if (std::string why = why_not_closed_manifold(mesh); !why.empty()) return why;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (!is_finite(mesh.vertices[v])) return "a vertex that is not finite";
        if (!is_finite_normal(mesh.normals[v])) return "no normal at " + text_of(mesh.vertices[v]);
        if (!std::isfinite(mesh.mean_curvatures[v]) || !std::isfinite(mesh.gaussian_curvatures[v]))
            return "no curvature at " + text_of(mesh.vertices[v]);
        if (mesh.atoms[v] >= atoms) return "a vertex of an atom that does not exist";
        if (mesh.components[v] >= surface.measures.components.size()) return "a vertex without a component";
    }
    const double smallest = smallest_area_of(mesh);
    if (!(smallest > kLeastTriangle * h * h)) return fmt::format("a triangle of {} Å²", smallest);
    return "";
}

std::string what_is_wrong_with_places(const Surface& surface, const AccessibleSurface& exact) {
    const Mesh& mesh = surface.mesh;
    const double h = surface.options.spacing;
    const bool direct = surface.options.method == Method::Direct;
    const double farthest = direct ? 0.02 * h : h;
    // A flow is smooth where the exact surface has creases and gaps that a coarse grid does not show.
    const bool shown = direct || h <= 0.6;
    std::size_t backwards = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3& p = mesh.vertices[v];
        const double distance = exact.nearest(p).signed_distance;
        if (!(std::abs(distance) <= farthest)) return fmt::format("a vertex {} Å off at {}", distance, text_of(p));
        const Vec3 step = 0.3 * h * mesh.normals[v];
        if (exact.nearest(p + step).signed_distance < exact.nearest(p - step).signed_distance) ++backwards;
    }
    const auto most = direct ? std::size_t{0} : 3 + mesh.vertices.size() / 100;
    return !shown || backwards <= most ? ""
                                       : fmt::format("{} of {} vertices face inwards", backwards, mesh.vertices.size());
}

std::string what_is_wrong_with_size(const Surface& surface, const Atoms& atoms, double reach, double slack) {
    const double probe = surface.options.probe;
    const double h = surface.options.spacing;
    const double exact = totals_of_parallel_body(atoms, probe, 0.0).ses_area;
    const SurfaceTotals inner = totals_of_parallel_body(atoms, probe, -reach * h);
    const SurfaceTotals outer = totals_of_parallel_body(atoms, probe, reach * h);
    const double volume = surface.measures.volume;
    if (!(inner.ses_volume <= volume + 1e-9 && volume <= outer.ses_volume + 1e-9))
        return fmt::format("volume {} is not between {} and {}", volume, inner.ses_volume, outer.ses_volume);
    double least = std::min({inner.ses_area, exact, outer.ses_area});
    double most = std::max({inner.ses_area, exact, outer.ses_area});
    for (const double part : {-0.7, -0.5, -0.3, -0.15, -0.05, 0.05, 0.15, 0.3, 0.5, 0.7}) {
        const double area = totals_of_parallel_body(atoms, probe, part * reach * h).ses_area;
        least = std::min(least, area);
        most = std::max(most, area);
    }
    const double area = surface.measures.area;
    if (!(least - slack * exact <= area && area <= most + slack * exact))
        return fmt::format("area {} is not between {} and {}, give or take {}", area, least, most, slack * exact);
    return "";
}

SignCount& operator+=(SignCount& sum, const SignCount& more) {
    sum.asked += more.asked;
    sum.wrong += more.wrong;
    sum.far_wrong += more.far_wrong;
    if (sum.first_far.empty()) sum.first_far = more.first_far;
    return sum;
}

SignCount count_signs(const Surface& surface, const Atoms& atoms, const AccessibleSurface& exact, std::size_t points) {
    return count_sides(surface, atoms, exact, points, [&](const Vec3& p) { return is_inside(*surface.level_set, p); });
}

SignCount count_windings(const Surface& surface, const Atoms& atoms, const AccessibleSurface& exact,
                         std::size_t points) {
    return count_sides(surface, atoms, exact, points,
                       [&](const Vec3& p) { return winding_number(surface.mesh, p) > 0.5; });
}

}  // namespace meniscus::testing

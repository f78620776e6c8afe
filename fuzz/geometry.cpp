// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Exact measures and distances of spheres whose centres stand on a coarse lattice, so that ties abound: spheres that
// touch, coincide, lie in one another, on one plane, line or sphere.
//
// Bytes: probe radius, step of the lattice, then four for each sphere: x, y, z and radius, in steps.
#include <algorithm>
#include <cmath>

#include "fuzzed_file.h"
#include "geometry/accessible_surface.h"
#include "meniscus/measures.h"

namespace {

using namespace meniscus;

constexpr std::size_t kMostSpheres = 40;
constexpr double kTolerance = 1e-5;  // relative; what degenerate arrangements are promised

struct Arrangement {
    Atoms atoms;
    double probe = 0.0;
};

Arrangement arrangement_of(const std::uint8_t* data, std::size_t size) {
    Arrangement a;
    a.probe = 0.1 * (data[0] % 64);
    const double step = 0.05 * (1 + data[1] % 40);
    for (const std::uint8_t* next = data + 2; next + 4 <= data + size; next += 4) {
        if (a.atoms.centres.size() == kMostSpheres) break;
        const auto coordinate = [&](int axis) { return step * (next[axis] % 16 - 8); };
        a.atoms.centres.push_back({coordinate(0), coordinate(1), coordinate(2)});
        a.atoms.radii.push_back(step * (1 + next[3] % 8));
    }
    return a;
}

bool agree(double a, double b, double scale) { return std::abs(a - b) <= kTolerance * scale; }

void require_sound_totals(const SurfaceTotals& t) {
    for (const double value :
         {t.sas_area, t.sas_volume, t.ses_area, t.ses_volume, t.contact_area, t.toroidal_area, t.reentrant_area})
        fuzz::require(std::isfinite(value) && value >= 0.0, "measures are finite and not negative");
    fuzz::require(agree(t.contact_area + t.toroidal_area + t.reentrant_area, t.ses_area, t.ses_area),
                  "the kinds of patches make up the SES");
    fuzz::require(t.ses_volume <= t.sas_volume * (1.0 + kTolerance), "the SES lies within the SAS");
}

void require_sums(const Measures& m) {
    double of_atoms = 0.0;
    for (const AtomMeasure& atom : m.atoms) of_atoms += atom.ses_area();
    double of_components = 0.0;
    double volume = 0.0;
    for (const SurfaceComponent& piece : m.components) {
        of_components += piece.ses_area;
        volume += piece.kind == ComponentKind::Outer ? piece.ses_volume : -piece.ses_volume;
    }
    fuzz::require(agree(of_atoms, m.totals.ses_area, m.totals.ses_area), "atoms make up the area");
    fuzz::require(agree(of_components, m.totals.ses_area, m.totals.ses_area), "components make up the area");
    fuzz::require(agree(volume, m.totals.ses_volume, m.totals.ses_volume), "components make up the volume");
}

// The SES holds the spheres, and nothing beyond the enlarged ones.
void require_distances(const Arrangement& a, double scale) {
    const AccessibleSurface surface(a.atoms, a.probe);
    for (std::size_t i = 0; i < a.atoms.centres.size(); ++i) {
        const double at_centre = surface.nearest(a.atoms.centres[i]).signed_distance;
        fuzz::require(at_centre <= -a.atoms.radii[i] + kTolerance * scale, "a centre is a radius deep");
    }
    for (const Vec3& far : {Vec3{1e3, 0, 0}, Vec3{-500, 700, 10}}) {
        const double distance = surface.nearest(far).signed_distance;
        fuzz::require(distance > 0.0 && std::isfinite(distance), "far points are outside");
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 6) return -1;  // not even one sphere
    const Arrangement a = arrangement_of(data, size);
    const Measures solvent = measure(a.atoms, {.probe = a.probe, .depth = true, .threads = 1});
    const Measures van_der_waals = measure(a.atoms, {.probe = 0.0, .threads = 1});
    // What is disputed is said to be so, and the program then fails (docs/limits.md).
    if (!solvent.agreed || !van_der_waals.agreed) return 0;
    require_sound_totals(solvent.totals);
    require_sums(solvent);
    fuzz::require(van_der_waals.totals.ses_volume <= solvent.totals.ses_volume + kTolerance * solvent.totals.sas_volume,
                  "the SES holds the spheres");
    require_distances(a, 1.0);
    return 0;
}

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "meniscus/errors.h"
#include "meniscus/measures.h"
#include "support/arrangements.h"
#include "support/brute_force_ses.h"
#include "support/mesh_checks.h"

namespace meniscus::testing {
namespace {

// Three atoms in a bent row and one beside them: contact, toroidal and reentrant patches, and a ridge.
Atoms small_molecule() {
    return {{{0, 0, 0}, {1.5, 0.2, 0}, {2.4, 1.5, 0.3}, {4.1, -1.0, 2.2}}, {1.7, 1.55, 1.52, 1.8}};
}

Atoms random_cluster(int count, double extent, unsigned seed, double smallest = 1.2, double largest = 2.0) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> within(0.0, extent);
    std::uniform_real_distribution<double> size(smallest, largest);
    Atoms atoms;
    for (int i = 0; i < count; ++i) {
        atoms.centres.push_back({within(random), within(random), within(random)});
        atoms.radii.push_back(size(random));
    }
    return atoms;
}

// A shell of atoms on a sphere: one outer surface and one cavity.
Atoms shell_of_spheres(double radius, int count) {
    Atoms atoms;
    for (int i = 0; i < count; ++i) {  // Fibonacci sphere
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double angle = 2.399963229728653 * i;
        const double r = std::sqrt(1.0 - z * z);
        atoms.centres.push_back({radius * r * std::cos(angle), radius * r * std::sin(angle), radius * z});
        atoms.radii.push_back(1.7);
    }
    return atoms;
}

void expect_same_bits(const Surface& a, const Surface& b) {
    EXPECT_TRUE(a.mesh.vertices == b.mesh.vertices);
    EXPECT_TRUE(a.mesh.normals == b.mesh.normals);
    EXPECT_TRUE(a.mesh.triangles == b.mesh.triangles);
    EXPECT_TRUE(a.mesh.patches == b.mesh.patches);
    EXPECT_TRUE(a.mesh.components == b.mesh.components);
    EXPECT_EQ(a.measures.area, b.measures.area);
    EXPECT_EQ(a.measures.volume, b.measures.volume);
    EXPECT_EQ(a.corrected_area, b.corrected_area);
    EXPECT_EQ(a.distance.mean, b.distance.mean);
    EXPECT_EQ(a.flow.residual, b.flow.residual);
}

class EveryMethod : public ::testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, ::testing::Values(Method::Flow, Method::Direct, Method::Gaussian));

TEST_P(EveryMethod, GivesAClosedManifoldWithoutDegenerateTriangles) {
    for (const double spacing : {0.5, 0.3}) {
        const Surface surface =
            compute_surface(random_cluster(60, 12.0, 5), {.method = GetParam(), .spacing = spacing});
        expect_closed_manifold(surface.mesh);
        EXPECT_TRUE(surface.passed());
        EXPECT_GT(smallest_area_of(surface.mesh), 1e-6 * spacing * spacing);
        EXPECT_EQ(surface.mesh.atoms.size(), surface.mesh.vertices.size());
        EXPECT_EQ(surface.mesh.patches.size(), surface.mesh.vertices.size());
        EXPECT_EQ(surface.mesh.components.size(), surface.mesh.vertices.size());
    }
}

TEST_P(EveryMethod, GivesTheSameBitsForAnyNumberOfThreads) {
    const Atoms atoms = random_cluster(60, 12.0, 6);
    expect_same_bits(compute_surface(atoms, {.method = GetParam()}, {.threads = 1}),
                     compute_surface(atoms, {.method = GetParam()}, {.threads = 2}));
}

TEST_P(EveryMethod, GivesTheSameBitsForAnyOrderOfAtoms) {
    const Atoms atoms = random_cluster(60, 12.0, 7);
    std::vector<std::uint32_t> order(atoms.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    Atoms shuffled;
    for (const std::uint32_t i : order) {
        shuffled.centres.push_back(atoms.centres[i]);
        shuffled.radii.push_back(atoms.radii[i]);
    }
    const Surface a = compute_surface(atoms, {.method = GetParam()});
    const Surface b = compute_surface(shuffled, {.method = GetParam()});
    expect_same_bits(a, b);
    for (std::size_t v = 0; v < a.mesh.atoms.size(); ++v) ASSERT_EQ(a.mesh.atoms[v], order[b.mesh.atoms[v]]);
}

TEST_P(EveryMethod, MovesWithTheMoleculeUpToTheGrid) {
    const Atoms atoms = random_cluster(40, 9.0, 8);
    Atoms moved = atoms;
    for (Vec3& c : moved.centres)
        c = Vec3{0.6 * c.x - 0.8 * c.y, 0.8 * c.x + 0.6 * c.y, c.z} + Vec3{103.7, -51.3, 12.9};
    const Surface a = compute_surface(atoms, {.method = GetParam(), .spacing = 0.25});
    const Surface b = compute_surface(moved, {.method = GetParam(), .spacing = 0.25});
    EXPECT_NEAR(b.corrected_area / a.corrected_area, 1.0, 3e-3);
    EXPECT_NEAR(b.corrected_volume / a.corrected_volume, 1.0, 1e-3);
}

TEST(Surface, VerticesLieOnTheSesByBruteForce) {
    const Atoms atoms = random_cluster(50, 10.0, 9);
    const BruteForceSes oracle(atoms, 1.4);
    for (const Method method : {Method::Direct, Method::Flow}) {
        const Surface surface = compute_surface(atoms, {.method = method, .spacing = 0.25});
        double sum = 0.0;
        double worst_report = 0.0;
        for (const Vec3& v : surface.mesh.vertices) sum += std::abs(oracle.signed_distance(v));
        const double mean = sum / static_cast<double>(surface.mesh.vertices.size());
        worst_report = std::abs(mean - surface.distance.mean);
        EXPECT_LT(worst_report, 1e-7) << "the report's distance is the true one";
        EXPECT_LT(mean, method == Method::Direct ? 1e-5 : 0.004);
        EXPECT_LE(surface.distance.mean, surface.distance.p99 + 1e-12);  // of direct nearly all are 0
        EXPECT_LE(surface.distance.p99, surface.distance.max);
    }
}

TEST(Surface, FlowForgetsItsStart) {
    const Atoms atoms = shell_of_spheres(6.5, 90);
    for (const double density : {-0.2, -0.5, -4.0}) {
        const Surface surface = compute_surface(atoms, {.spacing = 0.4, .density = density});
        EXPECT_TRUE(surface.flow.converged) << density;
        ASSERT_EQ(surface.measures.components.size(), 2U) << density;
        EXPECT_GT(surface.measures.components[0].volume, 0.0);
        EXPECT_LT(surface.measures.components[1].volume, 0.0) << "the cavity's wall faces inwards";
        EXPECT_LT(surface.distance.mean, 0.01) << density;
    }
}

TEST(Surface, SphereFallsToItsClosedFormWithSecondOrder) {
    const Atoms atoms{{{0.1, 0.2, 0.3}}, {1.7}};
    const double area = 4.0 * std::numbers::pi * 1.7 * 1.7;
    for (const Method method : {Method::Direct, Method::Flow}) {
        const double coarse = 1.0 - compute_surface(atoms, {.method = method, .spacing = 0.4}).measures.area / area;
        const double fine = 1.0 - compute_surface(atoms, {.method = method, .spacing = 0.2}).measures.area / area;
        EXPECT_GT(std::log2(coarse / fine), 1.8);
        EXPECT_LT(fine, 0.005);
    }
}

TEST(Surface, TwoSpheresMatchTheirClosedForms) {
    for (const TwoSpheresReference& c : kTwoSpheresReferences) {
        const Atoms atoms{{{0, 0, 0}, {c.d * 0.6, 0, c.d * 0.8}}, {c.r1, c.r2}};
        for (const Method method : {Method::Direct, Method::Flow}) {
            const auto run = [&](double spacing) {
                return compute_surface(atoms, {.method = method, .probe = c.probe, .spacing = spacing});
            };
            const Surface coarse = run(0.5);
            const Surface fine = run(0.25);
            EXPECT_NEAR(fine.corrected_volume / c.volume, 1.0, 2e-3) << c.d;
            EXPECT_NEAR(fine.corrected_area / c.area, 1.0, 1e-2) << c.d;
            const double order = std::log2(std::abs(coarse.measures.volume / c.volume - 1.0) /
                                           std::abs(fine.measures.volume / c.volume - 1.0));
            EXPECT_GT(order, 1.8) << c.d;
        }
    }
}

// Triangles of an even mesh are divided until they are as small as those of the grid.
TEST(Surface, EvenMeshesTellTheAreaWhateverTheSizeOfTheirTriangles) {
    const Atoms atoms = random_cluster(150, 14.0, 5);
    const double area = measure(atoms).totals.ses_area;
    for (const Method method : {Method::Direct, Method::Flow})
        for (const double edge : {0.6, 1.0, 2.0}) {
            const Surface surface =
                compute_surface(atoms, {.method = method, .remesh = {.edge = edge, .corners = Corners::OnSurface}});
            EXPECT_NEAR(surface.corrected_area / area, 1.0, 5e-3) << edge;
            EXPECT_LT(surface.measures.area / area, 1.0 - 0.01 * edge * edge) << edge;
        }
}

TEST(Surface, AnAreaThatIsOffAsksForAFinerGrid) {
    const Atoms atoms = spheres_with_narrow_necks();
    const double area = measure(atoms).totals.ses_area;
    SurfaceOptions options{.remesh = {.edge = 1.0}};
    const Surface coarse = compute_surface(atoms, options);
    EXPECT_GT(std::abs(coarse.corrected_area / area - 1.0), 5e-3);
    options.remesh.finer_grid = true;
    const Surface fine = compute_surface(atoms, options);
    EXPECT_EQ(fine.options.spacing, 0.25);
    EXPECT_NEAR(fine.corrected_area / area, 1.0, 5e-3);
    EXPECT_TRUE(fine.passed());
    EXPECT_EQ(fine.checks.size(), coarse.checks.size());
    options.exact = true;
    expect_same_bits(mesh(ExactSurface(atoms), options), fine);
    options.remesh.edge = 0.0;
    EXPECT_EQ(compute_surface(atoms, options).options.spacing, 0.5);
}

TEST(Surface, AFlowThatDoesNotConvergeIsNotRepeatedOnAFinerGrid) {
    const Atoms atoms = spheres_with_narrow_necks();
    const Surface surface = compute_surface(
        atoms, {.flow = {.time_step = 0.1, .max_steps = 2}, .remesh = {.edge = 1.0, .finer_grid = true}});
    EXPECT_GT(std::abs(surface.corrected_area / measure(atoms).totals.ses_area - 1.0), 5e-3);
    EXPECT_FALSE(surface.flow.converged);
    EXPECT_EQ(surface.options.spacing, 0.5);
}

TEST(Surface, IsMeasuredExactlyOnRequestAndOtherwiseTheSame) {
    const Atoms atoms = spheres_with_narrow_necks();
    for (const double edge : {0.0, 1.0})
        for (const Method method : {Method::Flow, Method::Direct, Method::Gaussian}) {
            SurfaceOptions options{.method = method, .remesh = {.edge = edge, .finer_grid = true}};
            const Surface without = compute_surface(atoms, options);
            EXPECT_EQ(without.measured, nullptr);
            options.exact = true;
            const Surface with = compute_surface(atoms, options);
            const Measures measures = measure(atoms);
            ASSERT_NE(with.measured, nullptr);
            EXPECT_EQ(with.measured->totals.ses_area, measures.totals.ses_area);
            EXPECT_EQ(with.measured->components.size(), measures.components.size());
            EXPECT_EQ(with.measured->atoms.size(), atoms.size());
            expect_same_bits(with, without);
        }
}

TEST(Surface, ExactMeasuresAreThoseOfTheSurfaceThatIsMade) {
    const Atoms atoms = small_molecule();
    const SurfaceTotals totals = measure(atoms).totals;
    const Surface accessible = compute_surface(atoms, {.surface = SurfaceKind::Sas, .exact = true});
    EXPECT_NEAR(accessible.measured->totals.ses_area, totals.sas_area, 1e-6 * totals.sas_area);
    const Surface bare = compute_surface(atoms, {.surface = SurfaceKind::Vdw, .exact = true});
    EXPECT_EQ(bare.measured->totals.ses_area, measure(atoms, {.probe = 0.0}).totals.ses_area);
}

TEST(Surface, AnAreaThatIsRightNeedsNoFinerGrid) {
    const SurfaceOptions options{.remesh = {.edge = 1.0, .finer_grid = true}};
    EXPECT_EQ(compute_surface(small_molecule(), options).options.spacing, 0.5);
}

// Otherwise triangles of a few Å would be divided into as many parts as if they were that large.
TEST(Surface, EdgesLongerThanTheMoleculeAreThoseOfTheMolecule) {
    const Atoms atoms = small_molecule();
    const Surface large = compute_surface(atoms, {.remesh = {.edge = 100.0}});
    const Surface huge = compute_surface(atoms, {.remesh = {.edge = 1e10}});
    expect_closed_manifold(huge.mesh);
    EXPECT_EQ(huge.mesh.vertices, large.mesh.vertices);
    EXPECT_EQ(huge.corrected_area, large.corrected_area);
    EXPECT_GT(huge.corrected_area, huge.measures.area);
}

TEST(Surface, PatchesAndAtomsAreThoseOfTheNearestFeature) {
    const Surface surface = compute_surface(small_molecule(), {.method = Method::Direct, .spacing = 0.3});
    const Atoms atoms = small_molecule();
    int kinds[3] = {0, 0, 0};
    for (std::size_t v = 0; v < surface.mesh.vertices.size(); ++v) {
        ++kinds[static_cast<int>(surface.mesh.patches[v])];
        const std::uint32_t atom = surface.mesh.atoms[v];
        const double gap = norm(surface.mesh.vertices[v] - atoms.centres[atom]) - atoms.radii[atom];
        EXPECT_GT(gap, -1e-6);
        if (surface.mesh.patches[v] == PatchKind::Contact) {
            EXPECT_NEAR(gap, 0.0, 1e-6);
        }
    }
    for (const int kind : kinds) EXPECT_GT(kind, 0);
}

TEST(Surface, ProbeZeroGivesTheVanDerWaalsSurface) {
    const Atoms atoms = small_molecule();
    const Surface surface = compute_surface(atoms, {.method = Method::Direct, .probe = 0.0, .spacing = 0.25});
    EXPECT_TRUE(surface.passed());
    for (const Vec3& v : surface.mesh.vertices) {
        double gap = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < atoms.size(); ++i) gap = std::min(gap, norm(v - atoms.centres[i]) - atoms.radii[i]);
        EXPECT_NEAR(gap, 0.0, 1e-5);
    }
}

TEST(Surface, ExtremeInputsStayClosed) {
    const Atoms cases[] = {
        {{{0, 0, 0}, {1e6, 0, 0}}, {1.5, 1.5}},
        {{{1e9, 1e9, 1e9}, {1e9 + 2, 1e9, 1e9}}, {1.5, 1.5}},
        {{{0, 0, 0}, {21, 0, 0}, {0, 20.5, 0}}, {20.0, 1.5, 0.01}},
        {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {1.5, 1.5, 1.4}},
        {{{0, 0, 0}, {5.8, 0, 0}, {2.9, 5.8 * std::sqrt(0.75), 0}}, {1.5, 1.5, 1.5}},
    };
    for (const Atoms& atoms : cases)
        for (const Method method : {Method::Flow, Method::Direct, Method::Gaussian}) {
            const Surface surface = compute_surface(atoms, {.method = method});
            EXPECT_TRUE(surface.passed());
            expect_closed_manifold(surface.mesh);
        }
}

TEST(Surface, FineGridsHaveNoMoreSliversThanOthers) {  // else this takes minutes
    constexpr double kFine = 0.02;
    const Surface surface = compute_surface({{{}}, {1.5}}, {.method = Method::Direct, .spacing = kFine});
    expect_closed_manifold(surface.mesh);
    EXPECT_NEAR(surface.measures.area, 4.0 * std::numbers::pi * 1.5 * 1.5, 1e-3);
    EXPECT_GT(surface.measures.shortest_edge, 0.1 * kFine);
    EXPECT_LT(surface.measures.shortest_edge, kFine);
}

TEST(Surface, MissingAnAtomSmallerThanTheGridIsAFailedCheck) {
    const Surface surface = compute_surface({{{0.05, 0.05, 0.05}}, {0.01}}, {.spacing = 0.5});
    EXPECT_FALSE(surface.passed());
}

TEST(Surface, OptionsOutOfRangeAreUsageErrors) {
    const Atoms atoms = small_molecule();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(compute_surface(atoms, {.probe = -1.0}), UsageError);
    EXPECT_THROW(compute_surface(atoms, {.probe = nan}), UsageError);
    EXPECT_THROW(compute_surface(atoms, {.spacing = 0.0}), UsageError);
    EXPECT_THROW(compute_surface(atoms, {.spacing = 1e-100}), UsageError);
    EXPECT_THROW(compute_surface(atoms, {.density = 0.5}), UsageError);
    EXPECT_THROW(compute_surface(atoms, {.flow = {.max_steps = 0}}), UsageError);
    EXPECT_THROW(compute_surface(atoms, {.min_cavity = -1.0}), UsageError);
    EXPECT_THROW(compute_surface(atoms, {.min_cavity = nan}), UsageError);
    EXPECT_THROW(compute_surface(atoms, {.remesh = {.simplify_topology = true}}), UsageError);
    EXPECT_THROW(compute_surface({}, {}), std::invalid_argument);
}

TEST(Surface, SmallCavitiesAreDroppedOnRequest) {
    const Atoms atoms = shell_of_spheres(6.5, 90);
    for (const double edge : {0.0, 0.8}) {
        const SurfaceOptions options{.remesh = {.edge = edge}};
        const Surface all = compute_surface(atoms, options);
        ASSERT_EQ(all.measures.components.size(), 2U);
        const double volume = -compute_surface(atoms).measures.components[1].volume;
        for (const double least : {0.999 * volume, 1.001 * volume}) {
            SurfaceOptions dropping = options;
            dropping.min_cavity = least;
            const Surface surface = compute_surface(atoms, dropping);
            const bool dropped = least > volume;
            EXPECT_EQ(surface.dropped.cavities, dropped ? 1U : 0U);
            EXPECT_EQ(surface.measures.components.size(), dropped ? 1U : 2U);
            EXPECT_EQ(surface.mesh.vertices == all.mesh.vertices, !dropped);
            EXPECT_TRUE(surface.passed());
        }
    }
}

// A ring of atoms whose hole just lets the probe through.
Atoms ring_of_atoms() {
    Atoms atoms;
    for (int i = 0; i < 12; ++i) {
        const double angle = i * std::numbers::pi / 6.0;
        atoms.centres.push_back({3.3 * std::cos(angle), 3.3 * std::sin(angle), 0.01 * i});
        atoms.radii.push_back(1.7);
    }
    return atoms;
}

TEST(Surface, TopologyIsSimplifiedOnlyOnRequest) {
    const auto run = [](double edge, bool simplify) {
        return compute_surface(ring_of_atoms(),
                               {.verify = true, .remesh = {.edge = edge, .simplify_topology = simplify}});
    };
    for (const double edge : {1.0, 2.0, 3.0, 4.0}) {
        EXPECT_EQ(run(edge, false).measures.euler_characteristic, 0) << edge;
        const Surface surface = run(edge, true);
        const bool narrow = edge >= 3.0;  // the hole is 3.2 Å wide
        EXPECT_EQ(surface.simplified.handles, narrow ? 1U : 0U) << edge;
        EXPECT_EQ(surface.measures.euler_characteristic, narrow ? 2 : 0) << edge;
        EXPECT_EQ(surface.measures.components.size(), 1U);
        EXPECT_EQ(surface.self_intersections, 0U);
        expect_closed_manifold(surface.mesh);
        EXPECT_GT(surface.measures.smallest_angle_deg, 25.0) << edge;
    }
}

TEST(Surface, VanDerWaalsSurfacesAreMadeEven) {
    for (const unsigned seed : {2U, 3U, 9U}) {  // with vertices in corners, where there is no normal
        const Surface surface = compute_surface(random_cluster(100, 12.0, seed),
                                                {.method = Method::Direct, .probe = 0.0, .remesh = {.edge = 1.5}});
        EXPECT_TRUE(surface.passed());
        expect_closed_manifold(surface.mesh);
    }
}

TEST(Surface, PiecesSmallerThanAnEdgeVanishOnRequest) {
    Atoms atoms = ring_of_atoms();
    atoms.centres.push_back({20.0, 0.0, 0.0});
    atoms.radii.push_back(0.8);
    const auto pieces = [&](bool simplify) {
        return compute_surface(atoms, {.remesh = {.edge = 2.0, .simplify_topology = simplify}});
    };
    EXPECT_EQ(pieces(false).measures.components.size(), 2U);
    EXPECT_EQ(pieces(true).measures.components.size(), 1U);
    EXPECT_EQ(pieces(true).simplified.pieces, 1U);
}

TEST(Surface, SelfIntersectionsAreLookedForOnRequest) {
    const auto named = [](const Surface& surface) {
        return std::count_if(surface.checks.begin(), surface.checks.end(),
                             [](const Check& check) { return check.name == "no_self_intersections"; });
    };
    const Surface plain = compute_surface(small_molecule());
    EXPECT_EQ(named(plain), 0);
    EXPECT_FALSE(plain.self_intersections);
    const Surface verified = compute_surface(small_molecule(), {.verify = true});
    EXPECT_EQ(named(verified), 1);
    EXPECT_EQ(verified.self_intersections, 0U);
    EXPECT_TRUE(verified.passed());
    // A grid far too coarse for the creases between atoms; of 400 clusters like this one it alone cannot be untangled.
    const Surface coarse = compute_surface(random_cluster(300, 18.0, 151, 0.6, 2.4),
                                           {.method = Method::Direct, .probe = 0.0, .spacing = 2.5, .verify = true});
    EXPECT_GT(coarse.self_intersections, 0U);
    EXPECT_FALSE(coarse.passed());
}

TEST(Surface, RefusesWhatWouldNotFit) {
    EXPECT_THROW(compute_surface(small_molecule(), {.spacing = 0.01}, {.memory_limit_mb = 50}), LimitError);
    EXPECT_THROW(compute_surface({{{1e12, 0, 0}}, {1.5}}, {}), LimitError);
}

TEST(Surface, ProgressEndsEveryStage) {
    double last = 0.0;
    std::string stages;
    const Progress progress = [&](std::string_view stage, double fraction) {
        if (!stages.ends_with(stage)) stages += (stages.empty() ? "" : " ") + std::string(stage);
        last = fraction;
    };
    compute_surface(small_molecule(), {}, {.progress = progress});
    EXPECT_EQ(stages, "geometry band flow mesh");
    EXPECT_EQ(last, 1.0);
}

TEST(Surface, StepsTooFewToConvergeAreReported) {
    const Surface surface = compute_surface(random_cluster(40, 9.0, 10), {.flow = {.time_step = 0.1, .max_steps = 2}});
    EXPECT_FALSE(surface.flow.converged);
    EXPECT_FALSE(surface.passed());
    expect_closed_manifold(surface.mesh);
}

}  // namespace
}  // namespace meniscus::testing

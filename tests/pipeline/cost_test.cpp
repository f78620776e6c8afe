// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/cost.h"

#include <gtest/gtest.h>

#include <numbers>
#include <regex>
#include <string>

#include "meniscus/errors.h"
#include "meniscus/measures.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"

namespace meniscus::testing {
namespace {

constexpr SurfaceOptions kFine{.spacing = 0.05};
constexpr std::size_t kLittle = 300;  // MB

Atoms ubiquitin() { return read_structure(MENISCUS_EXAMPLES "/1ubq.pdb", {}).atoms; }

std::string refusal(const Atoms& atoms, const SurfaceOptions& options, std::size_t memory_limit_mb = kLittle) {
    try {
        refuse_what_would_not_fit(atoms, options, estimate_cost(atoms, options), memory_limit_mb);
    } catch (const LimitError& error) {
        return error.what();
    }
    return "";
}

TEST(Cost, KnowsTheAreaOfASphere) {
    for (const double probe : {0.0, 1.4, 3.0})
        EXPECT_NEAR(estimate_cost({{{}}, {1.7}}, {.probe = probe}).area, 4 * std::numbers::pi * 1.7 * 1.7, 1e-9);
}

TEST(Cost, IsNearTheTruthForAProtein) {
    const Atoms atoms = ubiquitin();
    for (const double probe : {0.0, 0.8, 1.4, 3.0}) {
        const double area = measure(atoms, {.probe = probe}).totals.ses_area;
        EXPECT_NEAR(estimate_cost(atoms, {.probe = probe}).area, area, 0.25 * area) << probe;
    }
    const auto vertices = static_cast<double>(compute_surface(atoms).mesh.vertices.size());
    EXPECT_NEAR(estimate_cost(atoms, {}).vertices, vertices, 0.25 * vertices);
}

TEST(Cost, LargeProbesChangeLittle) {
    const Atoms atoms = ubiquitin();
    for (const double probe : {5.0, 10.0, 35.0, 1e3, 1e5}) {
        const double area = measure(atoms, {.probe = std::min(probe, 100.0)}).totals.ses_area;
        EXPECT_NEAR(estimate_cost(atoms, {.probe = probe}).area, area, 0.4 * area) << probe;
        EXPECT_EQ(refusal(atoms, {.probe = probe}, 100), "") << probe;
    }
}

TEST(Cost, KnowsSpheresThatNearlyBuryEachOther) {
    Atoms atoms;  // a ball of 4,000
    for (int i = 0; i < 4000; ++i) {
        const double z = 2.0 * std::fmod(0.618034 * i, 1.0) - 1.0;
        const double angle = 2.0 * std::numbers::pi * std::fmod(0.754878 * i, 1.0);
        const double r = 30.0 * std::cbrt(std::fmod(0.569840 * i, 1.0));
        const double across = r * std::sqrt(1.0 - z * z);
        atoms.centres.push_back({across * std::cos(angle), across * std::sin(angle), r * z});
        atoms.radii.push_back(1.7);
    }
    for (const double probe : {10.0, 30.0, 100.0}) {
        const double area = measure(atoms, {.probe = probe}).totals.sas_area;
        EXPECT_NEAR(estimate_cost(atoms, {.surface = SurfaceKind::Sas, .probe = probe}).area, area, 0.4 * area)
            << probe;
    }
}

TEST(Cost, GrowsAsTheGridGetsFiner) {
    const Atoms atoms = ubiquitin();
    const Cost coarse = estimate_cost(atoms, {.spacing = 0.5});
    const Cost fine = estimate_cost(atoms, {.spacing = 0.1});
    EXPECT_NEAR(fine.vertices / coarse.vertices, 25.0, 1e-9);
    EXPECT_GT(fine.memory_mb, 5 * coarse.memory_mb);
    EXPECT_GT(fine.seconds, 15 * coarse.seconds);
    EXPECT_LT(estimate_cost(atoms, {.method = Method::Direct}).seconds, coarse.seconds);
}

TEST(Cost, OfNothingIsLittle) { EXPECT_EQ(estimate_cost({}, {}).vertices, 0.0); }

TEST(Cost, RefusalNamesWhatWouldFit) {
    const Atoms atoms = ubiquitin();
    const std::string text = refusal(atoms, kFine);
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, std::regex("a spacing of ([0-9.]+) Å or more"))) << text;
    EXPECT_NE(text.find("300 MB are allowed"), std::string::npos) << text;
    EXPECT_NE(text.find("a larger memory limit"), std::string::npos) << text;
    SurfaceOptions wider = kFine;
    wider.spacing = std::stod(found[1]);
    EXPECT_EQ(refusal(atoms, wider), "");
    EXPECT_NO_THROW(compute_surface(atoms, wider));
}

TEST(Cost, RefusalOffersTheDirectMethodWhereThatFits) {
    const Atoms atoms = ubiquitin();
    SurfaceOptions options = kFine;
    options.method = Method::Direct;
    const std::size_t enough = static_cast<std::size_t>(estimate_cost(atoms, options).memory_mb) + 1;
    EXPECT_EQ(refusal(atoms, options, enough), "");
    options.method = Method::Flow;
    EXPECT_NE(refusal(atoms, options, enough).find("the method direct"), std::string::npos);
}

TEST(Cost, CountsExactMeasures) {
    const Atoms atoms = ubiquitin();
    const SurfaceOptions without{.spacing = 2.0};
    const SurfaceOptions with{.spacing = 2.0, .exact = true};
    EXPECT_GT(estimate_cost(atoms, with).seconds, estimate_cost(atoms, without).seconds);
    EXPECT_GE(estimate_cost(atoms, with).memory_mb, estimate_cost(atoms, without).memory_mb);
    EXPECT_EQ(estimate_cost(atoms, with).vertices, estimate_cost(atoms, without).vertices);
}

TEST(Cost, CountsEvenTriangles) {
    const Atoms atoms = ubiquitin();
    for (const double edge : {0.6, 1.0, 2.0}) {
        const SurfaceOptions options{.remesh = {.edge = edge}};
        const auto vertices = static_cast<double>(compute_surface(atoms, options).mesh.vertices.size());
        EXPECT_NEAR(estimate_cost(atoms, options).vertices, vertices, 0.25 * vertices) << edge;
        EXPECT_GT(estimate_cost(atoms, options).memory_mb, estimate_cost(atoms, {}).memory_mb) << edge;
    }
}

TEST(Cost, EdgesThatWouldNotFitAreRefusedWithThoseThatWould) {
    const Atoms atoms = ubiquitin();
    SurfaceOptions options{.remesh = {.edge = 0.05}};
    EXPECT_THROW(compute_surface(atoms, options, {.memory_limit_mb = 100}), LimitError);
    const std::string text = refusal(atoms, options, 100);
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, std::regex("edges of ([0-9.]+) Å or more"))) << text;
    EXPECT_EQ(text.find("a spacing"), std::string::npos) << text;
    options.remesh.edge = std::stod(found[1]);
    EXPECT_EQ(refusal(atoms, options, 100), "");
    EXPECT_TRUE(fits_into_memory(estimate_cost(atoms, options), 100));
    EXPECT_FALSE(fits_into_memory(estimate_cost(atoms, options), 50));
}

}  // namespace
}  // namespace meniscus::testing

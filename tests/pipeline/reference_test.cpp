// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The surface of the reference arrangements and proteins against exact volumes.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "meniscus/measures.h"
#include "meniscus/surface.h"
#include "support/mesh_checks.h"
#include "support/test_data.h"

namespace meniscus::testing {
namespace {

struct Reference {
    std::string file;
    std::size_t atoms = 0;
    double volume = 0.0;
};

// Rows of exact.tsv for the probe of 1.4 Å.
std::vector<Reference> references() {
    std::ifstream table(*test_data() / "reference/exact.tsv");
    std::vector<Reference> rows;
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::istringstream fields(line);
        Reference row;
        double probe = 0.0;
        double skipped = 0.0;
        fields >> row.file >> row.atoms >> probe >> skipped >> skipped >> skipped >> row.volume;
        if (probe == 1.4) rows.push_back(row);
    }
    return rows;
}

bool is_spheres(const Reference& row) { return row.file.starts_with("spheres/"); }

double volume_error(const Surface& surface, const Reference& row) {
    return std::abs(surface.measures.volume / row.volume - 1.0);
}

TEST(Reference, SphereFilesConvergeFromEveryStartWithSecondOrder) {
    MENISCUS_NEED_TEST_DATA();
    for (const Reference& row : references()) {
        if (!is_spheres(row)) continue;
        SCOPED_TRACE(row.file);
        const Atoms atoms = read_spheres(*test_data() / "reference" / row.file);
        const Surface coarse = compute_surface(atoms, {.spacing = 0.5});
        std::vector<std::size_t> pieces;
        for (const double density : {-0.2, -0.5, -4.0}) {
            const Surface fine = compute_surface(atoms, {.spacing = 0.25, .density = density});
            EXPECT_TRUE(fine.passed());
            EXPECT_LE(fine.distance.mean, 0.004);
            EXPECT_LT(volume_error(fine, row), 0.02);
            EXPECT_GE(std::log2(volume_error(coarse, row) / volume_error(fine, row)), 1.8);
            pieces.push_back(fine.measures.components.size());
        }
        EXPECT_EQ(pieces[0], pieces[1]);
        EXPECT_EQ(pieces[1], pieces[2]);
    }
}

TEST(Reference, ProteinsAndNucleicAcidsKeepTheirVolume) {
    MENISCUS_NEED_TEST_DATA();
    for (const Reference& row : references()) {
        if (is_spheres(row) || row.atoms > 5000) continue;  // the larger ones are run by bench/accuracy
        SCOPED_TRACE(row.file);
        const bool small = row.atoms < 200;
        const Atoms atoms = read_spheres(*test_data() / "reference" / row.file);
        for (const Method method : {Method::Flow, Method::Direct}) {
            const Surface coarse = compute_surface(atoms, {.method = method, .spacing = 0.5});
            EXPECT_TRUE(coarse.passed());
            EXPECT_LT(volume_error(coarse, row), small ? 0.012 : 0.008);
        }
        if (row.atoms > 2000) continue;
        const Surface fine = compute_surface(atoms, {.spacing = 0.25});
        EXPECT_TRUE(fine.passed());
        EXPECT_LE(fine.distance.mean, 0.004);
        EXPECT_LT(volume_error(fine, row), small ? 0.003 : 0.002);
        expect_closed_manifold(fine.mesh);
    }
}

// Richardson extrapolation of a second-order error from two spacings, one half of the other.
double extrapolated(double coarse, double fine) { return fine + (fine - coarse) / 3.0; }

TEST(Reference, ExactMeasuresAgreeWithTheMeshOfTheExactField) {
    MENISCUS_NEED_TEST_DATA();
    for (const char* name : {"1yjo-h", "1etn-h", "1crn", "1bna", "1ubq"}) {
        SCOPED_TRACE(name);
        const Atoms atoms = read_spheres(*test_data() / "reference/xyzr" / (std::string(name) + ".xyzr"));
        const Measures exact = measure(atoms);
        const Surface coarse = compute_surface(atoms, {.method = Method::Direct, .spacing = 0.3});
        const Surface fine = compute_surface(atoms, {.method = Method::Direct, .spacing = 0.15});
        EXPECT_NEAR(extrapolated(coarse.measures.area, fine.measures.area) / exact.totals.ses_area, 1.0, 1e-3);
        EXPECT_NEAR(extrapolated(coarse.measures.volume, fine.measures.volume) / exact.totals.ses_volume, 1.0, 1e-4);
    }
}

TEST(Reference, CorrectedMeasuresOfTheExactFieldFollowRidges) {
    MENISCUS_NEED_TEST_DATA();
    for (const Reference& row : references()) {
        if (is_spheres(row) || row.atoms < 200 || row.atoms > 5000) continue;
        SCOPED_TRACE(row.file);
        const Atoms atoms = read_spheres(*test_data() / "reference" / row.file);
        const SurfaceTotals exact = measure(atoms).totals;
        for (const double spacing : {0.5, 0.25}) {
            const Surface surface = compute_surface(atoms, {.method = Method::Direct, .spacing = spacing});
            EXPECT_NEAR(surface.corrected_area / exact.ses_area, 1.0, spacing == 0.5 ? 1.5e-3 : 5e-4);
            EXPECT_NEAR(surface.corrected_volume / exact.ses_volume, 1.0, 2e-4);
        }
    }
}

TEST(Reference, ExactMeasuresMatchTheTable) {
    MENISCUS_NEED_TEST_DATA();
    std::ifstream table(*test_data() / "reference/exact.tsv");
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::istringstream fields(line);
        std::string file;
        std::size_t atoms = 0;
        double probe = 0.0;
        SurfaceTotals t;
        fields >> file >> atoms >> probe >> t.sas_area >> t.sas_volume >> t.ses_area >> t.ses_volume >>
            t.contact_area >> t.toroidal_area >> t.reentrant_area;
        SCOPED_TRACE(line);
        const Measures m =
            measure(read_spheres(*test_data() / "reference" / file), {.probe = probe, .cavities = false});
        EXPECT_TRUE(m.agreed);
        if (!file.starts_with("spheres/")) {
            EXPECT_FALSE(m.degenerate) << "no protein needs a patch trimmed twice";
        }
        const double bound = file.starts_with("spheres/") ? 1e-5 : 1e-7;
        EXPECT_NEAR(m.totals.sas_area / t.sas_area, 1.0, bound);
        EXPECT_NEAR(m.totals.sas_volume / t.sas_volume, 1.0, bound);
        EXPECT_NEAR(m.totals.ses_area / t.ses_area, 1.0, bound);
        EXPECT_NEAR(m.totals.ses_volume / t.ses_volume, 1.0, bound);
        EXPECT_NEAR(m.totals.contact_area / t.contact_area, 1.0, bound);
        EXPECT_NEAR(m.totals.toroidal_area, t.toroidal_area, bound * t.ses_area);
        EXPECT_NEAR(m.totals.reentrant_area, t.reentrant_area, bound * t.ses_area);
    }
}

}  // namespace
}  // namespace meniscus::testing

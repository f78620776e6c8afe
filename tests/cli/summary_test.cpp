// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "summary.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace meniscus::cli {

namespace {

Surface sample_surface() {
    Surface surface;
    surface.corrected_area = 4823.118;
    surface.measures.area = 4790.5;
    surface.measures.components = {{100, 196, 4800.0, 10000.0}, {10, 16, 20.0, -5.0}};
    surface.measures.closed = true;
    surface.measures.manifold = true;
    surface.flow.steps = 4;
    surface.flow.converged = true;
    surface.checks = {{"closed", true, 1.0, 1.0}, {"converged", false, 0.25, 0.125}};
    return surface;
}

Structure sample_structure() {
    Structure structure;
    structure.file = "dir/1ubq.pdb";
    structure.radii_set = "united";
    structure.atoms.centres.resize(1);
    return structure;
}

}  // namespace

TEST(Summary, TellsWhatWasLeftOut) {
    Surface surface = sample_surface();
    surface.options.min_cavity = 12.5;
    surface.dropped.cavities = 3;
    surface.simplified = {.handles = 2, .pieces = 1};
    const std::string text = make_summary(sample_structure(), surface, {}, {});
    EXPECT_NE(text.find("components  2 (1 outer, 1 cavity); 3 cavities below 12.5 Å³ dropped; 2 handles cut; "
                        "1 piece vanished\n"),
              std::string::npos)
        << text;
}

TEST(Summary, SaysWhichLigandsMayFillCavities) {
    Structure structure = sample_structure();
    structure.left_out_ligands = {{"HEP", 1}};
    Surface surface = sample_surface();
    const std::string text = make_summary(structure, surface, {}, {});
    EXPECT_NE(text.find("  left out    ligands that may fill cavities: 1 HEP\n"), std::string::npos) << text;
    EXPECT_EQ(make_summary(sample_structure(), surface, {}, {}).find("ligands"), std::string::npos);
    surface.measures.components.pop_back();
    EXPECT_EQ(make_summary(structure, surface, {}, {}).find("ligands"), std::string::npos) << "no cavities";
}

TEST(Summary, IsShortAndNamesUnits) {
    const std::string text =
        make_summary(sample_structure(), sample_surface(), {.threads = 2}, {{"a.ply", OutputKind::Mesh}});
    EXPECT_TRUE(text.starts_with("dir/1ubq.pdb: 1 atom, radii united, probe 1.4 Å, spacing 0.5 Å\n")) << text;
    EXPECT_NE(text.find("area        4823.12 Å² (flat triangles 4790.50 Å²)\n"), std::string::npos) << text;
    EXPECT_NE(text.find("components  2 (1 outer, 1 cavity)\n"), std::string::npos) << text;
    EXPECT_NE(text.find("flow        4 steps, converged\n"), std::string::npos) << text;
    EXPECT_NE(text.find("written     a.ply\n"), std::string::npos) << text;
}

TEST(Summary, TellsRadiiOfTheFileFromASet) {
    Structure structure = sample_structure();
    structure.radii_set = "file";
    const std::string text = make_summary(structure, sample_surface(), {}, {});
    EXPECT_NE(text.find("1 atom, radii of the file, probe"), std::string::npos) << text;
}

TEST(Summary, HasNoFlowLineWithoutAFlow) {
    Surface surface = sample_surface();
    surface.options.method = Method::Direct;
    const std::string text = make_summary(sample_structure(), surface, {}, {});
    EXPECT_EQ(text.find("converged"), std::string::npos) << text;
}

TEST(Summary, ListsFailedChecksWithTheirBounds) {
    EXPECT_EQ(failed_checks(sample_surface(), {}), "converged (0.25, bound 0.125)");
    EXPECT_EQ(failed_checks({}, {}), "");
    Surface unresolved;
    unresolved.checks.push_back({"volume", false, 0.5, std::numeric_limits<double>::quiet_NaN()});
    EXPECT_EQ(failed_checks(unresolved, {}), "volume (0.5, with nothing to compare with)");
    Measures disputed;
    disputed.agreed = false;
    disputed.disputed = {"patches of atom 3"};
    EXPECT_EQ(failed_checks(sample_surface(), disputed),
              "exact_agreement (patches of atom 3), converged (0.25, bound 0.125)");
}

}  // namespace meniscus::cli

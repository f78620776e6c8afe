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

/// Measures of an outer piece and so many cavities.
Measures measures_with(std::size_t cavities) {
    Measures exact;
    exact.totals.ses_area = 4830.5;
    exact.totals.ses_volume = 12345.125;
    exact.errors.ses_area = 8.1e-7;
    exact.errors.ses_volume = 1e-6;
    exact.components.resize(1 + cavities);
    exact.components[0].ses_volume = 12400.0;
    for (std::size_t i = 1; i <= cavities; ++i) {
        exact.components[i].kind = ComponentKind::Cavity;
        exact.components[i].ses_volume = 10.0;
        exact.components[i].inside_of = 0;
    }
    return exact;
}

std::string summary_of(const Surface& surface) { return make_summary(sample_structure(), surface, {}, {}); }

/// The line that explains numbers of pieces, or the one behind it.
std::string line_after_components(const std::string& text) {
    const std::size_t begin = text.find('\n', text.find("  components ")) + 1;
    return text.substr(begin, text.find('\n', begin) - begin);
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

TEST(Summary, BeginsWithTheExactNumbers) {
    Surface surface = sample_surface();
    surface.measured = std::make_shared<const Measures>(measures_with(1));
    const std::string text = summary_of(surface);
    EXPECT_NE(text.find("spacing 0.5 Å\n"
                        "  area         4830.5000 ± 8.1e-07 Å² exact; mesh 4823.12 Å², flat triangles 4790.50 Å²\n"
                        "  volume      12345.1250 ± 1.0e-06 Å³ exact; mesh 0.00 Å³, flat triangles 0.00 Å³\n"
                        "  components  2 (1 outer, 1 cavity)\n"
                        "  mesh  "),
              std::string::npos)
        << text;
}

TEST(Summary, TellsBothNumbersOfPiecesAndWhyTheyDiffer) {
    Surface surface = sample_surface();
    surface.measured = std::make_shared<const Measures>(measures_with(2));
    const std::string text = summary_of(surface);
    EXPECT_NE(text.find("  components  3 (1 outer, 2 cavities) exact; mesh 2 (1 outer, 1 cavity)\n"), std::string::npos)
        << text;
    EXPECT_NE(line_after_components(text).find("smaller than the spacing"), std::string::npos) << text;
    surface.simplified.pieces = 1;
    EXPECT_NE(line_after_components(summary_of(surface)).find("narrower than an edge"), std::string::npos);
    surface.options.method = Method::Gaussian;
    EXPECT_NE(line_after_components(summary_of(surface)).find("Gaussian envelope is not"), std::string::npos);
}

TEST(Summary, SaysWhatTheMeshLacksOfTheExactSurface) {
    Surface surface = sample_surface();
    surface.measured = std::make_shared<const Measures>(measures_with(1));
    surface.measures.components.resize(1);
    surface.options.pieces = Pieces::Outer;
    std::string text = summary_of(surface);
    EXPECT_NE(text.find("± 8.1e-07 Å² exact, of all pieces; mesh of outer pieces 4823.12 Å²"), std::string::npos)
        << text;
    EXPECT_NE(line_after_components(text).find("the options"), std::string::npos) << text;
    surface.options.pieces = Pieces::All;
    surface.options.min_cavity = 20.0;
    surface.dropped.cavities = 1;
    text = summary_of(surface);
    EXPECT_NE(text.find("exact, of all pieces; mesh without small cavities 4823.12 Å²"), std::string::npos) << text;
    EXPECT_NE(line_after_components(text).find("the options"), std::string::npos) << text;
    surface.dropped.cavities = 0;
    surface.options.surface = SurfaceKind::Sas;
    EXPECT_NE(summary_of(surface).find("exact; mesh without creases 4823.12 Å²"), std::string::npos);
}

TEST(Summary, SaysThatAreasAreOfTheWholeWhereAPartIsWritten) {
    Surface surface = sample_surface();
    surface.measured = std::make_shared<const Measures>(measures_with(1));
    RunFacts facts;
    facts.shown = ShownPart{.select = "//A", .vertices = 3, .triangles = 1, .area = 2.5, .open = true};
    const std::string text = make_summary(sample_structure(), surface, facts, {});
    EXPECT_NE(text.find("flat triangles 4790.50 Å², of the whole surface\n"), std::string::npos) << text;
    EXPECT_NE(text.find("written     only the part of //A: 3 vertices, 1 triangles, 2.50 Å², open\n"),
              std::string::npos)
        << text;
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
    EXPECT_EQ(failed_checks(sample_surface()), "converged (0.25, bound 0.125)");
    EXPECT_EQ(failed_checks({}), "");
    Surface unresolved;
    unresolved.checks.push_back({"volume", false, 0.5, std::numeric_limits<double>::quiet_NaN()});
    EXPECT_EQ(failed_checks(unresolved), "volume (0.5, with nothing to compare with)");
    Surface disputed = sample_surface();
    Measures measured;
    measured.agreed = false;
    measured.disputed = {"patches of atom 3"};
    disputed.measured = std::make_shared<const Measures>(measured);
    EXPECT_EQ(failed_checks(disputed), "exact_agreement (patches of atom 3), converged (0.25, bound 0.125)");
}

}  // namespace meniscus::cli

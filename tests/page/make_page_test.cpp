// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "meniscus/page.h"
#include "page/decoding.h"
#include "support/scratch_folder.h"

namespace meniscus {
namespace {

using testing::ScratchFolder;
using testing::SmallMolecule;

TEST(MakePage, IsTheSameForAnyNumberOfThreads) {
    const SmallMolecule molecule;
    EXPECT_EQ(make_page(molecule.mesh, molecule.structure, {.threads = 1}),
              make_page(molecule.mesh, molecule.structure, {.threads = 2}));
}

TEST(MakePage, NamesCannotBringMarkup) {
    SmallMolecule molecule;
    molecule.structure.name = "</title><script>alert(1)</script>";
    molecule.structure.residues[0] = {.chain = "<img src=x onerror=alert(1)>", .name = "</script>"};
    PageOptions options;
    options.rows = {{"<script>", "</table>", "<img src=x onerror=alert(1)>"}};
    const std::string html = make_page(molecule.mesh, molecule.structure, options);
    EXPECT_EQ(html.find("<script>alert"), std::string::npos);
    EXPECT_EQ(html.find("<img src=x"), std::string::npos);
    EXPECT_EQ(html.find("</title><script>"), std::string::npos);
}

TEST(MakePage, IncompleteMeshesAreRefused) {
    const SmallMolecule molecule;
    const auto refused = [&](const auto& spoil) {
        SmallMolecule spoilt = molecule;
        spoil(spoilt);
        EXPECT_THROW(make_page(spoilt.mesh, spoilt.structure), UsageError);
    };
    refused([](SmallMolecule& m) { m.mesh.normals.pop_back(); });
    refused([](SmallMolecule& m) { m.mesh.atoms.clear(); });
    refused([](SmallMolecule& m) { m.mesh.atoms[0] = 2; });
    refused([](SmallMolecule& m) { m.mesh.patches.clear(); });
    refused([](SmallMolecule& m) { m.mesh.components.pop_back(); });
    refused([](SmallMolecule& m) { m.mesh.mean_curvatures.pop_back(); });
    refused([](SmallMolecule& m) { m.mesh.triangles[0][0] = 1000000; });
}

TEST(MakePage, AMeshWithoutTrianglesIsAPageOfAtoms) {
    const Structure structure = testing::two_atoms();
    EXPECT_NE(make_page(Mesh{}, structure).find("</html>"), std::string::npos);
}

TEST(MakePage, OptionsThatMakeNoSenseAreRefused) {
    const SmallMolecule molecule;
    EXPECT_THROW(make_page(molecule.mesh, molecule.structure, {.colours = {ColourScheme::Curvature, ValueRange{1, 0}}}),
                 UsageError);
    EXPECT_THROW(make_page(molecule.mesh, molecule.structure, {.viewpoint = Viewpoint{{0, 0, 0}, {0, 1, 0}}}),
                 UsageError);
}

TEST(WritePage, AFailedRunLeavesNothingBehind) {
    const ScratchFolder folder;
    SmallMolecule molecule;
    testing::write_file(folder / "a.html", "older");
    molecule.mesh.atoms.clear();
    EXPECT_THROW(write_page(folder / "a.html", molecule.mesh, molecule.structure), UsageError);
    EXPECT_EQ(testing::read_file(folder / "a.html"), "older");
    EXPECT_EQ(folder.listing(), std::vector<std::string>{"a.html"});
    EXPECT_THROW(write_page(folder / "none/a.html", SmallMolecule().mesh, SmallMolecule().structure), OutputError);
}

TEST(WritePage, WritesWhatMakePageMakes) {
    const ScratchFolder folder;
    const SmallMolecule molecule;
    write_page(folder / "a.html", molecule.mesh, molecule.structure);
    EXPECT_EQ(testing::read_file(folder / "a.html"), make_page(molecule.mesh, molecule.structure));
}

}  // namespace
}  // namespace meniscus

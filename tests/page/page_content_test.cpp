// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "meniscus/page.h"
#include "page/decoding.h"
#include "page/packed_text.h"

namespace meniscus {
namespace {

using testing::SmallMolecule;

TEST(PageContent, IsWhatTheFileHolds) {
    const SmallMolecule molecule;
    const PageContent content = page_content(molecule.mesh, molecule.structure);
    const std::string html = make_page(molecule.mesh, molecule.structure);
    EXPECT_NE(html.find(page::base64(page::deflated(content.data))), std::string::npos);
    EXPECT_NE(html.find("<title>" + content.title + "</title>"), std::string::npos);
}

TEST(PageContent, IncompleteMeshesAreRefused) {
    SmallMolecule molecule;
    molecule.mesh.normals.pop_back();
    EXPECT_THROW(page_content(molecule.mesh, molecule.structure), UsageError);
}

}  // namespace
}  // namespace meniscus

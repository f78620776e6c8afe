// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact_blocks.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace meniscus::cli {

TEST(ExactBlocks, TotalsAndErrorsHaveTheSameKeys) {
    Measures measures;
    measures.totals.ses_area = 12.5;
    measures.errors.ses_area = 1e-8;
    measures.sas_components = 3;
    const auto block = exact_json(measures);
    EXPECT_EQ(block["ses_area"], 12.5);
    EXPECT_EQ(block["errors"]["ses_area"], 1e-8);
    EXPECT_EQ(block["sas_components"], 3);
    for (const auto& item : block["errors"].items()) EXPECT_TRUE(block.contains(item.key())) << item.key();
    EXPECT_EQ(block["errors"].size(), 7u);
}

TEST(ExactBlocks, OnlyCavitiesHaveAnInscribedSphere) {
    Measures measures;
    measures.components.resize(2);
    measures.components[1].kind = ComponentKind::Cavity;
    measures.components[1].inside_of = 0;
    measures.components[1].inscribed_radius = 1.5;
    measures.components[1].inscribed_centre = {1.0, 2.0, 3.0};
    measures.components[1].atoms = {4, 7};
    measures.components[1].errors.ses_area = 1e-8;
    const auto list = components_json(measures);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0]["kind"], "outer");
    EXPECT_TRUE(list[0]["inside_of"].is_null());
    EXPECT_TRUE(list[0]["inscribed_radius"].is_null());
    EXPECT_TRUE(list[0]["inscribed_centre"].is_null());
    EXPECT_EQ(list[1]["kind"], "cavity");
    EXPECT_EQ(list[1]["inside_of"], 0);
    EXPECT_EQ(list[1]["inscribed_radius"], 1.5);
    EXPECT_EQ(list[1]["inscribed_centre"], (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(list[1]["atoms"], (std::vector<int>{4, 7}));
    EXPECT_EQ(list[1]["errors"]["ses_area"], 1e-8);
    EXPECT_TRUE(components_json({}).is_array());
}

TEST(ExactBlocks, InterfacesTellTheBuriedAreaAndHalfOfIt) {
    Interface interface;
    interface.sas_a = 10.0;
    interface.sas_b = 8.0;
    interface.sas_ab = 15.0;
    interface.ses_ab = 1.0;
    interface.sas_error = 2e-8;
    const auto block = interface_json("A,C", "B", interface);
    EXPECT_EQ(block["a"], "A,C");
    EXPECT_EQ(block["buried_sas"], 3.0);
    EXPECT_EQ(block["interface_area"], 1.5);
    EXPECT_EQ(block["buried_ses"], -1.0);
    EXPECT_EQ(block["errors"]["buried_sas"], 2e-8);
    EXPECT_EQ(block["errors"]["interface_area"], 1e-8);
}

TEST(ExactBlocks, DisputedPatchesAreNamed) {
    const std::vector<std::string> names{"patches of atom 1", "patches of atom 2"};
    EXPECT_EQ(disputed_patches(true, names), "");
    EXPECT_EQ(disputed_patches(false, names), "exact_agreement (patches of atom 1; patches of atom 2)");
    Measures measures;
    EXPECT_TRUE(agreement_check(measures).passed);
    measures.agreed = false;
    EXPECT_FALSE(agreement_check(measures).passed);
    EXPECT_EQ(agreement_check(measures).name, "exact_agreement");
}

}  // namespace meniscus::cli

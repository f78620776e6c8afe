// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure_summary.h"

#include <gtest/gtest.h>

namespace meniscus::cli {

namespace {

Structure sample_structure() {
    Structure structure;
    structure.file = "dir/1ubq.pdb";
    structure.radii_set = "united";
    structure.atoms.centres.resize(1);
    structure.labels.resize(1);
    structure.residues = {{.chain = "A", .name = "LEU", .number = 12, .insertion_code = ' '}};
    return structure;
}

Measures with_cavities(std::size_t count) {
    Measures measures;
    measures.totals.sas_area = 4799.24123;
    measures.errors.sas_area = 9.6e-7;
    measures.sas_components = 3;
    measures.components.resize(1 + count);
    for (std::size_t i = 1; i <= count; ++i) {
        measures.components[i].kind = ComponentKind::Cavity;
        measures.components[i].ses_area = 20.0;
        measures.components[i].inscribed_radius = 1.5;
        measures.components[i].atoms = {0};
    }
    return measures;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(MeasureSummary, NumbersHaveErrorsAndUnits) {
    const std::string text = make_summary(sample_structure(), with_cavities(1), {.threads = 2}, {});
    EXPECT_TRUE(text.starts_with("dir/1ubq.pdb: 1 atom, radii united, probe 1.4 Å\n")) << text;
    EXPECT_TRUE(contains(text, "  SAS area           4799.2412 ± 9.6e-07 Å²\n")) << text;
    EXPECT_TRUE(contains(text, "  pieces        SES: 1 outer, 1 cavity; SAS: 3\n")) << text;
    EXPECT_TRUE(contains(text, "1.500      1  A:LEU12\n")) << text;
    EXPECT_FALSE(contains(text, "written")) << text;
}

TEST(MeasureSummary, ListsOnlyTheLargestCavities) {
    const std::string text = make_summary(sample_structure(), with_cavities(25), {}, {});
    EXPECT_TRUE(contains(text, "and 15 smaller")) << text;
    EXPECT_FALSE(contains(make_summary(sample_structure(), with_cavities(10), {}, {}), "smaller"));
    EXPECT_FALSE(contains(make_summary(sample_structure(), with_cavities(0), {}, {}), "lined by"));
    Measures measures = with_cavities(2);
    measures.components.back().errors = {.ses_area = 2e-7, .ses_volume = 3e-8};
    EXPECT_TRUE(contains(make_summary(sample_structure(), measures, {}, {}),
                         "areas to ± 2.0e-07 Å², volumes to ± 3.0e-08 Å³\n"));
}

TEST(MeasureSummary, SaysWhichLigandsMayFillTheCavities) {
    Structure structure = sample_structure();
    structure.left_out_ligands = {{"HEM", 4}, {"PO4", 1}};
    const std::string line = "            ligands that may fill them were left out: 4 HEM, 1 PO4\n";
    EXPECT_TRUE(contains(make_summary(structure, with_cavities(1), {}, {}), line));
    EXPECT_FALSE(contains(make_summary(structure, with_cavities(0), {}, {}), "ligands"));
    EXPECT_FALSE(contains(make_summary(sample_structure(), with_cavities(1), {}, {}), "ligands"));
}

TEST(MeasureSummary, InterfacesAreOneLineEach) {
    ChainInterface interface;
    interface.chains = {{"A", "C"}, {"B"}};
    interface.areas.sas_a = 100.0;
    interface.areas.sas_b = 80.0;
    interface.areas.sas_ab = 150.0;
    EXPECT_EQ(interface_name(interface.chains), "A,C:B");
    const std::string text = summarise_interfaces(std::vector<ChainInterface>{interface});
    EXPECT_TRUE(contains(text, "  A,C:B              100.00       80.00      150.00       30.00       15.00")) << text;
    EXPECT_EQ(summarise_interfaces({}), "  no chains touch\n");
    EXPECT_TRUE(contains(summarise_interfaces(std::vector<ChainInterface>(40, interface)), "and 10 more"));
}

}  // namespace meniscus::cli

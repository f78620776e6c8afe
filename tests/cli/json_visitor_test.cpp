// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "json_schema.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace meniscus::cli {

namespace {

template <class T>
ordered_json to_json(const T& result) {
    return described_as_json([&](auto& visit) { describe(result, visit); });
}

}  // namespace

TEST(JsonVisitor, TotalsAndErrorsHaveTheSameKeys) {
    Measures measures;
    measures.totals.ses_area = 12.5;
    measures.errors.ses_area = 1e-8;
    measures.sas_components = 3;
    const auto block = to_json(measures);
    EXPECT_EQ(block["ses_area"], 12.5);
    EXPECT_EQ(block["errors"]["ses_area"], 1e-8);
    EXPECT_EQ(block["sas_components"], 3);
    for (const auto& item : block["errors"].items()) EXPECT_TRUE(block.contains(item.key())) << item.key();
    EXPECT_EQ(block["errors"].size(), 7u);
}

TEST(JsonVisitor, OnlyCavitiesHaveAnInscribedSphere) {
    SurfaceComponent cavity;
    cavity.kind = ComponentKind::Cavity;
    cavity.inside_of = 0;
    cavity.inscribed_radius = 1.5;
    cavity.inscribed_centre = {1.0, 2.0, 3.0};
    cavity.atoms = {4, 7};
    cavity.errors.ses_area = 1e-8;
    const ordered_json list{to_json(SurfaceComponent{}), to_json(cavity)};
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
}

TEST(JsonVisitor, InterfacesTellTheBuriedAreaAndHalfOfIt) {
    Interface interface;
    interface.sas_a = 10.0;
    interface.sas_b = 8.0;
    interface.sas_ab = 15.0;
    interface.ses_ab = 1.0;
    interface.sas_error = 2e-8;
    const auto block = to_json(interface);
    EXPECT_EQ(block["buried_sas"], 3.0);
    EXPECT_EQ(block["interface_area"], 1.5);
    EXPECT_EQ(block["buried_ses"], -1.0);
    EXPECT_EQ(block["errors"]["buried_sas"], 2e-8);
    EXPECT_EQ(block["errors"]["interface_area"], 1e-8);
}

TEST(SchemaVisitor, TypesAreThoseOfTheMembers) {
    SchemaVisitor visit;
    visit({"area", "Å²", "the area"}, 1.0);
    visit({"count", "", "a count"}, std::size_t{0});
    visit({"genus", "", "a number"}, -1);
    visit({"name", "", "a name"}, std::optional<std::string>());
    visit({"kind", "", "a kind"}, ComponentKind::Outer, kComponentKindWords);
    visit.optional_block({"more", "", "more"}, std::optional<PatchAreas>(),
                         [](auto& inner, const PatchAreas& areas) { describe(areas, inner); });
    visit.list({"pieces", "", "pieces"}, std::vector<SurfaceComponent>(),
               [](auto& inner, const SurfaceComponent& component) { describe(component, inner); });
    const auto rules = visit.rules();
    const auto& of = rules["properties"];
    EXPECT_EQ(rules["required"].size(), 7u);
    EXPECT_EQ(of["area"]["description"], "the area (Å²)");
    EXPECT_EQ(of["area"]["type"], (std::vector<std::string>{"number", "null"}));
    EXPECT_EQ(of["count"]["minimum"], 0);
    EXPECT_EQ(of["genus"], (ordered_json{{"description", "a number"}, {"type", "integer"}}));
    EXPECT_EQ(of["name"]["type"], (std::vector<std::string>{"string", "null"}));
    EXPECT_EQ(of["kind"]["enum"], (std::vector<std::string>{"outer", "cavity"}));
    EXPECT_EQ(of["more"]["type"], (std::vector<std::string>{"object", "null"}));
    EXPECT_EQ(of["pieces"]["items"]["properties"]["centre"]["items"]["type"], of["area"]["type"]);
}

TEST(SchemaVisitor, OfTwoOnlyWhatBothHaveIsRequired) {
    SchemaVisitor one;
    one({"a", "", ""}, 1);
    one({"b", "", ""}, 1);
    SchemaVisitor other;
    other({"b", "", ""}, 1);
    other({"c", "", ""}, 1);
    const auto both = either(one.rules(), other.rules());
    EXPECT_EQ(both["required"], std::vector<std::string>{"b"});
    EXPECT_EQ(both["properties"].size(), 3u);
}

}  // namespace meniscus::cli

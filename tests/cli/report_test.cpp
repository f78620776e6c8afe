// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

namespace meniscus::cli {

namespace {

std::vector<std::string> keys_of(const nlohmann::ordered_json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items()) keys.push_back(item.key());
    return keys;
}

Structure sample_structure() {
    Structure structure;
    structure.file = "dir/1ubq.pdb";
    structure.radii_set = "united";
    structure.dropped["waters"] = 58;
    structure.notes = {"58 waters left out (keep them with --waters)"};
    structure.warnings = {"1 atom at exactly the position of another atom"};
    return structure;
}

const RunFacts kFacts{.model = 2, .threads = 3, .seconds = {.exact = 0.25, .total = 1.5}};

nlohmann::ordered_json report_of(const SurfaceRequest& request, Surface surface = {}, const Measures& exact = {}) {
    RunFacts facts = kFacts;
    facts.checks = surface.checks;
    facts.checks.push_back(agreement_check(exact));
    surface.measured = std::make_shared<const Measures>(exact);
    return make_report(request, sample_structure(), surface, facts);
}

}  // namespace

TEST(Report, HasTheBlocksOfTheInterfaceInOrder) {
    const std::vector<std::string> expected{"meniscus",   "schema",         "input",  "options", "exact",
                                            "components", "mesh",           "flow",   "checks",  "expected",
                                            "time_s",     "peak_memory_mb", "values", "drawn"};
    EXPECT_EQ(keys_of(report_of({})), expected);
    const std::vector<std::string> times{"total", "read",  "estimate", "geometry", "band",   "flow",
                                         "mesh",  "exact", "picture",  "page",     "volume", "write"};
    EXPECT_EQ(keys_of(report_of({})["time_s"]), times);
}

TEST(Report, TellsWhatWasReadAndDropped) {
    const auto input = report_of({})["input"];
    EXPECT_EQ(input["file"], "1ubq.pdb");
    EXPECT_EQ(input["model"], 2);
    EXPECT_EQ(input["radii"], "united");
    EXPECT_EQ(input["dropped"]["waters"], 58);
    EXPECT_EQ(input["notes"], nlohmann::ordered_json(sample_structure().notes));
    EXPECT_EQ(input["warnings"], nlohmann::ordered_json(sample_structure().warnings));
}

TEST(Report, JoinedModelsHaveAWordInThePlaceOfANumber) {
    SurfaceRequest request;
    request.read.join_models = true;
    RunFacts facts = kFacts;
    facts.model = kJoinedModels;
    const auto report = make_report(request, sample_structure(), Surface{}, facts);
    EXPECT_EQ(report["input"]["model"], "join");
    EXPECT_EQ(report["options"]["model"], "join");
    EXPECT_EQ(report["options"]["hetero"], "none");
}

TEST(Report, LeavesOutWhatAMethodDoesNotUse) {
    SurfaceRequest request;
    request.surface.method = Method::Direct;
    Surface surface;
    surface.options = request.surface;
    const auto direct = report_of(request, surface);
    EXPECT_EQ(direct["options"]["method"], "direct");
    EXPECT_TRUE(direct["flow"].is_null());
    for (const char* key : {"flow", "density", "time_step", "max_steps"})
        EXPECT_TRUE(direct["options"][key].is_null()) << key;
    EXPECT_EQ(report_of({})["options"]["flow"], "anchored");
    EXPECT_EQ(report_of({})["options"]["threads"], 3);
}

TEST(Report, HoldsAMeshWithoutSmallCavitiesAgainstThePiecesThatItKeeps) {
    // An outer piece, a cavity with an island, in which there is a cavity, and another cavity.
    Measures exact;
    exact.components.resize(5);
    const double volumes[]{1000.0, 40.0, 15.0, 10.0, 2.0};
    const std::uint32_t around[]{kNone, 0, 1, 0, 2};
    for (std::size_t i = 0; i < 5; ++i) {
        exact.components[i].kind = i == 0 || i == 2 ? ComponentKind::Outer : ComponentKind::Cavity;
        exact.components[i].ses_volume = volumes[i];
        exact.components[i].ses_area = volumes[i];
        exact.components[i].inside_of = around[i];
    }
    exact.totals.ses_volume = 1000.0 - 40.0 + 15.0 - 10.0 - 2.0;
    const auto deviation = [&](double min_cavity, double volume) {
        Surface surface;
        surface.options.min_cavity = min_cavity;
        surface.measures.volume = volume;
        return report_of({}, surface, exact)["mesh"]["volume_deviation"].get<double>();
    };
    EXPECT_EQ(deviation(0.0, 963.0), 0.0);
    EXPECT_EQ(deviation(2.0, 963.0), 0.0) << "what encloses as much stays";
    EXPECT_EQ(deviation(5.0, 965.0), 0.0);
    EXPECT_EQ(deviation(20.0, 975.0), 0.0);
    EXPECT_EQ(deviation(50.0, 1000.0), 0.0);
}

TEST(Report, TellsOfSelfIntersectionsWhereTheyWereLookedFor) {
    Surface surface;
    surface.quality.emplace();
    EXPECT_TRUE(report_of({}, surface)["mesh"]["quality"]["self_intersections"].is_null());
    surface.self_intersections = 0;
    EXPECT_EQ(report_of({}, surface)["mesh"]["quality"]["self_intersections"], 0);
}

TEST(Report, WritesNoNumberThatIsNotFinite) {
    Surface surface;
    surface.distance.max = std::numeric_limits<double>::infinity();
    surface.distance.mean = std::numeric_limits<double>::quiet_NaN();
    surface.checks = {{"closed", false, std::numeric_limits<double>::quiet_NaN(), 0.0}};
    const auto report = nlohmann::json::parse(report_of({}, surface).dump());
    EXPECT_TRUE(report["mesh"]["max_distance"].is_null());
    EXPECT_TRUE(report["mesh"]["mean_distance"].is_null());
    EXPECT_TRUE(report["checks"][0]["value"].is_null());
    EXPECT_EQ(report["checks"][0]["passed"], false);
}

TEST(Report, ComparesTheMeshWithTheExactMeasures) {
    Surface surface;
    surface.measures.area = 99.0;
    surface.corrected_area = 100.5;
    surface.measures.volume = -12.0;
    surface.corrected_volume = -9.0;
    Measures exact;
    exact.totals.ses_area = 100.0;
    exact.totals.ses_volume = -10.0;  // only cavities count
    const auto report = report_of({}, surface, exact);
    EXPECT_DOUBLE_EQ(report["mesh"]["area_deviation"], -0.01);
    EXPECT_DOUBLE_EQ(report["mesh"]["corrected_area_deviation"], 0.005);
    EXPECT_DOUBLE_EQ(report["mesh"]["volume_deviation"], -0.2);
    EXPECT_DOUBLE_EQ(report["mesh"]["corrected_volume_deviation"], 0.1);
    EXPECT_EQ(report["time_s"]["exact"], 0.25);
    EXPECT_EQ(report["checks"].back()["name"], "exact_agreement");
    EXPECT_FALSE(report.contains("interfaces"));
}

TEST(Report, HasNullInThePlaceOfExactNumbersThatWereLeftOut) {
    Surface surface;
    surface.measures.area = 99.0;
    const auto report =
        nlohmann::json::parse(make_report(SurfaceRequest{}, sample_structure(), surface, kFacts).dump());
    EXPECT_TRUE(report["exact"].is_null());
    EXPECT_TRUE(report["components"].is_null());
    EXPECT_EQ(report["options"]["exact"], false);
    EXPECT_EQ(report["mesh"]["area"], 99.0);
    for (const char* key :
         {"area_deviation", "volume_deviation", "corrected_area_deviation", "corrected_volume_deviation"})
        EXPECT_TRUE(report["mesh"][key].is_null()) << key;
}

TEST(Report, OfMeasuresHasNoMeshAndNamesItsOptions) {
    MeasureRequest request;
    request.per = {RowsPer::Atom, RowsPer::Cavity};
    request.between = {"A:B"};
    Measures exact;
    exact.options.probe = 1.2;
    exact.agreed = false;
    RunFacts facts = kFacts;
    facts.checks = {agreement_check(exact)};
    const auto report = make_report(request, sample_structure(), exact, facts);
    EXPECT_TRUE(report["mesh"].is_null());
    EXPECT_TRUE(report["flow"].is_null());
    EXPECT_TRUE(report["interfaces"].is_null());
    EXPECT_EQ(report["input"]["probe"], 1.2);
    EXPECT_EQ(report["options"]["per"], (std::vector<std::string>{"atom", "cavity"}));
    EXPECT_EQ(report["options"]["between"], (std::vector<std::string>{"A:B"}));
    EXPECT_EQ(report["checks"][0]["passed"], false);
}

TEST(Report, OfInterfacesNamesTheGroups) {
    RunFacts facts = kFacts;
    ChainInterface interface;
    interface.chains = {{"A", "C"}, {"B"}};
    facts.interfaces = {interface};
    const auto report = make_report(MeasureRequest{}, sample_structure(), Measures{}, facts);
    ASSERT_EQ(report["interfaces"].size(), 1u);
    EXPECT_EQ(report["interfaces"][0]["a"], "A,C");
    EXPECT_EQ(report["interfaces"][0]["b"], "B");
}

TEST(Report, TheMeshIsOpenWhereOnlyAPartIsShown) {
    Surface surface;
    surface.measures.closed = true;
    RunFacts facts = kFacts;
    const auto closed = [&] {
        return make_report(SurfaceRequest{}, sample_structure(), surface, facts)["mesh"]["closed"];
    };
    facts.shown = {.select = "//A", .open = false};
    EXPECT_EQ(closed(), true);
    facts.shown->open = true;
    EXPECT_EQ(closed(), false);
}

TEST(Report, SurvivesFileNamesThatAreNoUtf8) {
    Structure structure;
    structure.file = "\xff.pdb";
    testing::internal::CaptureStdout();
    write_report("-", make_report(SurfaceRequest{}, structure, Surface{}, RunFacts{}));
    EXPECT_TRUE(nlohmann::json::accept(testing::internal::GetCapturedStdout()));
}

TEST(Report, CountsThreadsThatRun) {
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    EXPECT_EQ(threads_in_use(0), cores);
    EXPECT_EQ(threads_in_use(1), 1);
    EXPECT_EQ(threads_in_use(cores + 100), cores);
}

TEST(Report, KnowsThePeakOfMemory) { EXPECT_GT(peak_memory_mb(), 0.5); }

}  // namespace meniscus::cli

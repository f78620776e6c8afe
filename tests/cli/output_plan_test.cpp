// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "output_plan.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "meniscus/errors.h"

namespace meniscus::cli {

namespace {

namespace fs = std::filesystem;

/// An empty folder for one test.
class OutputPlan : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / fs::path("meniscus_output_plan_" + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "sub");
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }

    fs::path folder_;
};

}  // namespace

TEST_F(OutputPlan, TellsFormatsBySuffix) {
    EXPECT_EQ(kind_of("a.ply"), OutputKind::Mesh);
    EXPECT_EQ(kind_of("a.vtp"), OutputKind::Mesh);
    EXPECT_EQ(kind_of("dir.x/a.b.stl"), OutputKind::Mesh);
    EXPECT_EQ(kind_of("a.xyzrn"), OutputKind::Spheres);
    EXPECT_EQ(kind_of("a.html"), OutputKind::Page);
    EXPECT_EQ(kind_of("a.PLY"), OutputKind::Mesh);
    EXPECT_EQ(measure_kind_of("a.Csv"), OutputKind::Table);
    for (const char* path : {"a", "a.", "a.foo", ".ply", "-", "", "dir.ply/"})
        EXPECT_THROW(kind_of(path), UsageError) << path;
}

TEST_F(OutputPlan, DefaultsToAMeshAndAPageInTheCurrentFolder) {
    const std::vector<Output> expected{
        {"1ubq.ply", OutputKind::Mesh}, {"1ubq.html", OutputKind::Page}, {"1ubq.atoms.csv", OutputKind::AtomTable}};
    EXPECT_EQ(plan_outputs({}, "1ubq", ""), expected);
    EXPECT_EQ(plan_outputs({}, "1ubq_m01", "_m01").front().path, "1ubq_m01.ply");
}

TEST_F(OutputPlan, PutsOneAtomTableBesideTheMeshesOfAStem) {
    const std::vector<Output> expected{{"out/a.ply", OutputKind::Mesh},
                                       {"out/a.obj", OutputKind::Mesh},
                                       {"b.xyzr", OutputKind::Spheres},
                                       {"out/a.atoms.csv", OutputKind::AtomTable}};
    EXPECT_EQ(plan_outputs({"out/a.ply", "out/a.obj", "b.xyzr"}, "x", ""), expected);
}

TEST_F(OutputPlan, MarksModelsBeforeTheSuffix) {
    const std::vector<Output> plan = plan_outputs({"out/a.b.ply"}, "x", "_m02");
    EXPECT_EQ(plan.front().path, "out/a.b_m02.ply");
    EXPECT_EQ(plan.back().path, "out/a.b_m02.atoms.csv");
}

TEST_F(OutputPlan, RefusesAFileNamedTwice) {
    EXPECT_THROW(check_paths({in_folder("a.ply"), in_folder("sub/../a.ply")}, {}), UsageError);
    EXPECT_NO_THROW(check_paths({in_folder("a.ply"), in_folder("sub/a.ply")}, {}));
}

TEST_F(OutputPlan, AVertFileBringsAFaceFileWithIt) {
    EXPECT_EQ(files_of("out/a.b.vert"), (std::vector<std::string>{"out/a.b.vert", "out/a.b.face"}));
    EXPECT_EQ(files_of("a.ply"), std::vector<std::string>{"a.ply"});
    EXPECT_THROW(check_paths({in_folder("a.vert"), in_folder("a.face")}, {}), UsageError);
    std::ofstream(in_folder("b.face")) << "0 0 0 1\n";
    EXPECT_THROW(check_paths({in_folder("b.vert")}, {{"the input", in_folder("b.face")}}), UsageError);
    EXPECT_NO_THROW(check_paths({in_folder("a.vert"), in_folder("b.vert")}, {}));
}

TEST_F(OutputPlan, RefusesToOverwriteTheInput) {
    std::ofstream(in_folder("a.xyzr")) << "0 0 0 1\n";
    fs::create_symlink(in_folder("a.xyzr"), in_folder("link.xyzr"));
    const std::vector<ReadFile> read{{"the input", "-"}, {"the file of --radii", in_folder("a.xyzr")}};
    EXPECT_THROW(check_paths({in_folder("a.xyzr")}, read), UsageError);
    try {
        check_paths({in_folder("link.xyzr")}, read);
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("would overwrite the file of --radii"), std::string::npos);
    }
    EXPECT_NO_THROW(check_paths({"-", in_folder("b.xyzr")}, read));
}

TEST_F(OutputPlan, RefusesFoldersThatAreMissingOrMeantAsFiles) {
    EXPECT_THROW(check_paths({in_folder("none/a.ply")}, {}), OutputError);
    EXPECT_THROW(check_paths({in_folder("sub")}, {}), OutputError);
}

TEST_F(OutputPlan, LeavesDevicesAndStandardOutputAlone) {
    EXPECT_NO_THROW(check_paths({"-", "/dev/null", "/dev/null"}, {}));
}

TEST_F(OutputPlan, APictureNeedsNeitherMeshNorTable) {
    const std::vector<Output> expected{{"a_m01.png", OutputKind::Picture}};
    EXPECT_EQ(plan_outputs({"a.png"}, "name", "_m01"), expected);
    EXPECT_THROW(measure_kind_of("a.png"), UsageError);
}

TEST_F(OutputPlan, AMeshThatHoldsItsAtomsNeedsNoTable) {
    const std::vector<Output> expected{{"a.npz", OutputKind::Mesh}};
    EXPECT_EQ(plan_outputs({"a.npz"}, "name", ""), expected);
}

TEST_F(OutputPlan, TablesAndCopiesAreThoseOfMeasure) {
    EXPECT_EQ(measure_kind_of("a.csv"), OutputKind::Table);
    EXPECT_EQ(measure_kind_of("a.json"), OutputKind::Table);
    EXPECT_EQ(measure_kind_of("a.cif"), OutputKind::StructureCopy);
    EXPECT_THROW(measure_kind_of("a.ply"), UsageError);
    EXPECT_THROW(kind_of("a.csv"), UsageError);
    const std::vector<Output> expected{{"a_m02.csv", OutputKind::Table}, {"b_m02.pdb", OutputKind::StructureCopy}};
    EXPECT_EQ(plan_measure_outputs({"a.csv", "b.pdb"}, "_m02"), expected);
    EXPECT_TRUE(plan_measure_outputs({}, "").empty());
}

}  // namespace meniscus::cli

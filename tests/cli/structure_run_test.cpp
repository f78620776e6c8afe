// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure_run.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "support/scratch_folder.h"

namespace meniscus::cli {

namespace {

using meniscus::testing::read_file;
using meniscus::testing::ScratchFolder;
using meniscus::testing::write_file;

/// Counts atoms and writes nothing.
class CountingRun : public StructureRun {
public:
    explicit CountingRun(const CommonRequest& request, std::string failure = "")
        : StructureRun(request, 1), request_(request), failure_(std::move(failure)) {}

    std::vector<std::string> calls;
    mutable double seconds = 0.0;  ///< that a report tells

private:
    std::vector<Output> plan(const std::string& /*name*/, const std::string& mark) const override {
        std::vector<Output> outputs;
        for (const std::string& path : request_.outputs) outputs.push_back({path + mark, OutputKind::Table});
        return outputs;
    }
    void compute(const Job& job) override { calls.push_back("compute " + std::to_string(job.structure.atoms.size())); }
    void write(const Output& output, const Job& /*job*/) const override { write_file(output.path, "written"); }
    std::string failed() const override { return failure_; }
    nlohmann::ordered_json report(const Job& job, const RunFacts& facts) const override {
        seconds = facts.seconds.total;
        return {{"model", job.model}, {"threads", facts.threads}};
    }
    std::string summary(const Job& job, const RunFacts& /*facts*/) const override { return job.structure.name + "\n"; }

    const CommonRequest& request_;
    std::string failure_;
};

constexpr const char* kAtom = "ATOM      1  CA  GLY A   1       0.000   0.000   0.000  1.00  0.00           C\n";

class StructureRunTest : public ::testing::Test {
protected:
    StructureRunTest() {
        const std::string atom = kAtom;
        write_file(folder_ / "a.pdb", "MODEL        1\n" + atom + "ENDMDL\nMODEL        2\n" + atom + "ENDMDL\n");
        request_.input = folder_ / "a.pdb";
        request_.outputs = {folder_ / "t.csv"};
        request_.report = folder_ / "r.json";
        request_.progress = ProgressMode::Off;
    }

    ScratchFolder folder_;
    CommonRequest request_;
};

}  // namespace

TEST_F(StructureRunTest, WritesFilesReportAndSummary) {
    ::testing::internal::CaptureStdout();
    CountingRun run(request_);
    EXPECT_EQ(run(), Outcome::Done);
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "a\n");
    EXPECT_EQ(run.calls, (std::vector<std::string>{"compute 1"}));
    EXPECT_EQ(read_file(folder_ / "t.csv"), "written");
    EXPECT_EQ(nlohmann::json::parse(read_file(folder_ / "r.json"))["model"], 1);
}

TEST_F(StructureRunTest, EveryModelIsAStructureOfItsOwn) {
    request_.all_models = true;
    request_.quiet = true;
    CountingRun run(request_);
    EXPECT_EQ(run(), Outcome::Done);
    EXPECT_EQ(run.calls.size(), 2u);
    EXPECT_EQ(folder_.listing(), (std::vector<std::string>{"a.pdb", "r.json", "t.csv_m01", "t.csv_m02"}));
    EXPECT_EQ(nlohmann::json::parse(read_file(folder_ / "r.json")).size(), 2u);
}

TEST_F(StructureRunTest, AFailedCheckIsToldAndOutputsAreWrittenAllTheSame) {
    request_.quiet = true;
    ::testing::internal::CaptureStderr();
    CountingRun run(request_, "exact_agreement (patches of atom 3)");
    EXPECT_EQ(run(), Outcome::ChecksFailed);
    EXPECT_NE(::testing::internal::GetCapturedStderr().find("exact_agreement (patches of atom 3)"), std::string::npos);
    EXPECT_EQ(folder_.listing(), (std::vector<std::string>{"a.pdb", "r.json", "t.csv"}));
}

TEST_F(StructureRunTest, NothingIsReadBeforePathsAreChecked) {
    const auto run_once = [this] {
        CountingRun run(request_);
        return run();
    };
    request_.input = folder_ / "missing.pdb";
    request_.outputs = {folder_ / "none/t.csv"};
    EXPECT_THROW(run_once(), OutputError);
    request_.outputs = {request_.report};
    EXPECT_THROW(run_once(), UsageError);
    request_.outputs = {};
    EXPECT_THROW(run_once(), InputError);
}

TEST_F(StructureRunTest, TellsNoMoreTimeThanThereWas) {
    request_.quiet = true;
    const double before = Stopwatch::of_program().lap();
    CountingRun run(request_);
    run();
    EXPECT_GT(run.seconds, before);
    EXPECT_LT(run.seconds, Stopwatch::of_program().lap());
}

TEST(Stopwatch, OfTheProgramHasRunBefore) {
    Stopwatch own;
    EXPECT_LT(own.lap(), Stopwatch::of_program().lap());
}

}  // namespace meniscus::cli

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "standard_output.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"

namespace meniscus::cli {

namespace {

using Paths = std::vector<std::string>;

/// What is written for these values of -o and this one of --format.
Paths resolved(Paths outputs, const std::string& format) {
    CommonRequest request;
    request.outputs = std::move(outputs);
    request.format = format;
    resolve_standard_output(request, true);
    return request.outputs;
}

std::string refusal(CommonRequest request) {
    try {
        resolve_standard_output(request, true);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

CommonRequest piped() {
    CommonRequest request;
    request.outputs = {"-"};
    request.format = "obj";
    return request;
}

}  // namespace

TEST(StandardOutput, HasItsFormatAsASuffix) {
    EXPECT_EQ(resolved({"-"}, "ply"), Paths{"/dev/stdout.ply"});
    EXPECT_EQ(resolved({"a.ply", "/dev/stdout"}, ".OBJ"), (Paths{"a.ply", "/dev/stdout.obj"}));
    EXPECT_EQ(resolved({}, "csv"), Paths{"/dev/stdout.csv"});
    EXPECT_EQ(resolved({"a.ply"}, ""), Paths{"a.ply"});
    EXPECT_TRUE(use_standard_output({"a.ply", "/dev/stdout.obj"}));
    EXPECT_FALSE(use_standard_output({"a.ply"}));
}

TEST(StandardOutput, IsNamedInMessagesAsItWasAskedFor) {
    EXPECT_EQ(output_label("/dev/stdout.ply"), "standard output");
    EXPECT_EQ(output_label("a.ply"), "a.ply");
    EXPECT_EQ(spell_output("/dev/stdout.ply"), "--format ply");
    EXPECT_EQ(spell_output("a.ply"), "-o a.ply");
    EXPECT_THROW(kind_of("/dev/stdout.foo"), UsageError);
    try {
        measure_kind_of("/dev/stdout.foo");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_EQ(std::string(error.what()), "--format foo: unknown format; choose one of csv json pdb cif");
    }
}

TEST(StandardOutput, TakesOneOutputOfOneStructure) {
    const CommonRequest fine = piped();
    EXPECT_EQ(refusal(fine), "");
    CommonRequest request = fine;
    request.outputs = {"-", "-"};
    EXPECT_NE(refusal(request).find("two outputs"), std::string::npos);
    request = fine;
    request.report = "-";
    EXPECT_NE(refusal(request).find("--report -"), std::string::npos);
    request = fine;
    request.all_models = true;
    EXPECT_NE(refusal(request).find("--model all"), std::string::npos);
    request = fine;
    request.per_chain = true;
    EXPECT_NE(refusal(request).find("--per-chain"), std::string::npos);
}

TEST(StandardOutput, NeedsAFormatThatItCanHave) {
    CommonRequest request = piped();
    request.format = "";
    EXPECT_NE(refusal(request).find("add --format"), std::string::npos);
    for (const char* format : {"vert", "vdb"}) {
        request.format = format;
        EXPECT_NE(refusal(request).find("-o FILE."), std::string::npos) << format;
    }
    request.format = "ply";
    request.outputs = {"a.dat"};
    EXPECT_NE(refusal(request).find("the suffix of a file is its format"), std::string::npos);
}

TEST(StandardOutput, HasNoTableOfAtomsBesideIt) {
    const std::vector<Output> expected{{"/dev/stdout.ply", OutputKind::Mesh}};
    EXPECT_EQ(plan_outputs({"/dev/stdout.ply"}, "name", ""), expected);
    EXPECT_NO_THROW(check_paths({"/dev/stdout.ply"}, {}));
}

}  // namespace meniscus::cli

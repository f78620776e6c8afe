// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "structure/pdb_screen.h"

namespace meniscus::reading {
namespace {

constexpr const char* kAtomLine = "ATOM  \n";

// Models as "line of the first, line of the second ...: warnings".
std::string models_of(const std::string& text) {
    const PdbModels models = find_pdb_models(text);
    std::string description;
    for (const PdbModelSpan& span : models.spans) description += std::to_string(span.first_line) + " ";
    for (const std::string& line : models.warnings) description += "[" + line.substr(0, line.find(';')) + "]";
    return description;
}

std::string join(std::initializer_list<std::string> lines) {
    std::string text;
    for (const std::string& line : lines) text += line == "A" ? kAtomLine : line + "\n";
    return text;
}

TEST(PdbModels, WithoutRecordsThereIsOne) {
    EXPECT_EQ(models_of(join({"HEADER", "A", "A", "TER", "A", "END"})), "2 ");
    EXPECT_EQ(models_of("HEADER\n"), "");
}

TEST(PdbModels, ModelAndEndmdlEncloseThem) {
    EXPECT_EQ(models_of(join({"MODEL        1", "A", "ENDMDL", "MODEL        2", "A", "ENDMDL", "END"})), "1 4 ");
    EXPECT_EQ(models_of(join({"MODEL        1", "ENDMDL"})), "1 ");
}

TEST(PdbModels, EndSeparatesFramesOfATrajectory) {
    EXPECT_EQ(models_of(join({"A", "END", "A", "END"})), "1 3 ");
    EXPECT_EQ(models_of(join({"MODEL 1", "A", "ENDMDL", "END", "MODEL 2", "A", "ENDMDL", "END"})), "1 5 ");
}

TEST(PdbModels, RepeatedAndMissingNumbersAreNoted) {
    EXPECT_EQ(models_of(join({"MODEL 1", "A", "ENDMDL", "MODEL 1", "A", "ENDMDL"})),
              "1 4 [line 4: this MODEL number occurs more than once]");
    EXPECT_EQ(models_of(join({"MODEL", "A", "ENDMDL"})), "1 [line 1: MODEL without a number]");
}

TEST(PdbModels, AnythingButALetterMayFollowTheName) {
    for (const char* behind : {"1", "\t1", "_1", "-1", ":1"}) {
        const std::string record = std::string("MODEL") + behind;
        EXPECT_TRUE(models_of(join({record, "A", "MODEL 2", "A"})).starts_with("1 3 ")) << record;
    }
    EXPECT_EQ(models_of(join({"MODELS", "A", "MODELLER 10", "A"})), "2 ");
    EXPECT_EQ(models_of(join({"MODEL1", "A", "ENDMDL", "MODEL1", "A", "ENDMDL"})),
              "1 4 [line 4: this MODEL number occurs more than once]");
}

TEST(PdbModels, ModelsNeverClosedAreNotedOnce) {
    EXPECT_EQ(models_of(join({"MODEL 1", "A", "MODEL 2", "A", "END"})),
              "1 3 [line 1: this MODEL is never closed by ENDMDL]");
    EXPECT_EQ(models_of(join({"MODEL 1", "A"})), "1 [line 1: this MODEL is never closed by ENDMDL]");
}

TEST(PdbModels, AtomsOutsideModelsAreAModel) {
    EXPECT_EQ(models_of(join({"MODEL 1", "A", "ENDMDL", "A", "ENDMDL"})),
              "1 4 [line 4: atoms outside MODEL and ENDMDL]");
    EXPECT_EQ(models_of(join({"A", "ENDMDL", "MODEL 2", "A", "ENDMDL"})),
              "1 3 [line 1: atoms outside MODEL and ENDMDL]");
}

}  // namespace
}  // namespace meniscus::reading

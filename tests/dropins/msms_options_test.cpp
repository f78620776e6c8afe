// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/msms_options.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"

namespace meniscus::dropins {
namespace {

TEST(MsmsOptions, DefaultsAreThoseOfMsms) {
    const MsmsRequest request = parse_msms({});
    EXPECT_EQ(request.probe, 1.5);
    EXPECT_EQ(request.density, 1.0);
    EXPECT_TRUE(request.triangulated && request.with_area && request.with_header);
    EXPECT_FALSE(request.all_components || request.without_hydrogens);
    EXPECT_TRUE(request.cavity_atoms.empty());
}

TEST(MsmsOptions, MayBeCutShortAndTheFirstInOrderIsMeant) {
    // As VMD, TABI-PB, MaSIF, OpenStructure and PyGBe write them.
    const MsmsRequest request =
        parse_msms({"-prob", "1.4", "-dens", "2", "-hd", "2", "-if", "a", "-of", "b", "-af", "c", "-all", "-no_h"});
    EXPECT_EQ(request.probe, 1.4);
    EXPECT_EQ(request.density, 2.0);
    EXPECT_EQ(request.input, "a");
    EXPECT_EQ(request.surface, "b");
    EXPECT_EQ(request.area, "c");
    EXPECT_TRUE(request.all_components);
    EXPECT_FALSE(request.with_header);
    EXPECT_TRUE(request.warnings.empty());
    EXPECT_EQ(parse_msms({"-d", "2.5"}).density, 2.5);
    EXPECT_EQ(parse_msms({"-p", "0"}).probe, 0.0);
    EXPECT_FALSE(parse_msms({"-no"}).with_area);
    EXPECT_TRUE(parse_msms({"-noh"}).without_hydrogens);
    EXPECT_FALSE(parse_msms({"-surf", "ases"}).triangulated);
}

TEST(MsmsOptions, OneCavityTakesAsManyAtomsAsItSays) {
    EXPECT_EQ(parse_msms({"-one_cavity", "1", "7", "-noh"}).cavity_atoms, std::vector<std::uint32_t>{7});
    EXPECT_EQ(parse_msms({"-one", "3", "7", "0", "9"}).cavity_atoms, (std::vector<std::uint32_t>{7, 0, 9}));
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"-one_cavity", "0"},
                                                  {"-one_cavity", "4", "1", "2", "3", "4"},
                                                  {"-one_cavity", "2", "1"},
                                                  {"-one_cavity", "1", "-3"},
                                                  {"-one_cavity", "1", "1.5"},
                                                  {"-one_cavity"}})
        EXPECT_THROW(parse_msms(wrong), UsageError);
}

TEST(MsmsOptions, WhatMakesNoDifferenceIsTakenWithAWarning) {
    EXPECT_EQ(parse_msms({"-free_vertices", "-no_rest", "-no_rest_on_pbr"}).warnings.size(), 3U);
    EXPECT_EQ(parse_msms({"-hdensity", "5"}).warnings.size(), 1U);
    EXPECT_TRUE(parse_msms({"-hdensity", "3.0", "-density", "1"}).warnings.empty());  // MSMS's own
}

TEST(MsmsOptions, WhatMsmsDoesNotKnowIsRefused) {
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"-foo"},
                                                  {"a.xyzr"},
                                                  {"-"},
                                                  {"--if", "a"},
                                                  {"-if"},
                                                  {"-probe_radius", "x"},
                                                  {"-probe_radius", "-1"},
                                                  {"-density", "0"},
                                                  {"-density", "nan"},
                                                  {"-surface", "sas"},
                                                  {"-socketPort", "1357"},
                                                  {"-sinetd"},
                                                  {"-probe_radius_", "1"}})
        EXPECT_THROW(parse_msms(wrong), UsageError) << wrong.front();
}

TEST(MsmsOptions, AloneHIsHelpAlthoughItBeginsAnotherOption) {
    EXPECT_TRUE(parse_msms({"-h"}).help);
    EXPECT_EQ(parse_msms({"-h", "4"}).hdensity, 4.0);
    EXPECT_NE(msms_usage().find("-one_cavity N A..."), std::string::npos);
}

}  // namespace
}  // namespace meniscus::dropins

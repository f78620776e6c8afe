// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/nanoshaper_options.h"

#include <gtest/gtest.h>

#include <sstream>

#include "meniscus/errors.h"

namespace meniscus::dropins {
namespace {

NanoShaperRequest read_parameters(const std::string& text) {
    std::istringstream stream(text);
    return read_nanoshaper(stream, "a.prm");
}

TEST(NanoShaperOptions, DefaultsAreThoseOfNanoShaper) {
    const NanoShaperRequest request = read_parameters("");
    EXPECT_EQ(request.grid_scale, 2.0);
    EXPECT_EQ(request.probe, 1.4);
    EXPECT_EQ(request.input, "temp.xyzr");
    EXPECT_FALSE(request.msms_format || request.fill_cavities);
    EXPECT_EQ(request.fill_below, 11.4);
}

TEST(NanoShaperOptions, WhatTabiPbWritesIsReadWithoutAWarning) {
    const NanoShaperRequest request = read_parameters(
        "Grid_scale = 3.500000\nGrid_perfil = 90.000000\nXYZR_FileName = molecule.xyzr\nBuild_epsilon_maps = false\n"
        "Build_status_map = false\nSave_Mesh_MSMS_Format = true\nCompute_Vertex_Normals = true\nSurface = ses\n"
        "Smooth_Mesh = true\nSkin_Surface_Parameter = 0.450000\nCavity_Detection_Filling = false\n"
        "Conditional_Volume_Filling_Value = 11.400000\nKeep_Water_Shaped_Cavities = false\nProbe_Radius = 1.500000\n"
        "Accurate_Triangulation = true\nTriangulation = true\nCheck_duplicated_vertices = true\n"
        "Save_Status_map = false\nSave_PovRay = false\nMax_ses_patches_per_auxiliary_grid_2d_cell = 800\n"
        "Max_ses_patches_auxiliary_grid_2d_size = 50\n");
    EXPECT_EQ(request.grid_scale, 3.5);
    EXPECT_EQ(request.probe, 1.5);
    EXPECT_EQ(request.input, "molecule.xyzr");
    EXPECT_TRUE(request.msms_format && request.triangulated && request.with_normals);
    EXPECT_TRUE(request.warnings.empty()) << request.warnings.front();
}

TEST(NanoShaperOptions, NamesOfFilesBeginWithFolderAndRoot) {
    EXPECT_EQ(read_parameters("Root_FileName = /tmp/vmdns.u0.7.\n").root, "/tmp/vmdns.u0.7.");
    EXPECT_EQ(read_parameters("Output_Folder = out\nRoot_FileName = a_\n").root, "out/a_");
    EXPECT_EQ(read_parameters("Root_FileName = a_\nOutput_Folder = out/\n").root, "out/a_");
}

TEST(NanoShaperOptions, CommentsAndBlanksArePassedOver) {
    EXPECT_EQ(read_parameters("# a\n\n  Number_thread = 3 # of 32\r\n").threads, 3);
    EXPECT_EQ(read_parameters("Number_thread = -1 #default value is 32\n").threads, 0);
    EXPECT_EQ(read_parameters("Grid_scale=4").grid_scale, 4.0);
}

TEST(NanoShaperOptions, UnknownKeysAndOutputsOfOthersAreWarnedOf) {
    const NanoShaperRequest request = read_parameters("Grid_perfill = 70\nSave_PovRay = true\nStern_layer = -1.\n");
    ASSERT_EQ(request.warnings.size(), 2U);
    EXPECT_NE(request.warnings[0].find("a.prm:1:1: Grid_perfill"), std::string::npos);
    EXPECT_NE(request.warnings[1].find("Save_PovRay"), std::string::npos);
}

TEST(NanoShaperOptions, OtherSurfacesAndModesAreRefused) {
    for (const char* wrong : {"Surface = skin", "Surface = blobby", "Surface = mesh", "Operative_Mode = pockets"})
        EXPECT_THROW(read_parameters(wrong), InputError) << wrong;
    EXPECT_NO_THROW(read_parameters("Operative_Mode = normal\nSurface = SES"));
}

TEST(NanoShaperOptions, ValuesThatCannotBeReadAreToldWithTheirPlace) {
    for (const char* wrong :
         {"Grid_scale = 0", "Grid_scale = x", "Probe_Radius = -1", "Triangulation = maybe", "Grid_scale",
          "Number_thread = 1.5", "Grid_scale = nan", "Conditional_Volume_Filling_Value ="})
        EXPECT_THROW(read_parameters(wrong), InputError) << wrong;
    try {
        read_parameters("\n  Grid_scale = big\n");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("a.prm:2:3: Grid_scale")) << error.what();
    }
}

TEST(NanoShaperOptions, WhatIsNoTextIsShownAsText) {
    EXPECT_NE(read_parameters("\x01\xff = 1\n").warnings.at(0).find(std::string(2, '?') + " is unknown"),
              std::string::npos);
    try {
        read_parameters("Surface = " + std::string(5000, '\x02'));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_TRUE(std::string(error.what()).ends_with("not " + std::string(40, '?') + "...")) << error.what();
    }
}

}  // namespace
}  // namespace meniscus::dropins

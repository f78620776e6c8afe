// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/msms_report.h"

#include <gtest/gtest.h>

namespace meniscus::dropins {
namespace {

// Two spheres of 1.7 Å, 5.45 Å apart, as MSMS 2.6.1 reports them.
SurfaceComponent two_spheres() {
    SurfaceComponent component;
    component.toroidal_area = 8.144;
    component.contact_area = 67.243;
    component.ses_area = 75.387;
    component.sas_area = 238.258;
    component.atoms = {0, 1};
    return component;
}

TEST(MsmsReport, LinesThatCallersReadAreInMsmssColumns) {
    const MsmsRequest request;
    const std::vector<SurfaceComponent> components{two_spheres()};
    EXPECT_TRUE(msms_banner().starts_with("MSMS 2.6.1 started on "));
    EXPECT_EQ(msms_areas(request, components),
              "ANALYTICAL SURFACE AREA :\n"
              "    Comp. probe_radius,   reent,    toric,   contact    SES       SAS\n"
              "      0       1.500       0.000     8.144    67.243    75.387   238.258\n");
    EXPECT_NE(msms_components(components).find("    RS component 0 identified 0 1\n"), std::string::npos);
    const std::vector<MeshComponent> pieces{{100, 196, 74.132, 40.497}};
    EXPECT_TRUE(msms_volumes(request, pieces)
                    .ends_with("NUMERICAL VOLUMES AND AREA\n"
                               "    Comp. probe_radius SES_volume SES_area)\n"
                               "       0      1.50       40.497     74.132\n"
                               "    Total ses_volume:    40.497\n"));
    EXPECT_TRUE(msms_end(0.5).starts_with("MSMS terminated normally\nTotal Time real: "));
}

TEST(MsmsReport, TheInputIsToldWithItsRadii) {
    MsmsRequest request;
    request.input = "ttest.xyzrn";
    request.density = 5.0;
    SphereFile spheres;
    spheres.atoms = {{{0, 0, 0}, {5, 0, 0}}, {1.7, 1.7}};
    EXPECT_EQ(msms_input(request, spheres),
              "INPUT  ttest.xyzrn 2 spheres 0 collision only, radii  1.700 to  1.700\n"
              "PARAM  Probe_radius  1.500 density  5.000 hdensity  3.000\n");
}

TEST(MsmsReport, TheTableOfAreasHasALinePerSphereOfTheFile) {
    SphereFile spheres;
    spheres.atoms = {{{0, 0, 0}, {5, 0, 0}}, {0.0, 1.7}};
    spheres.names = {"H_GLY_1", "CA_GLY_1"};
    const std::vector<std::vector<AtomShare>> shares{{{1.5, 2.5}}, {{0.25, 0.0}}};
    const std::vector<std::uint32_t> places{1};
    EXPECT_EQ(msms_area_table(spheres, shares, places),
              "Atom #     ses_0     sas_0     ses_1     sas_1\n"
              "     0     0.000     0.000 H_GLY_1     0.000     0.000 H_GLY_1\n"
              "     1     1.500     2.500 CA_GLY_1     0.250     0.000 CA_GLY_1\n");
    spheres.names.clear();
    EXPECT_TRUE(msms_area_table(spheres, {shares.data(), 1}, places).ends_with("\n     1     1.500     2.500\n"));
}

}  // namespace
}  // namespace meniscus::dropins

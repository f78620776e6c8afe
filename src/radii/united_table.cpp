// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Set `united`: probe-contact radii of heavy atoms that stand for their hydrogens, as used for Table 1 of the paper
// of the method (docs/METHOD.md); of the same kind as those in M. L. Connolly, J. Appl. Cryst. 16, 548-558 (1983).
#include <array>

#include "radii/tables.h"

namespace meniscus {
namespace {

constexpr std::string_view kHaem = "HEM,HEC,HEA,HEB,HAS,HDD,HEV,HEO,HDM,HEME,HEMO,DHE,SRM,1FH,2FH";
constexpr std::string_view kIronSulphur = "SF4,FES,FS4,F3S,FS3,CLF,CFN,ICS,SF3,FSX";

constexpr auto kUnitedTable = std::to_array<RadiusRule>({
    // oxygen
    {"SER", "OG", 1.60},
    {"THR", "OG1", 1.60},
    {"TYR", "OH", 1.60},
    {kWaterResidues, "@O", 1.60},
    {"*", "@O", 1.40},
    // nitrogen; by HIS the table means the tautomer with its hydrogen on NE2, other names say where it is
    {"ASN", "ND2", 1.80},
    {"GLN", "NE2", 1.80},
    {"ARG", "NH1,NH2", 1.80},
    {"LYS", "NZ", 2.00},
    {"HIP,HSP,HISH", "ND1", 1.70},
    {"HID,HSD,HISD", "ND1", 1.70},
    {"HID,HSD,HISD", "NE2", 1.54},
    {"HIS", "ND1", 1.54},
    {kHaem, "@N", 1.54},
    {"*", "@N", 1.70},
    // carbon
    {"*", "C", 1.74},
    {"ASN,ASP,HIS,LEU,PHE,TRP,TYR", "CG", 1.74},
    {"GLU,GLN", "CD", 1.74},
    {"ARG,TYR", "CZ", 1.74},
    {"TRP", "CD2,CE2", 1.74},
    {"PHE", "CD1,CD2,CE1,CE2,CZ", 1.86},
    {"TYR", "CD1,CD2,CE1,CE2", 1.86},
    {"TRP", "CD1,CE3,CZ2,CZ3,CH2", 1.86},
    {"HIS", "CE1,CD2", 1.86},
    {"*", "@C", 2.00},
    // the rest
    {"CYX,CYS2,CYM", "SG", 1.80},
    {"CYS", "SG", 1.85},
    {"*", "@S,@P", 1.80},
    {"*", "@H,@D", 1.20},
    {kHaem, "@FE", 1.30},
    {kIronSulphur, "@FE", 1.30},
    {"*", "@FE", 1.24},
    {"*", "@CA", 1.97},
    {"*", "@ZN,@CU", 1.40},
    {"*", "@CD", 1.49},
    {"*", "@MG", 1.60},
    {"*", "@MN", 1.24},
    {"*", "@CO", 1.25},
    {"*", "@SE", 2.15},
    {"*", "@YB", 1.15},
});

}  // namespace

const std::span<const RadiusRule> kUnitedRules = kUnitedTable;

}  // namespace meniscus

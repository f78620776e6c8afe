// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Set `parse`: D. Sitkoff, K. A. Sharp, B. Honig, J. Phys. Chem. 98, 1978-1988 (1994), doi 10.1021/j100058a043;
// nucleotides: C. L. Tang, E. Alexov, A. M. Pyle, B. Honig, J. Mol. Biol. 366, 1475-1496 (2007); which atom has which
// value as in PARSE.DAT of PDB2PQR 3.5.2 (its RNA values serve for DNA too). Carbons with hydrogens have 2.0 and
// their hydrogens 0: such hydrogens do not exist for the surface. So it is with charged LYS and N-terminal groups.
#include <array>

#include "radii/tables.h"

namespace meniscus {
namespace {

constexpr std::string_view kParseAminoAcids =
    "ALA,ARG,ASN,ASP,CYS,GLN,GLU,GLY,HIS,ILE,LEU,LYS,MET,PHE,PRO,SER,THR,TRP,TYR,VAL,ACE,NME";
constexpr std::string_view kParseNucleotides = "A,C,G,I,T,U,DA,DC,DG,DI,DT,DU";

constexpr auto kParseTable = std::to_array<RadiusRule>({
    {kWaterResidues, "@O", 1.4},
    {kWaterResidues, "@H,@D", 1.0},
    // nucleotides
    {kParseNucleotides, "HO*,H2T,H3T,H5T", 0.0},
    {kParseNucleotides, "@H,@D", 1.1},
    {kParseNucleotides, "@C", 1.7},
    {kParseNucleotides, "@N", 1.5},
    {kParseNucleotides, "@O", 1.4},
    {kParseNucleotides, "@P", 1.9},
    // hydrogens
    {"NTERM", "H1,H2,H3,HT1,HT2,HT3,HN1,HN2,HN3", 0.0},
    {"*", "H,HN,HN1,HN2,H1,H2,HT1,HT2,HXT,HO,D", 1.0},
    {"ARG", "HE,HH*", 1.0},
    {"ASN", "HD1,HD2*", 1.0},
    {"ASP", "HD2", 1.0},
    {"CYS", "HG", 1.0},
    {"GLN", "HE*", 1.0},
    {"GLU", "HE2", 1.0},
    {"HIS", "HD*,HE*", 1.0},
    {"LYN", "HZ*", 1.0},
    {"PHE", "HD*,HE*,HZ*", 1.0},
    {"SER", "HG*", 1.0},
    {"THR", "HG1", 1.0},
    {"TRP", "HD*,HE*,HZ*,HH*", 1.0},
    {"TYR", "HD*,HE*,HH*", 1.0},
    {kParseAminoAcids, "@H,@D", 0.0},
    {"MSE", "@H,@D", 0.0},
    {"*", "HA*,HB*", 0.0},
    // main chain, of modified residues too
    {"NTERM", "N", 2.0},
    {"*", "N", 1.5},
    {"*", "C", 1.7},
    {"*", "O,OXT", 1.4},
    {"*", "CA@C,CB@C", 2.0},
    // side chains
    {"LYN", "NZ", 1.5},
    {"LYS", "NZ", 2.0},
    {"ARG", "CZ", 1.7},
    {"ASN,ASP", "CG", 1.7},
    {"GLN,GLU", "CD", 1.7},
    {"HIS", "CG,CD2,CE1", 1.7},
    {"PHE,TYR", "CG,CD1,CD2,CE1,CE2,CZ", 1.7},
    {"TRP", "CG,CD1,CD2,CE2,CE3,CZ2,CZ3,CH2", 1.7},
    {kParseAminoAcids, "@C", 2.0},
    {kParseAminoAcids, "@N", 1.5},
    {kParseAminoAcids, "@O", 1.4},
    {kParseAminoAcids, "@S", 1.85},
});

}  // namespace

const std::span<const RadiusRule> kParseRules = kParseTable;

}  // namespace meniscus

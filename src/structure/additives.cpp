// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/additives.h"

#include <algorithm>
#include <array>

namespace meniscus::reading {
namespace {

constexpr auto kSalts = std::to_array<std::string_view>({
    "SO4", "SO3", "PO4", "PI",  "2HP", "PO3", "NO3", "CO3", "BCT", "NH4", "SCN", "AZI", "ACT", "ACY",
    "FMT", "CIT", "FLC", "TLA", "TAR", "SRT", "MLI", "MLA", "MLT", "SIN", "OXL", "CAC", "VO4", "BO4",
});
constexpr auto kBuffers = std::to_array<std::string_view>({
    "TRS",
    "EPE",
    "MES",
    "NHE",
    "CXS",
    "B3P",
    "BTB",
    "MPO",
    "PIN",
    "IMD",
    "BCN",
    "TAM",
    "HAI",
});
/// And what helps nucleic acids to crystallise.
constexpr auto kPrecipitants = std::to_array<std::string_view>({
    "PEG", "PGE", "PG4", "PG0", "PG5", "PG6", "PG8", "1PE", "2PE", "PE3", "PE4", "PE5", "PE8",
    "P6G", "P33", "P3G", "P4G", "P4C", "12P", "15P", "16P", "XPE", "7PE", "7PG", "1PG", "6PE",
    "9PE", "AE3", "AE4", "PEU", "TOE", "ME2", "M2M", "SPD", "SPM", "JEF", "NEX",
});
constexpr auto kCryoprotectants = std::to_array<std::string_view>({
    "GOL",
    "EDO",
    "PGO",
    "PGR",
    "MPD",
    "MRD",
    "BU1",
    "BU2",
    "BU3",
    "HEZ",
    "CRY",
});
constexpr auto kSolvents = std::to_array<std::string_view>({
    "DMS", "DMF", "EOH", "MOH", "IPA", "IOH", "POL", "TBU", "CCN", "ACN", "DIO", "ETX",
    "BME", "DTT", "DTU", "DTV", "DTD", "TCE", "URE", "GAI", "MBN", "BNZ", "MTN", "DOD",
});
constexpr auto kDetergents = std::to_array<std::string_view>({
    "LMT", "LMU", "DMU", "UMQ", "BOG", "BGL", "BNG", "HTG", "HTO", "LDA", "C8E", "C10", "CE1", "CE9", "CXE",
    "CPS", "OLC", "OLB", "MPG", "SDS", "DDQ", "D10", "D12", "OCT", "HEX", "UND", "DD9", "R16", "TWT", "SOG",
});
constexpr auto kMembranes = std::to_array<std::string_view>({
    "POPC", "POPE", "POPG", "POPS", "POPA", "POPI", "DPPC", "DPPE", "DPPG", "DPPS", "DMPC",
    "DMPE", "DMPG", "DMPS", "DOPC", "DOPE", "DOPG", "DOPS", "DLPC", "DLPE", "DLPG", "DSPC",
    "DSPE", "DSPG", "SOPC", "SDPC", "SAPI", "PSM",  "SSM",  "CHL1", "CHOL",
});

template <class Table>
bool contains(const Table& table, std::string_view name) {
    return std::find(table.begin(), table.end(), name) != table.end();
}

}  // namespace

bool is_additive(std::string_view residue) {
    return contains(kSalts, residue) || contains(kBuffers, residue) || contains(kPrecipitants, residue) ||
           contains(kCryoprotectants, residue) || contains(kSolvents, residue) || contains(kDetergents, residue) ||
           contains(kMembranes, residue);
}

}  // namespace meniscus::reading

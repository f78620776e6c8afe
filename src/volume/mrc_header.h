// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The header of MRC and CCP4 maps (MRC2014, Cheng et al. 2015, J. Struct. Biol. 192, 146-150).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace meniscus {

/// As in the file. The triples n, start and axes are those of columns, rows and sections, columns running fastest; all
/// others are along x, y and z.
struct MrcHeader {
    std::array<std::int32_t, 3> n{};         ///< NX NY NZ: values
    std::int32_t mode = 2;                   ///< 0 int8, 1 int16, 2 float, 6 uint16
    std::array<std::int32_t, 3> start{};     ///< NXSTART ..: place of the first value, in spacings
    std::array<std::int32_t, 3> m{};         ///< MX MY MZ: intervals of the cell
    std::array<float, 3> cell{};             ///< CELLA: its edges, Å
    std::array<float, 3> angles{};           ///< CELLB: degrees
    std::array<std::int32_t, 3> axes{};      ///< MAPC MAPR MAPS: 1, 2, 3 for x, y, z
    float least = 0.0F;                      ///< DMIN
    float most = 0.0F;                       ///< DMAX
    float mean = 0.0F;                       ///< DMEAN
    std::int32_t space_group = 1;            ///< ISPG: 1 for one volume
    std::int32_t extended_size = 0;          ///< NSYMBT: bytes between header and values
    std::array<char, 8> extra1{};            ///<
    std::array<char, 4> extended_type{};     ///< EXTTYP
    std::int32_t version = 20140;            ///< NVERSION
    std::array<char, 84> extra2{};           ///<
    std::array<float, 3> origin{};           ///< ORIGIN: of the first value, Å
    std::array<char, 4> map{};               ///< MAP: "MAP "
    std::array<unsigned char, 4> machine{};  ///< MACHST: 0x44 0x44 little-endian, 0x11 0x11 big-endian
    float deviation = 0.0F;                  ///< RMS: of the values from their mean
    std::int32_t label_count = 0;            ///< NLABL
    std::array<std::array<char, 80>, 10> labels{};
};
static_assert(sizeof(MrcHeader) == 1024);
static_assert(offsetof(MrcHeader, version) == 108 && offsetof(MrcHeader, origin) == 196 &&
              offsetof(MrcHeader, labels) == 224);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "meniscus/errors.h"
#include "platform/files/atomic_file.h"
#include "volume/mrc_header.h"
#include "volume/writers.h"

namespace meniscus {
namespace {

static_assert(std::endian::native == std::endian::little, "files are written as numbers are in memory");

constexpr unsigned char kLittleEndian = 0x44;

void set_statistics(const std::vector<float>& values, MrcHeader& header) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    double sum = 0.0;
    for (const float v : values) sum += static_cast<double>(v);
    const double mean = sum / static_cast<double>(values.size());
    double squares = 0.0;
    for (const float v : values) squares += (static_cast<double>(v) - mean) * (static_cast<double>(v) - mean);
    header.least = *least;
    header.most = *most;
    header.mean = static_cast<float>(mean);
    header.deviation = static_cast<float>(std::sqrt(squares / static_cast<double>(values.size())));
}

void add_label(std::string_view text, MrcHeader& header) {
    auto& label = header.labels[static_cast<std::size_t>(header.label_count++)];
    label.fill(' ');
    std::copy_n(text.begin(), std::min(text.size(), label.size()), label.begin());
}

std::int32_t count_of(const std::string& path, std::size_t count) {
    if (count > std::numeric_limits<std::int32_t>::max())
        throw LimitError(
            fmt::format("{}: MRC holds at most 2147483647 nodes along an axis, not {}; write .dx", path, count));
    return static_cast<std::int32_t>(count);
}

// The first value lies at ORIGIN, where MRC2014 has it; the cell begins there.
MrcHeader header_of(const std::string& path, const Volume& volume, VolumeContent content) {
    const VolumeGrid& grid = volume.grid;
    const std::array spacing{grid.spacing.x, grid.spacing.y, grid.spacing.z};
    MrcHeader header;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        header.n[axis] = header.m[axis] = count_of(path, grid.counts[axis]);
        header.cell[axis] = static_cast<float>(static_cast<double>(grid.counts[axis]) * spacing[axis]);
    }
    header.angles = {90.0F, 90.0F, 90.0F};
    header.axes = {1, 2, 3};
    header.origin = {static_cast<float>(grid.origin.x), static_cast<float>(grid.origin.y),
                     static_cast<float>(grid.origin.z)};
    header.map = {'M', 'A', 'P', ' '};
    header.machine = {kLittleEndian, kLittleEndian, 0, 0};
    set_statistics(volume.values, header);
    for (const std::string& line : header_lines(content)) add_label(line, header);
    return header;
}

}  // namespace

void write_mrc(const std::string& path, const Volume& volume, VolumeContent content) {
    AtomicFile file(path);
    file.bytes(header_of(path, volume, content));
    const auto [nx, ny, nz] = volume.grid.counts;
    std::vector<float> row(nx);
    for (std::size_t k = 0; k < nz; ++k)
        for (std::size_t j = 0; j < ny; ++j) {
            for (std::size_t i = 0; i < nx; ++i) row[i] = volume.values[volume.grid.index(i, j, k)];
            file.write(std::string_view(reinterpret_cast<const char*>(row.data()), row.size() * sizeof(float)));
        }
    file.commit();
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzzed_volume.h"

#include <algorithm>
#include <cmath>

#include "meniscus/volume_file.h"

namespace meniscus::fuzz {

int run_volume(const FuzzedFile& file, const std::uint8_t* data, std::size_t size) {
    file.write(text_of(data, size));
    read_or_refuse(file.path(), [&] {
        const Volume volume = read_volume(file.path());
        require(volume.values.size() == volume.grid.size() && !volume.values.empty(), "a value for each node");
        require(std::all_of(volume.values.begin(), volume.values.end(), [](float v) { return std::isfinite(v); }),
                "values are finite");
        require(read_volume_grid(file.path()) == volume.grid, "the grid alone is the same");
        interpolate(volume, std::vector<Vec3>{volume.grid.node(0, 0, 0), {0.1, 0.2, 0.3}}, Interpolation::Cubic);
    });
    return 0;
}

}  // namespace meniscus::fuzz

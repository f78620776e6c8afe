// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Volumes and files of volumes for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "meniscus/errors.h"
#include "meniscus/volume_file.h"
#include "support/scratch_folder.h"

namespace meniscus::testing {

/// Reads content from a file of that name.
inline Volume read_content(const std::string& content, const std::string& name) {
    const ScratchFolder folder;
    write_file(folder / name, content);
    return read_volume(folder / name);
}

/// What the reader says of it without the folder; empty if it takes it.
inline std::string complaint(const std::string& content, const std::string& name) {
    const ScratchFolder folder;
    write_file(folder / name, content);
    try {
        read_volume(folder / name);
        return "";
    } catch (const InputError& error) {
        const std::string text = error.what();
        return text.substr(text.find(name));
    }
}

/// A volume with the values of a function at the nodes.
template <class Function>
Volume volume_of(const VolumeGrid& grid, const Function& function) {
    Volume volume{grid, {}};
    for (std::size_t i = 0; i < grid.counts[0]; ++i)
        for (std::size_t j = 0; j < grid.counts[1]; ++j)
            for (std::size_t k = 0; k < grid.counts[2]; ++k)
                volume.values.push_back(static_cast<float>(function(grid.node(i, j, k))));
    return volume;
}

}  // namespace meniscus::testing

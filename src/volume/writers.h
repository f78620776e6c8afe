// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The writers of volumes, one per format; see write_volume() for what they throw.
#pragma once

#include <array>
#include <string>

#include "meniscus/volume_file.h"

namespace meniscus {

/// Two lines without umlauts: the program, and what the values mean.
std::array<std::string, 2> header_lines(VolumeContent content);

void write_dx(const std::string& path, const Volume& volume, VolumeContent content);
void write_mrc(const std::string& path, const Volume& volume, VolumeContent content);
void write_vdb(const std::string& path, const Volume& volume, VolumeContent content);

}  // namespace meniscus

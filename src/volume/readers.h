// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The readers of volumes, one per format; see read_volume() for what they take and throw.
#pragma once

#include <string>

#include "meniscus/volume_file.h"

namespace meniscus {

/// How much of a file is read.
enum class VolumePart { Grid, All };

Volume read_dx(const std::string& path, VolumePart part);
Volume read_mrc(const std::string& path, VolumePart part);

}  // namespace meniscus

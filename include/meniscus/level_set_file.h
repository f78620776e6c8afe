// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Level sets in files of their own format, without loss.
#pragma once

#include <string>
#include <string_view>

#include "meniscus/level_set.h"

namespace meniscus {

/// Writes a level set: grid and coefficients, in the format that docs/conventions.md describes. The suffix is free;
/// .mls is usual. The file appears whole or not at all, as with write_mesh().
///
/// throws   OutputError
/// cost     about 2 kB per block of 8³ nodes
void write_level_set(const std::string& path, const LevelSet& level_set);

/// Reads it back, bit by bit the same.
///
/// throws   InputError, in one line, for a file that cannot be read, is of another kind or version, has been cut off or
///          changed (a checksum tells), or describes no grid. Nothing is allocated that the file is too short to hold.
LevelSet read_level_set(const std::string& path);

/// What write_level_set() would write, and the level set back from it.
///
/// name     of the bytes in messages
/// throws   as write_level_set() and read_level_set()
std::string level_set_bytes(const LevelSet& level_set);
LevelSet level_set_from_bytes(std::string_view bytes, const std::string& name);

}  // namespace meniscus

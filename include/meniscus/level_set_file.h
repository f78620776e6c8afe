// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Level sets in files, without loss, in a format of their own.
#pragma once

#include <string>
#include <string_view>

#include "meniscus/level_set.h"

namespace meniscus {

/// Writes a level set: grid and coefficients, in the format that docs/conventions.md describes, about 2 kB per block of
/// 8³ nodes. Any suffix will do; .mls is usual. The file appears whole or not at all, as with write_mesh().
///
/// throws   OutputError for a file that cannot be written
void write_level_set(const std::string& path, const LevelSet& level_set);

/// Reads a level set that write_level_set() wrote; every bit is the same.
///
/// throws   InputError, in one line, for a file that cannot be read, is of another kind or version, has been cut off or
///          changed (as a checksum shows), or does not describe a grid. Memory is allocated
///          only after sizes are checked against the length of the file
LevelSet read_level_set(const std::string& path);

/// The bytes that write_level_set() writes.
std::string level_set_bytes(const LevelSet& level_set);

/// The level set that level_set_bytes() turned into bytes.
///
/// name     what messages call the bytes
/// throws   as read_level_set()
LevelSet level_set_from_bytes(std::string_view bytes, const std::string& name);

}  // namespace meniscus

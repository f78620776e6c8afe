// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Takes the place of npz.cpp and level_set_file.cpp in a build without zlib (CMake's MENISCUS_ZLIB=OFF), which neither
// compresses arrays nor checks level sets: such files are refused.
#include "io/npz.h"
#include "meniscus/errors.h"
#include "meniscus/level_set_file.h"

namespace meniscus {
namespace {

constexpr const char* kNoLevelSets = "this build has no files of level sets (it has no zlib)";

}  // namespace

void write_npz(AtomicFile& /*file*/, const Mesh& /*mesh*/, const WriteOptions& /*options*/) {
    throw UsageError("this build writes no .npz (it has no zlib); choose another suffix");
}

void write_pocket_arrays(const std::string& path, const Pockets& /*pockets*/) {
    throw UsageError(path + ": this build writes no .npz (it has no zlib); choose another suffix");
}

void write_level_set(const std::string& path, const LevelSet& /*level_set*/) {
    throw OutputError(path + ": " + kNoLevelSets);
}

LevelSet read_level_set(const std::string& path) { throw InputError(path + ": " + kNoLevelSets); }

std::string level_set_bytes(const LevelSet& /*level_set*/) { throw UsageError(kNoLevelSets); }

LevelSet level_set_from_bytes(std::string_view /*bytes*/, const std::string& name) {
    throw InputError(name + ": " + kNoLevelSets);
}

}  // namespace meniscus

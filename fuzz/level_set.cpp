// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Level-set files. Their last four bytes are a checksum, which is made right, so that what stands before is looked at.
#include <zlib.h>

#include <cmath>
#include <cstring>

#include "fuzzed_file.h"
#include "grid/block_grid.h"
#include "meniscus/level_set_file.h"

namespace {

using namespace meniscus;

std::string with_right_checksum(std::string_view bytes) {
    std::string file(bytes);
    if (file.size() < sizeof(std::uint32_t)) return file;
    const std::size_t end = file.size() - sizeof(std::uint32_t);
    const auto* begin = reinterpret_cast<const Bytef*>(file.data());  // zlib's form of bytes
    const auto sum = static_cast<std::uint32_t>(::crc32(0, begin, static_cast<uInt>(end)));
    std::memcpy(file.data() + end, &sum, sizeof sum);
    return file;
}

void read(const std::string& path) {
    const LevelSet level_set = read_level_set(path);
    for (const Vec3& point : {Vec3{0, 0, 0}, level_set.grid().origin(), Vec3{1e300, 0, 0}}) level_set.value(point);
    level_set.intersect({0, 0, 0}, {0.6, 0.0, 0.8});
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::FuzzedFile file("a.mls");
    const std::string_view bytes = fuzz::text_of(data, size);
    file.write(bytes);
    fuzz::read_or_refuse(file.path(), [] { read(file.path()); });
    file.write(with_right_checksum(bytes));
    fuzz::read_or_refuse(file.path(), [] { read(file.path()); });
    return 0;
}

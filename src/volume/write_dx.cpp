// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <string_view>

#include "core/bits.h"
#include "platform/files/atomic_file.h"
#include "platform/files/digits.h"
#include "volume/writers.h"

namespace meniscus {
namespace {

constexpr std::size_t kPerLine = 3;  // VMD reads no more

// Line by line as APBS has it, whose reader and others know no other.
std::string header(const VolumeGrid& grid, VolumeContent content) {
    std::string text;
    for (const std::string& line : header_lines(content)) text += fmt::format("# {}\n", line);
    const std::string counts = fmt::format("{} {} {}", grid.counts[0], grid.counts[1], grid.counts[2]);
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "object 1 class gridpositions counts {}\n", counts);
    fmt::format_to(out, "origin {} {} {}\n", grid.origin.x, grid.origin.y, grid.origin.z);
    fmt::format_to(out, "delta {} 0 0\ndelta 0 {} 0\ndelta 0 0 {}\n", grid.spacing.x, grid.spacing.y, grid.spacing.z);
    fmt::format_to(out, "object 2 class gridconnections counts {}\n", counts);
    fmt::format_to(out, "object 3 class array type double rank 0 items {} data follows\n", grid.size());
    return text;
}

// Fields of two values repeat them.
class RepeatedNumber {
public:
    std::string_view text(float value) {
        const auto bits = bit_cast<std::uint32_t>(value);
        if (text_.empty() || bits != bits_) text_ = digits_of(value, digits_);
        bits_ = bits;
        return text_;
    }

private:
    Digits digits_{};
    std::string_view text_;
    std::uint32_t bits_ = 0;
};

constexpr const char* kFooter =
    "attribute \"dep\" string \"positions\"\n"
    "object \"regular positions regular connections\" class field\n"
    "component \"positions\" value 1\n"
    "component \"connections\" value 2\n"
    "component \"data\" value 3\n";

}  // namespace

void write_dx(const std::string& path, const Volume& volume, VolumeContent content) {
    AtomicFile file(path);
    file.write(header(volume.grid, content));
    RepeatedNumber number;
    for (std::size_t i = 0; i < volume.values.size(); ++i) {
        file.write(number.text(volume.values[i]));
        file.write(i % kPerLine == kPerLine - 1 || i + 1 == volume.values.size() ? '\n' : ' ');
    }
    file.write(kFooter);
    file.commit();
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/zip_writer.h"

#include <bit>
#include <utility>

#include "io/deflate.h"

namespace meniscus {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are written as the numbers are in memory");

constexpr std::uint16_t kZipVersion = 20;  // that a reader must know: deflate
constexpr std::uint16_t kZip64Version = 45;
constexpr std::uint16_t kMadeBy = (3U << 8U) | kZip64Version;  // Unix, whose permissions follow
constexpr std::uint32_t kPermissions = 0600U << 16U;
constexpr std::uint16_t kDeflate = 8;
constexpr std::uint32_t kEarliest = 0x0021U << 16U;  // 1980-01-01 00:00
constexpr std::uint16_t kZip64Field = 1;
constexpr std::uint32_t kInZip64 = 0xffffffffU;  // stands for a number that is told in 64 bits elsewhere

template <class... Numbers>
std::string bytes_of(const Numbers&... numbers) {
    std::string bytes;
    (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
    return bytes;
}

std::uint16_t word(std::size_t size) { return static_cast<std::uint16_t>(size); }

}  // namespace

// Sizes that ZIP64 tells are told there all together.
std::string ZipWriter::header_of(const Entry& entry) const {
    const bool large = is_large(entry.size) || is_large(entry.compressed_size);
    const auto shown = [large](std::uint64_t value) { return large ? kInZip64 : static_cast<std::uint32_t>(value); };
    const std::string extra =
        large ? bytes_of(kZip64Field, word(2 * sizeof(std::uint64_t)), entry.size, entry.compressed_size) : "";
    return bytes_of(std::uint32_t{0x04034b50}, large ? kZip64Version : kZipVersion, std::uint16_t{0}, kDeflate,
                    kEarliest, entry.checksum, shown(entry.compressed_size), shown(entry.size), word(entry.name.size()),
                    word(extra.size())) +
           entry.name + extra;
}

std::string ZipWriter::directory_entry(const Entry& entry) const {
    const bool large = is_large(entry.size) || is_large(entry.compressed_size) || is_large(entry.offset);
    const auto shown = [large](std::uint64_t value) { return large ? kInZip64 : static_cast<std::uint32_t>(value); };
    const std::string extra =
        large ? bytes_of(kZip64Field, word(3 * sizeof(std::uint64_t)), entry.size, entry.compressed_size, entry.offset)
              : "";
    constexpr std::uint16_t kNothing = 0;  // length of a comment, number of the disk, internal attributes
    return bytes_of(std::uint32_t{0x02014b50}, kMadeBy, large ? kZip64Version : kZipVersion, kNothing, kDeflate,
                    kEarliest, entry.checksum, shown(entry.compressed_size), shown(entry.size), word(entry.name.size()),
                    word(extra.size()), kNothing, kNothing, kNothing, kPermissions, shown(entry.offset)) +
           entry.name + extra;
}

std::string ZipWriter::end_of_directory(std::uint64_t start, std::uint64_t size) const {
    constexpr std::uint32_t kDisk = 0;
    const std::uint64_t count = entries_.size();
    const bool large = is_large(start) || is_large(size);
    std::string end;
    if (large) {
        constexpr std::uint64_t kRest = 44;  // bytes of this record that follow
        end =
            bytes_of(std::uint32_t{0x06064b50}, kRest, kMadeBy, kZip64Version, kDisk, kDisk, count, count, size, start);
        end += bytes_of(std::uint32_t{0x07064b50}, kDisk, start + size, std::uint32_t{1});
    }
    const auto shown = [large](std::uint64_t value) { return large ? kInZip64 : static_cast<std::uint32_t>(value); };
    return end + bytes_of(std::uint32_t{0x06054b50}, kDisk, word(count), word(count), shown(size), shown(start),
                          std::uint16_t{0});
}

void ZipWriter::write(std::string_view bytes) {
    file_.write(bytes);
    offset_ += bytes.size();
}

void ZipWriter::add(std::string name, std::span<const std::string_view> parts) {
    const Deflated content = deflated(parts);
    entries_.push_back({.name = std::move(name),
                        .checksum = content.checksum,
                        .compressed_size = content.compressed_size(),
                        .size = content.size,
                        .offset = offset_});
    write(header_of(entries_.back()));
    for (const std::string& piece : content.pieces) write(piece);
}

void ZipWriter::finish() {
    const std::uint64_t start = offset_;
    for (const Entry& entry : entries_) write(directory_entry(entry));
    write(end_of_directory(start, offset_ - start));
}

}  // namespace meniscus

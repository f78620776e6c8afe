// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/level_set_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <istream>
#include <limits>
#include <memory>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "grid/block_grid.h"
#include "meniscus/errors.h"
#include "platform/files/atomic_file.h"

namespace meniscus {
namespace {

static_assert(std::endian::native == std::endian::little, "files are written and read as numbers are in memory");

// Not text, and changed by programs that change the ends of lines.
constexpr std::array<char, 8> kMagic{'\x8d', 'M', 'L', 'S', '\r', '\n', '\x1a', '\n'};
constexpr std::uint32_t kFormatVersion = 1;
constexpr std::uint32_t kByteOrder = 0x01020304;  // reads as 0x04030201 where the file is of the other byte order
constexpr std::int32_t kFarthestBlock = 1 << 30;  // so that a block's neighbours can be counted too
constexpr double kFarthest = 1e9;  // Å, of the origin; also the largest spacing, and one by the smallest:
                                   // so that every place in the grid is a number of spacings that fits

struct Header {
    std::array<char, 8> magic = kMagic;
    std::uint32_t version = kFormatVersion;
    std::uint32_t byte_order = kByteOrder;
    std::uint32_t block_edge = kBlockEdge;
    std::uint32_t reserved = 0;
    std::uint64_t blocks = 0;
    double spacing = 0.0;
    std::array<double, 3> origin{};
};
static_assert(sizeof(Header) == 64 && std::is_trivially_copyable_v<Header>);

// As in the file: x, y, z.
using StoredBlock = std::array<std::int32_t, 3>;

constexpr std::uint64_t kBytesPerBlock = sizeof(StoredBlock) + sizeof(float) * kBlockNodes;
constexpr std::uint64_t kBytesAround = sizeof(Header) + sizeof(std::uint32_t);

// CRC-32 as in gzip and PNG.
class Checksum {
public:
    void add(const void* data, std::size_t size) {
        for (const auto* next = static_cast<const Bytef*>(data); size > 0;) {
            const auto part = static_cast<uInt>(std::min<std::size_t>(size, 1U << 30U));
            sum_ = ::crc32(sum_, next, part);
            next += part;
            size -= part;
        }
    }
    std::uint32_t value() const { return static_cast<std::uint32_t>(sum_); }

private:
    uLong sum_ = 0;
};

/// Where the bytes of a level set go.
using Sink = std::function<void(std::string_view)>;

class Writer {
public:
    explicit Writer(Sink sink) : sink_(std::move(sink)) {}

    void write(const void* data, std::size_t size) {
        if (size == 0) return;
        checksum_.add(data, size);
        sink_({static_cast<const char*>(data), size});
    }

    void finish() {
        const std::uint32_t sum = checksum_.value();
        sink_({reinterpret_cast<const char*>(&sum), sizeof sum});
    }

private:
    Sink sink_;
    Checksum checksum_;
};

void write_to(Writer writer, const LevelSet& level_set) {
    const BlockGrid& grid = level_set.grid();
    Header header;
    header.blocks = grid.block_count();
    header.spacing = grid.spacing();
    header.origin = {grid.origin().x, grid.origin().y, grid.origin().z};
    writer.write(&header, sizeof header);
    for (const BlockCoord& c : grid.coords()) {
        const StoredBlock block{c.x, c.y, c.z};
        writer.write(block.data(), sizeof block);
    }
    writer.write(level_set.coefficients().data(), level_set.coefficients().size_bytes());
    writer.finish();
}

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw InputError(name + ": " + what + "; write the level set again");
}

class Reader {
public:
    /// size   of what the stream holds, bytes
    Reader(std::string name, std::istream& stream, std::uint64_t size)
        : name_(std::move(name)), stream_(stream), size_(size) {}

    LevelSet read() {
        const Header header = read_header();
        std::vector<StoredBlock> stored(header.blocks);
        take(stored.data(), stored.size() * sizeof(StoredBlock));
        NodeField coefficients(header.blocks * kBlockNodes);
        take(coefficients.data(), coefficients.size() * sizeof(float));
        check_sum();
        auto grid = std::make_shared<const BlockGrid>(
            header.spacing, Vec3{header.origin[0], header.origin[1], header.origin[2]}, blocks_from(stored));
        return {std::move(grid), std::move(coefficients)};
    }

private:
    Header read_header() {
        Header header;
        if (size_ < sizeof header.magic) fail("is not a level-set file");
        take(&header, std::min<std::size_t>(size_, sizeof header));
        if (header.magic != kMagic) fail("is not a level-set file");
        if (size_ < kBytesAround) fail("is cut off");
        if (header.byte_order != kByteOrder) fail("was written in another byte order, which is not supported");
        if (header.version != kFormatVersion)
            fail("has version " + std::to_string(header.version) + " of the format, not 1");
        if (header.block_edge != kBlockEdge) fail("has blocks of another size than 8");
        if (header.blocks > (size_ - kBytesAround) / kBytesPerBlock) fail("is cut off");
        if (header.blocks * kBytesPerBlock != size_ - kBytesAround) fail("is longer than its header says");
        if (!(header.spacing >= 1.0 / kFarthest && header.spacing <= kFarthest))
            fail("has a spacing that is not between 1e-9 and 1e9 Å");
        if (!std::all_of(header.origin.begin(), header.origin.end(), [](double x) { return std::abs(x) <= kFarthest; }))
            fail("has an origin that is farther away than 1e9 Å");
        return header;
    }

    void take(void* data, std::size_t size) {
        if (size == 0) return;
        stream_.read(static_cast<char*>(data), static_cast<std::streamsize>(size));
        if (!stream_) fail("cannot be read to its end");
        checksum_.add(data, size);
    }

    void check_sum() {
        const std::uint32_t expected = checksum_.value();
        std::uint32_t stored = 0;
        take(&stored, sizeof stored);
        if (stored != expected) fail("has been changed or damaged: its checksum does not match");
    }

    // The grid sorts its blocks; coefficients are in that order only if the file's are.
    std::vector<BlockCoord> blocks_from(const std::vector<StoredBlock>& stored) const {
        std::vector<BlockCoord> blocks;
        blocks.reserve(stored.size());
        for (const auto& [x, y, z] : stored) {
            for (const std::int32_t c : {x, y, z})
                if (c < -kFarthestBlock || c > kFarthestBlock) fail("has a block that is too far away");
            blocks.push_back({.z = z, .y = y, .x = x});
            if (blocks.size() > 1 && !(blocks[blocks.size() - 2] < blocks.back())) fail("has blocks out of order");
        }
        return blocks;
    }

    [[noreturn]] void fail(const std::string& what) const { refuse(name_, what); }

    std::string name_;
    std::istream& stream_;
    std::uint64_t size_ = 0;
    Checksum checksum_;
};

}  // namespace

void write_level_set(const std::string& path, const LevelSet& level_set) {
    AtomicFile file(path);
    write_to(Writer([&file](std::string_view bytes) { file.write(bytes); }), level_set);
    file.commit();
}

LevelSet read_level_set(const std::string& path) {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (error) refuse(path, "cannot be read: " + error.message());
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(path, "cannot be read");
    return Reader(path, file, size).read();
}

std::string level_set_bytes(const LevelSet& level_set) {
    std::string all;
    write_to(Writer([&all](std::string_view bytes) { all += bytes; }), level_set);
    return all;
}

LevelSet level_set_from_bytes(std::string_view bytes, const std::string& name) {
    std::istringstream stream{std::string(bytes), std::ios::binary};
    return Reader(name, stream, bytes.size()).read();
}

}  // namespace meniscus

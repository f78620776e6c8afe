// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/gunzip.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "meniscus/errors.h"
#include "platform/memory.h"
#include "reading/read_bytes.h"

namespace meniscus::reading {
namespace {

// Far above any structure (the largest of the PDB have about 1 GB) and below what would exhaust a machine.
constexpr std::size_t kLargestContent = std::size_t{8} << 30U;
// Text of structures shrinks to a tenth, rarely to a fiftieth. What grows a thousandfold was made to fill the memory.
constexpr std::size_t kSuspicious = std::size_t{256} << 20U;
constexpr std::size_t kMostGrowth = 200;
constexpr int kGzipWindow = 15 + 16;  // largest window, gzip header (zlib.h, inflateInit2)

// A zlib stream that is closed on every way out.
class Inflater {
public:
    explicit Inflater(std::string_view bytes) : bytes_(bytes), rest_(bytes) {
        if (inflateInit2(&stream_, kGzipWindow) != Z_OK) throw std::bad_alloc();
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    // Decompresses what fits into `buffer`; returns zlib's code and appends the result to `content`.
    int step(std::string& content) {
        feed();
        stream_.next_out = buffer_.data();
        stream_.avail_out = static_cast<uInt>(buffer_.size());
        const int code = inflate(&stream_, Z_NO_FLUSH);
        content.append(reinterpret_cast<const char*>(buffer_.data()), buffer_.size() - stream_.avail_out);
        return code;
    }

    /// Bytes of input used so far.
    std::size_t taken() const { return bytes_.size() - rest_.size() - stream_.avail_in; }

    // After the end of a member: begins the next one; false if there is none. Archives and tapes fill their blocks with
    // zero bytes, which are ignored; anything else is a damaged member, whose content would be missing.
    bool next_member(const std::string& file) {
        const std::size_t next = std::min(bytes_.find_first_not_of('\0', taken()), bytes_.size());
        rest_ = bytes_.substr(next);
        stream_.avail_in = 0;
        if (rest_.empty()) return false;
        if (is_gzip(rest_)) return inflateReset(&stream_) == Z_OK;
        throw InputError(file + ": byte " + std::to_string(next + 1) +
                         ": what follows here is not gzip data; the file is damaged, fetch it again");
    }

private:
    void feed() {
        if (stream_.avail_in > 0 || rest_.empty()) return;
        const std::size_t size = std::min<std::size_t>(rest_.size(), std::numeric_limits<uInt>::max());
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest_.data()));  // zlib does not write to it
        stream_.avail_in = static_cast<uInt>(size);
        rest_.remove_prefix(size);
    }

    z_stream stream_{};
    std::string_view bytes_;
    std::string_view rest_;  // of the bytes, behind what zlib has been given
    std::array<Bytef, std::size_t{1} << 16U> buffer_{};
};

// The size that the last member says its content has, where that is plausible; else nothing is foreseen.
std::size_t likely_size(std::string_view bytes) {
    std::uint32_t size = 0;  // the last four bytes, the lowest first
    if (bytes.size() < sizeof size) return 0;
    for (std::size_t i = 0; i < sizeof size; ++i)
        size |= std::uint32_t{static_cast<unsigned char>(bytes[bytes.size() - sizeof size + i])} << (8 * i);
    return size <= kSuspicious && size / kMostGrowth <= bytes.size() ? size : 0;
}

}  // namespace

std::string gunzip(std::string_view bytes, const std::string& file) {
    std::string content;
    content.reserve(likely_size(bytes));
    Inflater inflater(bytes);
    const std::size_t room = available_memory() / kMemoryPerText;
    while (true) {
        const int code = inflater.step(content);
        if (content.size() > kLargestContent) {
            throw LimitError(file + ": more than 8 GiB when decompressed; decompress it and pass a part of it");
        }
        if (content.size() > kSuspicious && content.size() / kMostGrowth > inflater.taken()) {
            throw LimitError(file + ": grows more than " + std::to_string(kMostGrowth) +
                             " times when decompressed; no structure does, check where it comes from");
        }
        if (content.size() > kSuspicious && content.size() > room) {
            throw LimitError(file + ": too large for the memory when decompressed; pass a part of it");
        }
        if (code == Z_STREAM_END && !inflater.next_member(file)) return content;
        if (code == Z_BUF_ERROR) {
            throw InputError(file + ": the gzip data end too early; the file is cut off, fetch it again");
        }
        if (code != Z_OK && code != Z_STREAM_END) {
            throw InputError(file + ": the gzip data are damaged; fetch the file again");
        }
    }
}

}  // namespace meniscus::reading

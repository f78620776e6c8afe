// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the readers of all formats share: where they are in a file, and triangles from corners.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "meniscus/mesh.h"

namespace meniscus::reading {

/// A file in memory, decompressed.
struct MeshFile {
    std::string path;
    std::string bytes;
};

/// throws   InputError if it cannot be read
MeshFile load_mesh_file(const std::string& path);

/// throws   InputError "FILE:byte N: message"
[[noreturn]] void fail_at_byte(const std::string& file, std::size_t byte, const std::string& message);

/// Adds a polygon as a fan of triangles round its first corner.
void add_polygon(Mesh& mesh, std::span<const VertexId> corners);

/// throws   LimitError for more vertices than numbers for them
void check_vertex_count(const std::string& file, std::uint64_t count);

/// Walks through the words of a text, over the ends of lines and over comments, which begin with '#'.
class TextCursor {
public:
    TextCursor(const std::string& file, std::string_view text, std::size_t begin = 0)
        : file_(file), text_(text), position_(std::min(begin, text.size())), word_begin_(position_) {}

    /// The next word; empty at the end of the text.
    std::string_view next();
    /// The next word, which must be there.
    std::string_view word(const char* what);
    double number(const char* what);
    Vec3 point();
    std::uint64_t count(const char* what);
    /// The number, from 0, of a vertex, of which there are `vertices`.
    VertexId corner(std::size_t vertices);
    /// The words left on the line are passed over.
    void skip_line();

    const std::string& file() const { return file_; }
    std::size_t bytes_left() const { return text_.size() - position_; }
    /// Fails at the last word.
    [[noreturn]] void fail(const std::string& message) const;

private:
    const std::string& file_;
    std::string_view text_;
    std::size_t position_;
    std::size_t word_begin_;
};

/// Walks through the numbers of a binary file.
class BinaryCursor {
public:
    BinaryCursor(const std::string& file, std::string_view bytes, std::size_t begin = 0,
                 std::endian order = std::endian::little)
        : file_(file), bytes_(bytes), position_(std::min(begin, bytes.size())), order_(order) {}

    template <class T>
    T take(const char* what) {
        if (bytes_left() < sizeof(T)) fail(std::string("the file ends where ") + what + " should be; fetch it again");
        char raw[sizeof(T)];
        for (std::size_t i = 0; i < sizeof(T); ++i)
            raw[order_ == std::endian::native ? i : sizeof(T) - 1 - i] = bytes_[position_ + i];
        T value;
        std::memcpy(&value, raw, sizeof(T));
        position_ += sizeof(T);
        return value;
    }
    void skip(std::uint64_t size, const char* what);

    std::size_t position() const { return position_; }
    std::size_t bytes_left() const { return bytes_.size() - position_; }
    [[noreturn]] void fail(const std::string& message) const { fail_at_byte(file_, position_, message); }

private:
    const std::string& file_;
    std::string_view bytes_;
    std::size_t position_;
    std::endian order_;
};

}  // namespace meniscus::reading

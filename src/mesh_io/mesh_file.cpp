// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meniscus/errors.h"
#include "reading/numbers.h"
#include "reading/read_bytes.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

constexpr std::string_view kBlank = " \t\v\f\r\n";

Place place_of(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    const std::size_t line_end = before.find_last_of('\n');
    return {line, line_end == std::string_view::npos ? offset + 1 : offset - line_end};
}

}  // namespace

MeshFile load_mesh_file(const std::string& path) { return {path, read_unzipped(path, "mesh")}; }

void fail_at_byte(const std::string& file, std::size_t byte, const std::string& message) {
    throw InputError(file + ":byte " + std::to_string(byte) + ": " + message);
}

void add_polygon(Mesh& mesh, std::span<const VertexId> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

void check_vertex_count(const std::string& file, std::uint64_t count) {
    if (count > std::numeric_limits<VertexId>::max())
        throw LimitError(file + ": more than 2^32 - 1 vertices; cut the mesh into parts");
}

std::string_view TextCursor::next() {
    while (true) {
        position_ = std::min(text_.find_first_not_of(kBlank, position_), text_.size());
        if (position_ == text_.size() || text_[position_] != '#') break;
        skip_line();
    }
    word_begin_ = position_;
    position_ = std::min(text_.find_first_of(kBlank, position_), text_.size());
    return text_.substr(word_begin_, position_ - word_begin_);
}

std::string_view TextCursor::word(const char* what) {
    const std::string_view found = next();
    if (found.empty()) fail(std::string("the file ends where ") + what + " should be; fetch or write it again");
    return found;
}

double TextCursor::number(const char* what) {
    const std::string_view found = word(what);
    const auto value = finite_number(found);
    if (!value) fail(std::string(what) + ": " + shown(found) + " is not a finite number; correct it");
    return *value;
}

Vec3 TextCursor::point() {
    const double x = number("an x coordinate");
    const double y = number("a y coordinate");
    return {x, y, number("a z coordinate")};
}

std::uint64_t TextCursor::count(const char* what) {
    const std::string_view found = word(what);
    const auto value = whole_number<std::uint64_t>(found);
    if (!value) fail(std::string(what) + ": " + shown(found) + " is not a whole number of at least 0; correct it");
    return *value;
}

VertexId TextCursor::corner(std::size_t vertices) {
    const std::uint64_t number = count("a corner");
    if (number >= vertices)
        fail("a corner names vertex " + std::to_string(number) + ", but the last one is " + std::to_string(vertices) +
             " - 1; correct it");
    return static_cast<VertexId>(number);
}

void TextCursor::skip_line() { position_ = std::min(text_.find('\n', position_), text_.size()); }

void TextCursor::fail(const std::string& message) const { fail_at(file_, place_of(text_, word_begin_), message); }

void BinaryCursor::skip(std::uint64_t size, const char* what) {
    if (size > bytes_left()) fail(std::string("the file ends within ") + what + "; fetch it again");
    position_ += size;
}

}  // namespace meniscus::reading

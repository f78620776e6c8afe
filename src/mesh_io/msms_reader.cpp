// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/msms_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reading/numbers.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

constexpr std::size_t kHeaderWords = 4;      // how many, spheres, density, probe radius
constexpr std::size_t kNanoShaperWords = 1;  // how many
constexpr std::size_t kLeastVertexWords = 6;
constexpr std::size_t kLeastFaceWords = 3;

// The lines of one of the files that are neither comments nor the counts of the header, as words.
class MsmsLines {
public:
    MsmsLines(const MeshFile& file, const char* what, std::size_t least)
        : file_(file), lines_(file.bytes), what_(what), least_(least) {}

    // Moves to the next line of numbers; false at the end, where as many must have been as the header says.
    bool next() {
        while (lines_.next()) {
            split();
            if (words_.empty() || words_[0].starts_with('#')) continue;
            const bool may_count = words_.size() == kHeaderWords || words_.size() == kNanoShaperWords;
            if (read_++ == 0 && !expected_ && may_count) {
                expected_ = count(0);
                read_ = 0;
                continue;
            }
            if (words_.size() < least_)
                fail(words_.size(), std::string("a ") + what_ + " has at least " + std::to_string(least_) +
                                        " words; the line ends too early");
            return true;
        }
        if (expected_ && *expected_ != read_)
            throw InputError(file_.path + ": the header says " + std::to_string(*expected_) + ", but there are " +
                             std::to_string(read_) + " (a " + what_ + " a line); fetch or write the file again");
        return false;
    }

    double number(std::size_t i) const {
        const auto value = finite_number(words_[i]);
        if (!value) fail(i, shown(words_[i]) + " is not a finite number; correct it");
        return *value;
    }

    std::uint64_t count(std::size_t i) const {
        const auto value = whole_number<std::uint64_t>(words_[i]);
        if (!value) fail(i, shown(words_[i]) + " is not a whole number of at least 0; correct it");
        return *value;
    }

    [[noreturn]] void fail(std::size_t i, const std::string& message) const {
        fail_at(file_.path, {lines_.number(), i < columns_.size() ? columns_[i] : lines_.line().size() + 1}, message);
    }

private:
    void split() {
        words_.clear();
        columns_.clear();
        std::string_view line = lines_.line();
        if (line.ends_with('\r')) line.remove_suffix(1);
        Words words(line);
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            words_.push_back(word);
            columns_.push_back(words.column());
        }
    }

    const MeshFile& file_;
    Lines lines_;
    const char* what_;
    std::size_t least_;
    std::vector<std::string_view> words_;
    std::vector<std::size_t> columns_;
    std::optional<std::uint64_t> expected_;
    std::uint64_t read_ = 0;
};

}  // namespace

Mesh read_msms(const MeshFile& vertices, const MeshFile& faces) {
    Mesh mesh;
    MsmsLines points(vertices, "vertex", kLeastVertexWords);
    while (points.next()) mesh.vertices.push_back({points.number(0), points.number(1), points.number(2)});
    check_vertex_count(vertices.path, mesh.vertices.size());
    MsmsLines corners(faces, "face", kLeastFaceWords);
    while (corners.next()) {
        Triangle triangle;
        for (std::size_t i = 0; i < triangle.size(); ++i) {
            const std::uint64_t number = corners.count(i);
            if (number < 1 || number > mesh.vertices.size())
                corners.fail(i, "a corner names vertex " + std::to_string(number) + " of " +
                                    std::to_string(mesh.vertices.size()) + "; do both files belong together?");
            triangle[i] = static_cast<VertexId>(number - 1);
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

}  // namespace meniscus::reading

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/obj_reader.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "reading/numbers.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

// Names, materials and what is no surface of triangles but may stand beside one.
constexpr std::array<std::string_view, 20> kPassedOver{
    "vt",     "vn",  "vp",    "g",        "o",        "s", "mg", "usemtl", "mtllib",    "usemap",
    "maplib", "lod", "bevel", "c_interp", "d_interp", "l", "p",  "call",   "trace_obj", "shadow_obj"};

class ObjReader {
public:
    explicit ObjReader(const MeshFile& file) : file_(file), lines_(file.bytes) {}

    Mesh read() {
        while (lines_.next()) {
            std::string_view line = lines_.line().substr(0, lines_.line().find('#'));
            if (line.ends_with('\r')) line.remove_suffix(1);
            Words words(line);
            read_line(words);
        }
        return std::move(mesh_);
    }

private:
    void read_line(Words& words) {
        const std::string_view keyword = words.next();
        if (keyword == "v") return read_vertex(words);
        if (keyword == "f") return read_face(words);
        if (!keyword.empty() && std::find(kPassedOver.begin(), kPassedOver.end(), keyword) == kPassedOver.end())
            fail(words, shown(keyword) + " is not a keyword of a mesh in OBJ; is this an OBJ file?");
    }

    void read_vertex(Words& words) {
        check_vertex_count(file_.path, mesh_.vertices.size() + 1);
        const double x = coordinate(words);
        const double y = coordinate(words);
        mesh_.vertices.push_back({x, y, coordinate(words)});
    }

    double coordinate(Words& words) {
        const std::string_view word = words.next();
        const auto value = finite_number(word);
        if (!value) fail(words, "coordinate " + shown(word) + " is not a finite number; correct it");
        return *value;
    }

    void read_face(Words& words) {
        corners_.clear();
        for (std::string_view word = words.next(); !word.empty(); word = words.next())
            corners_.push_back(corner(words, word));
        if (corners_.size() < 3) fail(words, "a face with fewer than three corners; leave it out");
        add_polygon(mesh_, corners_);
    }

    // "7", "7/1", "7//3", "7/1/3", "-1".
    VertexId corner(const Words& words, std::string_view word) {
        const auto number = whole_number<std::int64_t>(word.substr(0, word.find('/')));
        if (!number || *number == 0)
            fail(words, "corner " + shown(word) + " is not the number of a vertex; correct it");
        const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
        if (*number > count || *number < -count)
            fail(words, "corner " + shown(word) + " names a vertex that is not among the " + std::to_string(count) +
                            " before it; correct it");
        return static_cast<VertexId>(*number > 0 ? *number - 1 : count + *number);
    }

    [[noreturn]] void fail(const Words& words, const std::string& message) const {
        fail_at(file_.path, {lines_.number(), words.column()}, message);
    }

    const MeshFile& file_;
    Lines lines_;
    Mesh mesh_;
    std::vector<VertexId> corners_;
};

}  // namespace

Mesh read_obj(const MeshFile& file) { return ObjReader(file).read(); }

}  // namespace meniscus::reading

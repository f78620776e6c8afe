// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/glb_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "meniscus/errors.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

using nlohmann::json;

// Numbers of the specification.
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::uint64_t kUnsignedByte = 5121;
constexpr std::uint64_t kUnsignedShort = 5123;
constexpr std::uint64_t kUnsignedInt = 5125;
constexpr std::uint64_t kFloat = 5126;
constexpr std::uint64_t kTriangles = 4;

// 4 x 4, column by column.
using Matrix = std::array<double, 16>;
constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    return c;
}

Vec3 column(const Matrix& m, std::size_t c) { return {m[4 * c], m[4 * c + 1], m[4 * c + 2]}; }

Vec3 moved(const Matrix& m, const Vec3& p) {
    return p.x * column(m, 0) + p.y * column(m, 1) + p.z * column(m, 2) + column(m, 3);
}

bool is_mirror(const Matrix& m) { return dot(column(m, 0), cross(column(m, 1), column(m, 2))) < 0.0; }

// Translation * rotation * scale, as nodes have them.
Matrix matrix_of(const std::array<double, 3>& t, const std::array<double, 4>& q, const std::array<double, 3>& s) {
    const auto& [x, y, z, w] = q;
    return {s[0] * (1 - 2 * (y * y + z * z)),
            s[0] * 2 * (x * y + z * w),
            s[0] * 2 * (x * z - y * w),
            0,
            s[1] * 2 * (x * y - z * w),
            s[1] * (1 - 2 * (x * x + z * z)),
            s[1] * 2 * (y * z + x * w),
            0,
            s[2] * 2 * (x * z + y * w),
            s[2] * 2 * (y * z - x * w),
            s[2] * (1 - 2 * (x * x + y * y)),
            0,
            t[0],
            t[1],
            t[2],
            1};
}

// Where the values of an accessor are.
struct Values {
    std::uint64_t begin = 0;  // in the binary chunk
    std::uint64_t stride = 0;
    std::uint64_t count = 0;
    std::uint64_t type = 0;
};

class GlbReader {
public:
    explicit GlbReader(const MeshFile& file) : file_(file) {}

    Mesh read() {
        read_chunks();
        try {
            check_extensions();
            add_scene();
        } catch (const json::exception& error) {
            fail(std::string("its JSON is not valid glTF (") + printable(error.what()) + ")");
        }
        return std::move(mesh_);
    }

private:
    void read_chunks() {
        BinaryCursor cursor(file_.path, file_.bytes);
        if (cursor.take<std::uint32_t>("the header") != kMagic)
            fail_at_byte(file_.path, 0, "the file does not begin with glTF; give it the suffix of its format");
        if (cursor.take<std::uint32_t>("the version") != 2) cursor.fail("only version 2 is read; convert the file");
        if (cursor.take<std::uint32_t>("the size") > file_.bytes.size())
            cursor.fail("the file is shorter than its header says; fetch it again");
        while (cursor.bytes_left() > 0) read_chunk(cursor);
        if (!has_json_) cursor.fail("there is no JSON in the file; fetch it again");
    }

    void read_chunk(BinaryCursor& cursor) {
        const std::uint64_t size = cursor.take<std::uint32_t>("the size of a chunk");
        const auto kind = cursor.take<std::uint32_t>("the kind of a chunk");
        const std::string_view bytes =
            std::string_view(file_.bytes).substr(cursor.position(), std::min<std::uint64_t>(size, cursor.bytes_left()));
        const std::size_t begin = cursor.position();
        cursor.skip(size, "a chunk");
        if (kind == kJsonChunk && !has_json_) parse(bytes, begin);
        if (kind == kBinaryChunk) {
            binary_ = bytes;
            binary_begin_ = begin;
        }
    }

    void parse(std::string_view text, std::size_t begin) {
        try {
            json_ = json::parse(text);
        } catch (const json::parse_error& error) {
            fail_at_byte(file_.path, begin + error.byte, "the JSON cannot be read; write the file again");
        } catch (const json::out_of_range&) {
            fail_at_byte(file_.path, begin, "the JSON holds a number beyond 1e308; write the file again");
        }
        has_json_ = true;
    }

    void check_extensions() const {
        if (const auto needed = json_.find("extensionsRequired"); needed != json_.end() && !needed->empty())
            fail("it needs the extension " + shown(needed->at(0).get<std::string>()) + ", which is not supported");
    }

    void add_scene() {
        if (!json_.contains("scenes")) return add_all_meshes();
        const json& scene = json_.at("scenes").at(json_.contains("scene") ? number_in(json_.at("scene")) : 0);
        visited_.assign(list("nodes").size(), false);
        if (!scene.contains("nodes")) return;
        for (const json& root : scene.at("nodes")) add_tree(number_in(root));
    }

    void add_all_meshes() {
        for (const json& mesh : list("meshes")) add_mesh(mesh, kIdentity);
    }

    const json& list(const char* name) const {
        static const json kEmpty = json::array();
        return json_.contains(name) ? json_.at(name) : kEmpty;
    }

    // Nodes make trees, so every one is met once; what is still to do is kept here, for files may nest deeply.
    void add_tree(std::size_t root) {
        struct Step {
            std::size_t node;
            Matrix parent;
        };
        std::vector<Step> steps{{root, kIdentity}};
        while (!steps.empty()) {
            const auto [number, parent] = steps.back();
            steps.pop_back();
            const json& node = list("nodes").at(number);
            if (visited_.at(number)) fail("a node has two parents or is its own");
            visited_[number] = true;
            const Matrix whole = product(parent, transformation(node));
            if (node.contains("mesh")) add_mesh(list("meshes").at(number_in(node.at("mesh"))), whole);
            if (!node.contains("children")) continue;
            for (const json& child : node.at("children"))
                steps.push_back({static_cast<std::size_t>(number_in(child)), whole});
        }
    }

    static Matrix transformation(const json& node) {
        if (node.contains("matrix")) return node.at("matrix").get<Matrix>();
        return matrix_of(node.value("translation", std::array<double, 3>{0, 0, 0}),
                         node.value("rotation", std::array<double, 4>{0, 0, 0, 1}),
                         node.value("scale", std::array<double, 3>{1, 1, 1}));
    }

    void add_mesh(const json& mesh, const Matrix& transform) {
        for (const json& primitive : mesh.at("primitives")) {
            if (primitive.contains("mode") && number_in(primitive.at("mode")) != kTriangles)
                fail("it has points, lines, strips or fans; write it again with separate triangles");
            add_primitive(primitive, transform);
        }
    }

    void add_primitive(const json& primitive, const Matrix& transform) {
        const Values places = values_of(number_in(primitive.at("attributes").at("POSITION")), "VEC3");
        if (places.type != kFloat) fail("positions are not of type float");
        const std::size_t first = mesh_.vertices.size();
        check_vertex_count(file_.path, first + places.count);
        check_repeats(first + places.count);
        mesh_.vertices.reserve(first + places.count);
        for (std::uint64_t v = 0; v < places.count; ++v)
            mesh_.vertices.push_back(moved(transform, position(places.begin + v * places.stride)));
        const bool turned = is_mirror(transform);
        if (!primitive.contains("indices")) return add_triangles(first, places.count, turned);
        const Values corners = values_of(number_in(primitive.at("indices")), "SCALAR");
        if (corners.type == kFloat) fail("indices are not whole numbers");
        check_repeats(mesh_.triangles.size() + corners.count / 3);
        if (corners.count % 3 != 0) fail("the number of indices is not a multiple of three");
        for (std::uint64_t i = 0; i < corners.count; i += 3) {
            std::array<std::uint64_t, 3> t{};
            for (std::size_t k = 0; k < t.size(); ++k) t[k] = index(corners, i + k, places.count);
            add_triangle(first, t, turned);
        }
    }

    // Nodes may show a mesh many times, but a small file may not fill the memory.
    void check_repeats(std::uint64_t count) const {
        if (count > file_.bytes.size()) fail("it repeats its meshes too many times");
    }

    void add_triangles(std::size_t first, std::uint64_t vertices, bool turned) {
        if (vertices % 3 != 0) fail("the number of vertices without indices is not a multiple of three");
        for (std::uint64_t v = 0; v < vertices; v += 3) add_triangle(first, {v, v + 1, v + 2}, turned);
    }

    void add_triangle(std::size_t first, std::array<std::uint64_t, 3> corners, bool turned) {
        if (turned) std::swap(corners[1], corners[2]);
        mesh_.triangles.push_back({static_cast<VertexId>(first + corners[0]), static_cast<VertexId>(first + corners[1]),
                                   static_cast<VertexId>(first + corners[2])});
    }

    Vec3 position(std::uint64_t begin) const {
        BinaryCursor cursor(file_.path, file_.bytes, binary_begin_ + begin);
        const auto x = cursor.take<float>("a position");
        const auto y = cursor.take<float>("a position");
        const auto z = cursor.take<float>("a position");
        if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
            cursor.fail("the position before it is not finite; write the file again");
        return {double{x}, double{y}, double{z}};
    }

    std::uint64_t index(const Values& values, std::uint64_t i, std::uint64_t vertices) const {
        BinaryCursor cursor(file_.path, file_.bytes, binary_begin_ + values.begin + i * values.stride);
        const std::uint64_t number = values.type == kUnsignedByte    ? cursor.take<std::uint8_t>("an index")
                                     : values.type == kUnsignedShort ? cursor.take<std::uint16_t>("an index")
                                                                     : cursor.take<std::uint32_t>("an index");
        if (number >= vertices)
            cursor.fail("the index before it names vertex " + std::to_string(number) + " of " +
                        std::to_string(vertices) + "; write the file again");
        return number;
    }

    // Checked against the size of the file.
    Values values_of(std::size_t accessor_number, const char* type) const {
        const json& accessor = list("accessors").at(accessor_number);
        if (accessor.contains("sparse") || !accessor.contains("bufferView"))
            fail("sparse accessors and accessors without a view are not supported");
        if (accessor.at("type").get<std::string>() != type) fail(std::string("an accessor is not of type ") + type);
        const json& view = list("bufferViews").at(number_in(accessor.at("bufferView")));
        if (number_in(view.at("buffer")) != 0 || list("buffers").at(0).contains("uri"))
            fail("buffers outside the file are not supported; write everything into one file");
        Values values{.type = number_in(accessor.at("componentType"))};
        const std::uint64_t size = size_of(values.type) * (std::string_view(type) == "VEC3" ? 3 : 1);
        const std::uint64_t view_begin = whole(view, "byteOffset");
        const std::uint64_t view_size = whole(view, "byteLength");
        const std::uint64_t offset = whole(accessor, "byteOffset");
        values.count = whole(accessor, "count");
        values.stride = view.contains("byteStride") ? whole(view, "byteStride") : size;
        values.begin = view_begin + offset;
        const bool in_file = view_begin <= binary_.size() && view_size <= binary_.size() - view_begin;
        const bool in_view = offset <= view_size && values.stride >= size && values.count <= view_size / size;
        const std::uint64_t used = values.count == 0 ? 0 : (values.count - 1) * values.stride + size;
        if (!in_file || !in_view || used > view_size - offset)
            fail("an accessor reaches beyond the data; is the file cut off?");
        return values;
    }

    std::uint64_t whole(const json& object, const char* name) const {
        return object.contains(name) ? number_in(object.at(name)) : 0;
    }

    // Below 2^32, so that products of two do not overflow.
    std::uint64_t number_in(const json& value) const {
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
            fail("a number in its JSON is not a whole number from 0 to 2^32 - 1");
        return value.get<std::uint64_t>();
    }

    std::uint64_t size_of(std::uint64_t type) const {
        if (type == kUnsignedByte) return sizeof(std::uint8_t);
        if (type == kUnsignedShort) return sizeof(std::uint16_t);
        if (type == kUnsignedInt || type == kFloat) return sizeof(std::uint32_t);
        fail("an accessor has component type " + std::to_string(type) + ", which is not supported");
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(file_.path + ": " + message + "; write the file again with plain triangles");
    }

    const MeshFile& file_;
    bool has_json_ = false;
    json json_;
    std::string_view binary_;
    std::size_t binary_begin_ = 0;
    std::vector<bool> visited_;
    Mesh mesh_;
};

}  // namespace

Mesh read_glb(const MeshFile& file) { return GlbReader(file).read(); }

}  // namespace meniscus::reading

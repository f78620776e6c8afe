// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/glb_reader.h"

#include "small_files.h"

namespace meniscus::testing {
namespace {

std::string glb(std::string json, const std::string& binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    return "glTF" +
           bytes_of<std::uint32_t>({2, static_cast<std::uint32_t>(28 + json.size() + binary.size()),
                                    static_cast<std::uint32_t>(json.size())}) +
           "JSON" + json + bytes_of<std::uint32_t>({static_cast<std::uint32_t>(binary.size())}) +
           std::string("BIN\0", 4) + binary;
}

std::string positions() {
    std::string bytes;
    for (const Vec3& p : kSquare)
        bytes += bytes_of<float>({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    return bytes;
}

struct Parts {
    std::string node = R"({"mesh": 0})";
    std::string type = "5123";
    std::string indices = bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
    std::string more{};
};

std::string square(const Parts& parts = {}) {
    const std::string length = std::to_string(parts.indices.size());
    return glb(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)" + parts.node +
                   R"(], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4},
                      {"bufferView": 1, "componentType": )" +
                   parts.type + R"(, "type": "SCALAR", "count": 6}],
        "bufferViews": [{"buffer": 0, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 48, "byteLength": )" +
                   length + R"(}], "buffers": [{"byteLength": 60}])" + parts.more + "}",
               positions() + parts.indices);
}

TEST(GlbReader, IndicesOfAllTypes) {
    expect_square(mesh_of(square(), "a.glb"));
    expect_square(mesh_of(square({.type = "5121", .indices = bytes_of<std::uint8_t>({0, 1, 2, 0, 2, 3})}), "a.glb"));
    expect_square(mesh_of(square({.type = "5125", .indices = bytes_of<std::uint32_t>({0, 1, 2, 0, 2, 3})}), "a.glb"));
}

TEST(GlbReader, NumbersBeyondDoubleAreRefused) {
    expect_error(glb(R"({"asset": 1e30812})", ""), "a.glb", "a.glb:byte 20: the JSON holds a number beyond 1e308");
}

TEST(GlbReader, WithoutIndicesThreeVerticesAreATriangle) {
    const Mesh mesh = mesh_of(glb(R"({"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
        "bufferViews": [{"buffer": 0, "byteLength": 48, "byteStride": 12}], "buffers": [{"byteLength": 48}]})",
                                  positions()),
                              "a.glb");
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(GlbReader, TransformationsOfNodesAreApplied) {
    const Mesh moved = mesh_of(square({.node = R"({"children": [1], "translation": [10, 0, 0]},
        {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [2, 2, 2]})"}),
                               "a.glb");
    EXPECT_LT(norm(moved.vertices[1] - Vec3{10, 2, 0}), 1e-12);  // x to y, twice as long
    EXPECT_LT(norm(moved.vertices[3] - Vec3{8, 0, 0}), 1e-12);
    const Mesh mirrored =
        mesh_of(square({.node = R"({"mesh": 0, "matrix": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,5,1]})"}), "a.glb");
    EXPECT_EQ(mirrored.vertices[2], (Vec3{-1, 1, 5}));
    EXPECT_EQ(mirrored.triangles[0], (Triangle{0, 2, 1}));
}

TEST(GlbReader, SaysWhatIsWrong) {
    expect_error(square({.indices = bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 4})}), "a.glb", "names vertex 4 of 4");
    expect_error(square({.indices = bytes_of<std::uint16_t>({0, 1, 2})}), "a.glb", "reaches beyond the data");
    expect_error(square({.type = "5122"}), "a.glb", "component type 5122");
    expect_error(square({.node = R"({"mesh": 7})"}), "a.glb", "its JSON is not valid glTF");
    expect_error(square({.node = R"({"children": [0]})"}), "a.glb", "a node has two parents or is its own");
    expect_error(square({.more = R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])"}), "a.glb",
                 "KHR_draco_mesh_compression");
    expect_error(glb("{", ""), "a.glb", "the JSON cannot be read");
    expect_error("OFF\n", "a.glb", "a.glb:byte 0: the file does not begin with glTF");
    expect_error(square().substr(0, 100), "a.glb", "the file is shorter than its header says");
}

}  // namespace
}  // namespace meniscus::testing

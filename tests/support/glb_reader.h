// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The smallest reader that can read back what our GLB writer writes, sharing nothing with it.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus::testing {

/// What a GLB file holds. Values are as stored, normalised ones divided by their largest.
struct GlbContent {  // NOLINT(bugprone-exception-escape): moving JSON does not throw, as the library promises
    nlohmann::json json;
    std::map<std::string, std::vector<std::vector<double>>> attributes;  ///< by name, one list per vertex
    std::vector<Triangle> triangles;
    std::map<std::string, std::vector<std::vector<double>>> ligands;  ///< attributes of a second mesh
};

class GlbReader {
public:
    explicit GlbReader(const std::string& content) : content_(content) {
        if (content.substr(0, 4) != "glTF" || word(4) != 2 || word(8) != content.size()) fail("no GLB 2.0 of its size");
        if (content.size() % 4 != 0) fail("not padded");
        const std::uint32_t length = word(12);
        if (content.substr(16, 4) != "JSON" || length % 4 != 0) fail("no JSON chunk");
        glb_.json = nlohmann::json::parse(content.substr(20, length));
        if (20 + length == content.size()) return;
        binary_ = 28 + length;
        binary_size_ = word(20 + length);
        if (content.substr(24 + length, 4) != std::string("BIN\0", 4)) fail("no BIN chunk");
        if (binary_ + binary_size_ != content.size()) fail("the BIN chunk does not end with the file");
        const auto& meshes = glb_.json.at("meshes");
        if (meshes.size() > 1) {
            read_primitive(meshes.at(1).at("primitives").at(0));
            glb_.ligands = std::exchange(glb_.attributes, {});
            glb_.triangles.clear();
        }
        read_primitive(meshes.at(0).at("primitives").at(0));
    }

    GlbContent take() { return std::move(glb_); }

private:
    [[noreturn]] static void fail(const std::string& what) { throw std::runtime_error(what); }

    template <class T>
    T number(std::size_t offset) const {
        if (offset + sizeof(T) > content_.size()) fail("the file ends too early");
        T value{};
        std::memcpy(&value, content_.data() + offset, sizeof value);
        return value;
    }

    std::uint32_t word(std::size_t offset) const { return number<std::uint32_t>(offset); }

    std::vector<std::vector<double>> values(const nlohmann::json& accessor, int target) const {
        const auto& view = glb_.json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
        if (view.at("target") != target) fail("a view with another target");
        const std::map<std::string, std::size_t> widths{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
        const std::size_t width = widths.at(accessor.at("type").get<std::string>());
        const int type = accessor.at("componentType");
        const std::size_t size = type == 5123 ? 2 : 4;
        const auto count = accessor.at("count").get<std::size_t>();
        const auto offset = view.at("byteOffset").get<std::size_t>();
        if (view.at("byteLength") != count * width * size) fail("a view of another size");
        if (offset % 4 != 0 || offset + count * width * size > binary_size_) fail("a view beyond the buffer");
        std::vector<std::vector<double>> all(count, std::vector<double>(width));
        std::size_t at = binary_ + offset;
        for (std::vector<double>& one : all)
            for (double& value : one) {
                if (type == 5126) value = number<float>(at);
                if (type == 5125) value = number<std::uint32_t>(at);
                if (type == 5123) value = number<std::uint16_t>(at) / (accessor.at("normalized") ? 65535.0 : 1.0);
                at += size;
            }
        return all;
    }

    void read_primitive(const nlohmann::json& primitive) {
        const auto& accessors = glb_.json.at("accessors");
        for (const auto& [name, number] : primitive.at("attributes").items())
            glb_.attributes[name] = values(accessors.at(number.get<std::size_t>()), 34962);
        const auto corners = values(accessors.at(primitive.at("indices").get<std::size_t>()), 34963);
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            glb_.triangles.push_back({static_cast<VertexId>(corners[i][0]), static_cast<VertexId>(corners[i + 1][0]),
                                      static_cast<VertexId>(corners[i + 2][0])});
    }

    const std::string& content_;
    std::size_t binary_ = 0;
    std::size_t binary_size_ = 0;
    GlbContent glb_;
};

/// throws   std::runtime_error for anything but what the format prescribes
inline GlbContent read_glb(const std::string& content) { return GlbReader(content).take(); }

}  // namespace meniscus::testing

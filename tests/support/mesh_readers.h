// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The smallest readers that can read back what our writers write, sharing nothing with them.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus::testing {

/// What a PLY file holds, whatever its encoding.
struct PlyContent {
    std::vector<std::string> header;                              ///< lines up to end_header
    std::vector<std::pair<std::string, std::string>> properties;  ///< type and name, in order
    std::map<std::string, std::vector<double>> values;            ///< per vertex, by name
    std::vector<Triangle> triangles;
    bool read_to_the_end = false;  ///< nothing is left over
};

template <class T>
double take_number(std::istream& in) {
    T value{};
    in.read(reinterpret_cast<char*>(&value), sizeof value);
    if (!in) throw std::runtime_error("the file ends too early");
    return static_cast<double>(value);
}

inline double take_number(std::istream& in, const std::string& type, bool text) {
    if (text) {
        std::string word;
        in >> word;
        if (!in) throw std::runtime_error("the file ends too early");
        return type == "float" ? static_cast<double>(std::stof(word)) : std::stod(word);
    }
    if (type == "uchar") return take_number<std::uint8_t>(in);
    if (type == "int") return take_number<std::int32_t>(in);
    if (type == "uint") return take_number<std::uint32_t>(in);
    if (type == "float") return take_number<float>(in);
    if (type == "double") return take_number<double>(in);
    throw std::runtime_error("unknown type " + type);
}

inline PlyContent read_ply(const std::string& content) {
    std::istringstream in(content);
    PlyContent ply;
    std::map<std::string, std::size_t> counts;
    std::string element;
    for (std::string line; ply.header.empty() || ply.header.back() != "end_header";) {
        if (!std::getline(in, line)) throw std::runtime_error("no end_header");
        ply.header.push_back(line);
        std::istringstream words(line);
        std::string keyword;
        std::string type;
        std::string name;
        words >> keyword >> type >> name;
        if (keyword == "element") counts[element = type] = std::stoul(name);
        if (keyword == "property" && element == "vertex") ply.properties.emplace_back(type, name);
    }
    const bool text = ply.header.at(1) == "format ascii 1.0";
    for (std::size_t v = 0; v < counts["vertex"]; ++v)
        for (const auto& [type, name] : ply.properties) ply.values[name].push_back(take_number(in, type, text));
    for (std::size_t f = 0; f < counts["face"]; ++f) {
        if (take_number(in, "uchar", text) != 3.0) throw std::runtime_error("not a triangle");
        Triangle t;
        for (VertexId& v : t) v = static_cast<VertexId>(take_number(in, "int", text));
        ply.triangles.push_back(t);
    }
    if (text) in >> std::ws;
    ply.read_to_the_end = in.peek() == std::istringstream::traits_type::eof();
    return ply;
}

inline Mesh read_obj(const std::string& content) {
    std::istringstream in(content);
    Mesh mesh;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string keyword;
        Vec3 p;
        words >> keyword;
        if (keyword == "v" || keyword == "vn") {
            words >> p.x >> p.y >> p.z;
            keyword == "v" ? mesh.vertices.push_back(p) : mesh.normals.push_back(to_small(p));
        } else if (keyword == "f") {
            Triangle t;
            for (VertexId& v : t) {
                std::string corner;
                words >> corner;
                const std::size_t slashes = corner.find("//");
                const std::string number = corner.substr(0, slashes);
                if (slashes != std::string::npos && corner.substr(slashes + 2) != number)
                    throw std::runtime_error("normal of another vertex");
                v = static_cast<VertexId>(std::stoul(number) - 1);
            }
            mesh.triangles.push_back(t);
        } else if (keyword != "#") {
            throw std::runtime_error("unknown line: " + line);
        }
    }
    return mesh;
}

inline Mesh read_off(const std::string& content) {
    std::istringstream in(content);
    std::string line;
    std::getline(in, line);
    if (line != "OFF") throw std::runtime_error("not OFF");
    while (in.peek() == '#') std::getline(in, line);
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t edges = 0;
    in >> vertices >> triangles >> edges;
    Mesh mesh;
    mesh.vertices.resize(vertices);
    mesh.triangles.resize(triangles);
    for (Vec3& p : mesh.vertices) in >> p.x >> p.y >> p.z;
    for (Triangle& t : mesh.triangles) {
        int corners = 0;
        in >> corners >> t[0] >> t[1] >> t[2];
        if (corners != 3) throw std::runtime_error("not a triangle");
    }
    if (!in) throw std::runtime_error("the file ends too early");
    return mesh;
}

/// Facet normals and corners, four vectors per triangle.
using Facets = std::vector<std::array<Vec3, 4>>;

inline Facets read_binary_stl(const std::string& content) {
    std::uint32_t count = 0;
    std::memcpy(&count, content.data() + 80, sizeof count);
    if (content.size() != 84 + std::size_t{50} * count) throw std::runtime_error("wrong size");
    Facets facets(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 12> numbers;
        std::memcpy(numbers.data(), content.data() + 84 + 50 * i, sizeof numbers);
        for (std::size_t k = 0; k < 4; ++k) facets[i][k] = {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
    }
    return facets;
}

inline Facets read_text_stl(const std::string& content) {
    std::istringstream in(content);
    Facets facets;
    std::size_t corner = 4;
    for (std::string word; in >> word;) {
        if (word == "facet") {
            in >> word;
            facets.emplace_back();
            in >> facets.back()[0].x >> facets.back()[0].y >> facets.back()[0].z;
            corner = 1;
        } else if (word == "vertex") {
            Vec3& p = facets.back().at(corner++);
            in >> p.x >> p.y >> p.z;
        }
    }
    return facets;
}

}  // namespace meniscus::testing

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/ply.h"

#include <bit>
#include <concepts>
#include <cstdint>
#include <functional>
#include <string>

#include "io/measured_arrays.h"
#include "io/precision.h"
#include "meniscus/version.h"

namespace meniscus {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are written as the numbers are in memory");

template <class T>
constexpr const char* kTypeName = "";
template <>
constexpr const char* kTypeName<float> = "float";
template <>
constexpr const char* kTypeName<double> = "double";
template <>
constexpr const char* kTypeName<std::uint8_t> = "uchar";
template <>
constexpr const char* kTypeName<std::int32_t> = "int";
template <>
constexpr const char* kTypeName<std::uint32_t> = "uint";

class PlyWriter {
public:
    PlyWriter(AtomicFile& file, const Mesh& mesh, const WriteOptions& options)
        : file_(file), mesh_(mesh), is_text_(options.encoding == Encoding::Text) {
        if (precision_needed(mesh) == Precision::Single)
            add_vectors<float>({"x", "y", "z"}, mesh.vertices);
        else
            add_vectors<double>({"x", "y", "z"}, mesh.vertices);
        if (!mesh.normals.empty()) add_vectors<float>({"nx", "ny", "nz"}, mesh.normals);
        if (!mesh.atoms.empty()) add<std::uint32_t>("atom", [&mesh](std::size_t v) { return mesh.atoms[v]; });
        if (!mesh.patches.empty()) add<std::uint8_t>("patch", [&mesh](std::size_t v) { return mesh.patches[v]; });
        if (!mesh.components.empty())
            add<std::int32_t>("component", [&mesh](std::size_t v) { return mesh.components[v]; });
        for (const auto& [name, values] : measured_arrays(mesh)) add(name, values);
        for (const VertexArray& array : options.extra)
            std::visit([&](auto values) { add(array.name, values); }, array.values);
        if (!options.colours.empty()) add_colours(options.colours);
    }

    void write() {
        write_header();
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
            for (const auto& property : properties_) property(v);
            end_line();
        }
        for (const Triangle& t : mesh_.triangles) write_face(t);
    }

private:
    template <class T, class Get>
    void add(const std::string& name, const Get& get) {
        declare<T>(name);
        properties_.emplace_back([this, get](std::size_t v) { put(static_cast<T>(get(v))); });
    }

    template <class T>
    void add(const std::string& name, std::span<const T> values) {
        add<T>(name, [values](std::size_t v) { return values[v]; });
    }

    template <class T>
    void add_vectors(const std::array<const char*, 3>& names, const std::vector<Vec3>& vectors) {
        for (const char* name : names) declare<T>(name);
        properties_.emplace_back([this, &vectors](std::size_t v) {
            put(static_cast<T>(vectors[v].x));
            put(static_cast<T>(vectors[v].y));
            put(static_cast<T>(vectors[v].z));
        });
    }

    void add_colours(std::span<const Colour> colours) {
        for (const char* name : {"red", "green", "blue", "alpha"}) declare<std::uint8_t>(name);
        properties_.emplace_back([this, colours](std::size_t v) {
            put(colours[v].red);
            put(colours[v].green);
            put(colours[v].blue);
            put(colours[v].alpha);
        });
    }

    template <class T>
    void declare(const std::string& name) {
        declarations_ += std::string("property ") + kTypeName<T> + ' ' + name + '\n';
    }

    void write_header() {
        const bool fits_int = mesh_.vertices.size() <= std::size_t{1} << 31U;
        file_.write(std::string("ply\nformat ") + (is_text_ ? "ascii" : "binary_little_endian") + " 1.0\n");
        file_.write(std::string("comment meniscus ") + kVersion + "\ncomment lengths in angstrom\n");
        file_.write("element vertex " + std::to_string(mesh_.vertices.size()) + '\n' + declarations_);
        file_.write("element face " + std::to_string(mesh_.triangles.size()) + '\n');
        file_.write(std::string("property list uchar ") + (fits_int ? "int" : "uint") +
                    " vertex_indices\nend_header\n");
    }

    void write_face(const Triangle& triangle) {
        put(std::uint8_t{3});
        if (!is_text_) return file_.bytes(triangle);
        for (const VertexId v : triangle) put(v);
        end_line();
    }

    template <class T>
    void put(T value) {
        if (!is_text_) return file_.bytes(value);
        if (!at_line_start_) file_.write(' ');
        at_line_start_ = false;
        if constexpr (std::signed_integral<T>)
            file_.write(std::to_string(value));
        else if constexpr (std::unsigned_integral<T>)
            file_.number(std::uint64_t{value});
        else
            file_.number(value);
    }

    void end_line() {
        if (is_text_) file_.write('\n');
        at_line_start_ = true;
    }

    AtomicFile& file_;
    const Mesh& mesh_;
    bool is_text_;
    bool at_line_start_ = true;
    std::string declarations_;
    std::vector<std::function<void(std::size_t)>> properties_;
};

}  // namespace

void write_ply(AtomicFile& file, const Mesh& mesh, const WriteOptions& options) {
    PlyWriter(file, mesh, options).write();
}

}  // namespace meniscus

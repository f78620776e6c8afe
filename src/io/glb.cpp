// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/glb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/srgb.h"
#include "io/measured_arrays.h"
#include "meniscus/errors.h"
#include "meniscus/version.h"

namespace meniscus {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are written as the numbers are in memory");

using nlohmann::ordered_json;

// Numbers of the specification.
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

constexpr std::uint32_t kLargestWholeFloat = 1U << 24U;  // all whole numbers up to it are floats

// Stands where a vertex has no value: glTF knows no NaN. The asset's extras say so.
constexpr float kMissing = std::numeric_limits<float>::lowest();

// Neither a mirror nor chalk.
constexpr double kRoughness = 0.7;

using FloatVector = std::array<float, 3>;
using LinearColour = std::array<std::uint16_t, 4>;

// What an accessor and its view of the buffer show.
struct Section {
    ordered_json accessor;  // without its view
    int target = kArrayBuffer;
    std::uint64_t size = 0;             // bytes, a multiple of four
    std::function<void()> write_bytes;  // all of them
};

// A mesh beside that of the surface, with a material of its own.
struct NodeBeside {
    std::string name;
    ordered_json primitive;
    ordered_json material;
};

// Braces alone would leave open whether a list of one is meant.
ordered_json list_of(ordered_json only) {
    ordered_json list = ordered_json::array();
    list.push_back(std::move(only));
    return list;
}

FloatVector single(const Vec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

std::array<std::uint16_t, 256> linear_table() {
    std::array<std::uint16_t, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<std::uint16_t>(std::lround(65535.0 * linear_from_srgb(static_cast<double>(i) / 255.0)));
    return table;
}

LinearColour to_linear(const Colour& c) {
    static const std::array<std::uint16_t, 256> table = linear_table();
    return {table[c.red], table[c.green], table[c.blue], static_cast<std::uint16_t>(257U * c.alpha)};
}

// "mean_curvature" -> "_MEAN_CURVATURE": names of one's own begin with an underscore.
std::string attribute_name(const std::string& name) {
    std::string attribute = "_";
    for (const char c : name) {
        const auto letter = static_cast<unsigned char>(c);
        if (letter > 127 || (std::isalnum(letter) == 0 && c != '_'))
            throw UsageError("GLB cannot hold the name '" + name + "'; use letters, digits and underscores");
        attribute += static_cast<char>(std::toupper(letter));
    }
    return attribute;
}

void check_values(const std::string& name, std::span<const float> values) {
    if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); }))
        throw UsageError("GLB cannot hold the values of '" + name + "': one is not finite; write PLY");
}

void check_values(const std::string& name, std::span<const std::uint32_t> values) {
    if (std::any_of(values.begin(), values.end(), [](std::uint32_t value) { return value > kLargestWholeFloat; }))
        throw LimitError("GLB cannot hold the values of '" + name +
                         "': whole numbers above 2^24 are not exact; write PLY");
}

template <class Vector>
void check_vectors(const std::string& name, const std::vector<Vector>& vectors) {
    const auto is_finite = [](const Vector& v) {
        const auto& [x, y, z] = single(v);
        return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
    };
    if (!std::all_of(vectors.begin(), vectors.end(), is_finite))
        throw UsageError("GLB cannot hold the " + name + ": one is not finite");
}

class GlbWriter {
public:
    GlbWriter(AtomicFile& file, const Mesh& mesh, const WriteOptions& options)
        : file_(file), mesh_(mesh), options_(options) {
        if (mesh.triangles.empty() || mesh.vertices.empty()) return;
        add_positions();
        if (!mesh.normals.empty()) add_vectors("NORMAL", mesh.normals);
        if (!options.colours.empty()) add_colours();
        if (!mesh.atoms.empty()) add_values("atom", std::span<const std::uint32_t>(mesh.atoms));
        if (!mesh.patches.empty()) add_patches();
        if (!mesh.components.empty()) add_values("component", std::span<const std::uint32_t>(mesh.components));
        for (const auto& [name, values] : measured_arrays(mesh))
            has_gaps(name) ? add_values_with_gaps(name, values) : add_values(name, values);
        for (const VertexArray& array : options.extra)
            std::visit([&](auto values) { add_values(array.name, values); }, array.values);
        add_triangles();
        if (options.beside != nullptr && !options.beside->mesh.triangles.empty()) add_ligands(*options.beside);
        for (const NamedMesh& named : options.named)
            if (!named.mesh.triangles.empty()) add_named(named);
    }

    void write() {
        const std::string json = padded_json();
        constexpr std::uint64_t kHeader = 12;
        constexpr std::uint64_t kChunkHeader = 8;
        const std::uint64_t binary = buffer_size();
        const std::uint64_t total =
            kHeader + kChunkHeader + json.size() + (sections_.empty() ? 0 : kChunkHeader + binary);
        if (total > std::numeric_limits<std::uint32_t>::max())
            throw LimitError("GLB cannot hold more than 4 GiB; choose a larger spacing or write PLY");
        file_.reserve(total);
        file_.write("glTF");
        word(2);
        word(total);
        word(json.size());
        file_.write("JSON");
        file_.write(json);
        if (sections_.empty()) return;
        word(binary);
        file_.write(std::string_view("BIN\0", 4));
        for (const Section& section : sections_) section.write_bytes();
    }

private:
    void word(std::uint64_t value) { file_.bytes(static_cast<std::uint32_t>(value)); }

    // One more section of `count` values of type T, which get(i) gives.
    template <class T, class Get>
    Section& add_section(ordered_json accessor, std::size_t count, const Get& get) {
        static_assert(sizeof(T) % 4 == 0, "the next section must begin at a multiple of four");
        accessor["count"] = count;
        const auto write_bytes = [this, count, get] {
            for (std::size_t i = 0; i < count; ++i) file_.bytes<T>(get(i));
        };
        return sections_.emplace_back(Section{
            .accessor = std::move(accessor), .size = std::uint64_t{count} * sizeof(T), .write_bytes = write_bytes});
    }

    // An attribute is the number of its accessor.
    template <class T, class Get>
    Section& add_attribute(const std::string& name, ordered_json accessor, const Get& get) {
        if (attributes_.contains(name)) throw UsageError("two vertex arrays would both be '" + name + "' in GLB");
        attributes_[name] = sections_.size();
        return add_section<T>(std::move(accessor), mesh_.vertices.size(), get);
    }

    template <class Vector>
    Section& add_vectors(const std::string& name, const std::vector<Vector>& vectors) {
        check_vectors(name, vectors);
        return add_attribute<FloatVector>(name, vectors_accessor(),
                                          [&vectors](std::size_t v) { return single(vectors[v]); });
    }

    static ordered_json vectors_accessor() { return {{"componentType", kFloat}, {"type", "VEC3"}}; }
    static ordered_json colours_accessor() {
        return {{"componentType", kUnsignedShort}, {"normalized", true}, {"type", "VEC4"}};
    }

    static void set_extent(const std::vector<Vec3>& positions, ordered_json& accessor) {
        FloatVector low = single(positions.front());
        FloatVector high = low;
        for (const Vec3& position : positions) {
            const FloatVector p = single(position);
            for (std::size_t i = 0; i < p.size(); ++i) {
                low[i] = std::min(low[i], p[i]);
                high[i] = std::max(high[i], p[i]);
            }
        }
        accessor["min"] = low;
        accessor["max"] = high;
    }

    void add_positions() { set_extent(mesh_.vertices, add_vectors("POSITION", mesh_.vertices).accessor); }

    void add_colours() {
        add_attribute<LinearColour>("COLOR_0", colours_accessor(),
                                    [colours = options_.colours](std::size_t v) { return to_linear(colours[v]); });
    }

    /// Triangles beside the surface, as the beginning of a primitive of their own.
    ordered_json add_shape(const Mesh& mesh) {
        check_vectors("places beside the surface", mesh.vertices);
        const std::size_t n = mesh.vertices.size();
        const std::size_t first = sections_.size();
        set_extent(mesh.vertices, add_section<FloatVector>(vectors_accessor(), n, [&mesh](std::size_t v) {
                                      return single(mesh.vertices[v]);
                                  }).accessor);
        add_section<FloatVector>(vectors_accessor(), n, [&mesh](std::size_t v) { return single(mesh.normals[v]); });
        add_corners(mesh.triangles);
        return {{"attributes", {{"POSITION", first}, {"NORMAL", first + 1}}}, {"indices", first + 2}};
    }

    ordered_json add_coloured_shape(const Mesh& mesh, const std::vector<Colour>& colours) {
        ordered_json primitive = add_shape(mesh);
        primitive["attributes"]["COLOR_0"] = sections_.size();
        add_section<LinearColour>(colours_accessor(), colours.size(),
                                  [&colours](std::size_t v) { return to_linear(colours[v]); });
        return primitive;
    }

    void add_ligands(const Bodies& bodies) {
        add_node("ligands", add_coloured_shape(bodies.mesh, bodies.colours), {{"pbrMetallicRoughness", look()}});
    }

    void add_named(const NamedMesh& named) {
        if (named.colours.empty())
            add_node(named.name, add_shape(named.mesh), colour_material(named.colour));
        else
            add_node(named.name, add_coloured_shape(named.mesh, named.colours), {{"pbrMetallicRoughness", look()}});
    }

    void add_node(const std::string& name, ordered_json primitive, ordered_json material) {
        beside_.push_back({name, std::move(primitive), std::move(material)});
    }

    static ordered_json look() { return {{"metallicFactor", 0.0}, {"roughnessFactor", kRoughness}}; }

    static ordered_json colour_material(const Colour& colour) {
        ordered_json coloured = look();
        const auto light = [](std::uint8_t channel) { return linear_from_srgb(channel / 255.0); };
        coloured["baseColorFactor"] = {light(colour.red), light(colour.green), light(colour.blue),
                                       colour.alpha / 255.0};
        ordered_json material{{"pbrMetallicRoughness", coloured}};
        if (colour.alpha < 255) material["alphaMode"] = "BLEND";
        return material;
    }

    template <class T>
    void add_values(const std::string& name, std::span<const T> values) {
        check_values(name, values);
        add_attribute<float>(attribute_name(name), {{"componentType", kFloat}, {"type", "SCALAR"}},
                             [values](std::size_t v) { return static_cast<float>(values[v]); });
    }

    // Whether these are values from elsewhere, of which some vertices have none.
    bool has_gaps(const std::string& name) const {
        return std::any_of(mesh_.values.begin(), mesh_.values.end(), [&](const VertexValues& brought) {
            return brought.name == name && std::any_of(brought.values.begin(), brought.values.end(),
                                                       [](float value) { return std::isnan(value); });
        });
    }

    void add_values_with_gaps(const std::string& name, std::span<const float> values) {
        if (std::any_of(values.begin(), values.end(), [](float value) { return std::isinf(value); }))
            throw UsageError("GLB cannot hold the values of '" + name + "': one is not finite; write PLY");
        missing_[attribute_name(name)] = kMissing;
        add_attribute<float>(attribute_name(name), {{"componentType", kFloat}, {"type", "SCALAR"}},
                             [values](std::size_t v) { return std::isnan(values[v]) ? kMissing : values[v]; });
    }

    void add_patches() {
        add_attribute<float>("_PATCH", {{"componentType", kFloat}, {"type", "SCALAR"}},
                             [this](std::size_t v) { return static_cast<float>(mesh_.patches[v]); });
    }

    void add_triangles() {
        corners_ = sections_.size();
        add_corners(mesh_.triangles);
    }

    void add_corners(const std::vector<Triangle>& triangles) {
        Section& section =
            add_section<Triangle>({{"componentType", kUnsignedInt}, {"type", "SCALAR"}}, triangles.size(),
                                  [&triangles](std::size_t t) { return triangles[t]; });
        section.accessor["count"] = 3 * triangles.size();
        section.target = kElementArrayBuffer;
    }

    std::uint64_t buffer_size() const {
        std::uint64_t size = 0;
        for (const Section& section : sections_) size += section.size;
        return size;
    }

    ordered_json asset() const {
        ordered_json extras{{"units", "angstrom"}, {"frame", "as in the input"}};
        if (options_.probe) extras["probe"] = *options_.probe;
        if (options_.open) extras["open"] = true;
        if (!missing_.empty()) extras["missing"] = missing_;
        return {{"version", "2.0"}, {"generator", std::string("Meniscus ") + kVersion}, {"extras", extras}};
    }

    void describe_mesh(ordered_json& json) const {
        const ordered_json primitive{{"attributes", attributes_}, {"indices", corners_}, {"material", 0}};
        json["scenes"] = list_of({{"nodes", list_of(0)}});
        json["nodes"] = list_of({{"mesh", 0}, {"name", "surface"}});
        json["meshes"] = list_of({{"name", "surface"}, {"primitives", list_of(primitive)}});
        json["materials"] =
            list_of({{"name", "surface"}, {"doubleSided", options_.open}, {"pbrMetallicRoughness", look()}});
        for (const NodeBeside& node : beside_) {
            const std::size_t number = json["nodes"].size();
            ordered_json shape = node.primitive;
            shape["material"] = number;
            ordered_json material{{"name", node.name}};
            material.update(node.material);
            json["scenes"][0]["nodes"].push_back(number);
            json["nodes"].push_back({{"mesh", number}, {"name", node.name}});
            json["meshes"].push_back({{"name", node.name}, {"primitives", list_of(shape)}});
            json["materials"].push_back(material);
        }
    }

    void describe_buffer(ordered_json& json) const {
        std::uint64_t offset = 0;
        for (const Section& section : sections_) {
            ordered_json accessor = section.accessor;
            accessor["bufferView"] = json["bufferViews"].size();
            json["bufferViews"].push_back(
                {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", section.size}, {"target", section.target}});
            json["accessors"].push_back(accessor);
            offset += section.size;
        }
        json["buffers"] = list_of({{"byteLength", offset}});
    }

    // Chunks end at a multiple of four.
    std::string padded_json() const {
        ordered_json json{{"asset", asset()}, {"scene", 0}, {"scenes", list_of(ordered_json::object())}};
        if (!sections_.empty()) {
            describe_mesh(json);
            describe_buffer(json);
        }
        std::string text = json.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        return text;
    }

    AtomicFile& file_;
    const Mesh& mesh_;
    const WriteOptions& options_;
    std::vector<Section> sections_;
    std::size_t corners_ = 0;  // the section of the surface's triangles
    ordered_json attributes_;
    std::vector<NodeBeside> beside_;  // the surface
    ordered_json missing_;            // by attribute, the number that stands for none
};

}  // namespace

void write_glb(AtomicFile& file, const Mesh& mesh, const WriteOptions& options) {
    GlbWriter(file, mesh, options).write();
}

}  // namespace meniscus

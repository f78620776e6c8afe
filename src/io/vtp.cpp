// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/vtp.h"

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/precision.h"
#include "io/vertex_arrays.h"
#include "meniscus/version.h"

namespace meniscus {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are written as the numbers are in memory");

constexpr std::uint64_t kHeaderSize = sizeof(std::uint64_t);  // bytes before each array

template <class T>
constexpr const char* kVtkTypeName = "";
template <>
constexpr const char* kVtkTypeName<float> = "Float32";
template <>
constexpr const char* kVtkTypeName<double> = "Float64";
template <>
constexpr const char* kVtkTypeName<std::uint8_t> = "UInt8";
template <>
constexpr const char* kVtkTypeName<std::uint32_t> = "UInt32";
template <>
constexpr const char* kVtkTypeName<std::int64_t> = "Int64";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

class VtpWriter {
public:
    VtpWriter(AtomicFile& file, const Mesh& mesh, const WriteOptions& options) : file_(file), mesh_(mesh) {
        points_ = precision_needed(mesh, options.shortest_edge) == Precision::Single
                      ? vectors<float>("Points", mesh.vertices)
                      : vectors<double>("Points", mesh.vertices);
        for_each_vertex_array(mesh, options, [this](const std::string& name, auto values) { add(name, values); });
        triangles_ = declare<std::int64_t, 1>("connectivity", 3 * mesh.triangles.size(), [this] {
            for (const Triangle& triangle : mesh_.triangles)
                for (const VertexId v : triangle) file_.bytes(std::int64_t{v});
        });
        triangles_ += declare<std::int64_t, 1>("offsets", mesh.triangles.size(), [this] {
            for (std::size_t t = 1; t <= mesh_.triangles.size(); ++t) file_.bytes(static_cast<std::int64_t>(3 * t));
        });
        probe_ = options.probe;
        is_open_ = options.open;
        active_normals_ = mesh.normals.empty() ? "" : R"( Normals="Normals")";
        active_scalars_ = options.colours.empty() ? "" : R"( Scalars="colors")";
    }

    void write() {
        file_.reserve(offset_);
        write_description();
        for (const auto& [size, write_values] : arrays_) {
            file_.bytes(size);
            write_values();
        }
        file_.write("\n  </AppendedData>\n</VTKFile>\n");
    }

private:
    struct Appended {
        std::uint64_t size;  // bytes
        std::function<void()> write_values;
    };

    // One more array in the appended data: its element.
    template <class T, int kComponents, class Write>
    std::string declare(const std::string& name, std::size_t count, const Write& write_values) {
        std::string element = std::string("        <DataArray type=\"") + kVtkTypeName<T> + "\" Name=\"" +
                              escaped(name) + "\" NumberOfComponents=\"" + std::to_string(kComponents) +
                              R"(" format="appended" offset=")" + std::to_string(offset_) + "\"/>\n";
        const std::uint64_t size = std::uint64_t{count} * kComponents * sizeof(T);
        arrays_.push_back({size, write_values});
        offset_ += kHeaderSize + size;
        return element;
    }

    template <class T>
    std::string vectors(const std::string& name, const std::vector<Vec3>& vectors) {
        return declare<T, 3>(name, vectors.size(), [this, vectors = std::span(vectors)] {
            for (const Vec3& v : vectors)
                file_.bytes(std::array{static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)});
        });
    }

    // Values whose memory is what the file holds.
    template <class T, int kComponents, class Values>
    std::string plain(const std::string& name, Values values) {
        static_assert(sizeof(typename Values::value_type) == kComponents * sizeof(T));
        return declare<T, kComponents>(name, values.size(), [this, values] {
            file_.write({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
        });
    }

    template <class Values>
    void add(const std::string& name, Values values) {
        using T = std::remove_const_t<typename Values::element_type>;
        if constexpr (std::is_same_v<T, SmallVec3>)
            point_data_ += plain<float, 3>("Normals", values);
        else if constexpr (std::is_same_v<T, Colour>)
            point_data_ += plain<std::uint8_t, 4>(name, values);
        else if constexpr (std::is_same_v<T, PatchKind>)
            point_data_ += plain<std::uint8_t, 1>(name, values);
        else
            point_data_ += plain<T, 1>(name, values);
    }

    void write_description() {
        const std::string triangles = std::to_string(mesh_.triangles.size());
        file_.write(std::string("<?xml version=\"1.0\"?>\n<!-- meniscus ") + kVersion +
                    ", lengths in angstrom -->\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <PolyData>\n");
        write_field_data();
        file_.write("    <Piece NumberOfPoints=\"" + std::to_string(mesh_.vertices.size()) +
                    "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" + triangles +
                    "\">\n      <PointData" + active_scalars_ + active_normals_ + ">\n" + point_data_ +
                    "      </PointData>\n      <Points>\n" + points_ + "      </Points>\n      <Polys>\n" + triangles_ +
                    "      </Polys>\n    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n   _");
    }

    void write_field_data() {
        if (!probe_ && !is_open_) return;
        file_.write("    <FieldData>\n");
        if (probe_) write_field<double>("probe", *probe_);
        if (is_open_) write_field<std::uint8_t>("open", 1.0);
        file_.write("    </FieldData>\n");
    }

    template <class T>
    void write_field(const std::string& name, double value) {
        file_.write(std::string("      <DataArray type=\"") + kVtkTypeName<T> + "\" Name=\"" + name +
                    R"(" NumberOfTuples="1" format="ascii">)");
        file_.number(value);
        file_.write("</DataArray>\n");
    }

    AtomicFile& file_;
    const Mesh& mesh_;
    std::optional<double> probe_;
    bool is_open_ = false;
    std::string active_scalars_;
    std::string active_normals_;
    std::string points_;
    std::string point_data_;
    std::string triangles_;
    std::vector<Appended> arrays_;
    std::uint64_t offset_ = 0;
};

}  // namespace

void write_vtp(AtomicFile& file, const Mesh& mesh, const WriteOptions& options) {
    VtpWriter(file, mesh, options).write();
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "io/measured_arrays.h"
#include "io/open_mark.h"
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

constexpr std::size_t kBatch = std::size_t{1} << 19U;  // bytes packed before they are written: half a core's cache

// Of small meshes less: the memory for it is new, and touching it takes longer than packing.
constexpr std::size_t kLeastBatch = std::size_t{1} << 15U;  // bytes
constexpr std::size_t kBatchesOfSmallMesh = 16;

constexpr std::size_t kPackedAtOnce = 256;  // vertices, whose records stay in the innermost cache from column to column

constexpr std::size_t kFaceSize = 1 + sizeof(Triangle);  // bytes

// A vertex property or a few in a row, of one type.
struct Column {
    std::function<void(std::size_t)> print;                          // one vertex, as text
    std::function<void(std::size_t, std::size_t, std::byte*)> pack;  // vertices begin to end, into their records
};

class PlyWriter {
public:
    PlyWriter(AtomicFile& file, const Mesh& mesh, const WriteOptions& options)
        : file_(file), mesh_(mesh), is_text_(options.encoding == Encoding::Text), is_open_(options.open) {
        if (precision_needed(mesh, options.shortest_edge) == Precision::Single)
            add_vectors<float>({"x", "y", "z"}, mesh.vertices);
        else
            add_vectors<double>({"x", "y", "z"}, mesh.vertices);
        if (!mesh.normals.empty()) add_vectors<float>({"nx", "ny", "nz"}, mesh.normals);
        if (!mesh.atoms.empty()) add<std::uint32_t>("atom", std::span(mesh.atoms));
        if (!mesh.patches.empty()) add<std::uint8_t>("patch", std::span(mesh.patches));
        if (!mesh.components.empty()) add<std::int32_t>("component", std::span(mesh.components));
        for (const auto& [name, values] : measured_arrays(mesh)) add<float>(name, values);
        for (const VertexArray& array : options.extra)
            std::visit([&]<class T>(std::span<const T> values) { add<T>(array.name, values); }, array.values);
        if (!options.colours.empty()) add_colours(options.colours);
    }

    void write() {
        write_header();
        if (is_text_)
            print_records();
        else
            pack_records();
    }

private:
    template <class T, std::size_t N, class Get>
    void add_column(const std::array<std::string, N>& names, const Get& get) {
        for (const std::string& name : names)
            declarations_ += std::string("property ") + kTypeName<T> + ' ' + name + '\n';
        const std::size_t offset = record_size_;
        record_size_ += N * sizeof(T);
        const auto print = [this, get](std::size_t v) {
            for (const T value : get(v)) print_number(value);
        };
        const auto pack = [this, get, offset](std::size_t begin, std::size_t end, std::byte* records) {
            const std::size_t size = record_size_;
            const auto get_here = get;  // bytes may be anything's: `get` itself would be loaded anew after every store
            const auto put = [&](std::size_t v, std::byte* to) {
                const std::array<T, N> values = get_here(v);
                std::memcpy(to, values.data(), sizeof values);
            };
            std::byte* to = records + offset;
            constexpr std::size_t kAtOnce = 4;  // or counting takes as long as packing
            for (; begin + kAtOnce <= end; begin += kAtOnce, to += kAtOnce * size)
                for (std::size_t k = 0; k < kAtOnce; ++k) put(begin + k, to + k * size);
            for (; begin < end; ++begin, to += size) put(begin, to);
        };
        columns_.push_back({print, pack});
    }

    template <class T, class From>
    void add(const std::string& name, std::span<const From> values) {
        add_column<T, 1>({name}, [values](std::size_t v) { return std::array<T, 1>{static_cast<T>(values[v])}; });
    }

    template <class T, class Vector>
    void add_vectors(const std::array<std::string, 3>& names, const std::vector<Vector>& vectors) {
        add_column<T, 3>(names, [of = std::span(vectors)](std::size_t v) {
            const auto& [x, y, z] = of[v];
            return std::array<T, 3>{static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)};
        });
    }

    void add_colours(std::span<const Colour> colours) {
        add_column<std::uint8_t, 4>({"red", "green", "blue", "alpha"}, [colours](std::size_t v) {
            const auto& [red, green, blue, alpha] = colours[v];
            return std::array<std::uint8_t, 4>{red, green, blue, alpha};
        });
    }

    void write_header() {
        const bool fits_int = mesh_.vertices.size() <= std::size_t{1} << 31U;
        file_.write(std::string("ply\nformat ") + (is_text_ ? "ascii" : "binary_little_endian") + " 1.0\n");
        file_.write(std::string("comment meniscus ") + kVersion + "\ncomment lengths in angstrom\n");
        if (is_open_) file_.write(std::string("comment ") + kOpenMark + '\n');
        file_.write("element vertex " + std::to_string(mesh_.vertices.size()) + '\n' + declarations_);
        file_.write("element face " + std::to_string(mesh_.triangles.size()) + '\n');
        file_.write(std::string("property list uchar ") + (fits_int ? "int" : "uint") +
                    " vertex_indices\nend_header\n");
    }

    void pack_records() {
        file_.reserve(mesh_.vertices.size() * record_size_ + mesh_.triangles.size() * kFaceSize);
        pack_in_batches(mesh_.vertices.size(), record_size_, [&](std::size_t begin, std::size_t end, std::byte* to) {
            for (const Column& column : columns_) column.pack(begin, end, to);
        });
        pack_in_batches(mesh_.triangles.size(), kFaceSize, [&](std::size_t begin, std::size_t end, std::byte* to) {
            for (const Triangle& triangle : std::span(mesh_.triangles).subspan(begin, end - begin)) {
                *to = std::byte{3};
                std::memcpy(to + 1, triangle.data(), sizeof triangle);
                to += kFaceSize;
            }
        });
    }

    // One batch is written while the next one is packed. pack_few(begin, end, to): some records of a batch
    template <class PackFew>
    void pack_in_batches(std::size_t count, std::size_t record_size, const PackFew& pack_few) {
        const std::size_t few = std::max(kLeastBatch / record_size, count / kBatchesOfSmallMesh);
        const std::size_t batch = std::max<std::size_t>(1, std::min(kBatch / record_size, few));
        std::array<std::unique_ptr<std::byte[]>, 2> records;
        for (auto& buffer : records) buffer.reset(new std::byte[std::min(count, batch) * record_size]);
        const auto end_of = [&](std::size_t begin) { return std::min(count, begin + batch); };
        const auto pack = [&](std::size_t first, std::size_t last, std::byte* to) {
            parallel_chunks(last - first, kPackedAtOnce, [&](std::size_t begin, std::size_t end) {
                pack_few(first + begin, first + end, to + begin * record_size);
            });
        };
        pack(0, end_of(0), records[0].get());
        for (std::size_t begin = 0; begin < count; begin = end_of(begin)) {
            const std::size_t next = end_of(begin);
            parallel_both(
                [&] {
                    file_.write({reinterpret_cast<const char*>(records[0].get()), (next - begin) * record_size});
                },
                [&] { pack(next, end_of(next), records[1].get()); });
            std::swap(records[0], records[1]);
        }
    }

    void print_records() {
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
            for (const Column& column : columns_) column.print(v);
            end_line();
        }
        for (const Triangle& triangle : mesh_.triangles) {
            print_number(std::uint8_t{3});
            for (const VertexId v : triangle) print_number(v);
            end_line();
        }
    }

    template <class T>
    void print_number(T value) {
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
        file_.write('\n');
        at_line_start_ = true;
    }

    AtomicFile& file_;
    const Mesh& mesh_;
    bool is_text_;
    bool is_open_;
    bool at_line_start_ = true;
    std::string declarations_;
    std::size_t record_size_ = 0;  // bytes of a vertex
    std::vector<Column> columns_;
};

}  // namespace

void write_ply(AtomicFile& file, const Mesh& mesh, const WriteOptions& options) {
    PlyWriter(file, mesh, options).write();
}

}  // namespace meniscus

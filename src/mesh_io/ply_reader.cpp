// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/ply_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reading/numbers.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

enum class Type { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

struct TypeName {
    std::string_view name;
    Type type;
};

constexpr auto kTypeNames = std::to_array<TypeName>({
    {"char", Type::Int8},
    {"int8", Type::Int8},
    {"uchar", Type::UInt8},
    {"uint8", Type::UInt8},
    {"short", Type::Int16},
    {"int16", Type::Int16},
    {"ushort", Type::UInt16},
    {"uint16", Type::UInt16},
    {"int", Type::Int32},
    {"int32", Type::Int32},
    {"uint", Type::UInt32},
    {"uint32", Type::UInt32},
    {"float", Type::Float},
    {"float32", Type::Float},
    {"double", Type::Double},
    {"float64", Type::Double},
});

constexpr std::size_t size_of(Type type) {
    constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

struct Property {
    std::string_view name;
    Type type = Type::Float;
    std::optional<Type> count_type;  // of a list
};

struct Element {
    std::string_view name;
    std::uint64_t count = 0;
    std::vector<Property> properties;

    std::optional<std::size_t> place_of(std::string_view property) const {
        const auto found =
            std::find_if(properties.begin(), properties.end(), [&](const Property& p) { return p.name == property; });
        if (found == properties.end()) return std::nullopt;
        return static_cast<std::size_t>(found - properties.begin());
    }
};

enum class Coding { Text, LittleEndian, BigEndian };

struct Header {
    Coding coding = Coding::Text;
    std::vector<Element> elements;
    std::size_t end = 0;  // where the data begin
};

// Lines up to end_header. Bytes behind it are no lines.
class HeaderReader {
public:
    explicit HeaderReader(const MeshFile& file) : file_(file), lines_(file.bytes) {}

    Header read() {
        if (!next() || keyword_ != "ply") fail("the file does not begin with ply; give it the suffix of its format");
        while (true) {
            if (!next()) fail("the file ends within its header; fetch it again");
            if (keyword_ == "end_header") break;
            read_line();
        }
        if (!has_format_) fail("the header does not say the format; write the file again");
        header_.end = lines_.end();
        return std::move(header_);
    }

private:
    bool next() {
        if (!lines_.next()) return false;
        std::string_view line = lines_.line();
        if (line.ends_with('\r')) line.remove_suffix(1);
        words_ = Words(line);
        keyword_ = words_.next();
        return true;
    }

    void read_line() {
        if (keyword_ == "format") return read_format();
        if (keyword_ == "element") return read_element();
        if (keyword_ == "property") return read_property();
        if (!keyword_.empty() && keyword_ != "comment" && keyword_ != "obj_info")
            fail(shown(keyword_) + " is not a keyword of a PLY header; correct it");
    }

    void read_format() {
        const std::string_view word = words_.next();
        has_format_ = true;
        if (word == "ascii") return void(header_.coding = Coding::Text);
        if (word == "binary_little_endian") return void(header_.coding = Coding::LittleEndian);
        if (word == "binary_big_endian") return void(header_.coding = Coding::BigEndian);
        fail("format " + shown(word) + " is unknown; it must be ascii, binary_little_endian or binary_big_endian");
    }

    void read_element() {
        Element element;
        element.name = words_.next();
        const std::string_view word = words_.next();
        const auto count = whole_number<std::uint64_t>(word);
        if (!count) fail("the number of elements " + shown(word) + " is not a whole number of at least 0; correct it");
        element.count = *count;
        header_.elements.push_back(element);
    }

    void read_property() {
        if (header_.elements.empty()) fail("a property before the first element; correct the header");
        Property property;
        std::string_view word = words_.next();
        if (word == "list") {
            property.count_type = type_of(words_.next());
            if (*property.count_type == Type::Float || *property.count_type == Type::Double)
                fail("the length of a list must have the type of a whole number; correct its type");
            word = words_.next();
        }
        property.type = type_of(word);
        property.name = words_.next();
        if (property.name.empty()) fail("a property without a name; correct the header");
        header_.elements.back().properties.push_back(property);
    }

    Type type_of(std::string_view word) const {
        const auto* found =
            std::find_if(kTypeNames.begin(), kTypeNames.end(), [&](const TypeName& t) { return t.name == word; });
        if (found == kTypeNames.end()) fail(shown(word) + " is not a type of PLY; correct it");
        return found->type;
    }

    [[noreturn]] void fail(const std::string& message) const {
        fail_at(file_.path, {std::max<std::size_t>(lines_.number(), 1), words_.column()}, message);
    }

    const MeshFile& file_;
    Lines lines_;
    Words words_{""};
    std::string_view keyword_;
    bool has_format_ = false;
    Header header_;
};

// Numbers of the data as text. Least sizes are for telling numbers that a file is too short to hold.
class TextSource {
public:
    TextSource(const MeshFile& file, const Header& header) : cursor_(file.path, file.bytes, header.end) {}

    double number(Type /*type*/) {
        const std::string_view word = cursor_.word("a number");
        const auto value = whole_number<double>(word);
        if (!value) fail(shown(word) + " is not a number; correct it");
        return *value;
    }
    void skip(Type type, std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i) number(type);
    }
    static std::size_t least_size(Type /*type*/) { return 1; }
    std::size_t bytes_left() const { return cursor_.bytes_left(); }
    bool at_end() { return cursor_.next().empty(); }
    [[noreturn]] void fail(const std::string& message) const { cursor_.fail(message); }

private:
    TextCursor cursor_;
};

class BinarySource {
public:
    BinarySource(const MeshFile& file, const Header& header)
        : cursor_(file.path, file.bytes, header.end,
                  header.coding == Coding::BigEndian ? std::endian::big : std::endian::little) {}

    double number(Type type) {
        switch (type) {
            case Type::Int8:
                return take<std::int8_t>();
            case Type::UInt8:
                return take<std::uint8_t>();
            case Type::Int16:
                return take<std::int16_t>();
            case Type::UInt16:
                return take<std::uint16_t>();
            case Type::Int32:
                return take<std::int32_t>();
            case Type::UInt32:
                return take<std::uint32_t>();
            case Type::Float:
                return take<float>();
            default:
                return take<double>();
        }
    }
    void skip(Type type, std::uint64_t count) { cursor_.skip(size_of(type) * count, "a list"); }
    static std::size_t least_size(Type type) { return size_of(type); }
    std::size_t bytes_left() const { return cursor_.bytes_left(); }
    bool at_end() const { return cursor_.bytes_left() == 0; }
    [[noreturn]] void fail(const std::string& message) const { cursor_.fail(message); }

private:
    template <class T>
    double take() {
        return static_cast<double>(cursor_.take<T>("a number"));
    }
    BinaryCursor cursor_;
};

template <class Source>
class DataReader {
public:
    DataReader(const MeshFile& file, const Header& header) : file_(file), header_(header), source_(file, header) {}

    Mesh read() {
        for (const Element& element : header_.elements) {
            check_size(element);
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else
                skip(element);
        }
        if (!source_.at_end()) source_.fail("the file continues after its last element; correct its header");
        return std::move(mesh_);
    }

private:
    // Nothing is allocated, and no loop begun, for what the file is too short to hold.
    void check_size(const Element& element) const {
        std::uint64_t least = 0;
        for (const Property& p : element.properties) least += Source::least_size(p.count_type.value_or(p.type));
        if (element.count > 0 && (least == 0 || element.count > source_.bytes_left() / least + 1))
            source_.fail("the header says " + std::to_string(element.count) + " of element " + shown(element.name) +
                         ", which do not fit into this file; is it cut off?");
    }

    void read_vertices(const Element& element) {
        const std::array places{element.place_of("x"), element.place_of("y"), element.place_of("z")};
        for (const auto& place : places)
            if (!place || element.properties[*place].count_type)
                source_.fail("vertices need properties x, y and z that are numbers; write the file again");
        check_vertex_count(file_.path, mesh_.vertices.size() + element.count);
        mesh_.vertices.reserve(mesh_.vertices.size() + element.count);
        for (std::uint64_t v = 0; v < element.count; ++v) {
            std::array<double, 3> point{};
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const double value = number_or_skip(element.properties[p]);
                for (std::size_t i = 0; i < places.size(); ++i)
                    if (p == *places[i]) point[i] = coordinate(value);
            }
            mesh_.vertices.push_back({point[0], point[1], point[2]});
        }
        vertices_are_read_ = true;
    }

    double coordinate(double value) const {
        if (!std::isfinite(value)) source_.fail("a coordinate is not a finite number; correct it");
        return value;
    }

    void read_faces(const Element& element) {
        auto place = element.place_of("vertex_indices");
        if (!place) place = element.place_of("vertex_index");
        if (!place || !element.properties[*place].count_type)
            source_.fail("faces need a list vertex_indices; write the file again");
        if (!vertices_are_read_ && element.count > 0) source_.fail("faces come before vertices; write the file again");
        for (std::uint64_t f = 0; f < element.count; ++f)
            for (std::size_t p = 0; p < element.properties.size(); ++p)
                if (p == *place)
                    read_corners(element.properties[p]);
                else
                    number_or_skip(element.properties[p]);
    }

    void read_corners(const Property& list) {
        corners_.resize(length_of(list));
        for (VertexId& corner : corners_) {
            const double number = source_.number(list.type);
            if (!(number >= 0.0 && number < static_cast<double>(mesh_.vertices.size()) && number == std::floor(number)))
                source_.fail("a corner of a face names a vertex that is not among the " +
                             std::to_string(mesh_.vertices.size()) + "; correct it");
            corner = static_cast<VertexId>(number);
        }
        if (corners_.size() < 3) source_.fail("a face with fewer than three corners; leave it out");
        add_polygon(mesh_, corners_);
    }

    void skip(const Element& element) {
        if (element.name == "tristrips")
            source_.fail("strips of triangles are not supported; write the mesh again with faces");
        for (std::uint64_t i = 0; i < element.count; ++i)
            for (const Property& property : element.properties) number_or_skip(property);
    }

    // 0 for a list.
    double number_or_skip(const Property& property) {
        if (!property.count_type) return source_.number(property.type);
        source_.skip(property.type, length_of(property));
        return 0.0;
    }

    std::uint64_t length_of(const Property& list) {
        const double length = source_.number(*list.count_type);
        const std::size_t most = source_.bytes_left() / Source::least_size(list.type);
        if (!(length >= 0.0 && length <= static_cast<double>(most) && length == std::floor(length)))
            source_.fail("a list of a length that does not fit into this file; correct it");
        return static_cast<std::uint64_t>(length);
    }

    const MeshFile& file_;
    const Header& header_;
    Source source_;
    Mesh mesh_;
    std::vector<VertexId> corners_;
    bool vertices_are_read_ = false;
};

}  // namespace

Mesh read_ply(const MeshFile& file) {
    const Header header = HeaderReader(file).read();
    if (header.coding == Coding::Text) return DataReader<TextSource>(file, header).read();
    return DataReader<BinarySource>(file, header).read();
}

}  // namespace meniscus::reading

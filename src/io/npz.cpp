// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/npz.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/labels.h"
#include "io/options_json.h"
#include "io/vertex_arrays.h"
#include "io/zip_writer.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are written as the numbers are in memory");

constexpr std::uint32_t kLayout = 1;
constexpr std::size_t kAlignment = 64;  // of the values in a .npy file
constexpr char32_t kReplacement = 0xfffd;

/// How an element looks to numpy: the letters of its type, and how many there are in a row.
template <class T>
struct Element;
template <>
struct Element<double> {
    static constexpr const char* kType = "<f8";
};
template <>
struct Element<float> {
    static constexpr const char* kType = "<f4";
};
/// Indices, all below 2^31, are read as signed numbers: torch knows no others of this size.
template <>
struct Element<std::uint32_t> {
    static constexpr const char* kType = "<i4";
};
template <>
struct Element<std::int32_t> {
    static constexpr const char* kType = "<i4";
};
template <>
struct Element<PatchKind> {
    static constexpr const char* kType = "|u1";
};
template <>
struct Element<Vec3> {
    static constexpr const char* kType = "<f8";
    static constexpr int kColumns = 3;
};
template <>
struct Element<Triangle> {
    static constexpr const char* kType = "<i4";
    static constexpr int kColumns = 3;
};
template <>
struct Element<Colour> {
    static constexpr const char* kType = "|u1";
    static constexpr int kColumns = 4;
};
template <>
struct Element<PocketFeatures> {
    static constexpr const char* kType = "<f4";
    static constexpr int kColumns = kPocketFeatures;
};

template <class T>
std::string shape_of(std::size_t count) {
    if constexpr (requires { Element<T>::kColumns; })
        return "(" + std::to_string(count) + ", " + std::to_string(Element<T>::kColumns) + ")";
    else
        return "(" + std::to_string(count) + ",)";
}

std::string header_of(const std::string& type, const std::string& shape) {
    std::string text = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
    const std::string magic("\x93NUMPY\x01\x00", 8);
    const std::size_t size = magic.size() + sizeof(std::uint16_t) + text.size() + 1;
    text.resize(text.size() + (kAlignment - size % kAlignment) % kAlignment, ' ');
    text += '\n';
    const auto length = static_cast<std::uint16_t>(text.size());
    return magic + std::string(reinterpret_cast<const char*>(&length), sizeof length) + text;
}

// Takes one letter off a text in UTF-8; bytes that are none become the replacement character.
char32_t take_letter(std::string_view& text) {
    const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80        ? 1
                               : first >> 5U == 6  ? 2
                               : first >> 4U == 14 ? 3
                               : first >> 3U == 30 ? 4
                                                   : 0;
    bool valid = length > 0 && length <= text.size();
    char32_t letter = length == 1 ? first : first & (0xffU >> (length + 1));
    for (std::size_t i = 1; valid && i < length; ++i) {
        valid = byte(i) >> 6U == 2;
        letter = (letter << 6U) | (byte(i) & 0x3fU);
    }
    text.remove_prefix(valid ? length : 1);
    return valid && letter <= 0x10ffff && letter >> 11U != 0x1b ? letter : kReplacement;  // no surrogates
}

std::u32string letters_of(std::string_view text) {
    std::u32string letters;
    while (!text.empty()) letters += take_letter(text);
    return letters;
}

class NpzWriter {
public:
    explicit NpzWriter(AtomicFile& file) : zip_(file) {}

    template <class Values>
    void add(const std::string& name, const Values& values) {
        using T = typename Values::value_type;
        if constexpr (std::is_same_v<T, SmallVec3>)  // as positions are: readers compute with both
            add(name, std::vector<Vec3>(values.begin(), values.end()));
        else
            add_bytes(name, header_of(Element<T>::kType, shape_of<T>(values.size())),
                      {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    }

    /// Text of one shape: "()" for a single one.
    void add_text(const std::string& name, const std::vector<std::u32string>& texts, const std::string& shape) {
        std::size_t width = 1;  // numpy has none of zero
        for (const std::u32string& text : texts) width = std::max(width, text.size());
        std::u32string content;
        for (std::u32string text : texts) {
            text.resize(width);
            content += text;
        }
        add_bytes(name, header_of("<U" + std::to_string(width), shape),
                  {reinterpret_cast<const char*>(content.data()), content.size() * sizeof(char32_t)});
    }

    void add_number(const std::string& name, const std::uint32_t& number) {
        add_bytes(name, header_of("<u4", "()"), {reinterpret_cast<const char*>(&number), sizeof number});
    }

    void finish() { zip_.finish(); }

private:
    void add_bytes(const std::string& name, const std::string& header, std::string_view bytes) {
        const auto fits = [](unsigned char c) { return c > 32 && c < 127 && c != '/' && c != '\\' && c != ':'; };
        if (!std::all_of(name.begin(), name.end(), fits))
            throw UsageError("NPZ cannot hold the name '" + name + "'; use letters, digits and underscores");
        if (!names_.insert(name).second) throw UsageError("two arrays would both be '" + name + "' in NPZ");
        zip_.add(name + ".npy", std::array<std::string_view, 2>{header, bytes});
    }

    ZipWriter zip_;
    std::set<std::string> names_;
};

/// The columns of NAME.atoms.csv.
class AtomColumns {
public:
    AtomColumns(NpzWriter& npz, const Structure& structure) : npz_(npz), structure_(structure) {
        check_labels(structure);
        npz_.add("atom_xyz", structure.atoms.centres);
        npz_.add("atom_radius", structure.atoms.radii);
        add_texts("atom_name", [](const AtomLabel& label, const Residue&) { return label.name; });
        add_texts("atom_element", [](const AtomLabel& label, const Residue&) { return label.element; });
        add_texts("atom_altloc", [](const AtomLabel& label, const Residue&) { return std::string(1, label.altloc); });
        add_texts("atom_chain", [](const AtomLabel&, const Residue& residue) { return residue.chain; });
        add_texts("atom_resname", [](const AtomLabel&, const Residue& residue) { return residue.name; });
        add_texts("atom_icode",
                  [](const AtomLabel&, const Residue& residue) { return std::string(1, residue.insertion_code); });
        add_numbers<std::int32_t>("atom_resnum",
                                  [](const AtomLabel&, const Residue& residue) { return residue.number; });
        add_numbers<std::uint32_t>("atom_residue",
                                   [](const AtomLabel& label, const Residue&) { return label.residue; });
        add_numbers<std::int32_t>("atom_serial", [](const AtomLabel& label, const Residue&) { return label.serial; });
        add_numbers<double>("atom_b_factor", [](const AtomLabel& label, const Residue&) { return label.b_factor; });
        add_numbers<double>("atom_occupancy", [](const AtomLabel& label, const Residue&) { return label.occupancy; });
        add_numbers<double>("atom_charge", [](const AtomLabel& label, const Residue&) { return label.charge; });
    }

private:
    template <class T, class Get>
    void add_numbers(const std::string& name, const Get& get) {
        std::vector<T> values;
        values.reserve(structure_.labels.size());
        for (std::size_t i = 0; i < structure_.labels.size(); ++i)
            values.push_back(get(structure_.labels[i], residue_of(structure_, i)));
        npz_.add(name, values);
    }

    template <class Get>
    void add_texts(const std::string& name, const Get& get) {
        std::vector<std::u32string> texts;
        texts.reserve(structure_.labels.size());
        for (std::size_t i = 0; i < structure_.labels.size(); ++i)
            texts.push_back(letters_of(get(structure_.labels[i], residue_of(structure_, i))));
        npz_.add_text(name, texts, "(" + std::to_string(texts.size()) + ",)");
    }

    NpzWriter& npz_;
    const Structure& structure_;
};

template <class Row, class T>
void add_member(NpzWriter& npz, const std::string& name, const std::vector<Row>& rows, T Row::*member) {
    std::vector<T> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(row.*member);
    npz.add(name, values);
}

// What voxels and points both have.
void add_voxels(NpzWriter& npz, const std::string& prefix, const std::vector<PocketVoxel>& voxels) {
    add_member(npz, prefix + "xyz", voxels, &PocketVoxel::position);
    add_member(npz, prefix + "depth", voxels, &PocketVoxel::depth);
    add_member(npz, prefix + "probability", voxels, &PocketVoxel::probability);
}

void add_pockets(NpzWriter& npz, const std::vector<Pocket>& pockets) {
    add_member(npz, "pocket_score", pockets, &Pocket::score);
    add_member(npz, "pocket_probability", pockets, &Pocket::probability);
    add_member(npz, "pocket_volume", pockets, &Pocket::volume);
    add_member(npz, "pocket_wall_area", pockets, &Pocket::wall_area);
    add_member(npz, "pocket_depth", pockets, &Pocket::depth);
    add_member(npz, "pocket_centre", pockets, &Pocket::centre);
    add_member(npz, "pocket_deepest", pockets, &Pocket::deepest);
    std::vector<std::uint32_t> cavity;
    cavity.reserve(pockets.size());
    for (const Pocket& pocket : pockets) cavity.push_back(pocket.cavity ? 1 : 0);
    npz.add("pocket_cavity", cavity);
}

}  // namespace

void write_npz(AtomicFile& file, const Mesh& mesh, const WriteOptions& options) {
    NpzWriter npz(file);
    npz.add("vertices", mesh.vertices);
    npz.add("triangles", mesh.triangles);
    for_each_vertex_array(mesh, options, [&npz](const std::string& name, auto values) { npz.add(name, values); });
    if (options.structure != nullptr) AtomColumns(npz, *options.structure);
    if (options.structure != nullptr && options.computed_with != nullptr)
        npz.add_text("options", {letters_of(options_json(*options.computed_with, *options.structure))}, "()");
    if (options.open) npz.add_number("open", 1);
    npz.add_number("layout", kLayout);
    npz.finish();
}

void write_pocket_arrays(const std::string& path, const Pockets& pockets) {
    AtomicFile file(path);
    NpzWriter npz(file);
    add_pockets(npz, pockets.pockets);
    add_voxels(npz, "voxel_", pockets.voxels);
    add_member(npz, "voxel_share", pockets.voxels, &PocketVoxel::share);
    add_member(npz, "voxel_pocket", pockets.voxels, &PocketVoxel::pocket);
    std::vector<PocketVoxel> points;
    for (const std::uint32_t v : pockets.points) points.push_back(pockets.voxels[v]);
    npz.add("point_voxel", pockets.points);
    add_voxels(npz, "point_", points);
    npz.add("point_features", pockets.features);
    std::vector<std::u32string> names;
    for (const std::string_view name : pocket_feature_names()) names.push_back(letters_of(name));
    npz.add_text("feature_names", names, "(" + std::to_string(names.size()) + ",)");
    npz.add_number("layout", kLayout);
    npz.finish();
    file.commit();
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <tuple>

#include "arrays.h"
#include "bindings.h"
#include "drawing_options.h"
#include "meniscus/colours.h"
#include "meniscus/describe_pockets.h"
#include "meniscus/draw_surface.h"
#include "meniscus/errors.h"
#include "meniscus/field.h"
#include "meniscus/file_words.h"
#include "meniscus/level_set_file.h"
#include "meniscus/ligand_bodies.h"
#include "meniscus/mesh_part.h"
#include "meniscus/page.h"
#include "meniscus/picture.h"
#include "meniscus/pocket_chemistry.h"
#include "meniscus/pockets.h"
#include "meniscus/vertex_values.h"
#include "meniscus/volume_file.h"
#include "meniscus/write.h"
#include "options.h"
#include "platform/files/atomic_file.h"

namespace meniscus::python {

namespace {

using Bytes = py::array_t<std::uint8_t, py::array::c_style>;

/// What is drawn: a scheme by its word, perhaps with a range, values by their name, or one colour per vertex.
struct Colouring {
    ColourOptions options;
    std::vector<Colour> given;
    std::vector<VertexValues> values;

    explicit Colouring(const py::dict& asked) {
        if (asked.contains("values")) take_values(asked["values"].cast<py::dict>());
        if (asked.contains("color")) choose(asked["color"].cast<std::string>());
        if (asked.contains("range")) {
            const auto [min, max] = asked["range"].cast<std::pair<double, double>>();
            options.range = ValueRange{min, max};
        }
        if (asked.contains("colors")) take(asked["colors"].cast<Bytes>());
        Options(asked).read("threads", threads_);
    }

    std::vector<Colour> of(const Mesh& mesh, const Structure& structure) const {
        return given.empty() ? colour_vertices(mesh, structure, options) : given;
    }

    /// With the values that were given, and those that the scheme brings along.
    ///
    /// pockets   those of pockets_of(), where they have been found already
    Mesh complete(const Mesh& mesh, const Structure& structure, const ExactSurface& exact,
                  const Pockets* pockets = nullptr) const {
        Mesh with = mesh;
        if (options.scheme == ColourScheme::Depth && given.empty() && !has_values("depth"))
            with.values.push_back(depth_values(mesh, exact));
        if (const auto more = values_of_scheme(options.scheme, structure))
            with.values.push_back(values_at_vertices(mesh, *more));
        with.values.insert(with.values.end(), values.begin(), values.end());
        if (wants_pockets())
            with.values.push_back(pocket_values(pockets != nullptr ? *pockets : pockets_of(structure, exact), mesh));
        return with;
    }

    /// Whether the scheme needs pockets_of().
    bool wants_pockets() const {
        return options.scheme == ColourScheme::Pocket && given.empty() && !has_values(kPocketValues);
    }

    /// Those of `meniscus surface --color pocket`: for any surface those of the SES.
    Pockets pockets_of(const Structure& structure, const ExactSurface& exact) const {
        const PocketOptions standard;
        RunOptions run;
        run.threads = threads_;
        return find_pockets(exact.of_same_atoms({SurfaceKind::Ses, standard.probe}), atom_classes(structure), standard,
                            run);
    }

private:
    bool has_values(const std::string& name) const {
        return std::any_of(values.begin(), values.end(), [&](const VertexValues& v) { return v.name == name; });
    }

    /// A scheme, the name of values that are given, or a colour.
    void choose(const std::string& word) {
        const bool is_scheme = is_word_of(kColourSchemeWords, word);
        if (!is_scheme && !has_values(word)) options.colour = colour_of_text(word);
        const bool of_values = !is_scheme && !options.colour && is_value_name(word) && !values.empty();
        if (of_values) options.value = word;
        if (options.colour)
            options.scheme = ColourScheme::Single;
        else
            options.scheme = of_values ? ColourScheme::Value : scheme_of(word);
    }

    static ColourScheme scheme_of(const std::string& word) {
        try {
            return parse_word("color", word, kColourSchemeWords);
        } catch (const UsageError& error) {
            throw UsageError(std::string(error.what()) + ", or a colour such as tomato or #ff6347");
        }
    }

    void take_values(const py::dict& arrays) {
        for (const auto& [name, array] : arrays) {
            const auto numbers = array.cast<py::array_t<float, py::array::c_style>>();
            values.push_back({name.cast<std::string>(), {numbers.data(), numbers.data() + numbers.size()}});
        }
    }

    void take(const Bytes& colours) {
        const auto rows = colours.unchecked<2>();
        for (py::ssize_t i = 0; i < rows.shape(0); ++i)
            given.push_back({rows(i, 0), rows(i, 1), rows(i, 2), rows(i, 3)});
    }

    int threads_ = 0;
};

/// Four numbers per vertex.
py::array colours(const Mesh& mesh, const Structure& structure, const ExactSurface& exact, const py::dict& given) {
    const Colouring colouring(given);
    std::vector<Colour> result;
    {
        const py::gil_scoped_release release;
        result = colouring.of(colouring.complete(mesh, structure, exact), structure);
    }
    return given_away(std::move(result));
}

/// What every mesh is written with.
WriteOptions write_options(const Structure& structure, const py::dict& given) {
    WriteOptions options{.structure = &structure};
    bool ascii = false;
    Options(given).read("threads", options.threads);
    Options(given).read("ascii", ascii);
    options.encoding = ascii ? Encoding::Text : Encoding::Binary;
    return options;
}

void save_points(const std::string& path, const Mesh& points, const Structure& structure, const ExactSurface& exact,
                 const py::dict& given) {
    const Colouring colouring(given);
    WriteOptions options = write_options(structure, given);
    const py::gil_scoped_release release;
    const Mesh complete = colouring.complete(points, structure, exact);
    const std::vector<Colour> colours = colouring.of(complete, structure);
    options.colours = colours;
    write_mesh(path, complete, options);
}

/// What of a surface is written: all of it, the part of some atoms, or the wall of a cavity.
class Shown {
public:
    explicit Shown(const py::dict& given) {
        Options(given).read("show", select_);
        Options(given).read("cavity_file", cavity_);
    }

    std::optional<MeshPart> part_of(const Mesh& mesh, const Surface& surface, const Structure& structure) const {
        if (!select_.empty()) return part_of_atoms(mesh, select_atoms(structure, select_, "show"));
        if (cavity_ != 0) return part_of_component(mesh, component(surface.measures));
        return std::nullopt;
    }

private:
    std::uint32_t component(const MeshMeasures& measures) const {
        int number = 0;
        for (std::uint32_t c = 0; c < measures.components.size(); ++c)
            if (measures.components[c].volume < 0.0 && ++number == cavity_) return c;
        throw UsageError("cavity " + std::to_string(cavity_) + ": the mesh has " + std::to_string(number));
    }

    std::string select_;
    int cavity_ = 0;  // from 1
};

std::vector<Colour> picked(const std::vector<Colour>& colours, const std::vector<VertexId>& vertices) {
    std::vector<Colour> result;
    result.reserve(vertices.size());
    for (const VertexId v : vertices) result.push_back(colours.at(v));
    return result;
}

void save_mesh(const std::string& path, const Surface& surface, const Structure& structure, const py::dict& given) {
    const Colouring colouring(given);
    const Shown shown(given);
    WriteOptions options = write_options(structure, given);
    options.computed_with = &surface.options;
    options.probe = surface.options.probe;
    const bool draws_ligands = with_ligands(given) && path.ends_with(".glb");
    const py::gil_scoped_release release;
    const Mesh complete = colouring.complete(surface.mesh, structure, surface.exact);
    std::vector<Colour> colours = colouring.of(complete, structure);
    const std::optional<MeshPart> part = shown.part_of(complete, surface, structure);
    if (part) colours = picked(colours, part->vertices);
    options.open = part && !measure_mesh(part->mesh).closed;
    options.colours = colours;
    const Mesh& written = part ? part->mesh : complete;
    const Bodies ligands = draws_ligands ? ligand_bodies(structure.ligands, written, colours) : Bodies{};
    options.beside = &ligands;
    write_mesh(path, written, options);
}

void save_picture(const std::string& path, const Surface& surface, const Structure& structure, const py::dict& given) {
    const Colouring colouring(given);
    DrawOptions options{.picture = picture_options(given)};
    if (colouring.given.empty()) options.scheme = colouring.options;
    Options(given).read("legend", options.legend);
    options.ligands = with_ligands(given);
    const py::gil_scoped_release release;
    const Mesh mesh = colouring.complete(surface.mesh, structure, surface.exact);
    const std::vector<Colour> colours = colouring.of(mesh, structure);
    write_picture(path, draw_surface(surface, structure, {mesh, colours}, options));
}

void save_page(const std::string& path, const Surface& surface, const Structure& structure, const Measures& exact,
               const py::dict& given) {
    const Colouring colouring(given);
    if (!colouring.given.empty()) throw UsageError(path + ": a page shows schemes; give it one");
    PageOptions options{.colours = colouring.options,
                        .viewpoint = viewpoint_of(given),
                        .projection = projection_of(given),
                        .ligands = with_ligands(given),
                        .rows = page_rows(structure, surface, exact),
                        .components = exact.components,
                        .exact = surface.exact};
    Options(given).read("threads", options.threads);
    const py::gil_scoped_release release;
    std::optional<Pockets> pockets;
    if (colouring.wants_pockets()) {
        pockets = colouring.pockets_of(structure, surface.exact);
        options.pockets = page_pockets(describe_pockets(*pockets, structure));
    }
    const Mesh mesh = colouring.complete(surface.mesh, structure, surface.exact, pockets ? &*pockets : nullptr);
    write_page(path, mesh, structure, options);
}

void save_level_set(const std::string& path, const Surface& surface) {
    if (!surface.level_set) throw UsageError(path + ": a surface of method direct has no level set; use method flow");
    const py::gil_scoped_release release;
    write_level_set(path, *surface.level_set);
}

/// A file that has it, three counts, spacing and middle, or the one round all atoms.
VolumeGrid grid_of(const py::dict& given, const Surface& surface) {
    if (given.contains("grid_file")) return read_volume_grid(given["grid_file"].cast<std::string>());
    const SurfaceOptions& made = surface.options;
    if (!given.contains("grid")) return enclosing_grid(surface.exact, made.spacing);
    const auto [counts, spacing, middle] =
        given["grid"].cast<std::tuple<std::array<std::size_t, 3>, double, std::array<double, 3>>>();
    return centred_grid(counts, spacing, vector_of(middle));
}

void save_volume(const std::string& path, const Surface& surface, const py::dict& given) {
    FieldOptions options;
    const Options words(given);
    words.read_word("field", options.content, kFieldWords);
    words.read("ion_radius", options.ion_radius);
    words.read("threads", options.threads);
    if (given.contains("eps"))
        std::tie(options.inner_dielectric, options.outer_dielectric) = given["eps"].cast<std::pair<double, double>>();
    std::optional<ApbsMap> map;
    if (given.contains("map")) words.read_word("map", map.emplace(), kApbsMapWords);
    const VolumeGrid grid = grid_of(given, surface);
    const py::gil_scoped_release release;
    if (map)
        write_volume(path, apbs_map(surface, grid, *map, options), content_of(*map));
    else
        write_volume(path, surface_field(surface, grid, options), options.content);
}

void save_values(const std::string& path, const Structure& structure, const Numbers& values) {
    const std::span<const double> numbers = numbers_of(values);
    const py::gil_scoped_release release;
    write_structure_copy(path, structure, numbers);
}

py::array map_values(const Mesh& mesh, const std::string& path, const py::dict& given) {
    SampleVolumeOptions options;
    Options(given).read("offset", options.offset);
    Options(given).read_word("interpolation", options.interpolation, kInterpolationWords);
    VertexValues values;
    {
        const py::gil_scoped_release release;
        values = sample_volume(mesh, "map", read_volume(path), options);
    }
    return given_away(std::move(values.values));
}

py::dict table_values(const Mesh& mesh, const Structure& structure, const std::string& path) {
    std::vector<VertexValues> all;
    {
        const py::gil_scoped_release release;
        const ValueTable table = read_value_table(path, structure);
        refuse_strange_table(table, path, structure);
        for (const AtomValues& column : table.columns) all.push_back(values_at_vertices(mesh, column));
    }
    py::dict arrays;
    for (VertexValues& values : all) arrays[py::str(values.name)] = given_away(std::move(values.values));
    return arrays;
}

/// A path is bytes of the system's own encoding; a pipe may make this wait for its reader.
void save_bytes(const std::string& path, const py::bytes& data) {
    const auto content = data.cast<std::string_view>();
    const py::gil_scoped_release release;
    AtomicFile file(path);
    file.reserve(content.size());
    file.write(content);
    file.commit();
}

/// Red, green, blue and alpha of a name of CSS or of "#rrggbb"; None for any other text.
py::object named_colour(const std::string& text) {
    const std::optional<Colour> colour = colour_of_text(text);
    if (!colour) return py::none();
    return py::make_tuple(colour->red, colour->green, colour->blue, colour->alpha);
}

using WithoutGil = py::call_guard<py::gil_scoped_release>;

}  // namespace

void bind_writers(py::module_& module) {
    module.def("named_color", &named_colour, py::arg("text"));
    module.def("colors", &colours, py::arg("mesh"), py::arg("structure"), py::arg("exact"), py::arg("options"));
    module.def("map_values", &map_values, py::arg("mesh"), py::arg("path"), py::arg("options"));
    module.def("table_values", &table_values, py::arg("mesh"), py::arg("structure"), py::arg("path"));
    module.def("write_mesh", &save_mesh, py::arg("path"), py::arg("surface"), py::arg("structure"), py::arg("options"));
    module.def("write_points", &save_points, py::arg("path"), py::arg("points"), py::arg("structure"), py::arg("exact"),
               py::arg("options"));
    module.def("write_picture", &save_picture, py::arg("path"), py::arg("surface"), py::arg("structure"),
               py::arg("options"));
    module.def("write_page", &save_page, py::arg("path"), py::arg("surface"), py::arg("structure"), py::arg("measures"),
               py::arg("options"));
    module.def("write_bytes", &save_bytes, py::arg("path"), py::arg("data"));
    module.def("write_level_set", &save_level_set, py::arg("path"), py::arg("surface"));
    module.def("write_volume", &save_volume, py::arg("path"), py::arg("surface"), py::arg("options"));
    module.def("write_spheres", &write_spheres, py::arg("path"), py::arg("structure"), WithoutGil());
    module.def("write_atom_table", &write_atom_table, py::arg("path"), py::arg("structure"), WithoutGil());
    module.def("write_structure_copy", &save_values, py::arg("path"), py::arg("structure"), py::arg("values"));
}

}  // namespace meniscus::python

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <algorithm>

#include "arrays.h"
#include "bindings.h"
#include "held_surface.h"
#include "meniscus/colours.h"
#include "meniscus/errors.h"
#include "meniscus/level_set_file.h"
#include "meniscus/picture.h"
#include "meniscus/write.h"
#include "options.h"

namespace meniscus::python {

namespace {

constexpr Words<ColourScheme, 13> kSchemes{{{"auto", ColourScheme::Automatic},
                                            {"single", ColourScheme::Single},
                                            {"patch", ColourScheme::Patch},
                                            {"element", ColourScheme::Element},
                                            {"chain", ColourScheme::Chain},
                                            {"residue", ColourScheme::Residue},
                                            {"residue-patch", ColourScheme::ResiduePatch},
                                            {"hydrophobicity", ColourScheme::Hydrophobicity},
                                            {"curvature", ColourScheme::Curvature},
                                            {"component", ColourScheme::Component},
                                            {"depth", ColourScheme::Depth},
                                            {"bfactor", ColourScheme::BFactor},
                                            {"plddt", ColourScheme::Plddt}}};

using Bytes = py::array_t<std::uint8_t, py::array::c_style>;

/// What is drawn: a scheme by its word, perhaps with a range, or one colour per vertex.
struct Colouring {
    ColourOptions options;
    std::vector<Colour> given;

    explicit Colouring(const py::dict& asked) {
        const Options words(asked);
        words.read_word("color", options.scheme, kSchemes);
        if (asked.contains("range")) {
            const auto [min, max] = asked["range"].cast<std::pair<double, double>>();
            options.range = ValueRange{min, max};
        }
        if (asked.contains("colors")) take(asked["colors"].cast<Bytes>());
    }

    std::vector<Colour> of(const Mesh& mesh, const Structure& structure) const {
        return given.empty() ? colour_vertices(mesh, structure, options) : given;
    }

private:
    void take(const Bytes& colours) {
        const auto rows = colours.unchecked<2>();
        for (py::ssize_t i = 0; i < rows.shape(0); ++i)
            given.push_back({rows(i, 0), rows(i, 1), rows(i, 2), rows(i, 3)});
    }
};

/// Four numbers per vertex.
py::array colours(const Mesh& mesh, const Structure& structure, const py::dict& given) {
    const Colouring colouring(given);
    std::vector<Colour> result;
    {
        const py::gil_scoped_release release;
        result = colouring.of(mesh, structure);
    }
    return owning(std::move(result));
}

void save_mesh(const std::string& path, const Mesh& mesh, const Structure& structure, const py::dict& given) {
    const Colouring colouring(given);
    bool ascii = false;
    Options(given).read("ascii", ascii);
    const py::gil_scoped_release release;
    std::vector<std::uint32_t> residues(mesh.atoms.size());
    std::transform(mesh.atoms.begin(), mesh.atoms.end(), residues.begin(),
                   [&](std::uint32_t atom) { return structure.labels[atom].residue; });
    const std::vector<Colour> colours = colouring.of(mesh, structure);
    write_mesh(
        path, mesh,
        {.encoding = ascii ? Encoding::Text : Encoding::Binary, .extra = {{"residue", residues}}, .colours = colours});
}

Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

PictureOptions picture_options(const py::dict& given) {
    const Options options(given);
    PictureOptions picture;
    options.read("width", picture.width);
    options.read("height", picture.height);
    options.read("outline", picture.outline);
    options.read("depth_cue", picture.depth_cue);
    if (given.contains("view")) {
        const auto [from, up] = given["view"].cast<std::pair<std::array<double, 3>, std::array<double, 3>>>();
        picture.viewpoint = Viewpoint{vector_of(from), vector_of(up)};
    }
    bool perspective = false;
    options.read("perspective", perspective);
    if (perspective) picture.projection = Projection::Perspective;
    if (given.contains("background")) {
        const auto c = given["background"].cast<std::array<std::uint8_t, 4>>();
        picture.background = {c[0], c[1], c[2], c[3]};
    }
    return picture;
}

/// Sharp borders where they are known at any point; colours that were given are known at the vertices.
ColourField field_of(const HeldSurface& held, const Colouring& colouring) {
    if (!colouring.given.empty()) return {};
    ColourField field;
    if (const auto& level_set = held.surface().level_set) field = colour_by_level_set(*level_set, colouring.options);
    if (!field) field = colour_by_feature(held.accessible(), held.structure(), colouring.options);
    return field;
}

void save_picture(const std::string& path, const HeldSurface& held, const py::dict& given) {
    const Colouring colouring(given);
    const PictureOptions options = picture_options(given);
    const py::gil_scoped_release release;
    const Mesh& mesh = held.surface().mesh;
    write_picture(path, draw_picture(mesh, colouring.of(mesh, held.structure()), options, field_of(held, colouring)));
}

void save_level_set(const std::string& path, const HeldSurface& held) {
    if (!held.surface().level_set)
        throw UsageError(path + ": a surface of method direct has no level set; take method flow");
    const py::gil_scoped_release release;
    write_level_set(path, *held.surface().level_set);
}

void save_values(const std::string& path, const Structure& structure, const Numbers& values) {
    const std::span<const double> numbers = numbers_of(values);
    const py::gil_scoped_release release;
    write_structure_copy(path, structure, numbers);
}

using WithoutGil = py::call_guard<py::gil_scoped_release>;

}  // namespace

void bind_writers(py::module_& module) {
    module.def("colors", &colours, py::arg("mesh"), py::arg("structure"), py::arg("options"));
    module.def("write_mesh", &save_mesh, py::arg("path"), py::arg("mesh"), py::arg("structure"), py::arg("options"));
    module.def("write_picture", &save_picture, py::arg("path"), py::arg("surface"), py::arg("options"));
    module.def("write_level_set", &save_level_set, py::arg("path"), py::arg("surface"));
    module.def("write_spheres", &write_spheres, py::arg("path"), py::arg("structure"), WithoutGil());
    module.def("write_atom_table", &write_atom_table, py::arg("path"), py::arg("structure"), WithoutGil());
    module.def("write_structure_copy", &save_values, py::arg("path"), py::arg("structure"), py::arg("values"));
}

}  // namespace meniscus::python

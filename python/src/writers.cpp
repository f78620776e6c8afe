// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

#include "arrays.h"
#include "bindings.h"
#include "held_surface.h"
#include "meniscus/colours.h"
#include "meniscus/errors.h"
#include "meniscus/legend.h"
#include "meniscus/level_set_file.h"
#include "meniscus/page.h"
#include "meniscus/picture.h"
#include "meniscus/write.h"
#include "options.h"

namespace meniscus::python {

namespace {

using Bytes = py::array_t<std::uint8_t, py::array::c_style>;

/// What is drawn: a scheme by its word, perhaps with a range, or one colour per vertex.
struct Colouring {
    ColourOptions options;
    std::vector<Colour> given;

    explicit Colouring(const py::dict& asked) {
        const Options words(asked);
        words.read_word("color", options.scheme, kColourSchemeWords);
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
    std::optional<double> probe;
    int threads = 0;
    Options(given).read("threads", threads);
    Options(given).read("ascii", ascii);
    Options(given).read("probe", probe);
    const py::gil_scoped_release release;
    const std::vector<Colour> colours = colouring.of(mesh, structure);
    write_mesh(path, mesh,
               {.encoding = ascii ? Encoding::Text : Encoding::Binary,
                .colours = colours,
                .structure = &structure,
                .probe = probe,
                .threads = threads});
}

Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

std::optional<Viewpoint> viewpoint_of(const py::dict& given) {
    if (!given.contains("view")) return std::nullopt;
    const auto [from, up] = given["view"].cast<std::pair<std::array<double, 3>, std::array<double, 3>>>();
    return Viewpoint{vector_of(from), vector_of(up)};
}

Projection projection_of(const py::dict& given) {
    bool perspective = false;
    Options(given).read("perspective", perspective);
    return perspective ? Projection::Perspective : Projection::Orthographic;
}

/// Nothing, or where the plane is: "auto", a depth, the number of a cavity, or a point and perhaps a normal.
std::optional<Cut> cut_of(const py::dict& given) {
    if (!given.contains("cut")) return std::nullopt;
    const auto asked = given["cut"].cast<py::dict>();
    const Options options(asked);
    Cut cut;
    if (asked.contains("cavity")) cut.through = Cut::Through::Cavity;
    if (asked.contains("depth")) cut.through = Cut::Through::Depth;
    options.read("cavity", cut.cavity);
    options.read("depth", cut.depth);
    if (asked.contains("point")) {
        cut.through = Cut::Through::Point;
        cut.point = vector_of(asked["point"].cast<std::array<double, 3>>());
    }
    if (asked.contains("normal")) cut.normal = vector_of(asked["normal"].cast<std::array<double, 3>>());
    return cut;
}

PictureOptions picture_options(const py::dict& given) {
    const Options options(given);
    PictureOptions picture;
    options.read("width", picture.width);
    options.read("height", picture.height);
    options.read("outline", picture.outline);
    options.read("depth_cue", picture.depth_cue);
    options.read("threads", picture.threads);
    picture.viewpoint = viewpoint_of(given);
    picture.projection = projection_of(given);
    picture.cut = cut_of(given);
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

/// With the legend at its right, if one is asked for.
Picture draw(const HeldSurface& held, const Colouring& colouring, PictureOptions options, bool with_legend) {
    const Mesh& mesh = held.surface().mesh;
    Picture legend{0, options.height, {}};
    if (with_legend)
        legend = draw_legend(make_legend(mesh, held.structure(), colouring.options),
                             {.width = options.width / 2, .height = options.height, .background = options.background});
    options.width -= legend.width;
    return side_by_side(draw_picture(mesh, colouring.of(mesh, held.structure()), options, field_of(held, colouring)),
                        legend);
}

void save_picture(const std::string& path, const HeldSurface& held, const py::dict& given) {
    const Colouring colouring(given);
    const PictureOptions options = picture_options(given);
    bool legend = false;
    Options(given).read("legend", legend);
    if (legend && !colouring.given.empty())
        throw UsageError("legend: tells what a scheme means; there is none for colours that are given");
    const py::gil_scoped_release release;
    write_picture(path, draw(held, colouring, options, legend));
}

void save_page(const std::string& path, const HeldSurface& held, const Measures& exact, const py::dict& given) {
    const Colouring colouring(given);
    if (!colouring.given.empty()) throw UsageError(path + ": a page shows schemes; give it one");
    PageOptions options{.colours = colouring.options,
                        .viewpoint = viewpoint_of(given),
                        .projection = projection_of(given),
                        .rows = page_rows(held.structure(), held.surface(), exact),
                        .components = exact.components};
    Options(given).read("threads", options.threads);
    const py::gil_scoped_release release;
    write_page(path, held.surface().mesh, held.structure(), options);
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
    module.def("write_page", &save_page, py::arg("path"), py::arg("surface"), py::arg("measures"), py::arg("options"));
    module.def("write_level_set", &save_level_set, py::arg("path"), py::arg("surface"));
    module.def("write_spheres", &write_spheres, py::arg("path"), py::arg("structure"), WithoutGil());
    module.def("write_atom_table", &write_atom_table, py::arg("path"), py::arg("structure"), WithoutGil());
    module.def("write_structure_copy", &save_values, py::arg("path"), py::arg("structure"), py::arg("values"));
}

}  // namespace meniscus::python

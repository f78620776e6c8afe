// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing_options.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <utility>

#include "options.h"

namespace meniscus::python {

namespace {

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

}  // namespace

bool with_ligands(const py::dict& given) {
    bool ligands = true;
    Options(given).read("ligands", ligands);
    return ligands;
}

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

}  // namespace meniscus::python

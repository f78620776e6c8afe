// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/compare.h"

#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "arrays.h"
#include "bindings.h"
#include "meniscus/colours.h"
#include "meniscus/read_mesh.h"
#include "meniscus/structure.h"
#include "meniscus/write.h"
#include "options.h"
#include "result_dict.h"

namespace meniscus::python {

namespace {

using namespace py::literals;
using Held = std::shared_ptr<ComparedSurface>;

Held from_file(const std::string& path) {
    const py::gil_scoped_release release;
    return std::make_shared<ComparedSurface>(mesh_to_compare(read_mesh(path)));
}

Held from_mesh(const Mesh& mesh) {
    const py::gil_scoped_release release;
    return std::make_shared<ComparedSurface>(mesh_to_compare(mesh));
}

Held from_exact(const ExactSurface& exact, const py::dict& given) {
    const Options asked(given);
    StructureToCompare options;
    asked.read("spacing", options.spacing);
    asked.read("threads", options.threads);
    const py::gil_scoped_release release;
    return std::make_shared<ComparedSurface>(exact_to_compare(exact, options));
}

py::dict measures_of(const ComparedSurface& s) {
    py::dict measures = dict_of(s);
    measures["merged_vertices"] = s.merged_vertices;
    return measures;
}

py::dict compare(const Held& a, const Held& b, const py::dict& given) {
    const Options asked(given);
    CompareOptions options;
    asked.read("points", options.density);
    asked.read("threads", options.threads);
    Comparison found;
    {
        const py::gil_scoped_release release;
        found = compare_surfaces(*a, *b, options);
    }
    return py::dict("a_to_b"_a = dict_of(found.a_to_b), "b_to_a"_a = dict_of(found.b_to_a),
                    "distances"_a = owning(std::move(found.distances)));
}

/// A's mesh with its distances, as the command line writes it.
void save(const std::string& path, const Mesh& compared, const py::array_t<float>& distances,
          const std::pair<double, double>& range, const Structure* structure, std::optional<double> probe) {
    Mesh mesh = compared;
    mesh.values.push_back({"distance", {distances.data(), distances.data() + distances.size()}});
    const py::gil_scoped_release release;
    const std::vector<Colour> colours = colour_values(mesh.values.back().values, {range.first, range.second});
    write_mesh(path, mesh, {.colours = colours, .structure = structure, .probe = probe});
}

}  // namespace

void bind_compare(py::module_& module) {
    py::class_<ComparedSurface, Held> type(module, "ComparedSurface");
    type.def_property_readonly(
        "mesh", [](const ComparedSurface& s) -> const Mesh& { return s.mesh; },
        py::return_value_policy::reference_internal);
    type.def_property_readonly("measures", &measures_of);
    module.def("is_mesh_file", &is_mesh_file, py::arg("path"));
    module.def("compared_file", &from_file, py::arg("path"));
    module.def("compared_mesh", &from_mesh, py::arg("mesh"));
    module.def("compared_exact", &from_exact, py::arg("exact"), py::arg("options"));
    module.def("compare", &compare, py::arg("a"), py::arg("b"), py::arg("options"));
    module.def("write_compared", &save, py::arg("path"), py::arg("mesh"), py::arg("distances"), py::arg("range"),
               py::arg("structure"), py::arg("probe"));
}

}  // namespace meniscus::python

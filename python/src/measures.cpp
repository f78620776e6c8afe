// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/measures.h"

#include <pybind11/stl.h>

#include <memory>

#include "arrays.h"
#include "bindings.h"
#include "meniscus/file_words.h"
#include "meniscus/tables.h"
#include "meniscus/write.h"
#include "options.h"
#include "pickling.h"
#include "result_dict.h"
#include "table_columns.h"

namespace meniscus::python {

namespace {

MeasureOptions measure_options(const py::dict& given) {
    MeasureOptions options;
    describe(options, OptionReader(given));
    return options;
}

std::shared_ptr<Measures> measure_structure(const Structure& structure, const py::dict& given) {
    const MeasureOptions options = measure_options(given);
    const py::gil_scoped_release release;
    return std::make_shared<Measures>(measure(structure.atoms, options));
}

/// One number of every atom; a view.
py::array column(const py::object& self, double AtomMeasure::*member) {
    const auto& atoms = self.cast<const Measures&>().atoms;
    const double* first = atoms.empty() ? nullptr : &(atoms.front().*member);
    py::array array(py::dtype::of<double>(), {static_cast<py::ssize_t>(atoms.size())},
                    {static_cast<py::ssize_t>(sizeof(AtomMeasure))}, first, self);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

/// As the report has them, but with a sphere of radius 0 where a piece has no inscribed one.
py::list components(const Measures& measures) {
    py::list list = dicts_of(measures.components);
    for (const py::handle& block : list) {
        if (!block["inscribed_radius"].is_none()) continue;
        block["inscribed_centre"] = object_of(Vec3{});
        block["inscribed_radius"] = 0.0;
    }
    return list;
}

py::dict table(const Measures& measures, const Structure& structure, const std::string& per) {
    return table_columns(measures_table(structure, measures, parse_word("per", per, kRowsPerWords)));
}

void save_table(const Measures& measures, const Structure& structure, const std::string& path, const std::string& per) {
    const RowsPer rows = parse_word("per", per, kRowsPerWords);
    const py::gil_scoped_release release;
    write_table(path, measures_table(structure, measures, rows));
}

}  // namespace

void bind_measures(py::module_& module) {
    py::class_<Measures, std::shared_ptr<Measures>> type(module, "Measures");
    type.def_property_readonly("totals", [](const Measures& m) { return dict_of(m.totals); });
    type.def_property_readonly("errors", [](const Measures& m) { return dict_of(m.errors); });
    type.def_property_readonly("largest_sas_piece", [](const Measures& m) { return dict_of(m.largest_sas_piece); });
    type.def_property_readonly("components", &components);
    type.def_property_readonly("probe", [](const Measures& m) { return m.options.probe; });
    type.def_property_readonly("depth_measured", [](const Measures& m) { return m.options.depth; });
    type.def_readonly("sas_components", &Measures::sas_components);
    type.def_readonly("agreed", &Measures::agreed);
    type.def_readonly("degenerate", &Measures::degenerate);
    type.def_readonly("disputed", &Measures::disputed);
    const auto def_column = [&type](const char* name, double AtomMeasure::*member) {
        type.def_property_readonly(name, [member](const py::object& self) { return column(self, member); });
    };
    def_column("atom_sas_area", &AtomMeasure::sas_area);
    def_column("atom_contact_area", &AtomMeasure::contact_area);
    def_column("atom_toroidal_area", &AtomMeasure::toroidal_area);
    def_column("atom_reentrant_area", &AtomMeasure::reentrant_area);
    def_column("atom_depth", &AtomMeasure::depth);
    def_pickle<Measures>(type);
    type.def("table", &table, py::arg("structure"), py::arg("per"));
    type.def("save", &save_table, py::arg("structure"), py::arg("path"), py::arg("per"));
    module.def("measure", &measure_structure, py::arg("structure"), py::arg("options"));
}

}  // namespace meniscus::python

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/interfaces.h"

#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <utility>

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

using namespace py::literals;
using Names = std::vector<std::string>;

/// The interfaces of one structure.
struct Interfaces {
    std::vector<ChainInterface> all;
};

template <class Archive>
void fields(Archive& archive, Interfaces& s) {
    auto& [all] = s;
    archive(all);
}

/// Without pairs, every pair of chains that touch.
std::shared_ptr<Interfaces> measure_pairs(const Structure& structure,
                                          const std::optional<std::vector<std::pair<Names, Names>>>& given,
                                          const py::dict& options) {
    MeasureOptions measured;
    describe(measured, OptionReader(options));
    const py::gil_scoped_release release;
    std::vector<ChainPair> pairs;
    if (!given) pairs = touching_chains(structure, measured.probe);
    if (given)
        for (const auto& [a, b] : *given) pairs.push_back({a, b});
    return std::make_shared<Interfaces>(Interfaces{chain_interfaces(structure, pairs, measured, spell_as_keyword)});
}

/// One number of every atom of a side.
py::array shares(const std::vector<InterfaceAtom>& atoms, double (InterfaceAtom::*share)() const) {
    std::vector<double> values;
    values.reserve(atoms.size());
    for (const InterfaceAtom& atom : atoms) values.push_back((atom.*share)());
    return owning(std::move(values));
}

/// With the names that the report has.
py::dict interface_dict(const ChainInterface& i) {
    const Interface& m = i.areas;
    py::dict block = dict_of(m);
    block["a"] = py::tuple(py::cast(i.chains.a));
    block["b"] = py::tuple(py::cast(i.chains.b));
    block["atoms_a"] = owning(std::vector<std::uint32_t>(i.group_a));
    block["atoms_b"] = owning(std::vector<std::uint32_t>(i.group_b));
    block["atom_buried_sas_a"] = shares(m.atoms_a, &InterfaceAtom::buried_sas);
    block["atom_buried_sas_b"] = shares(m.atoms_b, &InterfaceAtom::buried_sas);
    block["atom_buried_ses_a"] = shares(m.atoms_a, &InterfaceAtom::buried_ses);
    block["atom_buried_ses_b"] = shares(m.atoms_b, &InterfaceAtom::buried_ses);
    return block;
}

py::list interface_blocks(const Interfaces& interfaces) {
    py::list list;
    for (const ChainInterface& i : interfaces.all) list.append(interface_dict(i));
    return list;
}

Names disputed_patches(const Interfaces& interfaces) {
    Names all;
    for (const ChainInterface& i : interfaces.all)
        all.insert(all.end(), i.areas.disputed.begin(), i.areas.disputed.end());
    return all;
}

Table table_of(const Interfaces& interfaces, const Structure& structure, const std::string& per) {
    return interface_table(structure, interfaces.all, parse_word("per", per, kRowsPerWords));
}

void save_interfaces(const Interfaces& interfaces, const Structure& structure, const std::string& path,
                     const std::string& per) {
    const py::gil_scoped_release release;
    write_table(path, table_of(interfaces, structure, per));
}

}  // namespace

void bind_interfaces(py::module_& module) {
    py::class_<Interfaces, std::shared_ptr<Interfaces>> type(module, "Interfaces");
    type.def_property_readonly("blocks", &interface_blocks);
    type.def_property_readonly("disputed", &disputed_patches);
    type.def("table", [](const Interfaces& interfaces, const Structure& structure, const std::string& per) {
        return table_columns(table_of(interfaces, structure, per));
    });
    type.def("save", &save_interfaces, py::arg("structure"), py::arg("path"), py::arg("per"));
    def_pickle<Interfaces>(type);
    module.def("split_group", &split_group, py::arg("text"));
    module.def("measure_interfaces", &measure_pairs, py::arg("structure"), py::arg("pairs"), py::arg("options"));
}

}  // namespace meniscus::python

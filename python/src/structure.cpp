// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/structure.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cctype>
#include <memory>

#include "arrays.h"
#include "bindings.h"
#include "columns.h"
#include "meniscus/file_words.h"
#include "meniscus/named_atoms.h"
#include "meniscus/radii.h"
#include "options.h"
#include "pickling.h"

namespace meniscus::python {

std::string spell_as_keyword(std::string_view option, std::string_view value) {
    std::string name(option == "keep_waters" ? "waters" : option);
    if (value.empty()) return name;
    if (value == "true" || value == "false") return name + (value == "true" ? "=True" : "=False");
    const auto are_all = [value](auto is_kind) {
        return std::all_of(value.begin(), value.end(), [&](unsigned char c) { return is_kind(c) != 0; });
    };
    const bool is_bare = are_all([](int c) { return std::isupper(c); }) ||  // stands for what the user chooses
                         are_all([](int c) { return std::isdigit(c); });
    return name + "=" + (is_bare ? std::string(value) : '"' + std::string(value) + '"');
}

namespace {

using StructurePointer = std::shared_ptr<Structure>;

ReadOptions read_options(const py::dict& given) {
    const Options options(given);
    ReadOptions read{.spelling = spell_as_keyword};
    options.read("radii", read.radii);
    options.read_word("hydrogens", read.hydrogens, kHydrogenWords);
    options.read("model", read.model);
    options.read("join_models", read.join_models);
    options.read("assembly", read.assembly);
    options.read("altloc", read.altloc);
    options.read("chains", read.chains);
    options.read("select", read.select);
    options.read_word("hetero", read.hetero, kHeteroWords);
    options.read("waters", read.keep_waters);
    options.read("strict_radii", read.strict_radii);
    return read;
}

std::vector<StructurePointer> shared(std::vector<Structure>&& structures) {
    std::vector<StructurePointer> pointers;
    pointers.reserve(structures.size());
    for (Structure& structure : structures) pointers.push_back(std::make_shared<Structure>(std::move(structure)));
    return pointers;
}

StructurePointer read(const std::string& path, const py::dict& given) {
    const ReadOptions options = read_options(given);
    const py::gil_scoped_release release;
    return std::make_shared<Structure>(read_structure(path, options));
}

std::vector<StructurePointer> read_models(const std::string& path, const py::dict& given) {
    const ReadOptions options = read_options(given);
    const py::gil_scoped_release release;
    return shared(read_all_models(path, options));
}

StructurePointer read_bytes(std::string bytes, const std::string& name, const py::dict& given) {
    const ReadOptions options = read_options(given);
    const py::gil_scoped_release release;
    return std::make_shared<Structure>(parse_structure(std::move(bytes), name, options));
}

std::vector<StructurePointer> read_models_of_bytes(std::string bytes, const std::string& name, const py::dict& given) {
    const ReadOptions options = read_options(given);
    const py::gil_scoped_release release;
    return shared(parse_all_models(std::move(bytes), name, options));
}

/// What another program is called, how the structure is to be called, and what is to be noted first.
struct Origin {
    std::string source, name;
    Texts notes;

    explicit Origin(const py::dict& given) {
        const Options options(given);
        options.read("source", source);
        options.read("name", name);
        options.read("notes", notes);
    }
};

/// The structure, and the index of each kept atom among those given.
py::tuple read_atoms(const Positions& xyz, const py::dict& columns, const py::dict& given_origin,
                     const py::dict& given) {
    const ReadOptions options = read_options(given);
    const Origin origin(given_origin);
    const std::vector<NamedAtom> atoms = Columns(columns).named_atoms(points_of(xyz));
    auto made = std::make_shared<StructureOfAtoms>();
    {
        const py::gil_scoped_release release;
        *made = structure_of_atoms(atoms, origin.source, options);
    }
    Structure& structure = made->structure;
    structure.name = origin.name;
    structure.notes.insert(structure.notes.begin(), origin.notes.begin(), origin.notes.end());
    std::vector<std::int32_t> indices(made->indices.begin(), made->indices.end());
    return py::make_tuple(StructurePointer(made, &structure), owning(std::move(indices)));
}

std::vector<StructurePointer> split(const Structure& structure) { return shared(split_chains(structure)); }

py::array selected(const Structure& structure, const std::string& expression, const std::string& option) {
    std::vector<std::int32_t> indices;
    const std::vector<bool> chosen = select_atoms(structure, expression, option);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) indices.push_back(static_cast<std::int32_t>(i));
    return given_away(std::move(indices));
}

bool is_same(const Residue& a, const Residue& b) {
    return a.chain == b.chain && a.name == b.name && a.number == b.number && a.insertion_code == b.insertion_code;
}

/// Residues are runs of atoms of the same chain, name, number and insertion code.
StructurePointer from_arrays(const Positions& xyz, const Numbers& radii, const py::dict& given) {
    const Columns columns(given);
    auto structure = std::make_shared<Structure>();
    const std::span<const Vec3> centres = points_of(xyz);
    const std::span<const double> sizes = numbers_of(radii);
    structure->atoms = {{centres.begin(), centres.end()}, {sizes.begin(), sizes.end()}};
    structure->radii_set = "given";
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const Residue residue = columns.residue(i);
        if (i == 0 || !is_same(residue, structure->residues.back())) structure->residues.push_back(residue);
        structure->labels.push_back(columns.label(i));
        structure->labels.back().residue = static_cast<std::uint32_t>(structure->residues.size() - 1);
    }
    return structure;
}

py::array radii_by_name(const Texts& elements, const Texts& names, const Texts& residues, const std::string& set) {
    std::vector<AtomNames> atoms(elements.size());
    for (std::size_t i = 0; i < atoms.size(); ++i)
        atoms[i] = {.residue = residues[i], .name = names[i], .element = elements[i]};
    return given_away(radii_of(atoms, set));
}

template <class Get>
auto per_atom(const Structure& structure, Get get) {
    std::vector<decltype(get(structure.labels.front()))> column;
    column.reserve(structure.labels.size());
    for (const AtomLabel& label : structure.labels) column.push_back(get(label));
    return column;
}

template <class T>
py::array numbers(const Structure& structure, T AtomLabel::*member) {
    return owning(per_atom(structure, [member](const AtomLabel& label) { return label.*member; }));
}

Texts texts(const Structure& structure, std::string AtomLabel::*member) {
    return per_atom(structure, [member](const AtomLabel& label) { return label.*member; });
}

/// One entry per residue.
py::dict residue_columns(const Structure& structure) {
    Texts chain, name, icode;
    std::vector<std::int32_t> number;
    for (const Residue& residue : structure.residues) {
        chain.push_back(residue.chain);
        name.push_back(residue.name);
        number.push_back(residue.number);
        icode.emplace_back(1, residue.insertion_code);
    }
    py::dict columns;
    columns["chain"] = chain;
    columns["name"] = name;
    columns["number"] = owning(std::move(number));
    columns["icode"] = icode;
    return columns;
}

void bind_columns(py::class_<Structure, StructurePointer>& type) {
    type.def_property_readonly("xyz", [](const py::object& self) {
        return view(std::span<const Vec3>(self.cast<const Structure&>().atoms.centres), self);
    });
    type.def_property_readonly("radii", [](const py::object& self) {
        return view(std::span<const double>(self.cast<const Structure&>().atoms.radii), self);
    });
    type.def_property_readonly("name_of_atoms", [](const Structure& s) { return texts(s, &AtomLabel::name); });
    type.def_property_readonly("element", [](const Structure& s) { return texts(s, &AtomLabel::element); });
    type.def_property_readonly("altloc", [](const Structure& s) {
        return per_atom(s, [](const AtomLabel& label) { return std::string(1, label.altloc); });
    });
    type.def_property_readonly("residue", [](const Structure& s) { return numbers(s, &AtomLabel::residue); });
    type.def_property_readonly("serial", [](const Structure& s) { return numbers(s, &AtomLabel::serial); });
    type.def_property_readonly("b_factor", [](const Structure& s) { return numbers(s, &AtomLabel::b_factor); });
    type.def_property_readonly("occupancy", [](const Structure& s) { return numbers(s, &AtomLabel::occupancy); });
    type.def_property_readonly("charge", [](const Structure& s) { return numbers(s, &AtomLabel::charge); });
    type.def_property_readonly("residues", &residue_columns);
}

}  // namespace

void bind_structure(py::module_& module) {
    py::class_<Structure, StructurePointer> type(module, "Structure");
    type.def("__len__", [](const Structure& s) { return s.atoms.size(); });
    type.def_readonly("file", &Structure::file);
    type.def_readonly("name", &Structure::name);
    type.def_readonly("sha256", &Structure::sha256);
    type.def_readonly("radii_set", &Structure::radii_set);
    type.def_readonly("dropped", &Structure::dropped);
    type.def_property_readonly("ligands", [](const Structure& s) { return count_ligands(s.ligands); });
    type.def_readonly("notes", &Structure::notes);
    type.def_readonly("warnings", &Structure::warnings);
    bind_columns(type);
    def_pickle<Structure>(type);
    module.def("read", &read, py::arg("path"), py::arg("options"));
    module.def("read_models", &read_models, py::arg("path"), py::arg("options"));
    module.def("read_bytes", &read_bytes, py::arg("bytes"), py::arg("name"), py::arg("options"));
    module.def("read_models_of_bytes", &read_models_of_bytes, py::arg("bytes"), py::arg("name"), py::arg("options"));
    module.def("read_atoms", &read_atoms, py::arg("xyz"), py::arg("columns"), py::arg("origin"), py::arg("options"));
    module.def("select", &selected, py::arg("structure"), py::arg("expression"), py::arg("option"));
    module.def("split_chains", &split, py::arg("structure"));
    module.def("from_arrays", &from_arrays, py::arg("xyz"), py::arg("radii"), py::arg("columns"));
    module.def("radii", &radii_by_name, py::arg("elements"), py::arg("names"), py::arg("resnames"), py::arg("set"));
}

}  // namespace meniscus::python

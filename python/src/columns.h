// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Names and numbers of atoms that come from Python as a dict of lists.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meniscus/named_atoms.h"
#include "options.h"

namespace meniscus::python {

using Texts = std::vector<std::string>;

inline char letter(const std::string& text) { return text.empty() ? ' ' : text.front(); }

/// What is known of atoms beside their centres: every list has an entry per atom, or is empty.
struct Columns {
    Texts element, name, resname, chain, icode, altloc;
    std::vector<int> resnum, serial;
    std::vector<double> b_factor, occupancy, charge, radius;
    std::vector<bool> hetero, in_polymer;

    explicit Columns(const py::dict& given) {
        const Options options(given);
        options.read("element", element);
        options.read("name", name);
        options.read("resname", resname);
        options.read("chain", chain);
        options.read("icode", icode);
        options.read("altloc", altloc);
        options.read("resnum", resnum);
        options.read("serial", serial);
        options.read("b_factor", b_factor);
        options.read("occupancy", occupancy);
        options.read("charge", charge);
        options.read("radius", radius);
        options.read("hetero", hetero);
        options.read("in_polymer", in_polymer);
    }

    template <class T>
    static T at(const std::vector<T>& column, std::size_t i, T otherwise = {}) {
        return column.empty() ? otherwise : column[i];
    }

    Residue residue(std::size_t i) const {
        return {.chain = at(chain, i),
                .name = at(resname, i),
                .number = at(resnum, i),
                .insertion_code = letter(at(icode, i))};
    }
    AtomLabel label(std::size_t i) const {
        AtomLabel label;
        label.name = at(name, i);
        label.element = at(element, i);
        label.serial = at(serial, i, static_cast<int>(i + 1));
        label.b_factor = at(b_factor, i);
        label.occupancy = at(occupancy, i, 1.0);
        label.charge = at(charge, i);
        label.altloc = letter(at(altloc, i));
        return label;
    }
    NamedAtom named_atom(const Vec3& centre, std::size_t i) const {
        const AtomLabel from = label(i);
        return {.centre = centre,
                .chain = at(chain, i),
                .residue = at(resname, i),
                .name = from.name,
                .element = from.element,
                .residue_number = at(resnum, i),
                .insertion_code = letter(at(icode, i)),
                .altloc = from.altloc,
                .is_hetero = hetero.empty() ? std::nullopt : std::optional<bool>(hetero[i]),
                .in_polymer = !in_polymer.empty() && in_polymer[i],
                .serial = from.serial,
                .b_factor = from.b_factor,
                .occupancy = from.occupancy,
                .charge = from.charge,
                .radius = radius.empty() ? std::nullopt : std::optional<double>(radius[i])};
    }
    std::vector<NamedAtom> named_atoms(std::span<const Vec3> centres) const {
        std::vector<NamedAtom> atoms;
        atoms.reserve(centres.size());
        for (std::size_t i = 0; i < centres.size(); ++i) atoms.push_back(named_atom(centres[i], i));
        return atoms;
    }
};

}  // namespace meniscus::python

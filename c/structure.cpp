// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <limits>

#include "meniscus/errors.h"
#include "objects.h"

namespace meniscus::c {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "centres are handed out as x, y, z");

meniscus_structure* handle_of(Structure structure) {
    return new meniscus_structure{std::make_shared<const Structure>(std::move(structure))};
}

void check_sphere(std::size_t i, const double* centre, double radius) {
    const std::string number = std::to_string(i);
    if (!std::isfinite(centre[0]) || !std::isfinite(centre[1]) || !std::isfinite(centre[2]))
        throw UsageError("centres: sphere " + number + " has a coordinate that is not a finite number");
    if (!std::isfinite(radius) || radius <= 0.0)
        throw UsageError("radii: that of sphere " + number + " must be a finite number greater than 0");
}

Structure spheres(std::size_t n, const double* centres, const double* radii) {
    Structure structure;
    structure.name = "spheres";
    structure.radii_set = "file";
    structure.residues.emplace_back();
    structure.labels.resize(n);
    structure.atoms.radii.assign(radii, radii + n);
    for (std::size_t i = 0; i < n; ++i) {
        check_sphere(i, centres + 3 * i, radii[i]);
        structure.labels[i].serial = static_cast<int>(i + 1);
        structure.atoms.centres.push_back({centres[3 * i], centres[3 * i + 1], centres[3 * i + 2]});
    }
    return structure;
}

meniscus_atom label_of(const Structure& structure, std::size_t atom) {
    const AtomLabel& label = structure.labels[atom];
    const Residue& residue = structure.residues[label.residue];
    return {label.name.c_str(), label.element.c_str(),  residue.name.c_str(), residue.chain.c_str(), residue.number,
            label.serial,       residue.insertion_code, label.altloc,         label.b_factor,        label.occupancy,
            label.charge};
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;

meniscus_status meniscus_read(const char* path, const meniscus_options* options, meniscus_structure** structure) {
    return guarded([&] {
        need(path, "path");
        need(structure, "structure");
        *structure = handle_of(meniscus::read_structure(path, options_of(options).read));
    });
}

meniscus_status meniscus_parse(const void* bytes, size_t size, const char* name, const meniscus_options* options,
                               meniscus_structure** structure) {
    return guarded([&] {
        need(bytes, "bytes");
        need(structure, "structure");
        if (size > static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max()))
            throw meniscus::LimitError("size: " + std::to_string(size) + " bytes are more than memory can hold");
        *structure = handle_of(meniscus::parse_structure(std::string(static_cast<const char*>(bytes), size),
                                                         name != nullptr ? name : "<data>", options_of(options).read));
    });
}

meniscus_status meniscus_from_spheres(size_t n, const double* centres, const double* radii,
                                      meniscus_structure** structure) {
    return guarded([&] {
        need(centres, "centres");
        need(radii, "radii");
        need(structure, "structure");
        need_room(n, "n");
        if (n == 0) throw meniscus::UsageError("n: there must be at least one sphere");
        *structure = handle_of(spheres(n, centres, radii));
    });
}

void meniscus_structure_free(meniscus_structure* structure) { delete structure; }

size_t meniscus_atom_count(const meniscus_structure* structure) {
    return structure != nullptr ? structure->structure->atoms.size() : 0;
}

const double* meniscus_atom_centres(const meniscus_structure* structure) {
    return structure != nullptr ? &structure->structure->atoms.centres.data()->x : nullptr;
}

const double* meniscus_atom_radii(const meniscus_structure* structure) {
    return structure != nullptr ? structure->structure->atoms.radii.data() : nullptr;
}

meniscus_status meniscus_atom_label(const meniscus_structure* structure, size_t atom, meniscus_atom* label) {
    return guarded([&] {
        need(structure, "structure");
        need(label, "label");
        if (atom >= structure->structure->labels.size())
            throw meniscus::UsageError("atom: there is no atom " + std::to_string(atom));
        *label = label_of(*structure->structure, atom);
    });
}

meniscus_status meniscus_structure_report(meniscus_structure* structure, const char** json) {
    return guarded([&] {
        need(structure, "structure");
        need(json, "json");
        structure->report = report_of(*structure->structure);
        *json = structure->report.c_str();
    });
}

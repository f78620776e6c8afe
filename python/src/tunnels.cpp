// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/tunnels.h"

#include <pybind11/stl.h>

#include <optional>
#include <span>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "meniscus/describe_tunnels.h"
#include "result_dict.h"

namespace meniscus::python {

namespace {

ExactSurface surface_of(const Structure& structure) { return ExactSurface(structure.atoms, {SurfaceKind::Ses}); }

/// As the report has it, with arrays instead of the profile.
py::dict way_dict(const TunnelPath& path, const Structure& structure) {
    py::dict way = dict_of(describe_way(path, structure));
    way.attr("pop")("profile");
    std::vector<std::uint32_t> atoms;
    for (const std::uint32_t atom : path.bottleneck.atoms)
        if (atom != kNone) atoms.push_back(atom);
    way["atoms"] = owning(std::move(atoms));
    way["points"] = column_of(path.points, &PathPoint::position);
    way["radii"] = column_of(path.points, &PathPoint::radius);
    way["distances"] = column_of(path.points, &PathPoint::distance);
    return way;
}

/// For each the index of its start, its rank, and the way.
py::list tunnels_from(const Structure& structure, const Positions& starts, double min_radius, int count,
                      double large_probe, int threads) {
    TunnelOptions options;
    options.min_radius = min_radius;
    options.count = count;
    options.large_probe = large_probe;
    std::vector<Tunnel> found;
    {
        const std::span<const Vec3> points = points_of(starts);
        const py::gil_scoped_release release;
        RunOptions run;
        run.threads = threads;
        found = find_tunnels(surface_of(structure), points, options, run);
    }
    py::list list;
    for (const Tunnel& tunnel : found)
        list.append(py::make_tuple(tunnel.start, tunnel.rank, way_dict(tunnel.path, structure)));
    return list;
}

Vec3 middle_of(const std::vector<Vec3>& centres) {
    Vec3 sum;
    for (const Vec3& centre : centres) sum += centre;
    return (1.0 / static_cast<double>(centres.size())) * sum;
}

/// along   a direction, through the middle of the atoms, or two ends
std::optional<py::dict> pore_along(const Structure& structure, const Positions& along, int threads) {
    std::optional<TunnelPath> found;
    {
        const std::span<const Vec3> points = points_of(along);
        const py::gil_scoped_release release;
        RunOptions run;
        run.threads = threads;
        const ExactSurface exact = surface_of(structure);
        const PoreEnds ends = points.size() == 1 ? ends_along(exact, middle_of(exact.atoms().centres), points[0])
                                                 : PoreEnds{points[0], points[1]};
        found = find_pore(exact, ends, {}, run);
    }
    if (!found) return std::nullopt;
    return way_dict(*found, structure);
}

}  // namespace

void bind_tunnels(py::module_& module) {
    module.def("tunnels", &tunnels_from, py::arg("structure"), py::arg("starts"), py::arg("min_radius"),
               py::arg("count"), py::arg("large_probe"), py::arg("threads"));
    module.def("pore", &pore_along, py::arg("structure"), py::arg("along"), py::arg("threads"));
}

}  // namespace meniscus::python

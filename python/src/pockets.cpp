// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/pockets.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "drawing_options.h"
#include "meniscus/describe_pockets.h"
#include "meniscus/draw_pockets.h"
#include "meniscus/file_words.h"
#include "meniscus/pocket_places.h"
#include "meniscus/volume_file.h"
#include "meniscus/write.h"
#include "options.h"
#include "pickling.h"
#include "platform/files/atomic_file.h"
#include "result_dict.h"
#include "table_columns.h"

namespace meniscus::python {

namespace {

/// The pockets of one structure, at which places if any were given, and whether they passed their checks.
struct FoundPockets {
    Pockets pockets;
    std::vector<NamedPlace> places;
    std::vector<Check> checks;
};

template <class Archive>
void fields(Archive& archive, FoundPockets& s) {
    auto& [pockets, places, checks] = s;
    archive(pockets, places, checks);
}

/// A place that the caller names; without radii no ligand lies there.
NamedPlace place_of(const std::string& name, const Positions& points, const std::optional<Numbers>& radii,
                    double reach) {
    const std::span<const Vec3> centres = points_of(points);
    NamedPlace place{name, {{centres.begin(), centres.end()}, reach}, {}};
    if (!radii) return place;
    const std::span<const double> sizes = numbers_of(*radii);
    place.ligand = {place.place.points, {sizes.begin(), sizes.end()}};
    return place;
}

std::shared_ptr<FoundPockets> pockets_of(const Structure& structure, const py::dict& given,
                                         const std::vector<NamedPlace>& places, int threads) {
    PocketOptions options;
    describe(options, OptionReader(given));
    for (const NamedPlace& place : places) options.places.push_back(place.place);
    const py::gil_scoped_release release;
    const ExactSurface exact(structure.atoms, {SurfaceKind::Ses, options.probe});
    RunOptions run;
    run.threads = threads;
    FoundPockets found{find_pockets(exact, atom_classes(structure), options, run), places, {}};
    const bool agreed = exact.measures().agreed;
    found.checks = pocket_checks(found.pockets);
    found.checks.insert(found.checks.begin(), {"exact_agreement", agreed, agreed ? 1.0 : 0.0, 1.0});
    return std::make_shared<FoundPockets>(std::move(found));
}

/// As the report has them, with what is too long for it.
py::list described_pockets(const FoundPockets& found, const Structure& structure) {
    py::list list = dicts_of(describe_pockets(found.pockets, structure, found.places));
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Pocket& pocket = found.pockets.pockets[i];
        list[i]["deepest"] = object_of(pocket.deepest);
        list[i]["wall_atoms"] = column_of(pocket.wall, &WallAtom::atom);
        list[i]["wall_atom_areas"] = column_of(pocket.wall, &WallAtom::area);
        list[i]["voxels"] = object_of(pocket.voxels);
    }
    return list;
}

py::dict voxel_arrays(const FoundPockets& found) {
    using namespace py::literals;
    const std::vector<PocketVoxel>& all = found.pockets.voxels;
    return py::dict("xyz"_a = column_of(all, &PocketVoxel::position), "share"_a = column_of(all, &PocketVoxel::share),
                    "depth"_a = column_of(all, &PocketVoxel::depth),
                    "probability"_a = column_of(all, &PocketVoxel::probability),
                    "pocket"_a = column_of(all, &PocketVoxel::pocket));
}

Table table_of_pockets(const FoundPockets& found, const Structure& structure) {
    return pockets_table(describe_pockets(found.pockets, structure, found.places));
}

/// Of Python's Tunnel or Pore.
DescribedWay way_of(const py::handle& given) {
    const auto positions = given.attr("points").cast<Positions>();
    const auto radii = given.attr("radii").cast<Numbers>();
    const auto distances = given.attr("distances").cast<Numbers>();
    const std::span<const Vec3> points = points_of(positions);
    DescribedWay way;
    way.atoms = given.attr("bottleneck_atoms").cast<std::vector<std::string>>();
    TunnelPath& path = way.path;
    for (std::size_t i = 0; i < points.size(); ++i)
        path.points.push_back({points[i], numbers_of(distances)[i], numbers_of(radii)[i]});
    const auto narrowest = std::min_element(path.points.begin(), path.points.end(),
                                            [](const auto& a, const auto& b) { return a.radius < b.radius; });
    path.bottleneck.point = static_cast<std::size_t>(narrowest - path.points.begin());
    path.bottleneck.radius = given.attr("bottleneck_radius").cast<double>();
    path.bottleneck.position = vector_of(given.attr("bottleneck").cast<std::array<double, 3>>());
    path.bottleneck.at_end = given.attr("bottleneck_at_end").cast<bool>();
    path.certified_radius = given.attr("certified_radius").cast<double>();
    path.length = given.attr("length").cast<double>();
    path.curvature = given.attr("curvature").cast<double>();
    return way;
}

PocketWays ways_of(const py::list& tunnels, const py::object& pore) {
    PocketWays ways;
    for (const py::handle& tunnel : tunnels)
        ways.tunnels.push_back({tunnel.attr("pocket").cast<std::optional<std::size_t>>(),
                                tunnel.attr("rank").cast<std::size_t>(), way_of(tunnel)});
    if (!pore.is_none()) ways.pore = way_of(pore);
    return ways;
}

void save_pocket_atoms(const FoundPockets& found, const Structure& structure, const std::string& path,
                       const py::list& tunnels, const py::object& pore) {
    const PocketWays ways = ways_of(tunnels, pore);
    const py::gil_scoped_release release;
    PathsOfPockets paths;
    for (const DescribedTunnel& tunnel : ways.tunnels) paths.tunnels.push_back(tunnel.way.path);
    if (ways.pore) paths.pore = ways.pore->path;
    write_pocket_atoms(path, structure, found.pockets, paths);
}

/// A picture, a page or glTF.
void save_drawn_pockets(const FoundPockets& found, const Structure& structure, const std::string& path,
                        const py::list& tunnels, const py::object& pore, const py::dict& given) {
    const PocketWays ways = ways_of(tunnels, pore);
    DrawPocketsOptions options{.picture = picture_options(given), .ligands = with_ligands(given)};
    Options(given).read("legend", options.legend);
    const py::gil_scoped_release release;
    const ExactSurface exact(structure.atoms, {SurfaceKind::Ses, found.pockets.options.probe});
    const DrawnPockets drawn(exact, found.pockets, structure, ways);
    if (path.ends_with(".glb")) return drawn.write_glb(path, structure, options);
    if (path.ends_with(".png")) return write_picture(path, drawn.picture(structure, options));
    AtomicFile file(path);
    file.write(drawn.page(structure, describe_pockets(found.pockets, structure, found.places), options));
    file.commit();
}

void save_pocket_bodies(const FoundPockets& found, const std::string& path) {
    const py::gil_scoped_release release;
    write_mesh(path, pocket_bodies(found.pockets));
}

void save_pocket_table(const FoundPockets& found, const Structure& structure, const std::string& path) {
    const py::gil_scoped_release release;
    write_table(path, table_of_pockets(found, structure));
}

void save_pocket_volume(const FoundPockets& found, const std::string& path, const std::string& field) {
    const VolumeContent content = parse_word("field", field, kPocketFieldWords);
    const py::gil_scoped_release release;
    write_volume(path, pocket_volume(found.pockets, content), content);
}

void save_pocket_arrays(const FoundPockets& found, const std::string& path) {
    const py::gil_scoped_release release;
    write_pocket_arrays(path, found.pockets);
}

/// A model with its structure and the bottlenecks of its pockets, 0 for none.
using ModelPockets = std::tuple<std::shared_ptr<FoundPockets>, std::shared_ptr<Structure>, std::vector<double>>;

py::dict track_dict(const DescribedTrack& described) {
    using namespace py::literals;
    const PocketTrack& track = described.track;
    const auto members = [](const Spread& spread) {
        return py::make_tuple(spread.mean, spread.deviation, spread.values);
    };
    return py::dict("number"_a = described.number, "models"_a = track.models, "open"_a = track.open,
                    "best_rank"_a = track.best_rank, "score"_a = members(track.score),
                    "volume"_a = members(track.volume), "depth"_a = members(track.depth),
                    "mouth_radius"_a = members(track.mouth_radius), "ways"_a = track.ways,
                    "bottleneck"_a = members(track.bottleneck), "residues"_a = described.residues);
}

/// The tracks, and for each model the number of the track of each pocket.
py::tuple follow_pockets(const std::vector<ModelPockets>& models) {
    FollowedPockets followed;
    std::vector<std::vector<std::size_t>> of_pockets;
    std::vector<DescribedTrack> described;
    {
        const py::gil_scoped_release release;
        for (const auto& [found, structure, bottlenecks] : models)
            of_pockets.push_back(followed.add(found->pockets, *structure, bottlenecks));
        described = followed.described();
    }
    py::list tracks;
    for (const DescribedTrack& track : described) tracks.append(track_dict(track));
    return py::make_tuple(tracks, of_pockets);
}

}  // namespace

void bind_pockets(py::module_& module) {
    const py::class_<NamedPlace> place(module, "Place");
    module.def("place", &place_of, py::arg("name"), py::arg("points"), py::arg("radii"), py::arg("reach"));
    module.def(
        "places_of_selection",
        [](const Structure& molecule, const Structure& whole, const std::string& expression, double reach) {
            return places_of_selection(molecule, whole, expression, reach);
        },
        py::arg("molecule"), py::arg("whole"), py::arg("expression"), py::arg("reach"));
    py::class_<FoundPockets, std::shared_ptr<FoundPockets>> type(module, "Pockets");
    type.def_property_readonly("totals", [](const FoundPockets& found) { return dict_of(found.pockets); });
    type.def_property_readonly("checks", [](const FoundPockets& found) { return dicts_of(found.checks); });
    type.def_property_readonly("voxels", &voxel_arrays);
    type.def("doubt", [](const FoundPockets& found, const Structure& structure) {
        return doubt_of_ranking(structure, found.pockets.options.spacing);
    });
    type.def("descriptions", &described_pockets, py::arg("structure"));
    type.def(
        "table",
        [](const FoundPockets& found, const Structure& structure) {
            return table_columns(table_of_pockets(found, structure));
        },
        py::arg("structure"));
    type.def("save_atoms", &save_pocket_atoms, py::arg("structure"), py::arg("path"), py::arg("tunnels"),
             py::arg("pore"));
    type.def("save_drawn", &save_drawn_pockets, py::arg("structure"), py::arg("path"), py::arg("tunnels"),
             py::arg("pore"), py::arg("options"));
    type.def("save_bodies", &save_pocket_bodies, py::arg("path"));
    type.def("save_table", &save_pocket_table, py::arg("structure"), py::arg("path"));
    type.def("save_volume", &save_pocket_volume, py::arg("path"), py::arg("field"));
    type.def("save_arrays", &save_pocket_arrays, py::arg("path"));
    def_pickle<FoundPockets>(type);
    module.def("pockets", &pockets_of, py::arg("structure"), py::arg("options"), py::arg("places"), py::arg("threads"));
    module.def("follow_pockets", &follow_pockets, py::arg("models"));
}

}  // namespace meniscus::python

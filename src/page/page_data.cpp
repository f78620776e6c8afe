// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/page_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "meniscus/ligand_bodies.h"
#include "meniscus/list_of_counts.h"
#include "meniscus/tables.h"
#include "meniscus/version.h"
#include "page/page_content.h"
#include "page/schemes.h"
#include "render/camera.h"

namespace meniscus::page {

using nlohmann::ordered_json;

namespace {

constexpr double kValueStep = 0.01;  // of B factors

ordered_json point_json(const Vec3& p) { return ordered_json::array({p.x, p.y, p.z}); }

double cut_to(double value, double digits) { return std::round(value * digits) / digits; }

/// Words in the order in which they come up, each once.
class Words {
public:
    std::uint32_t number(const std::string& word) {
        const auto [found, is_new] = numbers_.try_emplace(word, static_cast<std::uint32_t>(list_.size()));
        if (is_new) list_.push_back(word);
        return found->second;
    }
    const ordered_json& list() const { return list_; }

private:
    std::map<std::string, std::uint32_t> numbers_;
    ordered_json list_ = ordered_json::array();
};

Vec3 lowest(std::span<const Vec3> points) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Vec3 low{kFar, kFar, kFar};
    for (const Vec3& p : points) low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    return low;
}

template <class Get>
std::string per_label(const std::vector<AtomLabel>& labels, const Get& get) {
    std::vector<std::int64_t> values;
    values.reserve(labels.size());
    for (const AtomLabel& label : labels) values.push_back(get(label));
    return differences(values);
}

std::string radii(std::span<const double> radii) {
    std::vector<std::int64_t> values;
    for (const double radius : radii) values.push_back(std::llround(radius / kQuantum));
    return differences(values);
}

/// Atoms as they are shown, and what is known of them.
struct ShownAtoms {
    std::span<const Vec3> centres;
    std::span<const double> radii;
    const std::vector<AtomLabel>& labels;
};

/// kind   how the names of the streams begin: "atom-"
ordered_json add_atoms(Streams& streams, const std::string& kind, const ShownAtoms& atoms) {
    const Vec3 low = lowest(atoms.centres);
    streams.add(kind + "x", differences(quantised(atoms.centres, &Vec3::x, low.x)));
    streams.add(kind + "y", differences(quantised(atoms.centres, &Vec3::y, low.y)));
    streams.add(kind + "z", differences(quantised(atoms.centres, &Vec3::z, low.z)));
    streams.add(kind + "radius", radii(atoms.radii));
    Words names;
    Words elements;
    const std::vector<AtomLabel>& labels = atoms.labels;
    streams.add(kind + "name", per_label(labels, [&](const AtomLabel& l) { return names.number(l.name); }));
    streams.add(kind + "element", per_label(labels, [&](const AtomLabel& l) { return elements.number(l.element); }));
    streams.add(kind + "residue", per_label(labels, [](const AtomLabel& l) { return l.residue; }));
    streams.add(kind + "serial", per_label(labels, [](const AtomLabel& l) { return l.serial; }));
    streams.add(kind + "bfactor",
                per_label(labels, [](const AtomLabel& l) { return std::llround(l.b_factor / kValueStep); }));
    return {{"count", atoms.centres.size()},
            {"low", point_json(low)},
            {"valueStep", kValueStep},
            {"names", names.list()},
            {"elements", elements.list()}};
}

ordered_json residues_json(const std::vector<Residue>& residues) {
    Words chains;
    Words names;
    ordered_json list = ordered_json::array();
    for (const Residue& r : residues)
        list.push_back({chains.number(r.chain), names.number(r.name), r.number,
                        r.insertion_code == ' ' ? "" : std::string(1, r.insertion_code)});
    return {{"chains", chains.list()}, {"names", names.list()}, {"list", list}};
}

/// Three planes of bytes.
std::string planes_of(const std::vector<Colour>& colours) {
    std::string planes;
    for (const auto channel : {&Colour::red, &Colour::green, &Colour::blue})
        for (const Colour& colour : colours) planes.push_back(static_cast<char>(colour.*channel));
    return planes;
}

std::string pairs(const std::vector<std::array<std::uint32_t, 2>>& bonds) {
    std::vector<std::int64_t> ends;
    for (const auto& [a, b] : bonds) ends.insert(ends.end(), {a, b});
    return differences(ends);
}

/// Ligands as atoms of their own with the radii of their balls; nothing where none are shown.
ordered_json add_ligands(Streams& streams, const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    const Ligands ligands = options.ligands ? ligands_near(structure.ligands, mesh) : Ligands{};
    if (ligands.centres.empty()) return {};
    std::vector<double> radii;
    for (const AtomLabel& label : ligands.labels) radii.push_back(ball_radius(label));
    ordered_json atoms = add_atoms(streams, "ligand-", {ligands.centres, radii, ligands.labels});
    streams.add("ligand-bonds", pairs(ligands.bonds));
    streams.add("ligand-colours", planes_of(ligand_colours(ligands, colours_shown(mesh, structure, options.colours))));
    return {{"atoms", std::move(atoms)},       {"residues", residues_json(ligands.residues)},
            {"bonds", ligands.bonds.size()},   {"stick", kStickRadius},
            {"inSurface", ligands.in_surface}, {"text", list_of_counts(count_ligands(ligands))}};
}

ordered_json cavities_json(const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    ordered_json list = ordered_json::array();
    for (const ListedCavity& cavity : list_cavities(mesh, structure, options.components))
        list.push_back({{"area", cut_to(cavity.area, 100.0)},
                        {"volume", cut_to(cavity.volume, 100.0)},
                        {"centre", point_json(cavity.centre)},
                        {"radius", cut_to(cavity.radius, 100.0)},
                        {"component", cavity.component == kNone ? ordered_json() : ordered_json(cavity.component)},
                        {"lining", cavity.lining}});
    return list;
}

ordered_json pockets_json(const std::vector<PagePocket>& pockets) {
    ordered_json list = ordered_json::array();
    for (const PagePocket& pocket : pockets)
        list.push_back({{"name", pocket.name},
                        {"colour", hex(pocket.colour)},
                        {"cavity", pocket.cavity},
                        {"score", cut_to(pocket.score, 100.0)},
                        {"volume", cut_to(pocket.volume, 100.0)},
                        {"depth", cut_to(pocket.depth, 100.0)},
                        {"area", cut_to(pocket.wall_area, 100.0)},
                        {"mouths", pocket.mouths},
                        {"mouthArea", cut_to(pocket.mouth_area, 100.0)},
                        {"openings", pocket.openings},
                        {"openingArea", cut_to(pocket.opening_area, 100.0)},
                        {"centre", point_json(pocket.centre)},
                        {"lining", pocket.lining},
                        {"ligand", pocket.ligand}});
    return list;
}

ordered_json way_json(const PageWay& way) {
    ordered_json profile = ordered_json::array();
    for (const PageWay::Place& place : way.profile)
        profile.push_back({cut_to(place.distance, 1000.0), cut_to(place.radius, 1000.0)});
    return {{"name", way.name},
            {"from", way.from},
            {"rank", way.rank},
            {"colour", way.colour ? ordered_json(hex(*way.colour)) : ordered_json()},
            {"radius", cut_to(way.radius, 1000.0)},
            {"distance", cut_to(way.distance, 1000.0)},
            {"bottleneck", point_json(way.bottleneck)},
            {"atoms", way.atoms},
            {"begin", point_json(way.begin)},
            {"end", point_json(way.end)},
            {"length", cut_to(way.length, 100.0)},
            {"curvature", cut_to(way.curvature, 100.0)},
            {"profile", std::move(profile)}};
}

/// Tunnels and pores, and what the colours along them mean.
ordered_json ways_json(const std::vector<PageWay>& ways) {
    ordered_json list = ordered_json::array();
    for (const PageWay& way : ways) list.push_back(way_json(way));
    ordered_json scale = ordered_json::array();
    for (int i = 0; i <= 32; ++i) {
        const double radius = std::exp2(i / 8.0);  // from 1 to 16 Å
        scale.push_back({cut_to(radius, 1000.0), hex(passage_colour(radius))});
    }
    return {{"list", std::move(list)}, {"scale", std::move(scale)}};
}

ordered_json add_tubes(Streams& streams, const Bodies& tubes, const Vec3& low) {
    std::vector<Colour> colours;
    for (const VertexId v : add_bodies(streams, "tube-", tubes.mesh, low)) colours.push_back(tubes.colours[v]);
    streams.add("tube-colours", planes_of(colours));
    return {{"triangles", tubes.mesh.triangles.size()}, {"vertices", colours.size()}};
}

std::span<const Vec3> points_of_view(const Mesh& mesh, const Structure& structure) {
    return mesh.vertices.empty() ? structure.atoms.centres : mesh.vertices;
}

ordered_json view_json(const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    const Camera camera(points_of_view(mesh, structure), {.viewpoint = options.viewpoint});
    return {{"right", point_json(camera.frame().right)},
            {"up", point_json(camera.frame().up)},
            {"towards", point_json(camera.frame().towards)},
            {"perspective", options.projection == Projection::Perspective}};
}

ordered_json rows_json(const std::vector<PageRow>& rows) {
    ordered_json list = ordered_json::array();
    for (const PageRow& row : rows) list.push_back({row.section, row.label, row.value});
    return list;
}

ordered_json schemes_json(const Mesh& mesh, const Structure& structure, const PageOptions& options, Streams& streams) {
    ordered_json list = ordered_json::array();
    for (const OfferedScheme& scheme : offered_schemes(mesh, structure, options.colours))
        list.push_back(describe(scheme, mesh, structure, streams));
    return list;
}

ordered_json values_json(const Mesh& mesh) {
    ordered_json list = ordered_json::array();
    for (const VertexValues& values : mesh.values) {
        const ValueScale scale = scale_of(values);
        list.push_back({{"name", values.name}, {"low", scale.low}, {"step", scale.step}});
    }
    return list;
}

std::string id_of_first(const Mesh& mesh, const Structure& structure, const ColourOptions& colours) {
    const ColourScheme shown = scheme_in_force(colours.scheme, structure);
    for (const OfferedScheme& scheme : offered_schemes(mesh, structure, colours))
        if (scheme.options.scheme == shown && scheme.options.value == colours.value) return scheme.id;
    return "single";
}

ordered_json places_json(const Streams& streams) {
    ordered_json places;
    for (const Streams::Place& place : streams.places()) places[place.name] = {place.offset, place.size};
    return places;
}

}  // namespace

std::string page_data(const Mesh& mesh, const Structure& structure, const PageOptions& options,
                      const VertexExtras& extras) {
    Streams streams;
    const Vec3 low = lowest(points_of_view(mesh, structure));
    add_mesh(streams, mesh, extras, low);
    ordered_json data{{"meniscus", kVersion},
                      {"name", structure.name},
                      {"quantum", kQuantum},
                      {"curvatureStep", kCurvatureStep},
                      {"shapeStep", kShapeStep},
                      {"depthStep", kDepthStep},
                      {"low", point_json(low)},
                      {"triangles", mesh.triangles.size()},
                      {"vertices", order_of_use(mesh).vertices.size()}};
    data["atoms"] = add_atoms(streams, "atom-", {structure.atoms.centres, structure.atoms.radii, structure.labels});
    data["residues"] = residues_json(structure.residues);
    if (ordered_json ligands = add_ligands(streams, mesh, structure, options); !ligands.is_null())
        data["ligands"] = std::move(ligands);
    data["schemes"] = schemes_json(mesh, structure, options, streams);
    data["values"] = values_json(mesh);
    data["scheme"] = id_of_first(mesh, structure, options.colours);
    data["view"] = view_json(mesh, structure, options);
    data["cavities"] = cavities_json(mesh, structure, options);
    if (!options.pockets.empty()) data["pockets"] = pockets_json(options.pockets);
    if (options.bodies != nullptr && !options.bodies->triangles.empty())
        data["bodies"] = {{"triangles", options.bodies->triangles.size()},
                          {"vertices", add_bodies(streams, "body-", *options.bodies, low).size()}};
    if (!options.ways.empty()) data["ways"] = ways_json(options.ways);
    if (options.tubes != nullptr && !options.tubes->mesh.triangles.empty())
        data["tubes"] = add_tubes(streams, *options.tubes, low);
    data["ligandsLeftOut"] = list_of_counts(structure.left_out_ligands);
    data["rows"] = rows_json(options.rows);
    data["streams"] = places_json(streams);
    const std::string json = data.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    std::string block;
    for (unsigned shift = 0; shift < 32U; shift += 8U) block.push_back(static_cast<char>(json.size() >> shift));
    return block + json + streams.bytes();
}

}  // namespace meniscus::page

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/msms_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <set>
#include <string_view>
#include <vector>

#include "io/sphere_names.h"
#include "meniscus/errors.h"
#include "meniscus/file_name.h"
#include "meniscus/version.h"
#include "platform/files/atomic_file.h"

namespace meniscus {
namespace {

constexpr std::uint64_t kUnitsPerAngstrom = 1000;  // three decimals
constexpr std::int64_t kLeast = -9999999;          // units; "-9999.999" fills its nine columns
constexpr std::int64_t kMost = 99999999;

// A place in units of the last decimal.
using Place = std::array<std::int64_t, 3>;

// What MSMS calls the patches.
std::uint64_t kind_of(PatchKind patch) {
    constexpr std::array<std::uint64_t, 3> kKinds{3, 1, 2};  // contact, toroidal, reentrant
    return kKinds[static_cast<std::size_t>(patch)];
}

// Of the corners' patches the one that two share; where all differ, the toroidal one, which lies between the others.
std::uint64_t kind_of(const Mesh& mesh, const Triangle& triangle) {
    const auto [a, b, c] = std::array{mesh.patches[triangle[0]], mesh.patches[triangle[1]], mesh.patches[triangle[2]]};
    if (a == b || a == c) return kind_of(a);
    return b == c ? kind_of(b) : kind_of(PatchKind::Toroidal);
}

Place rounded(const Vec3& point) {
    Place place{};
    const std::array coordinates{point.x, point.y, point.z};
    for (std::size_t i = 0; i < place.size(); ++i) {
        const double units = std::round(coordinates[i] * double{kUnitsPerAngstrom});
        if (!(units >= static_cast<double>(kLeast) && units <= static_cast<double>(kMost)))
            throw LimitError("MSMS files cannot hold a coordinate of " + std::to_string(coordinates[i]) +
                             " Å; move the structure nearer to the origin, or write .ply");
        place[i] = static_cast<std::int64_t>(units);
    }
    return place;
}

// The free place next to a taken one.
Place free_place_beside(const Place& taken, const std::set<Place>& in_use) {
    for (std::int64_t step = 1;; ++step)
        for (std::size_t axis = 0; axis < taken.size(); ++axis)
            for (const std::int64_t sign : {1, -1}) {
                Place place = taken;
                place[axis] += sign * step;
                if (!in_use.contains(place)) return place;
            }
}

// Vertices on two sides of a thin wall may round to one place; readers that merge equal points would glue them.
void part_coincident(std::vector<Place>& places) {
    std::vector<std::uint32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return places[a] != places[b] ? places[a] < places[b] : a < b; });
    std::vector<std::uint32_t> repeated;
    for (std::size_t i = 1; i < order.size(); ++i)
        if (places[order[i]] == places[order[i - 1]]) repeated.push_back(order[i]);
    if (repeated.empty()) return;
    std::set<Place> in_use(places.begin(), places.end());
    for (const std::uint32_t vertex : repeated) {
        places[vertex] = free_place_beside(places[vertex], in_use);
        in_use.insert(places[vertex]);
    }
}

std::vector<Place> places_of(const Mesh& mesh) {
    std::vector<Place> places;
    places.reserve(mesh.vertices.size());
    for (const Vec3& vertex : mesh.vertices) places.push_back(rounded(vertex));
    part_coincident(places);
    return places;
}

// At the right of so many columns.
void append_right(std::string& line, std::string_view text, std::size_t columns) {
    line.append(columns - std::min(columns, text.size()), ' ');
    line += text;
}

void append_number(std::string& line, std::uint64_t number, std::size_t columns) {
    std::array<char, 20> digits;
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    append_right(line, {digits.data(), static_cast<std::size_t>(end - digits.data())}, columns);
}

// "%9.3f" of a number of units, without a sign before zero. fmt would take three times as long.
void append_units(std::string& line, std::int64_t units) {
    const auto magnitude = static_cast<std::uint64_t>(std::abs(units));
    std::array<char, 32> text;
    char* at = text.data();
    if (units < 0) *at++ = '-';
    at = std::to_chars(at, text.data() + text.size(), magnitude / kUnitsPerAngstrom).ptr;
    *at++ = '.';
    for (const std::uint64_t unit : {100, 10, 1}) *at++ = static_cast<char>('0' + magnitude / unit % 10);
    append_right(line, {text.data(), static_cast<std::size_t>(at - text.data())}, 9);
    line += ' ';
}

std::int64_t units_of(double component) { return std::llround(component * double{kUnitsPerAngstrom}); }

std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    return text;
}

void check_count(std::size_t count, const char* what) {
    if (count > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
        throw LimitError(fmt::format("MSMS files hold at most 2^31 - 1 {}, but there are {}; write .ply", what, count));
}

bool is_word(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isgraph(c) != 0; });
}

void check(const Mesh& mesh, const MsmsOptions& options) {
    const std::size_t n = mesh.vertices.size();
    if (mesh.normals.size() != n || mesh.atoms.size() != n || mesh.patches.size() != n)
        throw UsageError(
            "MSMS files need the normal, the atom and the patch of every vertex, which this mesh does not have");
    check_count(n, "vertices");
    check_count(mesh.triangles.size(), "triangles");
    check_count(options.spheres, "spheres");
    if (options.names.empty()) return;
    const auto last = std::max_element(mesh.atoms.begin(), mesh.atoms.end());
    if (last != mesh.atoms.end() && *last >= options.names.size())
        throw UsageError(fmt::format("{} names for {} spheres", options.names.size(), std::size_t{*last} + 1));
    if (!std::all_of(options.names.begin(), options.names.end(), is_word))
        throw UsageError("names of spheres in MSMS files must not be empty or contain blanks");
}

void write_header(AtomicFile& file, const MsmsOptions& options, std::size_t count, bool of_vertices) {
    const char* items = of_vertices ? "vertices" : "faces";
    if (options.header == MsmsHeader::Full) {
        file.write(
            fmt::format("# MSMS solvent excluded surface {} for {}\n", items, one_line(file_name(options.title))));
        file.write(of_vertices ? "#vertex #sphere density probe_r\n" : "#faces  #sphere density probe_r\n");
        file.write(fmt::format("{:7} {:7} {:5.2f} {:5.2f}\n", count, options.spheres, options.density, options.probe));
    } else if (options.header == MsmsHeader::CountOnly) {
        file.write(fmt::format("# {} of {}, by meniscus {}\n", items, one_line(file_name(options.title)), kVersion));
        file.write(of_vertices ? "#vertex\n" : "#faces\n");
        file.write(fmt::format("{}\n", count));
    }
}

void write_vertices(AtomicFile& file, const Mesh& mesh, const MsmsOptions& options) {
    const std::vector<Place> places = places_of(mesh);
    std::string line;
    for (std::size_t v = 0; v < places.size(); ++v) {
        line.clear();
        for (const std::int64_t units : places[v]) append_units(line, units);
        const Vec3& normal = mesh.normals[v];
        for (const double component : {normal.x, normal.y, normal.z}) append_units(line, units_of(component));
        line += "      0 ";
        append_number(line, std::uint64_t{mesh.atoms[v]} + 1, 7);
        append_number(line, kind_of(mesh.patches[v]), 3);
        line += ' ';
        if (!options.names.empty()) line += options.names[mesh.atoms[v]];
        line += '\n';
        file.write(line);
    }
}

void write_faces(AtomicFile& file, const Mesh& mesh) {
    std::string line;
    for (const Triangle& triangle : mesh.triangles) {
        line.clear();
        for (const VertexId corner : triangle) {
            append_number(line, std::uint64_t{corner} + 1, 6);
            line += ' ';
        }
        append_number(line, kind_of(mesh, triangle), 2);
        line += "      1\n";
        file.write(line);
    }
}

double area_of(const Mesh& mesh) {
    double area = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += 0.5 * norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
    return area;
}

void write_both(const std::string& vert_path, const Mesh& mesh, const MsmsOptions& options) {
    check(mesh, options);
    AtomicFile vert(vert_path);
    AtomicFile face(face_path_beside(vert_path));
    write_header(vert, options, mesh.vertices.size(), true);
    write_vertices(vert, mesh, options);
    write_header(face, options, mesh.triangles.size(), false);
    write_faces(face, mesh);
    face.finish();
    vert.finish();
    face.commit();
    vert.commit();
}

}  // namespace

std::string face_path_beside(const std::string& vert_path) {
    return vert_path.substr(0, vert_path.rfind('.')) + ".face";
}

void write_msms(const std::string& stem, const Mesh& mesh, const MsmsOptions& options) {
    write_both(stem + ".vert", mesh, options);
}

void write_msms_pair(const std::string& vert_path, const Mesh& mesh, const Structure* structure, double probe) {
    const double area = area_of(mesh);
    MsmsOptions options{.density = area > 0.0 ? static_cast<double>(mesh.vertices.size()) / area : 0.0, .probe = probe};
    std::vector<std::string> names;
    if (structure != nullptr) {
        options.title = structure->file;
        options.spheres = structure->atoms.size();
        names = sphere_names(*structure);
        options.names = names;
    }
    write_both(vert_path, mesh, options);
}

}  // namespace meniscus

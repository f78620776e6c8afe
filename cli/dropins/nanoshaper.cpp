// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The program `meniscus-nanoshaper`: a surface for those who call NanoShaper.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "dropins/guarded.h"
#include "dropins/nanoshaper_options.h"
#include "dropins/sphere_file.h"
#include "meniscus/errors.h"
#include "meniscus/remesh.h"
#include "meniscus/surface.h"
#include "meniscus/version.h"
#include "meniscus/write.h"
#include "platform/files/atomic_file.h"

namespace meniscus::dropins {
namespace {

constexpr const char* kName = "meniscus-nanoshaper";
constexpr const char* kDefaultFile = "surfaceConfiguration.prm";

NanoShaperRequest read_parameters(const std::vector<std::string>& arguments) {
    if (arguments.size() > 1)
        throw UsageError("expected one argument, a file of parameters; its default is " + std::string(kDefaultFile));
    const std::string path = arguments.empty() ? kDefaultFile : arguments.front();
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("{}: cannot be opened: {}; check the name", path, std::strerror(errno)));
    return read_nanoshaper(file, path);
}

/// As many vertices as marching cubes on NanoShaper's grid give, on the exact surface. Where that grid would be too
/// coarse for the surface, a fine one is taken and its mesh made coarse.
SurfaceOptions surface_options(const NanoShaperRequest& request) {
    constexpr double kVerticesPerCellFace = 1.5;  // of marching cubes per area / spacing², mean over all directions
    SurfaceOptions options;
    options.method = Method::Direct;
    options.probe = request.probe;
    options.min_cavity = request.fill_cavities ? request.fill_below : 0.0;
    const double spacing = 1.0 / request.grid_scale;
    if (spacing > kCoarsestForRemeshing) {
        options.remesh.edge = edge_of_density(kVerticesPerCellFace / (spacing * spacing));
        options.remesh.corners = Corners::OnSurface;  // as NanoShaper has them
    } else {
        options.spacing = spacing;
    }
    return options;
}

double area_of(const Mesh& mesh, const Triangle& t) {
    return 0.5 * norm(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]));
}

/// OFF with normals and atoms (from 0 on) behind the coordinates, if they are asked for.
void write_off(const Mesh& mesh, const NanoShaperRequest& request) {
    AtomicFile file(request.root + "triangulatedSurf.off");
    file.write(fmt::format("OFF{}{}\n# by meniscus {}\n\n{} {} 0\n", request.with_normals ? "+N" : "",
                           request.with_atoms ? "+A" : "", kVersion, mesh.vertices.size(), mesh.triangles.size()));
    std::string line;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3& p = mesh.vertices[v];
        const Vec3& n = mesh.normals[v];
        line = fmt::format("{:.3f} {:.3f} {:.3f}", p.x, p.y, p.z);
        if (request.with_normals) fmt::format_to(std::back_inserter(line), " {:.3f} {:.3f} {:.3f}", n.x, n.y, n.z);
        if (request.with_atoms) fmt::format_to(std::back_inserter(line), " {}", mesh.atoms[v]);
        file.write(line += '\n');
    }
    for (const auto& [a, b, c] : mesh.triangles) file.write(fmt::format("3 {} {} {}\n", a, b, c));
    file.commit();
}

void write_areas(const Mesh& mesh, const NanoShaperRequest& request) {
    AtomicFile file(request.root + "triangleAreas.txt");
    for (const Triangle& triangle : mesh.triangles) file.write(fmt::format("{:f}\n", area_of(mesh, triangle)));
    file.commit();
}

void write_surface(const Mesh& mesh, const NanoShaperRequest& request) {
    if (request.msms_format)
        write_msms(request.root + "triangulatedSurf", mesh,
                   {.title = request.input, .probe = request.probe, .header = MsmsHeader::CountOnly});
    else
        write_off(mesh, request);
    write_areas(mesh, request);
}

void run(const std::vector<std::string>& arguments) {
    const NanoShaperRequest request = read_parameters(arguments);
    for (const std::string& warning : request.warnings) warn(kName, warning);
    const SphereFile spheres = read_sphere_file(request.input);
    print(fmt::format("<<INFO>> Starting Meniscus {}, a drop-in for NanoShaper\n<<INFO>> Read {} atoms from {}\n",
                      kVersion, spheres.atoms.size(), request.input));
    Surface surface = compute_surface(spheres.solid(), surface_options(request), {.threads = request.threads});
    const std::vector<std::uint32_t> places = spheres.solid_places();
    for (std::uint32_t& atom : surface.mesh.atoms) atom = places[atom];
    print(fmt::format("<<INFO>> Estimated volume {:.6g} [A^3]\n", surface.measures.volume));
    if (!request.triangulated) return require_passed(surface);
    write_surface(surface.mesh, request);
    print(
        fmt::format("<<INFO>> Number of vertices {} number of triangles {}\n"
                    "<<INFO>> Total, grid conformant, surface area is {:.6g} [A^2]\n",
                    surface.mesh.vertices.size(), surface.mesh.triangles.size(), surface.measures.area));
    require_passed(surface);
}

}  // namespace
}  // namespace meniscus::dropins

int main(int argc, char** argv) {
    return meniscus::dropins::run_guarded(meniscus::dropins::kName, argc, argv, meniscus::dropins::run);
}

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include "meniscus/describe_options.h"
#include "meniscus/write.h"
#include "objects.h"

namespace meniscus::c {
namespace {

static_assert(sizeof(SmallVec3) == 3 * sizeof(float) && sizeof(Triangle) == 3 * sizeof(std::uint32_t));

Progress progress_by(meniscus_progress function, void* user) {
    if (function == nullptr) return {};
    return [function, user](std::string_view stage, double fraction) {
        if (function(user, std::string(stage).c_str(), fraction) != 0) throw Stopped{};
    };
}

const float* data_or_null(const std::vector<float>& values) { return values.empty() ? nullptr : values.data(); }

}  // namespace

void write_to(const std::string& path, const meniscus_surface& surface, std::span<const Colour> colours) {
    const Surface& s = surface.surface;
    write_mesh(path, s.mesh,
               {.colours = colours,
                .structure = surface.structure.get(),
                .computed_with = &s.options,
                .probe = s.options.probe,
                .shortest_edge = s.measures.shortest_edge});
}

}  // namespace meniscus::c

using namespace meniscus::c;

meniscus_status meniscus_surface_new(const meniscus_exact* exact, const meniscus_options* given,
                                     meniscus_progress progress, void* user, meniscus_surface** surface) {
    return guarded([&] {
        need(exact, "exact");
        need(surface, "surface");
        const Options& options = options_of(given);
        for (const meniscus::Option& option : options.given)
            meniscus::refuse_without_effect(option, options.surface, spell);
        meniscus::RunOptions run = options.run;
        run.progress = progress_by(progress, user);
        *surface = new meniscus_surface{exact->structure, meniscus::mesh(exact->exact, options.surface, run)};
    });
}

void meniscus_surface_free(meniscus_surface* surface) { delete surface; }

size_t meniscus_vertex_count(const meniscus_surface* surface) {
    return surface != nullptr ? surface->surface.mesh.vertices.size() : 0;
}

size_t meniscus_triangle_count(const meniscus_surface* surface) {
    return surface != nullptr ? surface->surface.mesh.triangles.size() : 0;
}

const double* meniscus_vertex_positions(const meniscus_surface* surface) {
    return surface != nullptr ? &surface->surface.mesh.vertices.data()->x : nullptr;
}

const float* meniscus_vertex_normals(const meniscus_surface* surface) {
    return surface != nullptr ? &surface->surface.mesh.normals.data()->x : nullptr;
}

const uint32_t* meniscus_vertex_atoms(const meniscus_surface* surface) {
    return surface != nullptr ? surface->surface.mesh.atoms.data() : nullptr;
}

const uint8_t* meniscus_vertex_patches(const meniscus_surface* surface) {
    return surface != nullptr ? reinterpret_cast<const uint8_t*>(surface->surface.mesh.patches.data()) : nullptr;
}

const uint32_t* meniscus_vertex_components(const meniscus_surface* surface) {
    return surface != nullptr ? surface->surface.mesh.components.data() : nullptr;
}

const float* meniscus_vertex_values(const meniscus_surface* surface, const char* name) {
    if (surface == nullptr || name == nullptr) return nullptr;
    const meniscus::Mesh& mesh = surface->surface.mesh;
    const std::string_view wanted = name;
    if (wanted == "mean_curvature") return data_or_null(mesh.mean_curvatures);
    if (wanted == "gaussian_curvature") return data_or_null(mesh.gaussian_curvatures);
    if (wanted == "shape_index") return data_or_null(mesh.shape_indices);
    if (wanted == "area") return data_or_null(mesh.areas);
    return nullptr;
}

const uint32_t* meniscus_triangles(const meniscus_surface* surface) {
    return surface != nullptr ? surface->surface.mesh.triangles.data()->data() : nullptr;
}

meniscus_status meniscus_surface_report(meniscus_surface* surface, const char** json) {
    return guarded([&] {
        need(surface, "surface");
        need(json, "json");
        surface->report = report_of(*surface->structure, surface->surface);
        *json = surface->report.c_str();
    });
}

meniscus_status meniscus_write_mesh(const meniscus_surface* surface, const char* path) {
    return guarded([&] {
        need(surface, "surface");
        need(path, "path");
        write_to(path, *surface, {});
    });
}

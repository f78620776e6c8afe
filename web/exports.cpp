// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the WebAssembly module has beside the C interface: single precision for graphics, pages, an estimate beforehand,
// and progress that JavaScript hears of.
#include <emscripten.h>

#include <cstdlib>
#include <new>

#include "../c/objects.h"
#include "meniscus/cost.h"
#include "meniscus/file_words.h"
#include "meniscus/page.h"

// clang-format off
EM_JS(int, tell_progress, (const char* stage, double fraction), {
    return Module["progress"] ? Module["progress"](UTF8ToString(stage), fraction) : 0;
});
// clang-format on

namespace meniscus::c {
namespace {

int forward_progress(void* /*user*/, const char* stage, double fraction) { return tell_progress(stage, fraction); }

PageContent content_of(const Structure& structure, const Surface& surface, const char* colour) {
    PageOptions options{.exact = surface.exact};
    if (*colour != '\0') options.colours.scheme = parse_word("colour", colour, kColourSchemeWords);
    if (surface.measured != nullptr) {
        options.rows = page_rows(structure, surface, *surface.measured);
        options.components = surface.measured->components;
    } else {
        options.rows = page_rows(structure, surface);
    }
    return page_content(surface.mesh, structure, options);
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;

extern "C" {

/// meniscus_surface_new() whose progress goes to Module.progress(stage, fraction).
EMSCRIPTEN_KEEPALIVE meniscus_status meniscus_web_surface(const meniscus_exact* exact, const meniscus_options* options,
                                                          meniscus_surface** surface) {
    return meniscus_surface_new(exact, options, forward_progress, nullptr, surface);
}

/// Positions of the vertices in single precision, 3 numbers each.
EMSCRIPTEN_KEEPALIVE void meniscus_web_positions(const meniscus_surface* surface, float* positions) {
    for (const meniscus::Vec3& v : surface->surface.mesh.vertices) {
        *positions++ = static_cast<float>(v.x);
        *positions++ = static_cast<float>(v.y);
        *positions++ = static_cast<float>(v.z);
    }
}

/// meniscus_write_mesh(), with the colours that the program gives.
EMSCRIPTEN_KEEPALIVE meniscus_status meniscus_web_write_mesh(const meniscus_surface* surface, const char* path) {
    return guarded(
        [&] { write_to(path, *surface, meniscus::colour_vertices(surface->surface.mesh, *surface->structure)); });
}

/// Seconds of native code on one core, and MB that a surface would need.
EMSCRIPTEN_KEEPALIVE meniscus_status meniscus_web_estimate(const meniscus_structure* structure,
                                                           const meniscus_options* options, double* seconds,
                                                           double* megabytes) {
    return guarded([&] {
        const meniscus::Cost cost = meniscus::estimate_cost(structure->structure->atoms, options_of(options).surface);
        *seconds = cost.seconds;
        *megabytes = cost.memory_mb;
    });
}

/// What a page of the surface shows (page.h), colour: a scheme, or empty. Whoever calls frees *bytes.
EMSCRIPTEN_KEEPALIVE meniscus_status meniscus_web_page(const meniscus_surface* surface, const char* colour,
                                                       char** bytes, size_t* size) {
    return guarded([&] {
        const std::string data = content_of(*surface->structure, surface->surface, colour).data;
        *bytes = static_cast<char*>(std::malloc(data.size()));
        if (*bytes == nullptr) throw std::bad_alloc();
        *size = data.copy(*bytes, data.size());
    });
}
}

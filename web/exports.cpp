// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the WebAssembly module has beside the C interface: single precision for graphics, pages, an estimate beforehand,
// and progress that JavaScript hears of.
#include <emscripten.h>

#include <cstddef>
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

// Measured on 1UBQ, 1HGA and 1AON (docs/design/portable.md); interfaces as between the many chains of the last.
constexpr double kTimesNative = 2.4;
constexpr double kSecondsOfInterfacesPerAtom = 80e-6;

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

// Where web/src/engine.js reads what is known of an atom: four texts, two whole numbers.
static_assert(offsetof(meniscus_atom, name) == 0 && offsetof(meniscus_atom, element) == 4 &&
              offsetof(meniscus_atom, residue) == 8 && offsetof(meniscus_atom, chain) == 12 &&
              offsetof(meniscus_atom, residue_number) == 16 && offsetof(meniscus_atom, serial) == 20 &&
              sizeof(meniscus_atom) == 56);

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

/// What a surface with its reports would take here: seconds, memory in units of 2^20 bytes, and vertices.
EMSCRIPTEN_KEEPALIVE meniscus_status meniscus_web_estimate(const meniscus_structure* structure,
                                                           const meniscus_options* given, double* estimate) {
    return guarded([&] {
        const Options& options = options_of(given);
        const meniscus::Atoms& atoms = structure->structure->atoms;
        const meniscus::Cost cost = meniscus::estimate_cost(atoms, options.surface);
        estimate[0] = kTimesNative * cost.seconds;
        if (!options.between.empty()) estimate[0] += kSecondsOfInterfacesPerAtom * static_cast<double>(atoms.size());
        estimate[1] = cost.memory_mb;
        estimate[2] = cost.vertices;
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

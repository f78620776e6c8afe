// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/embree.h"

#include <dlfcn.h>

#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

namespace meniscus {
namespace {

// Throws for what the loader says: words are all it has.
[[noreturn]] void refuse(std::string_view reason) {
    const auto says = [&](std::string_view words) { return reason.find(words) != std::string_view::npos; };
    if (says("memory") || says("map segment")) throw std::bad_alloc();
    if (says("No such file"))
        throw std::runtime_error("pictures need Embree 3 (Debian package libembree3-3); install it");
    throw std::runtime_error("pictures cannot be drawn here: " + std::string(reason));
}

template <class Function>
Function find(void* library, const char* name) {
    void* const found = dlsym(library, name);
    if (found == nullptr) refuse(dlerror());
    return reinterpret_cast<Function>(found);
}

Embree load() {
    void* const library = dlopen("libembree3.so.3", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) refuse(dlerror());
    return {
        .new_device = find<decltype(&::rtcNewDevice)>(library, "rtcNewDevice"),
        .get_device_error = find<decltype(&::rtcGetDeviceError)>(library, "rtcGetDeviceError"),
        .release_device = find<decltype(&::rtcReleaseDevice)>(library, "rtcReleaseDevice"),
        .new_scene = find<decltype(&::rtcNewScene)>(library, "rtcNewScene"),
        .set_scene_flags = find<decltype(&::rtcSetSceneFlags)>(library, "rtcSetSceneFlags"),
        .commit_scene = find<decltype(&::rtcCommitScene)>(library, "rtcCommitScene"),
        .release_scene = find<decltype(&::rtcReleaseScene)>(library, "rtcReleaseScene"),
        .new_geometry = find<decltype(&::rtcNewGeometry)>(library, "rtcNewGeometry"),
        .set_new_geometry_buffer = find<decltype(&::rtcSetNewGeometryBuffer)>(library, "rtcSetNewGeometryBuffer"),
        .commit_geometry = find<decltype(&::rtcCommitGeometry)>(library, "rtcCommitGeometry"),
        .attach_geometry = find<decltype(&::rtcAttachGeometry)>(library, "rtcAttachGeometry"),
        .release_geometry = find<decltype(&::rtcReleaseGeometry)>(library, "rtcReleaseGeometry"),
        .intersect_1 = find<decltype(&::rtcIntersect1)>(library, "rtcIntersect1"),
    };
}

}  // namespace

const Embree& embree() {
    static const Embree functions = load();
    return functions;
}

}  // namespace meniscus

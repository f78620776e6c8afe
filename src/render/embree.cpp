// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/embree.h"

#include <optional>
#include <stdexcept>

#include "core/loaded_library.h"

namespace meniscus {
namespace {

Embree load() {
    const std::optional<LoadedLibrary> library = LoadedLibrary::load("libembree3.so.3");
    if (!library) throw std::runtime_error("pictures need Embree 3 (Debian package libembree3-3); install it");
    return {
        .new_device = library->function<decltype(::rtcNewDevice)>("rtcNewDevice"),
        .get_device_error = library->function<decltype(::rtcGetDeviceError)>("rtcGetDeviceError"),
        .release_device = library->function<decltype(::rtcReleaseDevice)>("rtcReleaseDevice"),
        .new_scene = library->function<decltype(::rtcNewScene)>("rtcNewScene"),
        .set_scene_flags = library->function<decltype(::rtcSetSceneFlags)>("rtcSetSceneFlags"),
        .commit_scene = library->function<decltype(::rtcCommitScene)>("rtcCommitScene"),
        .release_scene = library->function<decltype(::rtcReleaseScene)>("rtcReleaseScene"),
        .new_geometry = library->function<decltype(::rtcNewGeometry)>("rtcNewGeometry"),
        .set_new_geometry_buffer = library->function<decltype(::rtcSetNewGeometryBuffer)>("rtcSetNewGeometryBuffer"),
        .commit_geometry = library->function<decltype(::rtcCommitGeometry)>("rtcCommitGeometry"),
        .attach_geometry = library->function<decltype(::rtcAttachGeometry)>("rtcAttachGeometry"),
        .release_geometry = library->function<decltype(::rtcReleaseGeometry)>("rtcReleaseGeometry"),
        .intersect_1 = library->function<decltype(::rtcIntersect1)>("rtcIntersect1"),
    };
}

}  // namespace

const Embree& embree() {
    static const Embree functions = load();
    return functions;
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/embree.h"

#include <optional>
#include <stdexcept>

#include "platform/files/loaded_library.h"

namespace meniscus {
namespace {

Embree load() {
    const std::optional<LoadedLibrary> library = LoadedLibrary::load("libembree3.so.3");
    if (!library) throw std::runtime_error("pictures need Embree 3 (Debian package libembree3-3); install it");
    Embree found{};
    MENISCUS_FIND(library, rtcNewDevice, found.new_device);
    MENISCUS_FIND(library, rtcGetDeviceError, found.get_device_error);
    MENISCUS_FIND(library, rtcReleaseDevice, found.release_device);
    MENISCUS_FIND(library, rtcNewScene, found.new_scene);
    MENISCUS_FIND(library, rtcSetSceneFlags, found.set_scene_flags);
    MENISCUS_FIND(library, rtcCommitScene, found.commit_scene);
    MENISCUS_FIND(library, rtcReleaseScene, found.release_scene);
    MENISCUS_FIND(library, rtcNewGeometry, found.new_geometry);
    MENISCUS_FIND(library, rtcSetNewGeometryBuffer, found.set_new_geometry_buffer);
    MENISCUS_FIND(library, rtcCommitGeometry, found.commit_geometry);
    MENISCUS_FIND(library, rtcAttachGeometry, found.attach_geometry);
    MENISCUS_FIND(library, rtcReleaseGeometry, found.release_geometry);
    MENISCUS_FIND(library, rtcIntersect1, found.intersect_1);
    MENISCUS_FIND(library, rtcIntersect16, found.intersect_16);
    return found;
}

}  // namespace

const Embree& embree() {
    static const Embree functions = load();
    return functions;
}

}  // namespace meniscus

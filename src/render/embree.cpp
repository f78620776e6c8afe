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
    library->find("rtcNewDevice", found.new_device);
    library->find("rtcGetDeviceError", found.get_device_error);
    library->find("rtcReleaseDevice", found.release_device);
    library->find("rtcNewScene", found.new_scene);
    library->find("rtcSetSceneFlags", found.set_scene_flags);
    library->find("rtcCommitScene", found.commit_scene);
    library->find("rtcReleaseScene", found.release_scene);
    library->find("rtcNewGeometry", found.new_geometry);
    library->find("rtcSetNewGeometryBuffer", found.set_new_geometry_buffer);
    library->find("rtcCommitGeometry", found.commit_geometry);
    library->find("rtcAttachGeometry", found.attach_geometry);
    library->find("rtcReleaseGeometry", found.release_geometry);
    library->find("rtcIntersect1", found.intersect_1);
    library->find("rtcIntersect16", found.intersect_16);
    return found;
}

}  // namespace

const Embree& embree() {
    static const Embree functions = load();
    return functions;
}

}  // namespace meniscus

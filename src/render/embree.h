// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The functions of Embree that are used here, under their names without "rtc".
//
// The library is loaded with the first picture: that takes a twentieth of the time of a small surface, and most runs
// draw nothing.
#pragma once

#include <embree3/rtcore.h>

namespace meniscus {

struct Embree {
    decltype(&::rtcNewDevice) new_device;
    decltype(&::rtcGetDeviceError) get_device_error;
    decltype(&::rtcReleaseDevice) release_device;
    decltype(&::rtcNewScene) new_scene;
    decltype(&::rtcSetSceneFlags) set_scene_flags;
    decltype(&::rtcCommitScene) commit_scene;
    decltype(&::rtcReleaseScene) release_scene;
    decltype(&::rtcNewGeometry) new_geometry;
    decltype(&::rtcSetNewGeometryBuffer) set_new_geometry_buffer;
    decltype(&::rtcCommitGeometry) commit_geometry;
    decltype(&::rtcAttachGeometry) attach_geometry;
    decltype(&::rtcReleaseGeometry) release_geometry;
    decltype(&::rtcIntersect1) intersect_1;
    decltype(&::rtcIntersect16) intersect_16;
};

/// throws   std::runtime_error where the library is not installed, and as LoadedLibrary
const Embree& embree();

}  // namespace meniscus

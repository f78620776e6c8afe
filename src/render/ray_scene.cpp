// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/ray_scene.h"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>

#include "render/embree.h"

#ifndef MENISCUS_PORTABLE
#include <tbb/global_control.h>
#endif

namespace meniscus {
namespace {

// One thread builds the tree, so that ties between triangles are always decided alike.
#ifdef MENISCUS_PORTABLE
constexpr const char* kDevice = "threads=1";  // that Embree has threads of its own

struct OneThread {
    OneThread() {}  // as the other, an object that does something
};
#else
constexpr const char* kDevice = nullptr;

struct OneThread {
    tbb::global_control limit{tbb::global_control::max_allowed_parallelism, 1};
};
#endif

Vec3 centre_of(const std::vector<Vec3>& points) {
    Vec3 sum;
    for (const Vec3& p : points) sum += p;
    return (1.0 / static_cast<double>(points.size())) * sum;
}

float single(double value) { return static_cast<float>(value); }

/// Coordinates about `centre`, where single precision is fine even for molecules far from the origin.
void set_vertices(RTCGeometry geometry, const Mesh& mesh, const Vec3& centre) {
    auto* xyz = static_cast<float*>(embree().set_new_geometry_buffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
    if (xyz == nullptr) throw std::bad_alloc();
    for (const Vec3& vertex : mesh.vertices) {
        const Vec3 p = vertex - centre;
        *xyz++ = single(p.x);
        *xyz++ = single(p.y);
        *xyz++ = single(p.z);
    }
}

void set_triangles(RTCGeometry geometry, const Mesh& mesh) {
    auto* corners = static_cast<VertexId*>(embree().set_new_geometry_buffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), mesh.triangles.size()));
    if (corners == nullptr) throw std::bad_alloc();
    for (const Triangle& triangle : mesh.triangles)
        for (const VertexId corner : triangle) *corners++ = corner;
}

}  // namespace

struct RayScene::Handles {
    Handles() : device(embree().new_device(kDevice)), scene(device == nullptr ? nullptr : embree().new_scene(device)) {
        if (scene != nullptr) return;
        if (embree().get_device_error(device) != RTC_ERROR_UNSUPPORTED_CPU)
            throw std::bad_alloc();  // memory, or for threads
        throw std::runtime_error("pictures cannot be drawn here: Embree does not start");
    }
    ~Handles() {
        embree().release_scene(scene);
        embree().release_device(device);
    }
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;

    RTCDevice device;
    RTCScene scene;
};

RayScene::RayScene(const Mesh& mesh) : centre_(centre_of(mesh.vertices)) {
    const OneThread limit;
    const auto handles = std::make_shared<Handles>();
    RTCGeometry geometry = embree().new_geometry(handles->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    set_vertices(geometry, mesh, centre_);
    set_triangles(geometry, mesh);
    embree().commit_geometry(geometry);
    embree().attach_geometry(handles->scene, geometry);
    embree().release_geometry(geometry);
    embree().set_scene_flags(handles->scene, RTC_SCENE_FLAG_ROBUST);  // no holes along edges
    embree().commit_scene(handles->scene);
    handles_ = handles;
}

RayScene RayScene::cut(const HalfSpace& kept) const {
    RayScene copy = *this;
    copy.kept_ = kept;
    return copy;
}

/// Where along a ray something can be hit; empty if its end is not behind its beginning.
Interval RayScene::kept_part(const Ray& ray, double reach) const {
    const Interval part = kept_ ? kept_->part_of_ray(ray.origin, ray.direction) : Interval{};
    return {part.begin, std::min(part.end, reach)};
}

std::optional<RayHit> RayScene::first_hit(const Ray& ray, double reach) const {
    const Interval part = kept_part(ray, reach);
    if (part.begin >= part.end) return std::nullopt;
    const Vec3 origin = ray.origin - centre_;
    RTCRayHit query{};
    query.ray.org_x = single(origin.x);
    query.ray.org_y = single(origin.y);
    query.ray.org_z = single(origin.z);
    query.ray.dir_x = single(ray.direction.x);
    query.ray.dir_y = single(ray.direction.y);
    query.ray.dir_z = single(ray.direction.z);
    query.ray.tnear = single(part.begin);
    query.ray.tfar = single(part.end);
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    embree().intersect_1(handles_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return RayHit{query.ray.tfar, query.hit.primID, query.hit.u, query.hit.v};
}

void RayScene::first_hits(std::span<const Ray> rays, double reach, std::span<std::optional<RayHit>> hits) const {
    alignas(64) std::array<int, kTogether> is_sent{};
    RTCRayHit16 query{};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Interval part = kept_part(rays[i], reach);
        const Vec3 origin = rays[i].origin - centre_;
        query.ray.org_x[i] = single(origin.x);
        query.ray.org_y[i] = single(origin.y);
        query.ray.org_z[i] = single(origin.z);
        query.ray.dir_x[i] = single(rays[i].direction.x);
        query.ray.dir_y[i] = single(rays[i].direction.y);
        query.ray.dir_z[i] = single(rays[i].direction.z);
        query.ray.tnear[i] = single(part.begin);
        query.ray.tfar[i] = single(part.end);
        query.ray.mask[i] = ~0U;
        query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        is_sent[i] = part.begin < part.end ? -1 : 0;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    embree().intersect_16(is_sent.data(), handles_->scene, &context, &query);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i].reset();
        if (query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
        hits[i] = {query.ray.tfar[i], query.hit.primID[i], query.hit.u[i], query.hit.v[i]};
    }
}

}  // namespace meniscus

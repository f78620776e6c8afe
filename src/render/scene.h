// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What is seen at a point of the picture: a mesh in its colours and light, in front of a camera.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "meniscus/picture.h"
#include "render/camera.h"
#include "render/ray_scene.h"
#include "render/shading.h"
#include "render/sky_light.h"

namespace meniscus {

/// What one ray sees.
struct Glimpse {
    enum class Kind { Background, Surface, Section, Body };

    Light light{};
    float depth =
        std::numeric_limits<float>::infinity();  ///< behind the nearest vertex, Å; infinite for the background

    Kind kind = Kind::Background;

    bool is_background() const { return kind == Kind::Background; }
};

/// A place in the picture, pixels from its upper left corner.
struct Spot {
    double x = 0.0;
    double y = 0.0;
};

/// Triangles and one colour per vertex.
struct Painted {
    const Mesh& mesh;
    std::span<const Colour> colours;
};

class Scene {
public:
    /// All arguments but the rays must outlive the scene. Precondition: they have passed the checks of draw_picture(),
    /// and the mesh has a triangle.
    /// rays   of the mesh as it is, without a cut
    Scene(const Painted& surface, const RayScene& rays, const PictureOptions& options, const ColourField& exact,
          const Bodies& beside);

    /// Light of the sky that is known already, one share per vertex.
    void take_sky(std::span<const float> shares) { sky_.take(shares); }

    const Camera& camera() const { return camera_; }

    /// What is seen at every place: soonest for many next to each other. From several threads at once.
    std::vector<Glimpse> look(std::span<const Spot> spots) const;

private:
    struct Beside;

    /// What a ray hits, with the light that the surface sends back there.
    struct Sight {
        Ray ray;
        std::optional<RayHit> hit{};
        bool from_inside = false;      // it meets the side of the molecule
        const Beside* body = nullptr;  // it meets something beside the surface
        Light albedo{};

        Vec3 point() const { return ray.origin + hit->distance * ray.direction; }
    };

    /// Bodies that are drawn, prepared for rays; their sky is what the surface leaves open.
    struct Beside {
        Beside(Mesh shown, const RayScene& surface, double reach)
            : mesh(std::move(shown)), rays(mesh), sky({surface, mesh, reach}) {}
        Mesh mesh;
        RayScene rays;
        SkyLight sky;
    };

    const Mesh& mesh_of(const Sight& sight) const { return sight.body != nullptr ? sight.body->mesh : surface_.mesh; }
    std::vector<Sight> sights_at(std::span<const Spot> spots) const;
    std::vector<Sight> sights_of(const Beside& bodies, std::span<const Sight> along) const;
    double seen_at(const Sight& sight) const;
    float opacity_of(const Sight& sight) const;
    void forget_hidden(std::span<std::vector<Sight>> layers, std::size_t ray) const;
    void find_albedos(std::span<Sight> sights) const;
    Glimpse glimpse_through(std::span<const Sight* const> sights) const;
    Glimpse glimpse_of(const Sight& sight) const;
    bool faces_away(const Triangle& t, const Vec3& direction) const;
    /// A ray that meets the far side of the surface first has entered the cut molecule in its section.
    bool shows_section(const Sight& sight) const { return has_section_ && sight.from_inside; }
    Light light_from(const Sight& sight) const;
    Glimpse glimpse(Glimpse::Kind kind, const Light& light, const Vec3& point) const;
    double nearest_kept() const;

    Painted surface_;
    std::span<const Colour> colours_of_bodies_;
    const PictureOptions& options_;
    const ColourField& exact_;
    Camera camera_;
    std::optional<HalfSpace> kept_;  // by a cut
    bool has_section_;               // where the cut runs through the molecule
    RayScene rays_;
    SkyLight sky_;
    SkyLight sky_from_inside_;
    std::vector<std::unique_ptr<Beside>> beside_;  // solid bodies and clear ones, where there are any
    Lamps lamps_;
    Light background_;
    double front_;  // depth where the depth cue begins, Å
};

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The program `meniscus-msms`: a surface for those who call MSMS.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>

#include "dropins/guarded.h"
#include "dropins/msms_options.h"
#include "dropins/msms_report.h"
#include "dropins/sphere_file.h"
#include "dropins/surface_pieces.h"
#include "meniscus/errors.h"
#include "meniscus/measures.h"
#include "meniscus/remesh.h"
#include "meniscus/surface.h"
#include "meniscus/write.h"
#include "platform/files/atomic_file.h"

namespace meniscus::dropins {
namespace {

constexpr const char* kName = "meniscus-msms";
constexpr double kHydrogenRadius = 1.2;  // Å; what -noh leaves out

SphereFile read_spheres(const MsmsRequest& request) {
    if (request.input.empty()) throw UsageError("no input: name a file of spheres with -if");
    const SphereFile all = read_sphere_file(request.input);
    SphereFile kept = request.without_hydrogens ? without_radius(all, kHydrogenRadius) : all;
    if (kept.solid().empty()) throw InputError(request.input + ": -noh leaves no spheres");
    if (kept.collision_only > 0) warn(kName, "collision-only spheres are treated as ordinary ones");
    return kept;
}

/// Vertices lie on the exact surface; the grid is never coarser than the program's own, whatever the density.
Surface make_surface(const Atoms& atoms, const MsmsRequest& request) {
    SurfaceOptions options;
    options.method = Method::Direct;
    options.probe = request.probe;
    options.remesh.edge = edge_of_density(request.density);
    options.remesh.corners = Corners::OnSurface;  // as MSMS has them: readers take vertices for points of the surface
    options.spacing = std::min(options.spacing, options.remesh.edge);
    return compute_surface(atoms, options);
}

class MsmsRun {
public:
    explicit MsmsRun(const MsmsRequest& request)
        : request_(request),
          spheres_(read_spheres(request)),
          places_(spheres_.solid_places()),
          exact_(measure(spheres_.solid(), {.probe = request.probe, .patches = true})) {}

    void operator()() {
        print(msms_input(request_, spheres_));
        if (request_.triangulated) surface_ = make_surface(spheres_.solid(), request_);
        choose();
        print(msms_components(components()));
        if (request_.with_area) print(msms_areas(request_, components()));
        if (surface_) print(msms_volumes(request_, pieces()));
        if (surface_ && !request_.surface.empty()) write_pieces();
        if (request_.with_area && !request_.area.empty()) write_areas();
    }

    /// throws   ChecksFailed
    void check() const {
        if (surface_) require_passed(*surface_);
    }

private:
    /// Which exact components are asked for, and which pieces of the mesh stand for them.
    void choose() {
        if (surface_)
            matches_ = match_components(surface_->mesh, surface_->measures, exact_.components);
        else
            for (std::uint32_t c = 0; c < exact_.components.size(); ++c) matches_.push_back(c);
        if (!request_.cavity_atoms.empty())
            choose_touching();
        else
            choose_from_the_first_on(request_.all_components ? matches_.size()
                                                             : std::min<std::size_t>(1, matches_.size()));
        if (chosen_.empty())
            throw std::runtime_error("no closed piece of the surface could be meshed; use a higher -density");
        if (request_.all_components && chosen_.size() < exact_.components.size())
            warn(kName, std::to_string(exact_.components.size() - chosen_.size()) +
                            " closed pieces are too small for the mesh and are left out");
    }

    void choose_from_the_first_on(std::size_t count) {
        for (std::uint32_t piece = 0; piece < count; ++piece)
            if (matches_[piece] != kNone) chosen_.push_back(piece);
    }

    void choose_touching() {
        std::vector<std::uint32_t> atoms;
        for (const std::uint32_t place : request_.cavity_atoms) {
            const auto found = std::lower_bound(places_.begin(), places_.end(), place);
            if (found == places_.end() || *found != place)
                throw UsageError("-one_cavity: there is no sphere " + std::to_string(place) + " of positive radius");
            atoms.push_back(static_cast<std::uint32_t>(found - places_.begin()));
        }
        const std::uint32_t component = component_touching(exact_.components, atoms);
        const auto piece = std::find(matches_.begin(), matches_.end(), component);
        if (component == kNone || piece == matches_.end())
            throw UsageError("-one_cavity: no piece of the surface touches all these spheres; RS component not found");
        chosen_ = {static_cast<std::uint32_t>(piece - matches_.begin())};
    }

    std::vector<SurfaceComponent> components() const {
        std::vector<SurfaceComponent> components;
        for (const std::uint32_t piece : chosen_) components.push_back(exact_.components[matches_[piece]]);
        return components;
    }

    std::vector<MeshComponent> pieces() const {
        std::vector<MeshComponent> pieces;
        for (const std::uint32_t piece : chosen_) pieces.push_back(surface_->measures.components[piece]);
        return pieces;
    }

    void write_pieces() const {
        MsmsOptions options{.title = request_.input,
                            .spheres = spheres_.atoms.size(),
                            .density = request_.density,
                            .probe = request_.probe,
                            .names = spheres_.names,
                            .header = request_.with_header ? MsmsHeader::Full : MsmsHeader::None};
        for (std::size_t i = 0; i < chosen_.size(); ++i) {
            Mesh piece = piece_of(surface_->mesh, chosen_[i]);
            for (std::uint32_t& atom : piece.atoms) atom = places_[atom];
            write_msms(request_.surface + (i == 0 ? "" : "_" + std::to_string(i)), piece, options);
        }
    }

    void write_areas() const {
        std::vector<std::vector<AtomShare>> shares;
        for (const std::uint32_t piece : chosen_) shares.push_back(shares_of_atoms(exact_, matches_[piece]));
        AtomicFile file(request_.area.ends_with(".area") ? request_.area : request_.area + ".area");
        file.write(msms_area_table(spheres_, shares, places_));
        file.commit();
    }

    const MsmsRequest& request_;
    SphereFile spheres_;
    std::vector<std::uint32_t> places_;  // of the solid spheres in the file
    Measures exact_;
    std::optional<Surface> surface_;
    std::vector<std::uint32_t> matches_;  // exact component of every piece of the mesh
    std::vector<std::uint32_t> chosen_;   // pieces
};

void run(const std::vector<std::string>& arguments) {
    const auto start = std::chrono::steady_clock::now();
    const MsmsRequest request = parse_msms(arguments);
    if (request.help) {
        std::cerr << msms_usage();
        return;
    }
    print(msms_banner());
    for (const std::string& warning : request.warnings) warn(kName, warning);
    MsmsRun run_of(request);
    run_of();
    print(msms_end(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));
    run_of.check();
}

}  // namespace
}  // namespace meniscus::dropins

int main(int argc, char** argv) {
    return meniscus::dropins::run_guarded(meniscus::dropins::kName, argc, argv, meniscus::dropins::run);
}

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/msms_report.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "meniscus/version.h"
#include "messages.h"

namespace meniscus::dropins {
namespace {

std::string host() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : "this machine";
}

}  // namespace

std::string msms_banner() {
    return fmt::format("MSMS 2.6.1 started on {}\nby Meniscus {}, a drop-in program that contains no MSMS code\n",
                       host(), kVersion);
}

std::string msms_input(const MsmsRequest& request, const SphereFile& spheres) {
    const auto [least, most] = std::minmax_element(spheres.atoms.radii.begin(), spheres.atoms.radii.end());
    return fmt::format("INPUT  {} {} spheres {} collision only, radii {:6.3f} to {:6.3f}\n",
                       cli::one_line(request.input), spheres.atoms.size(), spheres.collision_only, *least, *most) +
           fmt::format("PARAM  Probe_radius {:6.3f} density {:6.3f} hdensity {:6.3f}\n", request.probe, request.density,
                       request.hdensity);
}

std::string msms_components(std::span<const SurfaceComponent> components) {
    constexpr std::size_t kShown = 3;
    std::string text = "REDUCED SURFACE ...\n";
    for (std::size_t c = 0; c < components.size(); ++c) {
        fmt::format_to(std::back_inserter(text), "    RS component {} identified", c);
        for (std::size_t i = 0; i < std::min(kShown, components[c].atoms.size()); ++i)
            fmt::format_to(std::back_inserter(text), " {}", components[c].atoms[i]);
        text += '\n';
    }
    return text;
}

std::string msms_areas(const MsmsRequest& request, std::span<const SurfaceComponent> components) {
    std::string text =
        "ANALYTICAL SURFACE AREA :\n    Comp. probe_radius,   reent,    toric,   contact    SES       SAS\n";
    for (std::size_t c = 0; c < components.size(); ++c)
        fmt::format_to(std::back_inserter(text), "  {:5} {:11.3f} {:11.3f} {:9.3f} {:9.3f} {:9.3f} {:9.3f}\n", c,
                       request.probe, components[c].reentrant_area, components[c].toroidal_area,
                       components[c].contact_area, components[c].ses_area, components[c].sas_area);
    return text;
}

std::string msms_volumes(const MsmsRequest& request, std::span<const MeshComponent> pieces) {
    std::string text = "TRIANGULATION...\n";
    for (std::size_t c = 0; c < pieces.size(); ++c)
        fmt::format_to(std::back_inserter(text), "    component {}: {} vertices, {} triangles\n", c, pieces[c].vertices,
                       pieces[c].triangles);
    text += "NUMERICAL VOLUMES AND AREA\n    Comp. probe_radius SES_volume SES_area)\n";
    double total = 0.0;
    for (std::size_t c = 0; c < pieces.size(); ++c) {
        fmt::format_to(std::back_inserter(text), "  {:6} {:9.2f} {:12.3f} {:10.3f}\n", c, request.probe,
                       pieces[c].volume, pieces[c].area);
        total += pieces[c].volume;
    }
    return text + fmt::format("    Total ses_volume: {:9.3f}\n", total);
}

std::string msms_end(double real) {
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return fmt::format("MSMS terminated normally\nTotal Time real: {:9.2f} user: {:9.2f} sys: {:9.2f}\n", real,
                       seconds(used.ru_utime), seconds(used.ru_stime));
}

std::string msms_area_table(const SphereFile& spheres, std::span<const std::vector<AtomShare>> shares,
                            std::span<const std::uint32_t> places) {
    std::vector<std::uint32_t> number(spheres.atoms.size(), kNone);
    for (std::size_t i = 0; i < places.size(); ++i) number[places[i]] = static_cast<std::uint32_t>(i);
    std::string text = "Atom #";
    for (std::size_t c = 0; c < shares.size(); ++c)
        fmt::format_to(std::back_inserter(text), " {:>9} {:>9}", fmt::format("ses_{}", c), fmt::format("sas_{}", c));
    text += '\n';
    for (std::size_t i = 0; i < number.size(); ++i) {
        fmt::format_to(std::back_inserter(text), "{:6}", i);
        for (const std::vector<AtomShare>& of_component : shares) {
            const AtomShare share = number[i] == kNone ? AtomShare{} : of_component[number[i]];
            fmt::format_to(std::back_inserter(text), " {:9.3f} {:9.3f}", share.ses, share.sas);
            if (!spheres.names.empty()) text.append(" ").append(spheres.names[i]);
        }
        text += '\n';
    }
    return text;
}

}  // namespace meniscus::dropins

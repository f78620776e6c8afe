// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What MSMS prints and its file of areas, in the words and columns that callers read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dropins/msms_options.h"
#include "dropins/sphere_file.h"
#include "dropins/surface_pieces.h"
#include "meniscus/measures.h"
#include "meniscus/mesh.h"

namespace meniscus::dropins {

/// The first lines; callers look for the version in the first.
std::string msms_banner();

/// INPUT and PARAM.
std::string msms_input(const MsmsRequest& request, const SphereFile& spheres);

/// "RS component 0 identified" and up to three atoms that touch it, for every component.
std::string msms_components(std::span<const SurfaceComponent> components);

/// Exact areas by kind of patch.
std::string msms_areas(const MsmsRequest& request, std::span<const SurfaceComponent> components);

/// Volumes and areas of the meshes; cavities count negative.
std::string msms_volumes(const MsmsRequest& request, std::span<const MeshComponent> pieces);

/// The last two lines.
/// real   seconds since the start; processor time is asked of the system
std::string msms_end(double real);

/// The table of areas: a line per sphere of the file, for every component the SES and the SAS area and, if there are
/// names, the name.
/// shares   per component, of the spheres that `places` names
std::string msms_area_table(const SphereFile& spheres, std::span<const std::vector<AtomShare>> shares,
                            std::span<const std::uint32_t> places);

}  // namespace meniscus::dropins

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/surface.h"

namespace meniscus {

SesProblem ses_problem(const Atoms& atoms, const SurfaceOptions& options) {
    SesProblem problem{atoms, options.surface == SurfaceKind::Ses ? options.probe : 0.0};
    if (options.surface == SurfaceKind::Sas)
        for (double& radius : problem.atoms.radii) radius += options.probe;
    return problem;
}

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A surface with the structure that it belongs to, as Python objects hold it.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "meniscus/accessible_surface.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"

namespace meniscus::python {

class HeldSurface {
public:
    HeldSurface(std::shared_ptr<const Structure> structure, Surface surface)
        : structure_(std::move(structure)), surface_(std::move(surface)) {}

    const Structure& structure() const { return *structure_; }
    const std::shared_ptr<const Structure>& shared_structure() const { return structure_; }
    const Surface& surface() const { return surface_; }

    /// The exact surface, made when it is first asked for.
    const AccessibleSurface& accessible() const {
        std::call_once(made_, [this] {
            const SesProblem problem = ses_problem(structure_->atoms, surface_.options);
            accessible_ = std::make_unique<AccessibleSurface>(problem.atoms, problem.probe);
        });
        return *accessible_;
    }

private:
    std::shared_ptr<const Structure> structure_;
    Surface surface_;
    mutable std::once_flag made_;
    mutable std::unique_ptr<AccessibleSurface> accessible_;
};

}  // namespace meniscus::python

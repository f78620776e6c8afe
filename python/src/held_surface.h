// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A surface with the structure that it belongs to, as Python objects hold it.
#pragma once

#include <memory>

#include "meniscus/structure.h"
#include "meniscus/surface.h"

namespace meniscus::python {

struct HeldSurface {
    std::shared_ptr<const Structure> structure;
    Surface surface;
    int threads = 0;  ///< that it was computed with, for what is asked of it later
};

}  // namespace meniscus::python

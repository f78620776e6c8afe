// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/gemmi/elements.h"

// gemmi is not written for our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <gemmi/elem.hpp>
#pragma GCC diagnostic pop

namespace meniscus::reading {

Bonding bonding_of(const std::string& symbol) {
    const gemmi::Element element(symbol);
    return {element.covalent_r(), element.is_metal(), element.is_hydrogen()};
}

}  // namespace meniscus::reading

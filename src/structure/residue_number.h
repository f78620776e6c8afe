// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers of residues that are one word with their insertion codes.
#pragma once

#include <string_view>

#include "reading/numbers.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// Sets number and insertion code from "27", "-5" or "27A"; false, and nothing set, if the word is none of these.
inline bool set_number(std::string_view digits, RawResidue& residue) {
    const bool has_code = !integer(digits) && digits.size() > 1 && digits.back() != '.';
    const auto value = integer(digits.substr(0, digits.size() - static_cast<std::size_t>(has_code)));
    if (!value) return false;
    residue.number = *value;
    if (has_code) residue.insertion_code = digits.back();
    return true;
}

}  // namespace meniscus::reading

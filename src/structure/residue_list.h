// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Groups atoms, as they come from a file, into residues.
#pragma once

#include <cstdint>
#include <vector>

#include "structure/raw_model.h"

namespace meniscus::reading {

/// Collects residues: atoms that follow each other with the same site (chain, segment, number, insertion code) and name
/// share one. Which of these residues are pieces of a larger one, join_residues decides.
class ResidueList {
public:
    explicit ResidueList(std::vector<RawResidue>& residues) : residues_(residues) {}

    /// Index of the residue that the next atom belongs to, added if it is new.
    std::uint32_t index_of(const RawResidue& residue) {
        if (residues_.empty() || !is_same(residues_.back(), residue)) residues_.push_back(residue);
        return static_cast<std::uint32_t>(residues_.size() - 1);
    }

private:
    static bool is_same(const RawResidue& a, const RawResidue& b) {
        return a.number == b.number && a.insertion_code == b.insertion_code && a.name == b.name && a.chain == b.chain &&
               a.segment == b.segment && a.label_chain == b.label_chain;
    }

    std::vector<RawResidue>& residues_;
};

}  // namespace meniscus::reading

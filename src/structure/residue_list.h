// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Groups atoms, as they come from a file, into residues.
#pragma once

#include <cstdint>
#include <vector>

#include "structure/raw_model.h"

namespace meniscus::reading {

/// Collects residues: neighbouring atoms of one site (chain, segment, number, insertion code) and one name share a
/// residue, also if alternatives with another name stand between them. What becomes of residues in several pieces,
/// join_residues decides.
class ResidueList {
public:
    explicit ResidueList(std::vector<RawResidue>& residues) : residues_(residues) {}

    /// Index of the residue that the next atom belongs to, added if it is new.
    std::uint32_t index_of(const RawResidue& residue) {
        if (residues_.empty() || !same_site(residues_.back(), residue)) site_begin_ = residues_.size();
        for (std::size_t i = site_begin_; i < residues_.size(); ++i) {
            if (residues_[i].name == residue.name) return static_cast<std::uint32_t>(i);
        }
        residues_.push_back(residue);
        return static_cast<std::uint32_t>(residues_.size() - 1);
    }

private:
    static bool same_site(const RawResidue& a, const RawResidue& b) {
        return a.number == b.number && a.insertion_code == b.insertion_code && a.chain == b.chain &&
               a.segment == b.segment && a.label_chain == b.label_chain;
    }

    std::vector<RawResidue>& residues_;
    std::size_t site_begin_ = 0;
};

}  // namespace meniscus::reading

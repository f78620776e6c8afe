// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Colours and numbers that are known of elements and residues by name.
#pragma once

#include <optional>
#include <string_view>

#include "meniscus/colour.h"

namespace meniscus {

/// The colours of RasMol (Sayle & Milner-White, TIBS 20, 1995, 374), after the models of Corey, Pauling and Koltun;
/// kNeutral for elements that it does not tell apart. `element` as in AtomLabel.
Colour element_colour(std::string_view element);

/// Of the kind of residue, under any of its common names; kNeutral for all others.
///
/// Amino acids: "ocean" of Kunzmann, Mayer & Hamacher, BMC Bioinformatics 21, 2020, 209, in which those that replace
/// each other look alike. Nucleotides: the hues of the Nucleic Acid Database (A red, C yellow, G green, T blue, U cyan)
/// in Tol's "bright".
Colour residue_colour(std::string_view residue);

/// "ALA" for any common name of alanine, "A" for DA: what residue_colour() goes by; empty where it knows none.
std::string_view residue_kind(std::string_view residue);

/// Kyte & Doolittle, J. Mol. Biol. 157, 1982, 105-132: -4.5 (arginine) to 4.5 (isoleucine); nothing for what is no
/// amino acid.
std::optional<double> hydropathy(std::string_view residue);

/// A band of confidence in the AlphaFold Protein Structure Database.
struct PlddtBand {
    double above;
    const char* name;
    Colour colour;
};
const PlddtBand& plddt_band(double plddt);

}  // namespace meniscus

// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/radii.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "meniscus/errors.h"
#include "radii/element_radii.h"
#include "radii/radius_set.h"
#include "radii/rule_file.h"
#include "reading/text.h"

namespace meniscus {
namespace {

RadiusSet find_or_read(const std::string& name) {
    if (auto set = find_radius_set(name)) return *set;
    std::error_code ignored;
    if (std::filesystem::exists(name, ignored)) return read_radius_rules(name);
    throw UsageError(fmt::format("radii {}: neither a radius set nor a file; choose one of {}, or a file of rules",
                                 name, radius_set_names()));
}

std::string upper(const std::string& text) {
    std::string result;
    for (const char c : text)
        if (std::isspace(static_cast<unsigned char>(c)) == 0)
            result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return result;
}

}  // namespace

std::vector<double> radii_of(std::span<const AtomNames> atoms, const std::string& set) {
    RadiusTyper typer(find_or_read(set));
    std::vector<double> radii;
    radii.reserve(atoms.size());
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const std::string residue = upper(atoms[i].residue);
        const std::string name = upper(atoms[i].name);
        const std::string element = upper(atoms[i].element);
        const bool united = typer.set().united && (element == "H" || element == "D");
        const auto known =
            united ? std::optional(0.0) : typer.find({.residue = residue, .name = name, .element = element});
        const auto of_element = element_radius(element);
        if (!known && !of_element)
            throw UsageError(
                fmt::format("atom {} ({} of {}, element {}): set {} has no radius for it, and its element is unknown; "
                            "give its element",
                            i, reading::shown(atoms[i].name), reading::shown(atoms[i].residue),
                            reading::shown(atoms[i].element), typer.set().name));
        radii.push_back(known ? *known : of_element->radius);
    }
    return radii;
}

}  // namespace meniscus

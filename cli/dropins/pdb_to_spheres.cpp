// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/pdb_to_spheres.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <vector>

#include "dropins/guarded.h"
#include "dropins/pdb_spheres.h"
#include "meniscus/errors.h"

namespace meniscus::dropins {
namespace {

constexpr double kUnitedHydrogen = 1.2;  // Å; the radius that msms -noh leaves out

bool is_hydrogen(const PdbRecord& record) { return record.names.element == "H" || record.names.element == "D"; }

struct PdbFile {
    std::string path;
    std::vector<PdbRecord> records;
};

std::vector<double> radii_for(const PdbFile& file, bool explicit_hydrogens) {
    std::vector<AtomNames> names;
    names.reserve(file.records.size());
    for (const PdbRecord& record : file.records) names.push_back(record.names);
    try {
        return radii_of(names, explicit_hydrogens ? "bondi" : "united");
    } catch (const UsageError& error) {
        throw InputError(fmt::format("{}: {}", file.path, error.what()));
    }
}

void print_spheres(const std::vector<PdbFile>& files, bool explicit_hydrogens, bool with_names,
                   const std::string& name) {
    std::string text;
    std::size_t hydrogens = 0;
    for (const PdbFile& file : files) {
        const std::vector<double> radii = radii_for(file, explicit_hydrogens);
        for (std::size_t i = 0; i < radii.size(); ++i) {
            const PdbRecord& record = file.records[i];
            const bool is_united = !explicit_hydrogens && is_hydrogen(record);
            const double radius = is_united ? kUnitedHydrogen : radii[i];
            text += with_names ? xyzrn_line(record, radius) : xyzr_line(record, radius);
            hydrogens += is_united ? 1 : 0;
        }
    }
    if (hydrogens > 0)
        warn(name, fmt::format("{} hydrogens written, but the radii of heavy atoms already include their hydrogens: "
                               "use msms -noh, or -h for explicit radii",
                               hydrogens));
    print(text);
}

PdbFile read_file(const std::string& path) {
    if (path == "-") return {path, read_pdb_records(std::cin, path)};
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("{}: cannot be opened: {}; check the name", path, std::strerror(errno)));
    return {path, read_pdb_records(file, path)};
}

void run(const std::string& name, bool with_names, const std::vector<std::string>& arguments) {
    bool explicit_hydrogens = false;
    std::vector<PdbFile> files;
    for (const std::string& argument : arguments) {
        if (argument == "--help")
            return print(fmt::format("Usage: {} [-h] [FILE.pdb ...]\n-h  explicit hydrogens\n", name));
        if (argument == "-h")
            explicit_hydrogens = true;
        else if (argument.size() > 1 && argument[0] == '-')
            throw UsageError(fmt::format("{}: unknown option; -h takes radii for explicit hydrogens", argument));
        if (argument[0] == '-' && argument != "-") continue;
        files.push_back(read_file(argument));
    }
    if (files.empty()) files.push_back(read_file("-"));
    print_spheres(files, explicit_hydrogens, with_names, name);
}

}  // namespace

int run_pdb_to_spheres(const std::string& name, bool with_names, int argc, char** argv) {
    return run_guarded(name, argc, argv, [&](const auto& arguments) { run(name, with_names, arguments); });
}

}  // namespace meniscus::dropins

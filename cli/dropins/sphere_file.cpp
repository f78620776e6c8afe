// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/sphere_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string_view>

#include "dropins/strict_number.h"
#include "meniscus/errors.h"
#include "next_line.h"
#include "reading/text.h"

namespace meniscus::dropins {
namespace {

struct Word {
    std::string_view text;
    std::size_t column = 0;  // from 1 on
};

std::vector<Word> words_of(std::string_view line) {
    constexpr std::string_view kBlanks = " \t\r\v\f";
    std::vector<Word> words;
    for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        words.push_back({line.substr(at, end - at), at + 1});
        at = line.find_first_not_of(kBlanks, end);
    }
    return words;
}

/// One line of the file, which knows where it stands.
class Line {
public:
    Line(const std::string& path, std::size_t number, std::string_view text)
        : path_(path), number_(number), words_(words_of(text)), end_(text.size() + 1) {}

    const std::vector<Word>& words() const { return words_; }

    double number(std::size_t i, const char* what) const {
        if (i >= words_.size()) fail(end_, fmt::format("the {} is missing; a sphere is x y z radius", what));
        const auto value = strict_number(words_[i].text);
        if (!value)
            fail(words_[i].column,
                 fmt::format("{} {} is not a finite number; correct it", what, reading::shown(words_[i].text)));
        return *value;
    }

    double radius() const {
        constexpr std::size_t kRadius = 3;
        const double value = number(kRadius, "radius");
        if (value < 0.0) fail(words_[kRadius].column, "the radius is negative; 0 leaves a sphere out");
        return value;
    }

private:
    [[noreturn]] void fail(std::size_t column, const std::string& message) const {
        throw InputError(fmt::format("{}:{}:{}: {}", path_, number_, column, message));
    }

    const std::string& path_;
    std::size_t number_;
    std::vector<Word> words_;
    std::size_t end_;
};

void add_sphere(const Line& line, SphereFile& spheres) {
    constexpr std::size_t kFlag = 4;
    spheres.atoms.centres.push_back(
        {line.number(0, "x coordinate"), line.number(1, "y coordinate"), line.number(2, "z coordinate")});
    spheres.atoms.radii.push_back(line.radius());
    const std::vector<Word>& words = line.words();
    const auto flag = words.size() > kFlag ? strict_number(words[kFlag].text) : std::nullopt;
    if (flag == 0.0) ++spheres.collision_only;
    const std::size_t name = kFlag + (flag ? 1 : 0);
    spheres.names.emplace_back(words.size() > name ? words[name].text : "");
}

void finish_names(std::vector<std::string>& names) {
    if (std::all_of(names.begin(), names.end(), [](const std::string& name) { return name.empty(); })) names.clear();
    for (std::string& name : names)
        if (name.empty()) name = "-";
}

}  // namespace

SphereFile read_sphere_file(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("{}: cannot be opened: {}; check the name", path, std::strerror(errno)));
    SphereFile spheres;
    std::size_t number = 0;
    for (std::string text; cli::next_line(file, text, path, number + 1);) {
        const Line line(path, ++number, text);
        if (!line.words().empty() && line.words().front().text.front() != '#') add_sphere(line, spheres);
    }
    if (file.bad()) throw InputError(path + ": cannot be read");
    if (spheres.solid().empty()) throw InputError(path + ": no sphere with a positive radius in this file");
    finish_names(spheres.names);
    return spheres;
}

std::vector<std::uint32_t> SphereFile::solid_places() const {
    std::vector<std::uint32_t> places;
    for (std::size_t i = 0; i < atoms.size(); ++i)
        if (atoms.radii[i] > 0.0) places.push_back(static_cast<std::uint32_t>(i));
    return places;
}

Atoms SphereFile::solid() const {
    Atoms solid;
    for (const std::uint32_t i : solid_places()) {
        solid.centres.push_back(atoms.centres[i]);
        solid.radii.push_back(atoms.radii[i]);
    }
    return solid;
}

SphereFile without_radius(const SphereFile& spheres, double radius) {
    SphereFile kept;
    kept.collision_only = spheres.collision_only;
    for (std::size_t i = 0; i < spheres.atoms.size(); ++i) {
        if (spheres.atoms.radii[i] == radius) continue;
        kept.atoms.centres.push_back(spheres.atoms.centres[i]);
        kept.atoms.radii.push_back(spheres.atoms.radii[i]);
        if (!spheres.names.empty()) kept.names.push_back(spheres.names[i]);
    }
    return kept;
}

}  // namespace meniscus::dropins

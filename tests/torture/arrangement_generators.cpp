// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "torture/arrangement_generators.h"

#include <rapidcheck.h>

#include <array>
#include <iomanip>
#include <limits>
#include <ostream>

namespace meniscus::testing {
namespace {

// What arrangements are made of: parts per thousand.
using Lump = std::array<int, 4>;
using Clay = std::vector<Lump>;

double fraction(int part) { return part / 1000.0; }
double between(double low, double high, int part) { return low + (high - low) * fraction(part); }

Vec3 in_cube(const Lump& lump, double edge) {
    return edge * Vec3{fraction(lump[0]), fraction(lump[1]), fraction(lump[2])};
}

Vec3 direction(const Lump& lump) {
    const Vec3 p = in_cube(lump, 2.0) - Vec3{1.0, 1.0, 1.0};
    return norm(p) > 1e-3 ? normalised(p) : Vec3{1.0, 0.0, 0.0};
}

const Lump& at(const Clay& clay, std::size_t i) { return clay[i % clay.size()]; }

// A neighbour of a number, or itself.
double nudged(double value, int part) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (part % 3 == 0) return value;
    return std::nextafter(value, part % 3 == 1 ? kInfinity : -kInfinity);
}

// 10^-1 to 10^-12 of either sign, or nothing.
double hair(int part) {
    if (part % 5 == 0) return 0.0;
    return (part % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, -1.0 - part % 12);
}

void add(Atoms& atoms, const Vec3& centre, double radius) {
    atoms.centres.push_back(centre);
    atoms.radii.push_back(radius);
}

// The first lump of each kind says how it is made, all of them where the spheres are.
using Shape = Atoms (*)(const Clay&, double probe);

Atoms cloud(const Clay& clay, double) {
    Atoms atoms;
    const double edge = std::cbrt(clay.size()) * between(0.5, 3.5, clay[0][3]);
    for (const Lump& lump : clay) add(atoms, in_cube(lump, edge), between(0.8, 2.2, lump[3]));
    return atoms;
}

Atoms lattice(const Clay& clay, double) {
    constexpr std::array kSteps{1.0, 1.5, 2.0, 2.5, 2.8, 3.2, 3.4, 4.8};
    const double step = kSteps[clay[0][3] % kSteps.size()];
    const int edge = 1 + static_cast<int>(std::cbrt(clay.size()));
    Atoms atoms;
    for (const Lump& lump : clay)
        add(atoms, step * Vec3{1.0 * (lump[0] % edge), 1.0 * (lump[1] % edge), 1.0 * (lump[2] % edge)}, 1.7);
    return atoms;
}

Atoms chain(const Clay& clay, double) {
    constexpr std::array<Vec3, 3> kAxes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    const double step = 0.5 * (1 + clay[0][3] % 12);
    Atoms atoms;
    Vec3 place;
    for (const Lump& lump : clay) {
        add(atoms, place, 1.5);
        place += step * kAxes[lump[0] % 2 == 0 ? 0 : lump[1] % 3];
    }
    return atoms;
}

Atoms nested(const Clay& clay, double) {
    Atoms atoms;
    for (const Lump& lump : clay) {
        const bool within = !atoms.empty() && lump[0] % 2 == 0;
        const Vec3 place = within ? atoms.centres[lump[1] % atoms.size()] : in_cube(lump, 6.0);
        const Vec3 shift = lump[0] % 4 == 0 ? Vec3{} : between(0.0, 0.5, lump[2]) * direction(lump);
        add(atoms, within ? place + shift : place, between(0.3, 2.5, lump[3]));
    }
    return atoms;
}

// Each touches the one before within rounding: from outside, from inside, or with the probe between.
Atoms kissing(const Clay& clay, double probe) {
    Atoms atoms;
    for (const Lump& lump : clay) {
        const double radius = 0.5 + 0.1 * (lump[3] % 16);
        if (atoms.empty()) {
            add(atoms, {}, radius);
            continue;
        }
        const double before = atoms.radii.back();
        const std::array distances{before + radius, before + radius + 2.0 * probe, std::abs(before - radius)};
        const double distance = nudged(distances[lump[3] % 7 < 4 ? 0 : lump[3] % 7 - 4], lump[2]);
        const Vec3 along = lump[1] % 2 == 0 ? Vec3{1, 0, 0} : direction(lump);
        add(atoms, atoms.centres.back() + distance * along, radius);
    }
    return atoms;
}

Atoms coincident(const Clay& clay, double) {
    Atoms atoms;
    for (const Lump& lump : clay) {
        Vec3 place = in_cube(at(clay, lump[0] % 3), 4.0);
        place.x = nudged(place.x, lump[1]);
        add(atoms, place, nudged(0.5 + 0.5 * (lump[3] % 4), lump[2]));
    }
    return atoms;
}

// Two sheets as far apart as the probe is wide, or a hair more or less.
Atoms needle_gap(const Clay& clay, double probe) {
    const double step = between(1.0, 3.0, clay[0][3]);
    const double gap = 2.0 * probe + hair(clay[0][0]);
    const int edge = 1 + static_cast<int>(std::sqrt(0.5 * static_cast<double>(clay.size())));
    Atoms atoms;
    for (int i = 0; i < 2 * edge * edge; ++i) {
        const double z = i % 2 == 0 ? 0.0 : gap + 3.0;
        const int row = i / 2 / edge;
        const int column = i / 2 % edge;
        add(atoms, {step * column, step * row, z}, 1.5);
    }
    return atoms;
}

// The probe just passes, or just does not.
Atoms needle_eye(const Clay& clay, double probe) {
    const int count = 3 + static_cast<int>(clay.size() % 20);
    const double radius = between(0.5, 2.0, clay[0][3]);
    Atoms atoms = ring(count, radius + probe + hair(clay[0][0]), radius);
    for (std::size_t i = 0; i + 1 < clay.size() / 4; ++i)
        add(atoms, {0.0, 0.0, between(2.0, 6.0, clay[i][1])}, between(0.5, 2.0, clay[i][2]));
    return atoms;
}

// Radii from 0.01 to 100 Å, each sphere near the surface of another.
Atoms great_and_small(const Clay& clay, double) {
    Atoms atoms;
    for (const Lump& lump : clay) {
        const double radius = 0.01 * std::pow(10.0, 4.0 * fraction(lump[3]));
        if (atoms.empty()) {
            add(atoms, {}, radius);
            continue;
        }
        const std::size_t beside = lump[2] % atoms.size();
        const double distance = atoms.radii[beside] + between(-0.8, 1.5, lump[1]) * radius;
        add(atoms, atoms.centres[beside] + distance * direction(lump), radius);
    }
    return atoms;
}

Atoms flat(const Clay& clay, double) {
    Atoms atoms = cloud(clay, 0.0);
    for (Vec3& c : atoms.centres) c.z = 0.0;
    if (clay[0][1] % 2 == 0) atoms.radii.assign(atoms.size(), 1.6);
    return atoms;
}

// On one sphere, so that as many circles as may be meet in one point.
Atoms cospherical(const Clay& clay, double probe) {
    const double radius = clay[0][0] % 2 == 0 ? 1.5 + probe : between(1.0, 6.0, clay[0][3]);
    Atoms atoms;
    for (const Lump& lump : clay) add(atoms, radius * direction(lump), 1.5);
    return atoms;
}

Atoms shell(const Clay& clay, double) {
    return hollow_shell(10 + static_cast<int>(clay.size()), between(1.0, 6.0, clay[0][0]),
                        between(1.0, 2.2, clay[0][3]));
}

// Two clusters so far apart that single precision would lose the atoms.
Atoms far_apart(const Clay& clay, double) {
    constexpr std::array kFar{1e3, 1e5, 1e6, -1e6};
    Atoms atoms = cloud(clay, 0.0);
    const double far = kFar[clay[0][0] % kFar.size()];
    for (std::size_t i = 0; i < atoms.size(); i += 2) atoms.centres[i] += Vec3{far, 0.7 * far, -0.3 * far};
    return atoms;
}

struct Kind {
    const char* name;
    Shape shape;
};
constexpr std::array kKinds{
    Kind{"cloud", cloud},
    Kind{"lattice", lattice},
    Kind{"chain", chain},
    Kind{"nested", nested},
    Kind{"kissing", kissing},
    Kind{"coincident", coincident},
    Kind{"needle gap", needle_gap},
    Kind{"needle eye", needle_eye},
    Kind{"flat", flat},
    Kind{"great and small", great_and_small},
    Kind{"shell", shell},
    Kind{"cospherical", cospherical},
    Kind{"far apart", far_apart},
};

// Evenly up to `end`, whatever size rapidcheck has arrived at.
rc::Gen<int> below(int end) { return rc::gen::resize(100, rc::gen::inRange(0, end)); }
rc::Gen<int> part() { return below(1000); }

// Shrinks by leaving out any lump, and each lump towards zero.
rc::Gen<Clay> any_clay() {
    const auto lump = rc::gen::map(rc::gen::tuple(part(), part(), part(), part()), [](const auto& t) {
        return Lump{std::get<0>(t), std::get<1>(t), std::get<2>(t), std::get<3>(t)};
    });
    const auto lumps = rc::gen::nonEmpty(rc::gen::container<Clay>(lump));
    return rc::gen::weightedOneOf<Clay>({{7, rc::gen::resize(20, lumps)}, {1, rc::gen::resize(75, lumps)}});
}

rc::Gen<double> any_probe() {
    return rc::gen::map(part(), [](int p) {
        if (p % 10 < 5) return 1.4;
        if (p % 10 == 5) return 0.0;
        return p % 10 == 9 ? between(3.0, 10.0, p) : between(0.1, 3.0, p);
    });
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Arrangement& arrangement) {
    out << std::setprecision(17) << arrangement.name << ", probe " << arrangement.probe << ", atoms {{";
    const char* comma = "";
    for (const Vec3& c : arrangement.atoms.centres) {
        out << comma << "{" << c.x << ", " << c.y << ", " << c.z << "}";
        comma = ", ";
    }
    comma = "}, {";
    for (const double r : arrangement.atoms.radii) {
        out << comma << r;
        comma = ", ";
    }
    return out << "}}";
}

rc::Gen<Arrangement> any_arrangement() {
    return rc::gen::map(rc::gen::tuple(below(static_cast<int>(kKinds.size())), any_clay(), any_probe()),
                        [](const auto& made) {
                            const auto& [kind, clay, probe] = made;
                            const Kind& chosen = kKinds[static_cast<std::size_t>(kind)];
                            return Arrangement{chosen.name, chosen.shape(clay, probe), probe};
                        });
}

std::ostream& operator<<(std::ostream& out, const Vessel& vessel) {
    return out << Arrangement{vessel.island ? "vessel with an island" : "vessel", vessel.atoms} << ", spacing "
               << vessel.spacing;
}

rc::Gen<Vessel> any_vessel() {
    const auto shape = rc::gen::tuple(part(), below(2), part(), part());
    return rc::gen::map(shape, [](const auto& parts) {
        const auto& [size, island, spacing, place] = parts;
        Vessel vessel{hollow_shell(180, between(6.5, 8.0, size), 2.2), island == 1, between(0.3, 0.6, spacing)};
        if (vessel.island) add(vessel.atoms, {}, between(0.9, 1.3, place));
        for (Vec3& c : vessel.atoms.centres) c += Vec3{fraction(size), fraction(place), fraction(spacing)};
        return vessel;
    });
}

rc::Gen<std::pair<Arrangement, double>> arrangements_with_spacings() {
    constexpr std::array kSpacings{0.25, 0.35, 0.5, 0.5, 0.7, 1.0, 1.6, 2.5};
    return rc::gen::pair(any_arrangement(), rc::gen::map(below(kSpacings.size()), [=](int i) {
                             return kSpacings[static_cast<std::size_t>(i)];
                         }));
}

}  // namespace meniscus::testing

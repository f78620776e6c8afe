// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The ranking of pockets beside the prototype that its model was fitted with.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "meniscus/pocket_chemistry.h"
#include "meniscus/pockets.h"
#include "meniscus/structure.h"
#include "pockets/pocket_model.h"
#include "pockets/pocket_space.h"
#include "pockets/point_features.h"
#include "support/test_data.h"

namespace meniscus::testing {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<Row> read_table(const std::filesystem::path& path) {
    std::ifstream file(path);
    const auto cells_of = [](const std::string& line) {
        std::vector<std::string> cells;
        std::istringstream text(line);
        for (std::string cell; std::getline(text, cell, '\t');) cells.push_back(cell);
        return cells;
    };
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> names = cells_of(line);
    std::vector<Row> rows;
    while (std::getline(file, line)) {
        const std::vector<std::string> cells = cells_of(line);
        Row& row = rows.emplace_back();
        for (std::size_t i = 0; i < cells.size(); ++i) row[names[i]] = cells[i];
    }
    return rows;
}

double number(const Row& row, const std::string& name) { return std::stod(row.at(name)); }

Structure read_heavy_atoms(const std::filesystem::path& path) {
    return read_structure(path, {.radii = "united", .hydrogens = HydrogenPolicy::Drop, .hetero = HeteroPolicy::None});
}

TEST(PocketReference, FeaturesAndProbabilitiesOfPoints) {
    MENISCUS_NEED_TEST_DATA();
    const std::filesystem::path folder = *test_data() / "reference";
    const Structure structure = read_heavy_atoms(folder / "pocket_points.pdb.gz");
    const ExactSurface small(structure.atoms);
    const ExactSurface large(structure.atoms, {SurfaceKind::Ses, 10.0});
    const PocketSpace space = pocket_space(small.accessible(), large.accessible(), structure.atoms.centres, 1.0);
    const RankedPoints points = rank_points(space, small.accessible(), structure.atoms, atom_classes(structure));
    const std::vector<Row> rows = read_table(folder / "pocket_points.tsv");
    ASSERT_GT(rows.size(), 20u);
    for (const Row& row : rows) {
        const Vec3 place{number(row, "x"), number(row, "y"), number(row, "z")};
        std::size_t i = 0;
        while (i < points.voxels.size() && norm(space.position(points.voxels[i]) - place) > 1e-6) ++i;
        ASSERT_LT(i, points.voxels.size()) << place.x << " " << place.y << " " << place.z;
        for (std::size_t f = 0; f < FeatureCount; ++f) {
            const std::string name(pocket_model().terms[f].feature);
            const double expected = number(row, name);
            EXPECT_NEAR(points.features[i][f], expected, 1e-3 * std::max(1.0, std::abs(expected))) << name;
        }
        EXPECT_NEAR(probability(pocket_model(), points.features[i]), number(row, "p"), 1e-3);
    }
}

TEST(PocketReference, SitesOfStructures) {
    MENISCUS_NEED_TEST_DATA();
    std::size_t compared = 0;
    std::string name;  // rows of a structure follow each other
    Pockets pockets;
    for (const Row& row : read_table(*test_data() / "reference" / "pocket_sites.tsv")) {
        if (row.at("name") != name) {
            name = row.at("name");
            const Structure structure = read_heavy_atoms(*test_data() / "pockets" / (name + ".pdb.gz"));
            pockets = find_pockets(ExactSurface(structure.atoms), atom_classes(structure));
            for (const Check& check : pocket_checks(pockets)) EXPECT_TRUE(check.passed) << name << " " << check.name;
            EXPECT_NEAR(pockets.scale, 1.0, 0.005) << name;
        }
        const auto rank = static_cast<std::size_t>(number(row, "rank"));
        ASSERT_GE(pockets.pockets.size(), rank);
        const Pocket& pocket = pockets.pockets[rank - 1];
        EXPECT_NEAR(pocket.score, number(row, "score"), 0.01 * number(row, "score")) << name << " " << rank;
        const Vec3 centre{number(row, "x"), number(row, "y"), number(row, "z")};
        EXPECT_LT(norm(pocket.centre - centre), 0.1) << name << " " << rank;
        ++compared;
    }
    EXPECT_GT(compared, 60u);
}

}  // namespace
}  // namespace meniscus::testing

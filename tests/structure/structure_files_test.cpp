// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Whole entries: how many atoms are kept, and that formats agree.
#include <algorithm>
#include <array>

#include "fragments.h"
#include "support/test_data.h"

namespace meniscus {
namespace {

std::string path_of(const std::string& name) { return (*testing::test_data() / "structures" / name).string(); }

struct Expected {
    const char* file;
    std::size_t atoms;
    const char* radii;
};

constexpr auto kFiles = std::to_array<Expected>({
    {"1a0q.pdb", 3183, "united"},    {"1a63.pqr", 2065, "file"},
    {"1aki.pdb", 1001, "united"},    {"1aon.from-mmtf.cif.gz", 58674, "united"},
    {"1bna.cif", 486, "united"},     {"1bna.pdb", 486, "united"},
    {"1brs.pdb", 1742, "united"},    {"1crn.cif", 327, "united"},
    {"1crn.pdb", 327, "united"},     {"1d3z.pdb", 1231, "bondi"},
    {"1d66.pdb", 1707, "united"},    {"1ema.cif", 1771, "united"},
    {"1en2.cif", 627, "united"},     {"1fss.pdb", 4689, "united"},
    {"1gya.pdb", 1774, "bondi"},     {"1hga.pdb", 4384, "united"},
    {"1igy.pdb", 10032, "united"},   {"1ihm.pdb", 11284, "united"},
    {"1l2y.pdb", 304, "bondi"},      {"1mah.pdb", 4576, "united"},
    {"1npc.pdb.gz", 2390, "united"}, {"1tw7_doubled_h36.pdb.gz", 6236, "bondi"},
    {"1u19.pdb", 5498, "united"},    {"1ubq.pdb", 602, "united"},
    {"1us0.pdb", 2491, "united"},    {"2isk.pdb", 13928, "united"},
    {"2ptc_h.pdb", 4115, "bondi"},   {"3o5r.pdb", 982, "united"},
    {"3sn6.cif", 10247, "united"},   {"4gxy.pdb", 3506, "united"},
    {"4hhb.cif", 4384, "united"},    {"4hhb.pdb", 4384, "united"},
    {"4pti.ent", 454, "united"},     {"6xm4.xyzr", 48519, "file"},
    {"mache.pqr", 8279, "file"},
});

TEST(StructureFiles, KeepTheAtomsOfThePolymer) {
    MENISCUS_NEED_TEST_DATA();
    for (const Expected& expected : kFiles) {
        const Structure s = read_structure(path_of(expected.file));
        EXPECT_EQ(s.atoms.size(), expected.atoms) << expected.file;
        EXPECT_EQ(s.radii_set, expected.radii) << expected.file;
        EXPECT_FALSE(testing::has_warning(s, "not in radius set")) << expected.file;
    }
}

TEST(StructureFiles, PdbAndCifOfAnEntryGiveTheSameAtomsInTheSameOrder) {
    MENISCUS_NEED_TEST_DATA();
    for (const std::string name : {"4hhb", "1bna", "1crn"}) {
        const ReadOptions all{.hetero = HeteroPolicy::All, .keep_waters = true};
        const Structure pdb = read_structure(path_of(name + ".pdb"), all);
        const Structure cif = read_structure(path_of(name + ".cif"), all);
        EXPECT_EQ(pdb.atoms.centres, cif.atoms.centres) << name;
        EXPECT_EQ(pdb.atoms.radii, cif.atoms.radii) << name;
    }
}

TEST(StructureFiles, CoordinatesAreThoseOfTheReferenceSpheres) {
    MENISCUS_NEED_TEST_DATA();
    for (const std::string name : {"1crn", "1ubq", "1hga", "1mah", "1fss", "4hhb", "1bna", "1d66", "2isk"}) {
        const Structure s = read_structure(path_of(name + ".pdb"), {.radii = "bondi"});
        const Atoms expected = testing::read_spheres(*testing::test_data() / "reference/xyzr" / (name + ".xyzr"));
        EXPECT_EQ(s.atoms.centres, expected.centres) << name;
        EXPECT_EQ(s.atoms.radii, expected.radii) << name;
    }
}

TEST(StructureFiles, ACapsidHasSixtyCopies) {
    MENISCUS_NEED_TEST_DATA();
    const Structure s = read_structure(path_of("1ihm.pdb"), {.assembly = "1"});
    EXPECT_EQ(s.atoms.size(), 677040U);
    EXPECT_EQ(s.residues.front().chain, "A");
    EXPECT_EQ(s.residues.back().chain, "C-60");
}

TEST(StructureFiles, EveryModelOfAnNmrEntryCanBeRead) {
    MENISCUS_NEED_TEST_DATA();
    const std::vector<Structure> models = read_all_models(path_of("1l2y.pdb"));
    ASSERT_EQ(models.size(), 38U);
    for (const Structure& s : models) EXPECT_EQ(s.atoms.size(), 304U);
    EXPECT_EQ(models.back().name, "1l2y_m38");
}

TEST(StructureFiles, EverySetTypesAProtein) {
    MENISCUS_NEED_TEST_DATA();
    for (const char* set : {"bondi", "united", "protor", "naccess", "parse"}) {
        const Structure s = read_structure(path_of("1ubq.pdb"), {.radii = set, .strict_radii = true});
        EXPECT_EQ(s.atoms.size(), 602U) << set;
        EXPECT_EQ(s.radii_set, set);
    }
}

}  // namespace
}  // namespace meniscus

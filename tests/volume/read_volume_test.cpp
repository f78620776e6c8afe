// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "volume_files.h"

namespace meniscus::testing {
namespace {

TEST(ReadVolume, TheSuffixTellsTheFormat) {
    EXPECT_THROW(read_volume("a.cube"), UsageError);
    EXPECT_THROW(read_volume_grid("dx"), UsageError);
    EXPECT_THROW(read_volume("/nowhere/a.dx"), InputError);
    EXPECT_THROW(read_volume("/nowhere/a.map.gz"), InputError);
}

}  // namespace
}  // namespace meniscus::testing

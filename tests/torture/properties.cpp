// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "torture/properties.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "torture/torture_count.h"

namespace meniscus::testing {
namespace {

constexpr std::uint64_t kSeed = 20090101;

bool seed_is_given() {
    const char* given = std::getenv("RC_PARAMS");
    return given != nullptr && std::string(given).find("seed") != std::string::npos;
}

}  // namespace

void expect_property(int count, const rc::detail::Property& property) {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    const std::string name = std::string(test->test_suite_name()) + "/" + test->name();
    const rc::detail::Configuration& configuration = rc::detail::configuration();
    rc::detail::TestParams params = configuration.testParams;
    params.maxSuccess = torture_count(count);
    if (!seed_is_given()) params.seed = kSeed;
    const rc::detail::TestResult result = rc::detail::checkProperty(property, {name, name}, params);
    std::ostringstream text;
    rc::detail::printResultMessage(result, text);
    if (!result.is<rc::detail::SuccessResult>()) ADD_FAILURE() << text.str();
}

}  // namespace meniscus::testing
